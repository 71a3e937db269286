// Meshes as modelling programs and exporters write them.
#include <gmock/gmock.h>

#include "models/read/gltf_uri.h"
#include "models/read/mesh_loader.h"
#include "models/read/mesh_size.h"
#include "models/read/obj_text.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

constexpr char kMark[] = "\xEF\xBB\xBF";
constexpr char kStl[] =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
    "endfacet\nendsolid t\n";

std::string MessageFor(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  const std::string file = folder.Write(name, bytes);
  return MessageOf([&] { LoadMesh(file); }, folder);
}

/// The corners of all triangles, in their order.
std::vector<Eigen::Vector3d> CornersOf(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  const auto mesh = LoadMesh(folder.Write(name, bytes));
  std::vector<Eigen::Vector3d> corners;
  for (const auto& triangle : mesh->triangles) {
    for (const std::uint32_t index : triangle) corners.push_back(mesh->vertices[index]);
  }
  return corners;
}

std::string Windows(const std::string& text) {
  std::string lines = kMark;
  for (const char c : text) lines += c == '\n' ? "\r\n" : std::string(1, c);
  return lines;
}

TEST(ExportedMesh, MayBeginWithAByteOrderMark) {
  const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
  EXPECT_EQ(CornersOf("a.obj", Windows(obj)), CornersOf("a.obj", obj));
  EXPECT_EQ(CornersOf("a.stl", Windows(kStl)), CornersOf("a.stl", kStl));
  EXPECT_EQ(CornersOf("a.dae", Windows(TriangleCollada())), CornersOf("a.dae", TriangleCollada()));
  const ScratchFolder folder;
  folder.Write("a.bin", TriangleBytes());
  EXPECT_EQ(LoadMesh(folder.Write("a.gltf", Windows(TriangleGltf("a.bin"))))->triangles.size(), 1u);
  EXPECT_THAT(MessageFor("a.obj", std::string("\xFF\xFEv\0 \0", 6)),
              HasSubstr("a.obj:1:1: expected text in UTF-8, found UTF-16; save it as UTF-8"));
}

TEST(ExportedObj, CornersMayNameTextureAndNormalsThatAreNotThere) {
  const std::string vertices = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n";
  const auto plain = CornersOf("a.obj", vertices + "f 1 2 3\nf 1 3 4\n");
  for (const char* faces :
       {"f 1/1/1 2/2/2 3/3/3\nf 1/9/9 3/9/9 4/9/9\n", "f 1//1 2//1 3//1\nf 1//1 3//1 4//1\n",
        "f 1/1 2/2 3/3\nf 1/ 3/ 4/\n", "f -4 -3 -2\nf -4/-1/-1 -2 -1\n",
        "g a\nusemtl b\ns 1\nf 1 2 \\\n 3\nvn 0 0 1\nvt 0 0\no c\n\tf 1\t3 4 # end\n",
        "f 1 2 3 4\n"}) {
    const auto corners = CornersOf("a.obj", vertices + faces);
    if (std::string(faces) == "f 1 2 3 4\n") {
      EXPECT_EQ(corners.size(), 6u);
    } else {
      EXPECT_EQ(corners, plain) << faces;
    }
  }
}

TEST(ExportedObj, CornersMayComeBeforeTheirPlaces) {
  EXPECT_EQ(CornersOf("a.obj", "f 1 2 3\nv 0 0 0\nv 1 0 0\nv 0 1 0\n").size(), 3u);
}

TEST(ExportedObj, CornersThatNameNoVertexAreRefusedWithTheirLine) {
  const std::string vertices = "v 0 0 0\nv +1.0 0 0\nv 0 1 0\n";
  EXPECT_EQ(MessageFor("a.obj", vertices + "f 1 2 9\n"),
            "a.obj:4:1: not a usable mesh: expected corners from 1 to 3, the vertices of the file, "
            "found 'f 1 2 9'");
  for (const char* bad :
       {"f 0 1 2", "f -4 1 2", "f 1 2 x", "f 1/a 2 3", "f 1/1/1/1 2 3", "f 1.5 2 3", "f /1 2 3"}) {
    EXPECT_THAT(MessageFor("a.obj", vertices + bad + "\n"),
                HasSubstr("a.obj:4:1: not a usable mesh: expected"))
        << bad;
  }
  EXPECT_THAT(MessageFor("a.obj", vertices + "f 1 2\n"), HasSubstr("without faces"));
}

TEST(ExportedStl, TextMayBeInCapitalsAndWithoutItsLastLines) {
  const auto whole = CornersOf("a.stl", kStl);
  std::string capitals = kStl;
  for (char& c : capitals) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  EXPECT_EQ(CornersOf("a.stl", capitals), whole);
  EXPECT_EQ(CornersOf("a.stl", Replaced(kStl, "vertex 1 0 0", "Vertex +1.0E+0 0 0")), whole);
  EXPECT_EQ(CornersOf("a.stl", Replaced(kStl, "endsolid t\n", "")), whole);
  EXPECT_EQ(CornersOf("a.stl", Replaced(kStl, "endloop\nendfacet\nendsolid t\n", "")), whole);
}

TEST(ExportedCollada, UnitsThatAreNoLengthAreRefusedWithTheirLine) {
  const auto with = [](const std::string& metres) {
    return Replaced(TriangleCollada(), "<library_geometries>",
                    "<asset>\n<unit meter=\"" + metres + "\"/></asset><library_geometries>");
  };
  for (const char* bad : {"0", "0.0", "-1", "nan", "inf", "1e999", "1e-300", "", "0,01"}) {
    EXPECT_THAT(
        MessageFor("a.dae", with(bad)),
        testing::MatchesRegex("a.dae:[0-9]+:1: not a usable mesh: <unit>: meter: expected.*"))
        << bad;
  }
  EXPECT_EQ(MessageFor("a.dae", with("0.001")), "(no error)");
}

TEST(ExportedGltf, BuffersMayHaveAnyNameOfAUri) {
  const ScratchFolder folder;
  folder.Write("rover body.bin", TriangleBytes());
  folder.Write("k\xC3\xB6rper 100%.bin", TriangleBytes());
  for (const char* uri :
       {"rover%20body.bin", "rover body.bin", "./rover%20body.bin", "rover\\u0020body.bin",
        "k%C3%B6rper%20100%25.bin", "k\\u00f6rper%20100%25.bin", "k\xC3\xB6rper%20100%25.bin"}) {
    EXPECT_EQ(LoadMesh(folder.Write("a.gltf", TriangleGltf(uri)))->triangles.size(), 1u) << uri;
  }
}

TEST(ExportedGltf, AddressesThatLeadElsewhereAreNone) {
  for (const char* uri :
       {"../a.bin", "%2e%2e/a.bin", "..%2Fa.bin", "sub/a.bin", "sub%5Ca.bin", "a%00.bin", "a%2.bin",
        "a%zz.bin", "a.txt", ".bin", "file:///a.bin", "http:a.bin", "a\n.bin", "sub\\a.bin"}) {
    EXPECT_FALSE(BufferNameOf(uri)) << uri;
  }
  EXPECT_EQ(BufferNameOf("a%20b.BIN"), "a b.BIN");
}

TEST(ExportedGltf, DataIsInBase64AsRfc4648HasIt) {
  const std::pair<const char*, const char*> examples[] = {{"", ""},       {"Zg==", "f"},
                                                          {"Zm8=", "fo"}, {"Zm9v", "foo"},
                                                          {"Zm8", "fo"},  {"Zm9vYg==", "foob"}};
  for (const auto& [text, bytes] : examples) EXPECT_EQ(FromBase64(text), bytes);
  for (const char* bad : {"Z", "Zg=", "Zm9v=", "Z m9v", "Zm-_"})
    EXPECT_FALSE(FromBase64(bad)) << bad;
}

TEST(MeshSize, IsTheBoxOfAllVertices) {
  TriangleMesh mesh = BoxMesh({1.5, 0.25, 3.0});
  for (Eigen::Vector3d& v : mesh.vertices) v += Eigen::Vector3d(5, -7, 2);
  EXPECT_LT((ExtentOf(mesh) - Eigen::Vector3d(1.5, 0.25, 3.0)).norm(), 1e-12);
  EXPECT_EQ(SizeText(ExtentOf(mesh)), "1.5 x 0.25 x 3 m");
  EXPECT_EQ(SizeText({1234.4, 0.0123456, 0}), "1234 x 0.0123 x 0 m");
  EXPECT_EQ(UnitDoubt(ExtentOf(mesh)), "");
  EXPECT_THAT(UnitDoubt({450, 300, 120}), HasSubstr("450 x 300 x 120 m; is it in millimetres?"));
  EXPECT_THAT(UnitDoubt({4e-4, 3e-4, 0}), HasSubstr("scaled twice?"));
}

}  // namespace
}  // namespace dockyard
