// What the tests of the readers share.
#pragma once
#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "params/file.h"
#include "scene/model_file.h"
#include "tests/refusal.h"
#include "tests/temporary_folder.h"

namespace cg {

// Reads `bytes` as the format of `extension` ("obj"), as if it were the file "test.obj".
inline Model read_bytes(const std::string& extension, const std::string& bytes) {
  const std::string where = "test." + extension;
  if (extension == "obj") return read_obj(bytes, where, {});
  if (extension == "ply") return read_ply(bytes, where);
  if (extension == "off") return read_off(bytes, where);
  return read_stl(bytes, where);
}

inline std::size_t face_count(const Model& model) {
  std::size_t n = 0;
  for (const ModelPart& part : model.parts) n += part.mesh->data().face_count();
  return n;
}

// The message of the InputError that reading throws; empty where it does not.
inline std::string error_of(const std::string& extension, const std::string& bytes) {
  return refusal_of([&] { read_bytes(extension, bytes); });
}

inline std::vector<glm::dvec3> positions_of_face(const Mesh& mesh, std::size_t f) {
  const MeshData& data = mesh.data();
  std::vector<glm::dvec3> out;
  for (std::uint32_t c = data.first_corner[f]; c < data.first_corner[f + 1]; ++c)
    out.push_back(data.positions[data.corners[c].position]);
  return out;
}

// One text that must be refused: its message begins with `begin` ("test.obj:3: ") and has `part` in it.
struct Refused {
  std::string bytes, begin, part;
};

inline void expect_refused(const std::string& extension, const std::vector<Refused>& all) {
  for (const Refused& one : all) {
    const std::string message = error_of(extension, one.bytes);
    EXPECT_TRUE(message.starts_with(one.begin)) << one.bytes.substr(0, 200) << "\n-> " << message;
    EXPECT_NE(message.find(one.part), std::string::npos) << one.bytes.substr(0, 200) << "\n-> " << message;
  }
}

struct TestFolder : TemporaryFolder {
  std::filesystem::path write(const std::string& name, const std::string& bytes) const {
    std::filesystem::create_directories((*this / name).parent_path());
    save_file(*this / name, bytes);
    return *this / name;
  }
};

}  // namespace cg
