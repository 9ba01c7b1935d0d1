#include "workbench/texture_library.h"

#include <algorithm>
#include <optional>

#include "image/image_file.h"
#include "workbench/data_folder.h"
#include "workbench/remembered.h"

namespace cg {

namespace {

namespace fs = std::filesystem;

fs::path textures_folder() { return data_folder() / "textures"; }

fs::path file_of(const std::string& image) {
  const fs::path path(image);
  return path.is_absolute() ? path : textures_folder() / path;
}

// A file's rows begin at the top, a texture's at the bottom.
template <class Texel, class Convert>
Image<Texel> upright(const FileImage& file, const Convert& convert) {
  const int w = file.info.width, h = file.info.height;
  auto out = Image<Texel>::unwritten(w, h);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x) {
      const float alpha = file.alpha.empty() ? 1.0f : file.alpha.at(x, y);
      out.at(x, h - 1 - y) = convert(glm::vec4(file.colour.at(x, y), alpha));
    }
  return out;
}

// As many bits as the file has: a height in 8 bits is a flight of stairs.
Texels texels_of(const FileImage& file) {
  const auto whole = [](float most) {
    return [most](const glm::vec4& v) { return glm::clamp(v, 0.0f, 1.0f) * most + 0.5f; };
  };
  if (file.info.floating) return upright<glm::vec4>(file, [](const glm::vec4& v) { return v; });
  if (file.info.bits <= 8)
    return upright<glm::u8vec4>(file, [&](const glm::vec4& v) { return glm::u8vec4(whole(255)(v)); });
  return upright<glm::u16vec4>(file, [&](const glm::vec4& v) { return glm::u16vec4(whole(65535)(v)); });
}

// A picture, or what stands in its place and why.
struct LoadedTexture {
  TextureHandle image;
  std::optional<InputError> error;
};

LoadedTexture load(const fs::path& file, Encoding encoding) try {
  return {TextureImage::make(texels_of(read_image(file)), encoding), std::nullopt};
} catch (const InputError& e) {
  return {TextureImage::placeholder(), e};
} catch (const std::bad_alloc&) {
  return {TextureImage::placeholder(),
          InputError(file.string(), Words{"the picture does not fit into memory", "画像がメモリに収まらない"})};
}

// Failures are remembered like pictures: a file that cannot be read is not tried again with every frame.
std::shared_ptr<const LoadedTexture> texture_in(const fs::path& file, Encoding encoding) {
  static Remembered<std::pair<std::string, Encoding>, LoadedTexture> textures;
  return textures.get({file.string(), encoding}, stamp_of(file),
                      [&] { return std::make_shared<const LoadedTexture>(load(file, encoding)); });
}

}  // namespace

std::vector<std::string> bundled_textures() {
  std::vector<std::string> names;
  std::error_code error;
  for (fs::directory_iterator i(textures_folder(), error), end; !error && i != end; i.increment(error)) {
    const std::string type = i->path().extension().string();
    if (type == ".png" || type == ".jpg" || type == ".hdr") names.push_back(i->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

std::string find_texture(const std::string& name, const fs::path& folder) {
  if (name.empty()) return name;
  std::error_code error;
  const fs::path here = folder.empty() ? fs::path(name) : folder / name;
  const fs::path bundled = textures_folder() / here.filename();
  if (fs::is_regular_file(here, error))
    return fs::equivalent(here, bundled, error) ? here.filename().string()
                                                : fs::absolute(here, error).lexically_normal().string();
  for (const std::string& file : {name, name + ".png"})
    if (!fs::path(file).has_parent_path() && fs::is_regular_file(textures_folder() / file, error)) return file;
  return fs::absolute(here, error).lexically_normal().string();
}

void load_textures(Scene& scene, std::vector<InputError>* bad) {
  const auto load_into = [&](Material& material, const std::string& where) {
    for (std::size_t i = 0; i < material.layers.size(); ++i) {
      TextureLayer& layer = material.layers[i];
      if (layer.image.empty()) continue;
      const auto loaded = texture_in(file_of(layer.image), layer.encoding);
      layer.texture = {loaded, loaded->image.get()};
      if (!loaded->error || !bad) continue;
      const InputError& e = *loaded->error;
      bad->emplace_back(where + "layers." + std::to_string(i) + ".image: " + e.where, e.found, e.accepted, e.line,
                        e.byte);
    }
  };
  load_into(scene.material, "material.");
  for (std::size_t i = 0; i < scene.objects.size(); ++i)
    if (scene.objects[i].own_material)
      load_into(scene.objects[i].material, "objects." + std::to_string(i) + ".material.");
}

}  // namespace cg
