// Meshes, and what a mesh importer's process may answer.
#include <fstream>
#include <memory>

#include "fuzz/kind.h"
#include "models/read/config_error.h"
#include "models/read/mesh_child.h"
#include "models/read/mesh_format.h"
#include "models/read/mesh_import.h"
#include "models/read/mesh_loader.h"
#include "sim/base/hash.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

/// Reads meshes as LoadMesh does, but may leave the importing out, or do it in this process.
class MeshReader {
 public:
  MeshReader(std::string file, const MeshFuzzOptions& options)
      : name_(std::move(file)), options_(options) {
    folder_.Write("a.bin", TriangleBytes());
  }

  bool Read(const std::string& bytes) {
    const std::string file = folder_.Write(name_, bytes);
    return ReadOrRefused([&] {
      const MeshStatement stated = CheckMeshFormat(file, bytes);
      if (++passed_ % options_.import_every != 0) return;
      if (options_.unguarded) {
        ImportMesh(file, stated);
      } else {
        LoadGuarded(file, bytes);
      }
    });
  }

 private:
  void LoadGuarded(const std::string& file, const std::string& bytes) const {
    try {
      LoadMesh(file);
    } catch (const ConfigError& error) {
      if (std::string(error.what()).find("the mesh importer") != std::string::npos) Keep(bytes);
      throw;
    }
  }
  void Keep(const std::string& bytes) const {
    if (options_.crash_dir.empty()) return;
    const std::string name = std::to_string(HashText(kHashSeed, bytes));
    std::ofstream(options_.crash_dir + "/" + name, std::ios::binary) << bytes;
  }

  ScratchFolder folder_;
  std::string name_;
  MeshFuzzOptions options_;
  int passed_ = 0;
};

FuzzKind MeshKind(const std::string& format, const std::vector<std::string>& seeds,
                  const std::vector<std::string>& words, const MeshFuzzOptions& options) {
  const auto reader = std::make_shared<MeshReader>("a." + format, options);
  // Bytes without a GLB's lengths are the JSON in one, so that mutations come past the lengths.
  const bool glb = format == "glb";
  return {format, [seeds] { return seeds; }, words,
          [reader, glb](const std::string& bytes) {
            const bool whole = !glb || bytes.substr(0, 4) == "glTF";
            return reader->Read(whole ? bytes : Glb(bytes, TriangleBytes()));
          }};
}

std::string BinaryStl(int triangles) {
  std::string stl(80, ' ');
  stl += std::string{static_cast<char>(triangles), '\0', '\0', '\0'};
  for (int i = 0; i < triangles * 50; ++i) stl += static_cast<char>(i % 63);
  return stl;
}

constexpr const char* kTextStl = R"(solid a
facet normal 0 0 1
 outer loop
  vertex 0 0 0
  vertex 1 0 0
  vertex 0 1 0
 endloop
endfacet
endsolid a
)";

constexpr const char* kObj = R"(mtllib none.mtl
o part
v 0 0 0
v 1 0 0
v 0 1 0
v 0 0 1
vt 0 0
vn 0 0 1
usemtl m
s off
f 1/1/1 2/1/1 3/1/1
g other
f -1 -2 -3
f 1 2 3 4
)";

std::vector<std::string> GltfWords() {
  return {
      "\"nodes\"",      "\"children\"",   "\"meshes\"",        "\"primitives\"",  "\"attributes\"",
      "\"POSITION\"",   "\"indices\"",    "\"accessors\"",     "\"bufferViews\"", "\"buffers\"",
      "\"byteOffset\"", "\"byteStride\"", "\"componentType\"", "\"count\"",       "\"sparse\"",
      "\"matrix\"",     "\"mode\"",       "\"uri\"",           "\"extensions\"",  "\"skins\"",
      "\"animations\"", "\"images\"",     "\"scenes\"",        "\"cameras\"",     "5125",
      "5123",           "4294967295",     "data:;base64,",     "\"targets\"",     "\"weights\""};
}

/// The encoded mesh of an answer, from a process that a hostile file may rule.
FuzzKind AnswerKind() {
  return {
      "mesh_answer",
      [] {
        return std::vector{EncodeMesh(BoxMesh({1, 1, 1})), EncodeMesh(CylinderMesh(1.0, 1.0, 8))};
      },
      {},
      [](const std::string& bytes) { return ReadOrRefused([&] { DecodeMesh(bytes, "answer"); }); }};
}

}  // namespace

std::vector<NamedKind> MeshKinds(const MeshFuzzOptions& options) {
  const auto kind = [options](const std::string& format, const std::vector<std::string>& seeds,
                              const std::vector<std::string>& words) {
    return NamedKind{format, [=] { return MeshKind(format, seeds, words, options); }};
  };
  return {kind("stl", {BinaryStl(4), kTextStl},
               {"solid", "facet normal", "outer loop", "vertex ", "endloop", "endfacet", "endsolid",
                "nan", "1e308"}),
          kind("obj", {kObj, Slurp(SourceFile("models/axel/station/meshes/module.obj"))},
               {"v ", "vt ", "vn ", "f ", "l ", "p ", "o ", "g ", "usemtl ", "mtllib ", "s ",
                "curv ", "surf ", "end", "\\\n", "//", "1e308", "-1"}),
          kind("dae", {TriangleCollada()},
               {"<polylist count=\"1\">",
                "<vcount>3</vcount>",
                "<node>",
                "</node>",
                "<instance_node url=\"#",
                "<matrix>",
                "<controller>",
                "<skin>",
                "<input ",
                "semantic=\"NORMAL\"",
                "set=\"0\"",
                "offset=\"1\"",
                "<library_nodes>",
                "<instance_controller url=\"#",
                "stride=\"0\"",
                "count=\"4294967295\"",
                "<animation>",
                "<!DOCTYPE",
                "<polygons>",
                "<trifans>",
                "<tristrips>",
                "<ph>"}),
          kind("gltf", {TriangleGltf("a.bin")}, GltfWords()),
          kind("glb", {Glb(TriangleGltf(), TriangleBytes()), TriangleGltf()}, GltfWords()),
          {"mesh_answer", AnswerKind}};
}

}  // namespace dockyard
