#include "ui/fonts.h"

#include <fcntl.h>
#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include <imgui_freetype.h>
#include <imgui_internal.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <optional>
#include <span>
#include <vector>
#include FT_FREETYPE_H

namespace cg {
namespace {

// The roles a face can play; each names the families that can play it, the best first.
enum Role { text, bold, mono, italic, roman, japanese, role_count };
struct Wish {
  const char* family;
  int weight, slant;
};
const std::vector<Wish> wishes[role_count] = {
    {{"Inter", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN}, {"DejaVu Sans", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN}},
    {{"Inter", FC_WEIGHT_DEMIBOLD, FC_SLANT_ROMAN}, {"DejaVu Sans", FC_WEIGHT_BOLD, FC_SLANT_ROMAN}},
    {{"JetBrains Mono", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN}, {"DejaVu Sans Mono", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN}},
    {{"STIX", FC_WEIGHT_REGULAR, FC_SLANT_ITALIC},
     {"STIXGeneral", FC_WEIGHT_REGULAR, FC_SLANT_ITALIC},
     {"Latin Modern Roman", FC_WEIGHT_REGULAR, FC_SLANT_ITALIC},
     {"Inter", FC_WEIGHT_REGULAR, FC_SLANT_ITALIC}},
    {{"STIX", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN},
     {"STIXGeneral", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN},
     {"Latin Modern Roman", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN},
     {"Inter", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN}},
    {{"Noto Sans CJK JP", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN},
     {"IPAexGothic", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN},
     {"VL Gothic", FC_WEIGHT_REGULAR, FC_SLANT_ROMAN}},
};

// A face in memory. `per_em` turns a size in em into the ascent-to-descent height that ImGui calls size.
struct Face {
  void* data = nullptr;
  std::size_t size = 0;
  int index = 0;
  float per_em = 1;
};

bool is_font(const void* data, std::size_t size) {
  if (size < 1024) return false;
  for (const char* magic : {"OTTO", "ttcf", "true"})
    if (std::memcmp(data, magic, 4) == 0) return true;
  return std::memcmp(data, "\0\1\0\0", 4) == 0;
}

// Maps the file and opens it once with FreeType, so that ImGui, which aborts on a bad one, never sees it.
std::optional<Face> open_face(FT_Library library, const char* path, int index) {
  const int file = ::open(path, O_RDONLY | O_CLOEXEC);
  if (file < 0) return {};
  struct stat info {};
  void* data = MAP_FAILED;
  if (::fstat(file, &info) == 0 && info.st_size > 0)
    data = ::mmap(nullptr, std::size_t(info.st_size), PROT_READ, MAP_PRIVATE, file, 0);
  ::close(file);
  if (data == MAP_FAILED) return {};
  const std::size_t size = std::size_t(info.st_size);
  FT_Face face = nullptr;
  if (!is_font(data, size) ||
      FT_New_Memory_Face(library, static_cast<const FT_Byte*>(data), FT_Long(size), index, &face) != 0) {
    ::munmap(data, size);
    return {};
  }
  const bool usable = FT_IS_SCALABLE(face) && FT_Select_Charmap(face, FT_ENCODING_UNICODE) == 0 &&
                      face->units_per_EM > 0 && face->ascender > face->descender;
  const float per_em = usable ? float(face->ascender - face->descender) / float(face->units_per_EM) : 0;
  FT_Done_Face(face);
  if (usable && per_em > 0.5f && per_em < 4) return Face{data, size, index, per_em};
  ::munmap(data, size);
  return {};
}

std::optional<Face> find_face(FcConfig* config, FT_Library library, const Wish& wish) {
  FcPattern* pattern = FcPatternBuild(nullptr, FC_FAMILY, FcTypeString, wish.family, FC_SLANT, FcTypeInteger,
                                      wish.slant, FC_WEIGHT, FcTypeInteger, wish.weight, nullptr);
  FcObjectSet* asked = FcObjectSetBuild(FC_FILE, FC_INDEX, nullptr);
  FcFontSet* found = FcFontList(config, pattern, asked);
  std::vector<std::pair<std::string, int>> files;
  for (int i = 0; found && i < found->nfont; ++i) {
    FcChar8* file = nullptr;
    int index = 0;
    if (FcPatternGetString(found->fonts[i], FC_FILE, 0, &file) != FcResultMatch) continue;
    FcPatternGetInteger(found->fonts[i], FC_INDEX, 0, &index);
    if ((index >> 16) == 0) files.emplace_back(reinterpret_cast<const char*>(file), index);  // no variations
  }
  if (found) FcFontSetDestroy(found);
  FcObjectSetDestroy(asked);
  FcPatternDestroy(pattern);
  std::sort(files.begin(), files.end(), [](const auto& a, const auto& b) {  // the plain cut of a family, always
    return std::pair(a.first.size(), a.first) < std::pair(b.first.size(), b.first);
  });
  for (const auto& [file, index] : files)
    if (auto face = open_face(library, file.c_str(), index)) return face;
  return {};
}

}  // namespace

class FontFiles {
 public:
  FontFiles() {
    FT_Library library = nullptr;
    if (FT_Init_FreeType(&library) != 0) return;
    if (FcConfig* config = FcInitLoadConfigAndFonts()) {
      for (int role = 0; role < role_count; ++role)
        for (const Wish& wish : wishes[role])
          if ((faces[role] = find_face(config, library, wish))) break;
      FcConfigDestroy(config);
    }
    FT_Done_FreeType(library);
  }
  ~FontFiles() {
    for (const auto& face : faces)
      if (face) ::munmap(face->data, face->size);
  }
  FontFiles(const FontFiles&) = delete;
  FontFiles& operator=(const FontFiles&) = delete;
  std::array<std::optional<Face>, role_count> faces;
};

std::shared_ptr<const FontFiles> find_fonts() { return std::make_shared<FontFiles>(); }

namespace {

using Ranges = ImVector<ImWchar>;  // pairs of inclusive ends, closed by 0

// A formula sets quantities italic and vectors, digits and signs upright: k_d (N·L).
bool is_italic(ImWchar c) { return (c >= 'a' && c <= 'z') || c == 'I' || c == 'E' || (c >= 0x3b1 && c <= 0x3c9); }

struct Builder {
  ImFontAtlas& atlas;
  float scale;
  const FontFiles& files;

  bool add(Role role, float em, const Ranges& ranges, bool merge) const {
    const auto& face = files.faces[role];
    if (!face) return false;
    ImFontConfig config;
    config.FontDataOwnedByAtlas = false;
    config.FontNo = face->index;
    config.GlyphRanges = ranges.Data;
    config.MergeMode = merge;
    config.OversampleH = 1;
    config.PixelSnapH = true;
    config.FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
    const float pixels = std::clamp(em * scale * face->per_em, 4.0f, 400.0f);
    return atlas.AddFontFromMemoryTTF(face->data, int(face->size), pixels, &config) != nullptr;
  }

  // The faces in turn; what one lacks, the next gives.
  ImFont* stack(float em, std::initializer_list<std::pair<Role, const Ranges*>> parts) const {
    bool any = false;
    for (const auto& [role, ranges] : parts) any = add(role, em, *ranges, any) || any;
    if (!any) {
      ImFontConfig config;
      config.SizePixels = std::clamp(em * scale, 4.0f, 400.0f);
      atlas.AddFontDefault(&config);
    }
    return atlas.Fonts.back();
  }
};

}  // namespace

std::unique_ptr<BuiltFonts> build_fonts(float scale, const std::unordered_set<ImWchar>& wanted,
                                        const FontFiles& files) {
  auto built = std::make_unique<BuiltFonts>();
  built->scale = scale;
  built->atlas = std::make_unique<ImFontAtlas>();
  ImFontAtlas& atlas = *built->atlas;
  ImFontGlyphRangesBuilder every, slanted, upright;
  every.AddRanges(atlas.GetGlyphRangesDefault());
  for (ImWchar c : wanted) every.AddChar(c);
  for (ImWchar c = 0x21; c < 0x7f; ++c) (is_italic(c) ? slanted : upright).AddChar(c);
  for (const char* p : {"·", "Σ", "−", "×", "′", "²", "α", "β", "θ", "ρ", "π"}) {
    unsigned c = 0;
    ImTextCharFromUtf8(&c, p, nullptr);
    (is_italic(ImWchar(c)) ? slanted : upright).AddChar(ImWchar(c));
  }
  for (ImWchar c : wanted)  // and whatever signs the formulas of lessons have: √, ∫, Δ
    if (c > 0xa0 && c < 0x2e80) (is_italic(c) ? slanted : upright).AddChar(c);
  upright.AddChar(' ');
  auto& [all, italics, uprights] = built->ranges;
  every.BuildRanges(&all);
  slanted.BuildRanges(&italics);
  upright.BuildRanges(&uprights);

  atlas.FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas.Flags |= ImFontAtlasFlags_NoPowerOfTwoHeight;
  const Builder b{atlas, scale, files};
  Fonts& f = built->fonts;
  f.text = b.stack(17, {{text, &all}, {japanese, &all}, {roman, &all}});
  f.small = b.stack(14, {{text, &all}, {japanese, &all}, {roman, &all}});
  f.bold = b.stack(17, {{bold, &all}, {japanese, &all}});
  f.mono = b.stack(15.5f, {{mono, &all}, {text, &all}});
  f.small_mono = b.stack(13.5f, {{mono, &all}, {text, &all}, {japanese, &all}});
  f.math = b.stack(22, {{roman, &uprights}, {italic, &italics}});
  f.math_sub = b.stack(15.5f, {{roman, &uprights}, {italic, &italics}});
  f.formula = b.stack(28, {{roman, &uprights}, {italic, &italics}});
  f.formula_sub = b.stack(18.5f, {{roman, &uprights}, {italic, &italics}});
  atlas.Build();
  return built;
}

}  // namespace cg
