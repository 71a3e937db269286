// Files mutated at random: each is read or refused with a ConfigError, nothing else happens.
#include <gmock/gmock.h>

#include "models/read/mesh_loader.h"
#include "models/read/urdf.h"
#include "sim/app/check_file.h"
#include "sim/app/systems.h"
#include "sim/base/random.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

std::size_t Below(RandomStream& random, std::size_t n) {
  return n == 0 ? 0 : static_cast<std::size_t>(random.NextBits() % n);
}

/// One to four edits: bytes changed, removed or repeated, the end cut off, odd words put in.
std::string Mutated(std::string bytes, RandomStream& random) {
  static const std::vector<std::string> words{
      "nan", "-.inf", "1e308",    "-1",   "99999999999999999999",
      "[",   "]",     "{",        "}",    ":",
      "&a",  "*a",    "<<:",      "- ",   "\n",
      "\t",  "\"",    "'",        "<",    "/>",
      "</",  "&#0;",  "%",        "../",  std::string(1, '\0'),
      "#",   "!!x",   "\xef\xbb", "\xff", "0"};
  const std::size_t edits = 1 + Below(random, 4);
  for (std::size_t i = 0; i < edits; ++i) {
    const std::size_t at = Below(random, bytes.size() + 1);
    switch (Below(random, 6)) {
      case 0:
        if (at < bytes.size()) bytes[at] = static_cast<char>(random.NextBits());
        break;
      case 1:
        bytes.erase(at, 1 + Below(random, 40));
        break;
      case 2:
        bytes.insert(at, bytes.substr(Below(random, bytes.size() + 1), 1 + Below(random, 60)));
        break;
      case 3:
        if (Below(random, 4) == 0) bytes.resize(at);
        break;
      default:
        bytes.insert(at, words[Below(random, words.size())]);
        break;
    }
  }
  return bytes;
}

struct Tally {
  int read = 0, refused = 0;
};

/// Reads the file or refuses it with a ConfigError; anything else that is thrown ends the test.
void Try(const std::string& file, const std::function<void(const std::string&)>& load,
         Tally& tally) {
  try {
    load(file);
    ++tally.read;
  } catch (const ConfigError& error) {
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    ++tally.refused;
  }
}

/// Both happen: at least a tenth is refused and a fiftieth read (of most kinds a third is; of the
/// strictest, GLB with its length changed, a thirtieth). Else the mutations try nothing.
void ExpectBoth(const Tally& tally, const std::string& name) {
  const int count = tally.read + tally.refused;
  EXPECT_GT(tally.read, count / 50) << name;
  EXPECT_GT(tally.refused, count / 10) << name;
}

/// Mutates the file in its copied folder; `load` must read it or throw ConfigError.
void Fuzz(const std::string& model, const std::string& name, std::uint64_t seed, int count,
          const std::function<void(const std::string&)>& load) {
  const ScratchFolder folder;
  folder.CopyModel(model);
  const std::string original = Slurp(SourceFile(name));
  RandomStream random(seed);
  Tally tally;
  for (int i = 0; i < count; ++i) {
    const std::string file = folder.Write(name, Mutated(original, random));
    Try(file, load, tally);
  }
  ExpectBoth(tally, name);
}

/// Meshes that do not change are imported once for all files.
class MutatedFiles : public testing::Test {
 protected:
  const std::function<void(const std::string&)> Check =
      [systems = Systems()](const std::string& file) { CheckFile(file, systems); };
};

TEST_F(MutatedFiles, CameraFilesAreReadOrRefused) {
  Fuzz("cameras", "models/cameras/navcam.yaml", 11, 300, Check);
  Fuzz("cameras", "models/cameras/axel_640.yaml", 12, 300, Check);
  Fuzz("cameras", "tests/models/data/m2020_cameras.json", 13, 300, Check);
}

TEST_F(MutatedFiles, RoverYamlIsReadOrRefused) {
  Fuzz("axel", "models/axel/axel.yaml", 1, 300, Check);
}
TEST_F(MutatedFiles, StationYamlIsReadOrRefused) {
  Fuzz("axel", "models/axel/station/station.yaml", 2, 300, Check);
}
TEST_F(MutatedFiles, SoilYamlIsReadOrRefused) {
  Fuzz("soils", "models/soils/loose_sand.yaml", 3, 400, Check);
}
TEST_F(MutatedFiles, UrdfIsReadOrRefused) { Fuzz("axel", "models/axel/axel.urdf", 4, 300, Check); }
// Each file costs a process: tests of 150 to 200 take a few seconds.
TEST_F(MutatedFiles, ObjIsReadOrRefused) {
  Fuzz("axel", "models/axel/meshes/paddles.obj", 5, 150, Check);
}
TEST_F(MutatedFiles, OtherObjIsReadOrRefused) {
  Fuzz("axel", "models/axel/meshes/paddles.obj", 15, 150, Check);
}

TEST_F(MutatedFiles, ScenariosAndTablesAreReadOrRefused) {
  const ScratchFolder folder;
  for (const char* model : {"axel", "soils"}) folder.CopyModel(model);
  std::vector<std::string> names{"scenarios/axel_typical.yaml", "scenarios/mars_yard_40.csv",
                                 "scenarios/mars_yard_40.yaml", "scenarios/ci_4.yaml"};
  for (const std::string& name : names) folder.Write(name, Slurp(SourceFile(name)));
  for (const std::string& name : names) {
    EXPECT_NO_THROW(Check((folder.path() / name).string())) << name;
  }
  RandomStream random(6);
  Tally tally;
  for (int i = 0; i < 300; ++i) {
    const std::string& name = names[static_cast<std::size_t>(i) % names.size()];
    const std::string original = Slurp(SourceFile(name));
    folder.Write(name, Mutated(original, random));
    const bool table = name == "scenarios/mars_yard_40.csv";  // its campaign reads it
    Try((folder.path() / (table ? "scenarios/mars_yard_40.yaml" : name)).string(), Check, tally);
    folder.Write(name, original);
  }
  ExpectBoth(tally, "scenarios and tables");
}

using Wrap = std::function<std::string(const std::string&)>;
std::string Bare(const std::string& bytes) { return bytes; }

/// Mutates bytes that no file here holds, `count` times; the file is what `wrap` makes of them.
void FuzzMesh(const std::string& name, const std::string& original, std::uint64_t seed, int count,
              const Wrap& wrap = Bare) {
  const ScratchFolder folder;
  folder.Write("a.bin", TriangleBytes());
  RandomStream random(seed);
  Tally tally;
  const auto load = [](const std::string& file) {
    EXPECT_FALSE(LoadMesh(file)->triangles.empty());
  };
  EXPECT_NO_THROW(load(folder.Write(name, wrap(original)))) << name;
  for (int i = 0; i < count; ++i) {
    Try(folder.Write(name, wrap(Mutated(original, random))), load, tally);
  }
  ExpectBoth(tally, name);
}

TEST_F(MutatedFiles, StlInBytesIsReadOrRefused) {
  // As many triangles as its length tells, so a byte more or less is refused and a byte changed
  // is mostly read.
  std::string stl(80, ' ');
  stl += std::string("\x04\0\0\0", 4);
  for (int i = 0; i < 4 * 50; ++i) stl += static_cast<char>(i % 63);
  FuzzMesh("a.stl", stl, 7, 300);
}

TEST_F(MutatedFiles, ColladaIsReadOrRefused) { FuzzMesh("a.dae", TriangleCollada(), 8, 400); }

TEST_F(MutatedFiles, GltfInTextIsReadOrRefused) {
  FuzzMesh("a.gltf", TriangleGltf("a.bin"), 9, 300);
}

TEST_F(MutatedFiles, GltfInBytesIsReadOrRefused) {
  FuzzMesh("a.glb", Glb(TriangleGltf(), TriangleBytes()), 10, 300);
}

TEST_F(MutatedFiles, GltfInBytesWithLengthsThatFitIsReadOrRefused) {
  FuzzMesh("a.glb", TriangleGltf(), 11, 300,
           [](const std::string& json) { return Glb(json, TriangleBytes()); });
}

}  // namespace
}  // namespace dockyard
