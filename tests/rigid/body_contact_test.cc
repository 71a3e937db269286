// Cylinders, edges and wheels in a convex body: depths and normals against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "sim/base/random.h"
#include "sim/rigid/body_contact.h"
#include "sim/rigid/rocks.h"
#include "sim/vehicles/wheel_contact.h"

namespace dockyard {
namespace {

using Contacts = std::vector<BodyContact>;

/// A block whose top is z = 0 and whose front is x = 0, behind which it lies.
ConvexBody Block(double length_m = 1.0, double width_m = 1.0, double depth_m = 0.3) {
  std::vector<Eigen::Vector3d> points;
  for (int i = 0; i < 8; ++i) {
    points.emplace_back(i & 1 ? length_m : 0.0, (i & 2 ? 0.5 : -0.5) * width_m,
                        i & 4 ? 0.0 : -depth_m);
  }
  return HullOf(points);
}

Eigen::Vector3d Sum(const Contacts& contacts) {
  Eigen::Vector3d sum(0, 0, 0);
  for (const BodyContact& c : contacts) sum += c.share * c.depth_m * c.normal;
  return sum;
}

Contacts OfCylinder(const ConvexBody& body, const Cylinder& cylinder) {
  Contacts contacts;
  AddCylinderContacts(body, cylinder, 0, contacts);
  return contacts;
}

TEST(CylinderContact, LyingOnAFlatIsTwoHalvesOfOneDepth) {
  const Contacts contacts = OfCylinder(Block(), {{0.5, 0.0, 0.249}, {0, 1, 0}, 0.25, 0.1});
  ASSERT_EQ(contacts.size(), 2u);
  for (const BodyContact& c : contacts) {
    EXPECT_NEAR(c.depth_m, 0.001, 1e-9);
    EXPECT_LT((c.normal - Eigen::Vector3d::UnitZ()).norm(), 1e-6);
    EXPECT_EQ(c.share, 0.5);
    EXPECT_NEAR(std::abs(c.p.y()), 0.1 / std::sqrt(3.0), 1e-5);
  }
}

TEST(CylinderContact, AgainstAnEdgeIsPushedThroughItsAxis) {
  // The axle 0.2 before the block and 0.15 above its top: 0.25 from the edge.
  const Contacts contacts = OfCylinder(Block(), {{-0.2, 0.0, 0.15}, {0, 1, 0}, 0.252, 0.1});
  ASSERT_EQ(contacts.size(), 2u);
  EXPECT_NEAR(contacts[0].depth_m, 0.002, 1e-9);
  EXPECT_LT((contacts[0].normal - Eigen::Vector3d(-0.8, 0.0, 0.6)).norm(), 1e-6);
}

TEST(CylinderContact, OnATiltedFacetIsPushedSquareToIt) {
  // The facet tilts about x: the cylinder meets it with the edge of its lower side.
  const double tilt = 0.3, half = 0.1, radius = 0.25, depth = 1e-3;
  const ConvexBody facet = Pose3{RotX(tilt), Eigen::Vector3d(-0.5, 0, 0)} * Block();
  const Eigen::Vector3d normal = RotX(tilt) * Eigen::Vector3d::UnitZ();
  // The cylinder's lowest point along the normal is at depth: its edge at y = +half.
  const double low = -std::cos(tilt) * radius - std::sin(tilt) * half;
  const Eigen::Vector3d centre = (-low - depth) * normal;
  const Contacts contacts = OfCylinder(facet, {centre, {0, 1, 0}, radius, half});
  ASSERT_GE(contacts.size(), 1u);
  for (const BodyContact& c : contacts) {
    EXPECT_LT((c.normal - normal).norm(), 2e-3);
    EXPECT_LT(c.depth_m, depth);
  }
  const Eigen::Vector3d sum = Sum(contacts);
  EXPECT_NEAR(sum.norm(), 0.5 * depth, 0.02 * depth);  // the mean of a wedge
}

TEST(CylinderContact, EndOnIsPushedBackAlongItsAxis) {
  const Contacts contacts =
      OfCylinder(Block(1.0, 1.0, 1.0), {{-0.499, 0.1, -0.3}, {1, 0, 0}, 0.03, 0.5});
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].depth_m, 0.001, 1e-9);
  EXPECT_LT((contacts[0].normal + Eigen::Vector3d::UnitX()).norm(), 1e-9);
}

TEST(CylinderContact, HasNoJumpAsItTurnsFromALineToAnEnd) {
  // Lowered to the same mean depth at every tilt, the force goes on without a jump.
  double last = 0.0;
  for (int i = -200; i <= 200; ++i) {
    const double tilt = 1e-4 * i;
    const Contacts contacts =
        OfCylinder(Block(), {{0.5, 0.0, 0.2495}, {0, std::cos(tilt), std::sin(tilt)}, 0.25, 0.1});
    const double force = Sum(contacts).z();
    if (i > -200) {
      EXPECT_NEAR(force, last, 2e-5) << tilt;
    }
    last = force;
  }
}

TEST(CylinderContact, DepthIsItsDistanceFromARocksSurface) {
  // Against a search over the rock's surface within the cylinder's length.
  int met = 0;
  for (std::uint64_t key = 1; key <= 60; ++key) {
    RandomStream random(key);
    const ConvexBody rock = RockShape({0.2, 0.09}, 0.3, 0.1, key);
    const Cylinder rim{
        {random.Uniform(-0.1, 0.1), random.Uniform(-0.05, 0.05), 0.345}, {0, 1, 0}, 0.265, 0.075};
    double nearest = 1e9;
    for (const auto& t : rock.triangles) {
      for (int i = 0; i <= 60; ++i) {
        for (int j = 0; i + j <= 60; ++j) {
          const Eigen::Vector3d p = (i * rock.vertices[t[0]] + j * rock.vertices[t[1]] +
                                     (60 - i - j) * rock.vertices[t[2]]) /
                                    60.0;
          if (std::abs(p.y() - rim.centre.y()) > rim.half_m) continue;
          nearest = std::min(nearest, std::hypot(p.x() - rim.centre.x(), p.z() - rim.centre.z()));
        }
      }
    }
    const Contacts contacts = OfCylinder(rock, rim);
    if (nearest > rim.radius_m) continue;
    ++met;
    double depth = 0.0;
    for (const BodyContact& c : contacts) depth = std::max(depth, c.depth_m);
    // Gauss's points are off the deepest by a fifth of the length at most.
    EXPECT_LE(depth, rim.radius_m - nearest + 1e-5);
    EXPECT_GT(depth, 0.3 * (rim.radius_m - nearest));
  }
  EXPECT_GT(met, 20);
}

WheelModel Wheel(int paddles) {
  WheelModel wheel{.rim_radius_m = 0.265, .width_m = 0.15};
  wheel.paddle_count = paddles;
  wheel.paddle_height_m = 0.035;
  wheel.paddle_thickness_m = 0.01;
  return wheel;
}

Contacts OfWheel(const ConvexBody& body, const WheelModel& wheel, const Pose3& X_AK) {
  Contacts contacts;
  AddWheelContacts(body, wheel, X_AK, contacts);
  return contacts;
}

TEST(WheelContact, StandsOnAPaddleWithBothOfItsEdges) {
  const Contacts contacts =
      OfWheel(Block(), Wheel(12), {RotY(0.5 * kPi), Eigen::Vector3d(0.5, 0.0, 0.299)});
  ASSERT_EQ(contacts.size(), 4u);
  for (const BodyContact& c : contacts) {
    EXPECT_NEAR(c.depth_m, 0.001, 1e-12);
    EXPECT_EQ(c.normal, Eigen::Vector3d::UnitZ());
    EXPECT_NEAR(std::abs(c.p.x() - 0.5), 0.005, 1e-12);
  }
}

TEST(WheelContact, BetweenTwoPaddlesStandsOnBothOfThem) {
  const double lowest = 0.3 * std::cos(kPi / 12) + 0.005 * std::sin(kPi / 12);
  const Contacts contacts = OfWheel(
      Block(), Wheel(12), {RotY(0.5 * kPi + kPi / 12), Eigen::Vector3d(0.5, 0.0, lowest - 0.001)});
  ASSERT_EQ(contacts.size(), 4u);
  for (const BodyContact& c : contacts) EXPECT_NEAR(c.depth_m, 0.001, 1e-12);
}

TEST(WheelContact, APaddlesFaceHooksOnAnEdge) {
  const ConvexBody block = Block(1.0, 1.0, 0.02);
  // A paddle that points up and ahead, over the front edge of a slab, as on the way down on to it.
  const double angle = Radians(-30.0);
  // The edge is 0.28 from the axle and 1 mm within the paddle's leading face.
  const Eigen::Vector3d out(std::cos(angle), 0.0, -std::sin(angle));
  const Eigen::Vector3d down(-std::sin(angle), 0.0, -std::cos(angle));  // forward turning
  const Eigen::Vector3d axle = -0.28 * out - (0.005 - 0.001) * down;
  WheelModel wheel = Wheel(12);
  wheel.phase_rad = angle;
  const Contacts contacts = OfWheel(block, wheel, {Eigen::Matrix3d::Identity(), axle});
  double hooked = 0.0;
  for (const BodyContact& c : contacts) {
    EXPECT_NEAR(c.depth_m, 0.001, 1e-9);
    EXPECT_LT((c.normal + down).norm(), 1e-6);
    hooked += c.share;
  }
  EXPECT_NEAR(hooked, 1.0, 1e-9);
}

TEST(WheelContact, APebbleAmidTheWidthIsNotMissed) {
  // A pebble of 2 cm width anywhere under a paddle or a paddle's face.
  for (int i = 0; i <= 20; ++i) {
    const double y = -0.07 + 0.007 * i;
    const ConvexBody pebble =
        Pose3{Eigen::Matrix3d::Identity(), Eigen::Vector3d(-0.01, y, 0.02)} * Block(0.02, 0.02);
    const Contacts contacts =
        OfWheel(pebble, Wheel(12), {RotY(0.5 * kPi), Eigen::Vector3d(0.0, 0.0, 0.319)});
    EXPECT_NEAR(Sum(contacts).z(), 2e-3, 1e-9);  // both edges of the paddle
  }
}

TEST(WheelContact, IsTheSameOnAMirroredRock) {
  for (std::uint64_t key = 1; key <= 20; ++key) {
    const ConvexBody rock = RockShape({0.2, 0.08}, 0.3, 0.1, key);
    ConvexBody mirrored = rock;
    for (Eigen::Vector3d& p : mirrored.vertices) p.y() = -p.y();
    mirrored = HullOf(mirrored.vertices);
    const Pose3 X_AK{RotZ(0.2) * RotY(0.3 * static_cast<double>(key)),
                     Eigen::Vector3d(0.02, 0.01, 0.36)};
    const Pose3 X_AM{RotZ(-0.2) * RotY(0.3 * static_cast<double>(key)),
                     Eigen::Vector3d(0.02, -0.01, 0.36)};
    const Eigen::Vector3d a = Sum(OfWheel(rock, Wheel(12), X_AK));
    const Eigen::Vector3d b = Sum(OfWheel(mirrored, Wheel(12), X_AM));
    EXPECT_NEAR(a.x(), b.x(), 1e-6);
    EXPECT_NEAR(a.y(), -b.y(), 1e-6);
    EXPECT_NEAR(a.z(), b.z(), 1e-6);
  }
}

TEST(HullContact, CornerOnAFaceAndEdgeAcrossAnEdge) {
  const ConvexBody block = Block();
  const ConvexBody corner =
      Pose3{RotX(0.6) * RotY(0.7), Eigen::Vector3d(0.5, 0.0, 0.0)} * Block(0.1, 0.1, 0.1);
  double lowest = 1e9;
  for (const Eigen::Vector3d& p : corner.vertices) lowest = std::min(lowest, p.z());
  const ConvexBody part = Pose3::Translation(0.0, 0.0, -lowest - 0.002) * corner;
  Contacts contacts;
  AddHullContacts(block, part, 0, contacts);
  ASSERT_FALSE(contacts.empty());
  for (const BodyContact& c : contacts) {
    EXPECT_NEAR(c.depth_m, 0.002, 1e-12);
    EXPECT_LT((c.normal - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
  }
}

// A corner goes through a plate of 10 mm from above.
TEST(HullContact, CornerIsPushedBackOutOfAPlateBeyondItsMiddle) {
  const ConvexBody plate = Block(0.4, 0.4, 0.01);
  const ConvexBody tipped = Pose3{RotX(0.6) * RotY(0.7), {0.0, 0.0, 0.0}} * Block(0.1, 0.1, 0.1);
  double lowest = 1e9;
  for (const Eigen::Vector3d& p : tipped.vertices) lowest = std::min(lowest, p.z());
  for (const double depth_m : {0.002, 0.0049, 0.0051, 0.008}) {
    const ConvexBody part = Pose3::Translation(0.0, 0.0, -depth_m - lowest) * tipped;
    Contacts contacts;
    AddHullContacts(plate, part, 0, contacts);
    ASSERT_EQ(contacts.size(), 3u) << depth_m;  // the corner of three edges
    for (const BodyContact& c : contacts) {
      EXPECT_NEAR(c.depth_m, depth_m, 1e-12);
      EXPECT_LT((c.normal - Eigen::Vector3d::UnitZ()).norm(), 1e-12);
    }
    Contacts other;
    AddHullContacts(part, plate, 0, other);
    EXPECT_EQ(other.size(), 3u) << depth_m;
    for (const BodyContact& c : other) {
      EXPECT_NEAR(c.depth_m, depth_m, 1e-12);
      EXPECT_LT((c.normal + Eigen::Vector3d::UnitZ()).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace dockyard
