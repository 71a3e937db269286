// Meshes with hollows as convex pieces, against volumes and against which points lie within.
#include "models/read/convex_pieces.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdio>

#include "models/read/mesh_loader.h"
#include "models/read/urdf.h"
#include "sim/rigid/convex_body.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

double Volume(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    sum += mesh.vertices[a].dot(mesh.vertices[b].cross(mesh.vertices[c])) / 6.0;
  }
  return sum;
}

double Volume(const ConvexBody& body) {
  return Volume(TriangleMesh{body.vertices, body.triangles});
}

/// A channel: 3 by 1 by 2 with a slot of 1 by 1 from above.
TriangleMesh Channel() {
  const Eigen::Vector2d outline[8] = {{0, 0}, {3, 0}, {3, 2}, {2, 2},
                                      {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  TriangleMesh mesh;
  for (const double y : {0.0, 1.0}) {
    for (const Eigen::Vector2d& p : outline) mesh.vertices.emplace_back(p.x(), y, p.y());
  }
  for (std::uint32_t i = 0; i < 8; ++i) {
    const std::uint32_t j = (i + 1) % 8;
    mesh.triangles.push_back({i, 8 + j, j});
    mesh.triangles.push_back({i, 8 + i, 8 + j});
  }
  for (const auto& [a, b, c] : std::vector<std::array<std::uint32_t, 3>>{
           {0, 1, 4}, {0, 4, 5}, {1, 2, 3}, {1, 3, 4}, {0, 5, 6}, {0, 6, 7}}) {
    mesh.triangles.push_back({a, b, c});
    mesh.triangles.push_back({8 + a, 8 + c, 8 + b});
  }
  return mesh;
}

/// A docking funnel: a ring about x whose inside narrows from 0.25 to 0.1 over 0.3.
TriangleMesh Funnel(std::uint32_t sides) {
  const Eigen::Vector2d outline[4] = {{0, 0.1}, {0, 0.3}, {0.3, 0.3}, {0.3, 0.25}};
  TriangleMesh mesh;
  for (std::uint32_t i = 0; i < sides; ++i) {
    const double angle = 2.0 * kPi * i / sides;
    for (const Eigen::Vector2d& p : outline) {
      mesh.vertices.emplace_back(p.x(), p.y() * std::cos(angle), p.y() * std::sin(angle));
    }
  }
  for (std::uint32_t i = 0; i < sides; ++i) {
    for (std::uint32_t k = 0; k < 4; ++k) {
      const std::uint32_t next = (i + 1) % sides;
      const std::uint32_t a = 4 * i + k, b = 4 * i + (k + 1) % 4, c = 4 * next + (k + 1) % 4,
                          d = 4 * next + k;
      mesh.triangles.push_back({a, c, b});
      mesh.triangles.push_back({a, d, c});
    }
  }
  return mesh;
}

/// By the solid angle of the surface from the point (van Oosterom and Strackee 1983).
bool IsWithin(const TriangleMesh& mesh, const Eigen::Vector3d& p) {
  double angle = 0.0;
  for (const auto& [i, j, k] : mesh.triangles) {
    const Eigen::Vector3d a = mesh.vertices[i] - p, b = mesh.vertices[j] - p,
                          c = mesh.vertices[k] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    angle += 2.0 * std::atan2(a.dot(b.cross(c)),
                              la * lb * lc + a.dot(b) * lc + b.dot(c) * la + a.dot(c) * lb);
  }
  return std::abs(angle) > 2.0 * kPi;
}

std::vector<ConvexBody> BodiesOf(const TriangleMesh& mesh) {
  std::vector<ConvexBody> bodies;
  for (const auto& piece : ConvexPieces(mesh)) bodies.push_back(HullOf(piece));
  return bodies;
}

TEST(ConvexPieces, OfAChannelAreItsThreeBoxes) {
  ASSERT_NEAR(std::abs(Volume(Channel())), 5.0, 1e-12);
  EXPECT_FALSE(IsConvex(Channel()));
  for (const bool mirrored : {false, true}) {
    TriangleMesh mesh = Channel();
    if (mirrored) {
      for (auto& [a, b, c] : mesh.triangles) std::swap(b, c);
    }
    const std::vector<ConvexBody> bodies = BodiesOf(mesh);
    ASSERT_EQ(bodies.size(), 3u);
    double sum = 0.0;
    for (const ConvexBody& body : bodies) {
      EXPECT_EQ(body.vertices.size(), 8u);
      sum += Volume(body);
    }
    EXPECT_NEAR(sum, 5.0, 1e-6);
  }
}

TEST(ConvexPieces, OfAFunnelFillItAndLeaveItsMouthOpen) {
  const TriangleMesh mesh = Funnel(32);
  EXPECT_FALSE(IsConvex(mesh));
  const std::vector<ConvexBody> bodies = BodiesOf(mesh);
  int within = 0, missed = 0, without = 0, filled = 0;
  // A grid over the box about it.
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 24; ++j) {
      for (int k = 0; k < 24; ++k) {
        const Eigen::Vector3d p(0.3 * (i + 0.5) / 12, 0.6 * (j + 0.5) / 24 - 0.3,
                                0.6 * (k + 0.5) / 24 - 0.3);
        const bool covered = std::any_of(bodies.begin(), bodies.end(), [&](const ConvexBody& body) {
          return DistanceTo(body, p).distance_m <= 0.0;
        });
        const bool solid = IsWithin(mesh, p);
        within += solid;
        missed += solid && !covered;
        without += !solid;
        filled += !solid && covered;
        // The cone's inside, less the hollow that may be filled.
        const double free_m = 0.1 + 0.5 * p.x() - kFilledHollow * 0.9;
        EXPECT_FALSE(covered && std::hypot(p.y(), p.z()) < free_m) << p.transpose();
      }
    }
  }
  std::printf("funnel: %zu pieces, of %d points within %d missed, of %d without %d filled\n",
              bodies.size(), within, missed, without, filled);
  EXPECT_LT(missed, within / 100);
  EXPECT_LT(filled, without / 20);
}

TEST(ConvexPieces, OfAConvexMeshAreOne) {
  for (const TriangleMesh& mesh :
       {BoxMesh({1.0, 2.0, 3.0}), CylinderMesh(0.5, 2.0), SphereMesh(1.0)}) {
    EXPECT_TRUE(IsConvex(mesh));
  }
  EXPECT_EQ(ConvexPieces(BoxMesh({1.0, 2.0, 3.0})).size(), 1u);
}

/// The file's collisions and warnings, of a robot with this mesh for its only link.
UrdfModel WithCollision(const TriangleMesh& mesh) {
  const ScratchFolder folder;
  std::string obj;
  for (const Eigen::Vector3d& p : mesh.vertices) {
    obj += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " " +
           std::to_string(p.z()) + "\n";
  }
  for (const auto& [a, b, c] : mesh.triangles) {
    obj += "f " + std::to_string(a + 1) + " " + std::to_string(b + 1) + " " +
           std::to_string(c + 1) + "\n";
  }
  folder.Write("m.obj", obj);
  return LoadUrdf(folder.Write("m.urdf",
                               "<robot name=\"m\"><link name=\"a\"><collision name=\"c\"><geometry>"
                               "<mesh filename=\"m.obj\"/></geometry></collision></link></robot>"));
}

TEST(ConvexPieces, AreTheCollisionsOfAUrdfsMesh) {
  const UrdfModel channel = WithCollision(Channel());
  ASSERT_EQ(channel.links[0].collisions.size(), 3u);
  for (const Collision& part : channel.links[0].collisions) EXPECT_EQ(part.name, "c");
  EXPECT_TRUE(channel.warnings.empty());
  EXPECT_EQ(WithCollision(BoxMesh({1.0, 1.0, 1.0})).links[0].collisions.size(), 1u);
}

TEST(ConvexPieces, OfAMeshOfTooManyTrianglesAreItsHullWithAWarning) {
  const UrdfModel fine = WithCollision(Funnel(80));
  EXPECT_EQ(fine.links[0].collisions.size(), 1u);
  ASSERT_EQ(fine.warnings.size(), 1u);
  EXPECT_THAT(fine.warnings[0],
              HasSubstr("a mesh with hollows and 640 triangles: its convex hull counts"));
}

TEST(ConvexPieces, AFlatMeshIsRefusedWithItsPlace) {
  const ScratchFolder folder;
  EXPECT_THAT(
      MessageOf(
          [] {
            WithCollision({{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}}, {{0, 1, 2}, {0, 2, 3}}});
          },
          folder),
      HasSubstr("collision: expected a mesh with a thickness"));
}

}  // namespace
}  // namespace dockyard
