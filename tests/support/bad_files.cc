#include "support/bad_files.h"

#include <unistd.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace dockyard {

namespace fs = std::filesystem;

ScratchFolder::ScratchFolder() {
  std::string pattern = (fs::temp_directory_path() / "dockyard_models_XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no scratch folder");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

std::string ScratchFolder::Write(const std::string& name, const std::string& bytes) const {
  const fs::path file = path_ / name;
  fs::create_directories(file.parent_path());
  fs::remove(file);  // ext4 waits for the disk where a file is cut to nothing and written anew
  std::ofstream(file, std::ios::binary) << bytes;
  return file.string();
}

void ScratchFolder::CopyModel(const std::string& model) const {
  fs::create_directories((path_ / "models" / model).parent_path());
  fs::copy(SourceFile("models/" + model), path_ / "models" / model, fs::copy_options::recursive);
}

std::string Slurp(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw std::runtime_error("cannot open " + file.string());
  std::ostringstream bytes;
  bytes << in.rdbuf();
  return bytes.str();
}

std::string Replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == std::string::npos) throw std::runtime_error("not in the text: " + from);
  return text.replace(at, from.size(), to);
}

std::string Glb(const std::string& json, const std::string& binary) {
  const auto word = [](std::size_t value) {
    const auto number = static_cast<std::uint32_t>(value);
    std::string bytes(4, '\0');
    std::memcpy(bytes.data(), &number, 4);
    return bytes;
  };
  const auto chunk = [&](const std::string& type, std::string bytes, char pad) {
    bytes.resize((bytes.size() + 3) / 4 * 4, pad);
    return word(bytes.size()) + type + bytes;
  };
  const std::string chunks =
      chunk("JSON", json, ' ') + chunk(std::string("BIN\0", 4), binary, '\0');
  return "glTF" + word(2) + word(12 + chunks.size()) + chunks;
}

std::string TriangleGltf(const std::string& uri) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],
"max":[1,1,0]}],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{)" +
         (uri.empty() ? "" : "\"uri\":\"" + uri + "\",") + R"("byteLength":36}]})";
}

std::string TriangleBytes() {
  const float corners[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  return {reinterpret_cast<const char*>(corners), sizeof corners};
}

std::string TriangleCollada() {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit meter="1" name="meter"/><up_axis>Z_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="9">0 0 0 1 0 0 0 0 2</float_array><technique_common>
<accessor source="#pa" count="3" stride="3"><param name="X" type="float"/><param name="Y"
type="float"/><param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="1"><input semantic="VERTEX" source="#v" offset="0"/><p>0 1 2</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node><instance_geometry url="#g"/></node>
</visual_scene></library_visual_scenes><scene><instance_visual_scene url="#s"/></scene></COLLADA>
)";
}

std::string MessageOf(const std::function<void()>& call, const ScratchFolder& folder) {
  try {
    call();
  } catch (const ConfigError& error) {
    std::string message = error.what();
    const std::string prefix = folder.path().string() + "/";
    for (std::size_t at; (at = message.find(prefix)) != std::string::npos;) {
      message.erase(at, prefix.size());
    }
    return message;
  }
  return "(no error)";
}

}  // namespace dockyard
