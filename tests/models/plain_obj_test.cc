// Plain OBJ files as our own reader takes them, beside the importer.
#include "models/read/plain_obj.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>

#include "models/read/mesh_import.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

void ExpectAsImported(const std::string& text, const std::string& what) {
  const auto plain = PlainObj(text);
  ASSERT_TRUE(plain) << what;
  const TriangleMesh imported = ImportMesh("a.obj", {MeshFormat::kObj, text});
  ASSERT_EQ(plain->vertices.size(), imported.vertices.size()) << what;
  for (std::size_t i = 0; i < plain->vertices.size(); ++i) {
    // assimp takes 2.14313e-18 for 2.1431302e-18.
    EXPECT_LT((plain->vertices[i] - imported.vertices[i]).norm(), 1e-20) << what;
  }
  EXPECT_EQ(plain->triangles, imported.triangles) << what;
}

TEST(PlainObj, IsWhatTheImporterMakesOfOurModels) {
  int count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(SourceFile("models"))) {
    if (entry.path().extension() != ".obj") continue;
    ExpectAsImported(Slurp(entry.path()), entry.path());
    ++count;
  }
  EXPECT_GT(count, 5);
}

TEST(PlainObj, IsWhatTheImporterMakesOfRandomTriangles) {
  std::mt19937 random(7);
  const auto below = [&](int count) { return static_cast<int>(random() % count); };
  for (int mesh = 0; mesh < 100; ++mesh) {
    std::string text = "# random\no mesh\n";
    const int places = 3 + below(40);
    for (int i = 0; i < places; ++i) {
      text += "v";
      for (int k = 0; k < 3; ++k)
        text += " " + std::to_string(below(9) - 4) + "." + std::to_string(below(4) * 25);
      text += i % 2 == 0 ? "\n" : "\r\n";
    }
    for (int i = 0; i < 60; ++i) {
      text += "f";
      for (int k = 0; k < 3; ++k) text += " " + std::to_string(1 + below(places));
      text += "\n";
    }
    ExpectAsImported(text, text);
  }
}

TEST(PlainObj, LeavesAllElseToTheImporter) {
  const std::string places = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 1 1 0\n";
  EXPECT_TRUE(PlainObj(places + "f 1 2 3\n"));
  EXPECT_TRUE(PlainObj(places + "f 1 2 3"));
  for (const char* rest :
       {"", "f 1 2 3 4\n", "f 1 2\n", "f 1/1 2/2 3/3\n", "f 1 2 5\n", "f 0 1 2\n", "f -1 -2 -3\n",
        "f 1 2 3x\n", "vt 0 0\nf 1 2 3\n", "vn 0 0 1\nf 1 2 3\n", "o a\nf 1 2 3\no b\nf 2 3 4\n",
        "usemtl red\nf 1 2 3\n", "v 1 2\nf 1 2 3\n", "v 1 2 3 4\nf 1 2 3\n", "v 1 2 nan\nf 1 2 3\n",
        "v 1 2 2e3\nf 1 2 3\n", "f 1 2 \\\n3\n", "l 1 2\nf 1 2 3\n",
        "f 99999999999999999999 1 2\n"}) {
    EXPECT_FALSE(PlainObj(places + rest)) << rest;
  }
  EXPECT_FALSE(PlainObj(""));
}

}  // namespace
}  // namespace dockyard
