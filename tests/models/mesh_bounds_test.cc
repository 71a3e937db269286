// Mesh files whose counts, strides, indices, nesting or references would lead an importer out of
// its memory, its stack or its time. Each minimal file made assimp 5.2.5 crash, hang or read wrong
// geometry.
#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <chrono>

#include "models/read/mesh_loader.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

std::string MessageFor(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  const std::string file = folder.Write(name, bytes);
  return MessageOf([&] { LoadMesh(file); }, folder);
}

std::string Times(std::size_t n, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < n; ++i) all += text;
  return all;
}

/// The message for the Collada triangle with one place changed.
std::string Changed(const std::string& from, const std::string& to) {
  return MessageFor("a.dae", Replaced(TriangleCollada(), from, to));
}

TEST(ColladaBounds, ArraysHoldAsManyNumbersAsTheirCount) {
  EXPECT_EQ(Changed("count=\"9\"", "count=\"0\""),
            "a.dae:5:16: not a usable mesh: <float_array>: count: expected 9, as many as there are "
            "numbers");
  EXPECT_THAT(Changed("count=\"9\"", "count=\"\""), HasSubstr("<float_array>: count: expected a"));
  EXPECT_THAT(Changed("count=\"9\"", "count=\"4000000000\""), HasSubstr("a whole number from 0"));
  EXPECT_THAT(Changed("count=\"9\"", "count=\"-1\""), HasSubstr("a whole number from 0 to 1e8"));
  EXPECT_THAT(Changed("0 0 0 1 0 0", "0 0 0 one 0 0"), HasSubstr("expected numbers, found 'one'"));
}

TEST(ColladaBounds, AccessorsStayWithinTheirArray) {
  EXPECT_THAT(Changed("stride=\"3\"", "stride=\"99999999999\""),
              HasSubstr("a.dae:6:1: not a usable mesh: <accessor>: stride: expected a whole"));
  const char* within = "<accessor>: count, stride and offset: expected all within the array's 9";
  EXPECT_THAT(Changed("stride=\"3\"", "stride=\"4\""), HasSubstr(within));
  EXPECT_THAT(Changed("count=\"3\" stride", "count=\"4\" stride"), HasSubstr(within));
  EXPECT_THAT(Changed("stride=\"3\"", "stride=\"3\" offset=\"1\""), HasSubstr(within));
  EXPECT_THAT(Changed("source=\"#pa\"", "source=\"#q\""), HasSubstr("id of a <float_array>"));
  EXPECT_THAT(Changed("name=\"X\" type=\"float\"", "name=\"X\" type=\"float4x4\""),
              HasSubstr("<param>: type: expected float"));
}

TEST(ColladaBounds, IndicesNameVerticesThatAreThere) {
  for (const char* bad : {"3", "-1", "2147483648", "99999999999999999999", "x", "1.5"}) {
    EXPECT_EQ(Changed("<p>0 1 2", std::string("<p>0 1 ") + bad),
              std::string("a.dae:9:71: not a usable mesh: <p>: expected indices from 0 to 2, found "
                          "'") +
                  bad + "'");
  }
}

TEST(ColladaBounds, FacesAddUpToTheirCount) {
  EXPECT_THAT(Changed("triangles count=\"1\"", "triangles count=\"2\""),
              HasSubstr("expected one list of 6 corners, found 3"));
  EXPECT_THAT(Changed("<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/>", ""),
              HasSubstr("expected one <input semantic=\"VERTEX\">"));
  EXPECT_THAT(Changed("offset=\"0\"", "offset=\"4000000\""), HasSubstr("offset: expected less"));
  const std::string strips = Replaced(Replaced(TriangleCollada(), "<triangles", "<tristrips"),
                                      "</triangles", "</tristrips");
  EXPECT_EQ(MessageFor("a.dae", strips), "(no error)");
  EXPECT_THAT(MessageFor("a.dae", Replaced(strips, "0 1 2</p>", "0</p>")),
              HasSubstr("expected at least 3 corners"));
}

TEST(ColladaBounds, PolygonsWithTheirCornersAreRead) {
  const ScratchFolder folder;
  const std::string list = Replaced(
      Replaced(Replaced(TriangleCollada(), "<triangles", "<polylist"), "</triangles", "</polylist"),
      "<p>", "<vcount>3</vcount><p>");
  EXPECT_EQ(LoadMesh(folder.Write("a.dae", list))->triangles.size(), 1u);
  for (const char* bad : {"4", "0", "3 3", "x", ""}) {
    EXPECT_THAT(MessageFor("a.dae", Replaced(list, "<vcount>3", std::string("<vcount>") + bad)),
                HasSubstr("not a usable mesh"))
        << bad;
  }
}

TEST(ColladaBounds, NestingIsCountedOutsideComments) {
  const std::string hidden = "<!-- " + Times(90000, "</a>") + " -->" + Times(90000, "<node>");
  EXPECT_THAT(Changed("<node>", hidden), HasSubstr("elements nested deeper than 64 levels"));
}

TEST(ColladaBounds, BrokenTagsAreRefusedInLinearTime) {
  // 6 MB took more than 60 s where every '<' looked for its '>' anew; now 0.2 s.
  const auto start = std::chrono::steady_clock::now();
  EXPECT_EQ(MessageFor("a.dae", "<COLLADA " + Times(3000000, "<a")),
            "a.dae:1:1: not a usable mesh: a tag without its end");
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  EXPECT_LT(took.count(), 10.0);
}

TEST(ColladaBounds, InstancesNeitherReturnToThemselvesNorMultiply) {
  const auto with = [](const std::string& nodes, const std::string& first) {
    const std::string library = Replaced(TriangleCollada(), "<library_visual_scenes>",
                                         "<library_nodes>" + nodes +
                                             "</library_nodes>"
                                             "<library_visual_scenes>");
    return MessageFor("a.dae", Replaced(library, "<node><inst",
                                        "<node><instance_node url=\"#" + first + "\"/><inst"));
  };
  EXPECT_EQ(with("<node id=\"a\"><instance_geometry url=\"#g\"/></node>", "a"), "(no error)");
  EXPECT_THAT(with("<node id=\"a\"><instance_node url=\"#a\"/></node>", "a"),
              HasSubstr("not a usable mesh: the mesh importer"));
  std::string tenfold = "<node id=\"n9\"><instance_geometry url=\"#g\"/></node>";
  for (int i = 8; i >= 0; --i) {
    const std::string next = "<instance_node url=\"#n" + std::to_string(i + 1) + "\"/>";
    tenfold += "<node id=\"n" + std::to_string(i) + "\">" + Times(10, next) + "</node>";
  }
  EXPECT_THAT(with(tenfold, "n0"), HasSubstr("not a usable mesh: the mesh importer"));
}

TEST(ColladaBounds, WhatHasNoPartInTheMeshIsLeftOut) {
  const std::string skin =
      "<library_controllers><controller id=\"c\"><skin source=\"#g\">"
      "<vertex_weights count=\"4000000000\"><vcount>1</vcount><v>1 1</v>"
      "</vertex_weights></skin></controller></library_controllers>";
  EXPECT_EQ(Changed("<library_visual_scenes>", skin + "<library_visual_scenes>"), "(no error)");
  EXPECT_THAT(Changed("instance_geometry", "instance_controller"),
              HasSubstr("<instance_controller>: skinned meshes are not read"));
}

TEST(ObjBounds, PartsAreSoManyThatComparingAllTakesNoTime) {
  // 100 000 objects took more than 60 s, 200 000 materials more than 60 s and 2 GB.
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 10000; ++i) text += "o a" + std::to_string(i) + "\nf 1 2 3\n";
  EXPECT_EQ(MessageFor("a.obj", text), "(no error)");
  for (const char* more : {"usemtl b\n", "o b\n", "o\tb\n", "\r  g b\n"}) {
    EXPECT_EQ(MessageFor("a.obj", text + more),
              "a.obj: not a usable mesh: more than 10000 objects, groups and changes of material");
  }
}

TEST(ObjBounds, CornersHoldNumbers) {
  const auto changed = [](const std::string& to) {
    return MessageFor("a.obj", "v 0 0 0\n" + to + "\nv 0 1 0\nf 1 2 3\n");
  };
  for (const char* good : {"v 1 0 0", "v  1.0e+00 -0 0.5", "v 1 0 0 1", "v 1 0 0 0.5 0.5 0.5",
                           "v 1 0 0 # corner", "vn 1 0 0\nv 1 0 0"}) {
    EXPECT_EQ(changed(good), "(no error)") << good;
  }
  EXPECT_EQ(changed("v 1x 0 0"),
            "a.obj:2:1: not a usable mesh: expected 'v' and numbers, found 'v 1x 0 0'");
  for (const char* bad : {"v 1,5 0 0", "v a b c", "v 1 0", "v 1 0 0 1 1", "v 0x10 0 0"}) {
    EXPECT_THAT(changed(bad), HasSubstr("a.obj:2:1: not a usable mesh: expected 'v' and")) << bad;
  }
}

constexpr std::array kFacetEnds{"vertex 0 1 0\n", "endloop", "endloop\n", "endfacet", "endfacet\n"};

TEST(StlBounds, TextIsWholeFacetsToItsEnd) {
  const std::string facet =
      "facet normal nan 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\n";
  const std::string whole = "solid a b\n" + facet + facet + "endsolid a b\n";
  EXPECT_EQ(MessageFor("a.stl", whole), "(no error)");
  EXPECT_EQ(MessageFor("a.stl", whole + whole), "(no error)");
  // Some programs leave the last lines out. Cut anywhere else, it is no mesh.
  int complete = 0;
  for (std::size_t length = 40; length < whole.size() - 13; ++length) {
    const std::string cut = whole.substr(0, length);
    const bool facets = std::any_of(kFacetEnds.begin(), kFacetEnds.end(),
                                    [&](const char* end) { return cut.ends_with(end); });
    complete += facets ? 1 : 0;
    EXPECT_THAT(MessageFor("a.stl", cut), HasSubstr(facets ? "(no error)" : "not a usable mesh"))
        << length;
  }
  EXPECT_EQ(complete, 9);
  for (const char* bad : {"vertex 1 0", "vertex 1,5 0 0", "vertex 1x 0 0", "vertex a b c",
                          "vertex 1 0 0\nvertex 5 5 5", "rubbish 1 0 0"}) {
    EXPECT_THAT(MessageFor("a.stl", Replaced(whole, "vertex 1 0 0", bad)),
                HasSubstr(": not a usable mesh: expected "))
        << bad;
  }
}

/// The messages for the triangle as .gltf and as .glb, which must be the same reason.
std::string ChangedGltf(const std::string& from, const std::string& to) {
  const std::string json = Replaced(TriangleGltf(), from, to);
  const std::string binary = MessageFor("a.glb", Glb(json, TriangleBytes()));
  const std::string text = MessageFor("a.gltf", json);
  const std::string prefix = "a.gltf: not a usable mesh: ";
  EXPECT_EQ(text.substr(0, prefix.size()), prefix) << text;
  EXPECT_EQ("a.glb" + text.substr(6), binary);
  return text.substr(std::min(prefix.size(), text.size()));
}

/// The reason against the triangle as .glb with one place changed.
std::string ChangedBinary(const std::string& from, const std::string& to) {
  const std::string message =
      MessageFor("a.glb", Glb(Replaced(TriangleGltf(), from, to), TriangleBytes()));
  const std::string prefix = "a.glb: not a usable mesh: ";
  return message.rfind(prefix, 0) == 0 ? message.substr(prefix.size()) : message;
}

TEST(GltfBounds, NestingOfWhatIsNotReadDoesNotMatter) {
  const std::string deep = Times(200000, "[") + Times(200000, "]");
  for (const std::string& more : {"\"x\":" + deep, "\"y\":\"" + Times(200000, "]") + '"'}) {
    const std::string json = Replaced(TriangleGltf(), "\"scene\":0", more);
    EXPECT_EQ(MessageFor("a.glb", Glb(json, TriangleBytes())), "(no error)");
  }
  EXPECT_THAT(ChangedGltf("\"scene\":0", "\"x\":" + Times(200000, "[")),
              HasSubstr("no glTF document"));
}

TEST(GltfBounds, NodesMakeATree) {
  std::string chain = "\"nodes\":[{\"children\":[1]},";
  for (int i = 2; i < 1000; ++i) chain += "{\"children\":[" + std::to_string(i) + "]},";
  const std::string deep =
      Replaced(TriangleGltf(), "\"nodes\":[{\"mesh\":0}]", chain + "{\"mesh\":0}]");
  EXPECT_EQ(MessageFor("a.glb", Glb(deep, TriangleBytes())), "(no error)");
  const char* no_tree = "a node with two parents or in a circle";
  EXPECT_EQ(ChangedBinary("\"nodes\":[{\"mesh\":0}]", "\"nodes\":[{\"mesh\":0,\"children\":[0]}]"),
            no_tree);
  EXPECT_EQ(
      ChangedBinary("\"nodes\":[{\"mesh\":0}]", "\"nodes\":[{\"children\":[1,1]},{\"mesh\":0}]"),
      no_tree);
}

TEST(GltfBounds, CountsAndLengthsAreThoseOfAMesh) {
  EXPECT_EQ(ChangedGltf("\"count\":3", "\"count\":3000000000"),
            "count: expected a whole number from 0 to 134217728, found 3000000000");
  for (const char* bad : {"-3", "3.5", "\"3\"", "[]", "null"}) {
    EXPECT_THAT(ChangedGltf("\"count\":3", std::string("\"count\":") + bad),
                HasSubstr("count: expected a whole number"))
        << bad;
  }
  EXPECT_THAT(ChangedBinary("\"byteLength\":36}]}", "\"byteLength\":1e12}]}"),
              HasSubstr("byteLength: expected a whole number"));
  std::string primitives = "\"primitives\":[";
  for (int i = 0; i < 20; ++i) primitives += "{\"attributes\":{\"POSITION\":0}},";
  const std::string many = Replaced(TriangleGltf(), "\"primitives\":[", primitives);
  EXPECT_EQ(MessageFor("a.glb", Glb(many, TriangleBytes())), "(no error)");
  // One buffer that several primitives name: together more than a mesh may have.
  const std::string zeros(3 * 100000 * 12, '\0');
  const std::string large = Replaced(Replaced(many, "\"count\":3", "\"count\":300000"),
                                     "\"byteLength\":36}],", "\"byteLength\":3600000}],");
  EXPECT_THAT(
      MessageFor("a.glb",
                 Glb(Replaced(large, "\"byteLength\":36}]}", "\"byteLength\":3600000}]}"), zeros)),
      HasSubstr("more than 500000 triangles"));
}

TEST(Gltf, NodesPlaceWhatTheyHoldByMatrixOrByScaleRotationAndTranslation) {
  // A quarter turn about z, and twice the size: (x, y, z) -> (1 - 2 y, 2 x, 2 z).
  const ScratchFolder folder;
  const Eigen::Vector3d expected[] = {{1, 0, 0}, {1, 2, 0}, {-1, 0, 0}};
  for (const char* place :
       {"\"matrix\":[0,2,0,0,-2,0,0,0,0,0,2,0,1,0,0,1]",
        "\"translation\":[1,0,0],\"rotation\":[0,0,0.7071067811865476,0.7071067811865476],"
        "\"scale\":[2,2,2]"}) {
    const std::string json =
        Replaced(TriangleGltf(), "\"mesh\":0}", "\"mesh\":0," + std::string(place) + "}");
    const auto mesh = LoadMesh(folder.Write("a.glb", Glb(json, TriangleBytes())));
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT((mesh->vertices[mesh->triangles[0][i]] - expected[i]).norm(), 1e-12) << place;
    }
  }
  // Mirrored, the face is turned round.
  const std::string mirrored =
      Replaced(TriangleGltf(), "\"mesh\":0}", "\"mesh\":0,\"scale\":[1,1,-1]}");
  const auto mesh = LoadMesh(folder.Write("a.glb", Glb(mirrored, TriangleBytes())));
  EXPECT_EQ(mesh->vertices[mesh->triangles[0][1]], Eigen::Vector3d(0, 1, 0));
}

TEST(Gltf, StripsAndFansAreReadAsTheirTriangles) {
  const ScratchFolder folder;
  const float corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
  const std::string square(reinterpret_cast<const char*>(corners), sizeof corners);
  std::string json = Replaced(TriangleGltf(), "\"count\":3", "\"count\":4");
  for (int i = 0; i < 2; ++i) json = Replaced(json, "\"byteLength\":36", "\"byteLength\":48");
  const auto up = [&](const char* mode) {  // z of twice each triangle's area
    const std::string text =
        Replaced(json, "\"POSITION\":0}", std::string("\"POSITION\":0},\"mode\":") + mode);
    std::vector<double> areas;
    const auto mesh = LoadMesh(folder.Write("a.glb", Glb(text, square)));
    for (const auto& t : mesh->triangles) {
      const Eigen::Vector3d a = mesh->vertices[t[1]] - mesh->vertices[t[0]],
                            b = mesh->vertices[t[2]] - mesh->vertices[t[0]];
      areas.push_back(a.cross(b).z());
    }
    return areas;
  };
  EXPECT_EQ(up("5"), (std::vector<double>{1.0, 1.0}));   // both face up
  EXPECT_EQ(up("6"), (std::vector<double>{1.0, -1.0}));  // corners 0 1 2 and 0 2 3
}

TEST(GltfBounds, WhatIsNotReadIsRefused) {
  EXPECT_EQ(ChangedGltf("\"scene\":0", "\"skins\":[]"), "\"skins\", which is not read");
  EXPECT_EQ(ChangedGltf("\"count\":3", "\"sparse\":{},\"count\":3"),
            "\"sparse\", which is not read");
  EXPECT_EQ(ChangedGltf("{\"attributes\"", "{\"targets\":[],\"attributes\""),
            "\"targets\", which is not read");
  EXPECT_EQ(ChangedGltf("{\"attributes\"",
                        "{\"extensions\":{\"KHR_draco_mesh_compression\":{}},\"attributes\""),
            "\"KHR_draco_mesh_compression\", which is not read");
  EXPECT_EQ(ChangedGltf("\"2.0\"", "\"1.0\""), "no glTF document of version 2");
}

TEST(GltfBounds, BuffersLieBesideTheMesh) {
  // Given a path or an address, assimp takes the file of the same name beside the mesh.
  const ScratchFolder folder;
  folder.Write("in/a.bin", TriangleBytes());
  folder.Write("a.bin", TriangleBytes());
  const auto message = [&](const std::string& uri) {
    const std::string file = folder.Write("in/a.gltf", TriangleGltf(uri));
    return MessageOf([&] { LoadMesh(file); }, folder);
  };
  EXPECT_EQ(message("a.bin"), "(no error)");
  EXPECT_EQ(
      message("data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD"
              "8AAAAA"),
      "(no error)");
  EXPECT_EQ(message("../a.bin"),
            "in/a.gltf: not a usable mesh: uri: expected the name of a .bin file in the "
            "mesh's own folder, found '../a.bin'");
  for (const std::string& uri :
       {(folder.path() / "a.bin").string(), std::string("file:///a.bin"),
        std::string("http://localhost/a.bin"), std::string("..\\u002fa.bin"),
        std::string("%2e%2e/a.bin"), std::string("x/../a.bin"), std::string("a.txt"),
        std::string(".bin"), std::string("a.bin\\u0000")}) {
    EXPECT_THAT(message(uri), HasSubstr("the name of a .bin file in the mesh's own folder")) << uri;
  }
}

TEST(GltfBounds, ViewsAndAccessorsStayWithinTheirBytes) {
  const char* within = "accessors[0]: expected all within the view's 36 bytes";
  EXPECT_EQ(ChangedBinary("\"bufferView\":0,", "\"bufferView\":0,\"byteOffset\":24,"), within);
  EXPECT_EQ(ChangedBinary("\"count\":3", "\"count\":4"), within);
  EXPECT_EQ(ChangedBinary("{\"buffer\":0,", "{\"buffer\":0,\"byteStride\":16,"), within);
  EXPECT_THAT(ChangedBinary("{\"buffer\":0,", "{\"buffer\":0,\"byteStride\":4,"),
              HasSubstr("bufferViews[0].byteStride: expected 0 or at least 12"));
  EXPECT_THAT(ChangedBinary("{\"buffer\":0,", "{\"buffer\":0,\"byteOffset\":4,"),
              HasSubstr("bufferViews[0]: expected all within the buffer's 36 bytes"));
  EXPECT_THAT(ChangedBinary("{\"buffer\":0,", "{\"buffer\":1,"),
              HasSubstr("expected buffers[1] to be there"));
  EXPECT_THAT(ChangedBinary("\"byteLength\":36}]}", "\"byteLength\":72}]}"),
              HasSubstr("buffers[0].byteLength: expected at most the 36 bytes"));
  EXPECT_THAT(ChangedBinary("\"count\":3", "\"count\":3,\"count\":2"),
              HasSubstr("\"count\" given twice"));
}

TEST(GltfBounds, PositionsAreThreeFloats) {
  for (const char* type : {"SCALAR", "VEC2", "VEC4", "VEC9"}) {
    EXPECT_THAT(ChangedBinary("VEC3", type), HasSubstr("expected a")) << type;
  }
  for (const char* component : {"5121", "5125", "77"}) {
    EXPECT_THAT(ChangedBinary("5126", component), HasSubstr("expected a")) << component;
  }
  EXPECT_THAT(ChangedBinary("\"POSITION\":0", "\"POSITION\":1"),
              HasSubstr("expected accessors[1] to be there"));
  EXPECT_THAT(ChangedBinary("\"count\":3", "\"count\":2"),
              HasSubstr("expected three corners a triangle"));
}

TEST(GltfBounds, IndicesNameVerticesThatAreThere) {
  std::string json = Replaced(TriangleGltf(), "\"POSITION\":0}", "\"POSITION\":0},\"indices\":1");
  json = Replaced(json, "}],\"bufferViews\":[",
                  "},{\"bufferView\":1,\"componentType\":5121,\"count\":6,\"type\":\"SCALAR\"}],"
                  "\"bufferViews\":[{\"buffer\":0,\"byteLength\":36},{\"buffer\":0,\"byteOffset\":"
                  "36,\"byteLength\":6}],\"x\":[");
  json = Replaced(json, "\"byteLength\":36}]}", "\"byteLength\":42}]}");
  const auto message = [&](const std::string& indices) {
    return MessageFor("a.glb", Glb(json, TriangleBytes() + indices));
  };
  EXPECT_EQ(message(std::string("\0\1\2\2\1\0", 6)), "(no error)");
  EXPECT_EQ(message(std::string("\0\1\2\2\1\3", 6)),
            "a.glb: not a usable mesh: a vertex index out of range");
}

}  // namespace
}  // namespace dockyard
