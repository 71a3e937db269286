#include <gmock/gmock.h>

#include <cstring>

#include "models/read/mesh_loader.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

constexpr char kTriangle[] = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";

std::string MessageFor(const std::string& name, const std::string& bytes) {
  const ScratchFolder folder;
  const std::string file = folder.Write(name, bytes);
  return MessageOf([&] { LoadMesh(file); }, folder);
}

/// Volume by the divergence theorem; positive when faces look outwards.
double SignedVolume(const TriangleMesh& mesh) {
  double volume = 0.0;
  for (const auto& t : mesh.triangles) {
    volume += mesh.vertices[t[0]].dot(mesh.vertices[t[1]].cross(mesh.vertices[t[2]])) / 6.0;
  }
  return volume;
}

std::string Bytes(std::uint32_t value) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &value, 4);
  return bytes;
}

std::string BinaryStl(const std::vector<std::array<float, 9>>& triangles) {
  std::string bytes(80, ' ');
  bytes += Bytes(static_cast<std::uint32_t>(triangles.size()));
  for (const auto& corners : triangles) {
    bytes += std::string(12, '\0');
    bytes.append(reinterpret_cast<const char*>(corners.data()), 36);
    bytes += std::string(2, '\0');
  }
  return bytes;
}

TEST(Mesh, ObjTriangleIsRead) {
  const ScratchFolder folder;
  const auto mesh = LoadMesh(folder.Write("a.obj", kTriangle));
  ASSERT_EQ(mesh->triangles.size(), 1u);
  const auto& t = mesh->triangles[0];
  EXPECT_EQ(mesh->vertices[t[0]], Eigen::Vector3d(0, 0, 0));
  EXPECT_EQ(mesh->vertices[t[1]], Eigen::Vector3d(1, 0, 0));
  EXPECT_EQ(mesh->vertices[t[2]], Eigen::Vector3d(0, 1, 0));
}

TEST(Mesh, AStoreImportsTheSameBytesOnce) {
  const ScratchFolder folder;
  MeshStore store;
  const auto first = LoadMesh(folder.Write("a.obj", kTriangle), &store);
  EXPECT_EQ(LoadMesh(folder.Write("b.obj", kTriangle), &store), first);
  EXPECT_NE(LoadMesh(folder.Write("b.obj", kTriangle)), first);
  const auto changed = LoadMesh(folder.Write("a.obj", Replaced(kTriangle, "v 1", "v 7")), &store);
  EXPECT_EQ(changed->vertices[changed->triangles[0][1]], Eigen::Vector3d(7, 0, 0));
  // The numbers of a glTF document may lie in another file.
  folder.Write("a.bin", TriangleBytes());
  const std::string gltf = folder.Write("a.gltf", TriangleGltf("a.bin"));
  EXPECT_EQ(LoadMesh(gltf, &store)->triangles.size(), 1u);
  folder.Write("a.bin", "short");
  EXPECT_THAT(MessageOf([&] { LoadMesh(gltf, &store); }, folder), HasSubstr("not a usable mesh"));
}

TEST(Mesh, StlIsReadFromTextAndBytes) {
  const ScratchFolder folder;
  const auto binary = LoadMesh(folder.Write("b.stl", BinaryStl({{0, 0, 0, 1, 0, 0, 0, 1, 0}})));
  EXPECT_EQ(binary->triangles.size(), 1u);
  const auto text = LoadMesh(folder.Write(
      "t.stl",
      "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid t\n"));
  EXPECT_EQ(text->triangles.size(), 1u);
}

TEST(Mesh, ColladaIsReadInMetresWithZUp) {
  const ScratchFolder folder;
  const auto mesh = LoadMesh(folder.Write("a.dae", TriangleCollada()));
  ASSERT_EQ(mesh->triangles.size(), 1u);
  Eigen::Vector3d high(-9, -9, -9);
  for (const Eigen::Vector3d& v : mesh->vertices) high = high.cwiseMax(v);
  EXPECT_LT((high - Eigen::Vector3d(1, 0, 2)).norm(), 1e-6);
}

TEST(Mesh, GltfIsReadWithTheBufferBesideItAndNoneElsewhere) {
  const ScratchFolder folder;
  folder.Write("in/a.bin", TriangleBytes());
  folder.Write("out.bin", TriangleBytes());
  const std::string text = TriangleGltf("a.bin");
  EXPECT_EQ(LoadMesh(folder.Write("in/a.gltf", text))->triangles.size(), 1u);
  const std::string outside = folder.Write("in/b.gltf", Replaced(text, "a.bin", "../out.bin"));
  EXPECT_THAT(MessageOf([&] { LoadMesh(outside); }, folder),
              StartsWith("in/b.gltf: not a usable mesh: "));
}

TEST(Mesh, GlbIsReadWithItsOwnBytes) {
  const ScratchFolder folder;
  const auto mesh = LoadMesh(folder.Write("a.glb", Glb(TriangleGltf(), TriangleBytes())));
  ASSERT_EQ(mesh->triangles.size(), 1u);
  EXPECT_EQ(mesh->vertices[mesh->triangles[0][1]], Eigen::Vector3d(1, 0, 0));
}

TEST(Mesh, OtherFormatsAreRefusedUnseen) {
  EXPECT_EQ(MessageFor("a.ply", std::string("ply\nformat ascii 1. \ncomm")),
            "a.ply: expected a mesh file (.stl, .obj, .dae, .gltf or .glb), found extension "
            "'.ply'");
  EXPECT_THAT(MessageFor("a.fbx", "Kaydara FBX Binary"), HasSubstr("found extension '.fbx'"));
}

TEST(Mesh, FilesThatAreNotWhatTheyClaimAreRefused) {
  // The 25 bytes that crashed an importer by way of its guess at the format.
  const std::string ply = "ply\nformat ascii 1. \ncomm";
  ASSERT_EQ(ply.size(), 25u);
  EXPECT_THAT(MessageFor("a.stl", ply), HasSubstr("neither a binary STL file"));
  EXPECT_THAT(MessageFor("a.obj", ply), HasSubstr("an OBJ file without vertices or faces"));
  EXPECT_THAT(MessageFor("a.dae", ply), HasSubstr("no Collada document"));
  EXPECT_THAT(MessageFor("a.gltf", ply), HasSubstr("no glTF document"));
  EXPECT_THAT(MessageFor("a.glb", ply), HasSubstr("no binary glTF 2.0 file"));
}

TEST(Mesh, LengthsThatAHeaderLiesAboutAreRefused) {
  std::string stl = BinaryStl({{0, 0, 0, 1, 0, 0, 0, 1, 0}});
  stl.replace(80, 4, Bytes(0xffffffffu));
  EXPECT_THAT(MessageFor("a.stl", stl), HasSubstr("neither a binary STL file"));
  EXPECT_THAT(MessageFor("a.glb", "glTF" + Bytes(2) + Bytes(0x7fffffff) + std::string(20, ' ')),
              HasSubstr("no binary glTF 2.0 file"));
}

TEST(Mesh, EmptyMissingAndHugeFilesAreRefused) {
  EXPECT_THAT(MessageFor("a.obj", ""), HasSubstr("not a usable mesh"));
  EXPECT_THAT(MessageFor("a.obj", "v 0 0 0\nf 1 1\n"), HasSubstr("not a usable mesh"));
  EXPECT_THAT(MessageFor("a.obj", std::string(kMaxMeshBytes + 1, '#')),
              HasSubstr("larger than 32 MiB"));
  const ScratchFolder folder;
  EXPECT_EQ(MessageOf([&] { LoadMesh(folder.path() / "none.obj"); }, folder),
            "none.obj: no such file");
}

TEST(Mesh, CoordinatesMustBeFiniteAndWithinAKilometre) {
  const float inf = std::numeric_limits<float>::infinity(), nan = std::nanf("");
  for (const float bad : {inf, nan, 1e30f, -2000.0f}) {
    EXPECT_THAT(MessageFor("a.stl", BinaryStl({{bad, 0, 0, 1, 0, 0, 0, 1, 0}})),
                HasSubstr("not a usable mesh: "))
        << bad;
  }
  EXPECT_EQ(MessageFor("a.obj", "v 0 0 0\nv 1 0 0\nv nan 1 0\nf 1 2 3\n"),
            "a.obj:3:1: not a usable mesh: expected 'v' and numbers, found 'v nan 1 0'");
  EXPECT_THAT(MessageFor("a.obj", "v 0 0 0\nv 1e5 0 0\nv 0 1 0\nf 1 2 3\n"),
              HasSubstr("a coordinate that is not finite or beyond 1000 m"));
}

TEST(Mesh, IndexOutOfRangeIsRefused) {
  EXPECT_THAT(MessageFor("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n"),
              HasSubstr("not a usable mesh"));
}

TEST(Mesh, TooManyTrianglesAreRefused) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (std::size_t i = 0; i <= kMaxMeshTriangles; ++i) text += "f 1 2 3\n";
  EXPECT_THAT(MessageFor("a.obj", text), HasSubstr("more than 500000 triangles"));
}

TEST(MeshShapes, AreClosedLookOutwardsAndHaveTheirVolume) {
  EXPECT_NEAR(SignedVolume(BoxMesh({1, 2, 3})), 6.0, 1e-12);
  const double polygon = 0.5 * 32 * std::sin(2 * kPi / 32);  // area of the 32-gon of radius 1
  EXPECT_NEAR(SignedVolume(CylinderMesh(0.5, 2.0, 32)), polygon * 0.25 * 2.0, 1e-12);
  const double sphere = 4.0 / 3.0 * kPi;
  EXPECT_NEAR(SignedVolume(SphereMesh(1.0, 32)), sphere, 0.01 * sphere);
}

TEST(MeshShapes, MirroredScaleKeepsFacesOutwards) {
  EXPECT_NEAR(SignedVolume(Scaled(BoxMesh({1, 1, 1}), {-1, 2, 1})), 2.0, 1e-12);
}

TEST(MeshesHere, LookOutwardsAndAreSmall) {
  for (const char* name :
       {"axel/meshes/body", "axel/meshes/body_coaxial", "axel/meshes/camera_heads",
        "axel/meshes/camera_posts", "axel/meshes/arm", "axel/meshes/wheel", "axel/meshes/paddles",
        "axel/station/meshes/module", "axel/station/meshes/cone_face",
        "axel/station/meshes/stand"}) {
    const auto mesh = LoadMesh(SourceFile("models/" + std::string(name) + ".obj"));
    EXPECT_GT(SignedVolume(*mesh), 0.0) << name;
    EXPECT_LT(mesh->triangles.size(), 3000u) << name;
  }
}

TEST(MeshesHere, ConeIsSeenFromInside) {
  const auto cone = LoadMesh(SourceFile("models/axel/station/meshes/cone.obj"));
  for (const auto& t : cone->triangles) {
    const Eigen::Vector3d a = cone->vertices[t[0]], b = cone->vertices[t[1]],
                          c = cone->vertices[t[2]], normal = (b - a).cross(c - a);
    const Eigen::Vector3d axis_point((a.x() + b.x() + c.x()) / 3.0 + 0.05, 0, 0);
    EXPECT_GT(normal.dot(axis_point - a), 0.0);
  }
}

}  // namespace
}  // namespace dockyard
