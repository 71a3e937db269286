// The search for near parts, against every pair.
#include "sim/rigid/near_parts.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/base/random.h"

namespace dockyard {
namespace {

using Eigen::Vector3d;

constexpr double kWithin_m = 0.01;

ConvexBody DrawnBox(RandomStream& random) {
  std::vector<Vector3d> corners;
  const Vector3d half(random.Uniform(0.01, 0.2), random.Uniform(0.01, 0.2),
                      random.Uniform(0.01, 0.2));
  for (int i = 0; i < 8; ++i) {
    corners.push_back(
        half.cwiseProduct(Vector3d(i & 1 ? 1.0 : -1.0, i & 2 ? 1.0 : -1.0, i & 4 ? 1.0 : -1.0)));
  }
  return HullOf(corners);
}

// Two boxes are apart if a plane across one of 15 directions parts them (Gottschalk, Lin and
// Manocha 1996). The largest gap is no more than their distance.
double GapOf(const ConvexBody& a, const ConvexBody& b) {
  std::vector<Vector3d> directions;
  for (const ConvexBody* body : {&a, &b}) {
    for (const HalfSpace& face : body->faces) directions.push_back(face.normal);
  }
  const std::size_t faces = a.faces.size();
  for (std::size_t i = 0; i < faces; ++i) {
    for (std::size_t k = faces; k < 2 * faces; ++k) {
      const Vector3d across = directions[i].cross(directions[k]);
      if (across.norm() > 1e-9) directions.push_back(across.normalized());
    }
  }
  double most_m = -1.0;
  for (const Vector3d& n : directions) {
    double a_high = -1e9, b_low = 1e9;
    for (const Vector3d& p : a.vertices) a_high = std::max(a_high, n.dot(p));
    for (const Vector3d& p : b.vertices) b_low = std::min(b_low, n.dot(p));
    most_m = std::max(most_m, b_low - a_high);
  }
  return most_m;
}

// Boxes that drift and turn: a pair that touches is never missed, though few steps search.
TEST(NearParts, HasEveryPairThatTouchesWhileAllMove) {
  constexpr int kBoxes = 30, kSteps = 400;
  RandomStream random(7);
  NearParts near(kWithin_m);
  std::vector<ConvexBody> boxes;
  std::vector<Pose3> poses;
  std::vector<Vector3d> drift, turn;
  const auto Drawn = [&](double most) {
    return Vector3d(random.Uniform(-most, most), random.Uniform(-most, most),
                    random.Uniform(-most, most));
  };
  for (int i = 0; i < kBoxes; ++i) {
    boxes.push_back(DrawnBox(random));
    poses.push_back({RotZ(random.Uniform(-kPi, kPi)), Drawn(0.6)});
    drift.push_back(Drawn(5e-4));
    turn.push_back(Drawn(2e-3));
    near.Add(boxes.back(), poses.back(), {});
  }
  int touching = 0, extra = 0;
  for (int step = 0; step < kSteps; ++step) {
    for (int i = 0; i < kBoxes; ++i) {
      const auto at = static_cast<std::size_t>(i);
      poses[at].p += drift[at];
      poses[at].R = Eigen::AngleAxisd(turn[at].norm(), turn[at].normalized()) * poses[at].R;
      near.Place(i, poses[at]);
    }
    const std::vector<NearPair>& pairs = near.Find();
    for (int a = 0; a < kBoxes; ++a) {
      for (int b = a + 1; b < kBoxes; ++b) {
        const auto one = static_cast<std::size_t>(a), other = static_cast<std::size_t>(b);
        const double gap_m = GapOf(poses[one] * boxes[one], poses[other] * boxes[other]);
        const bool found = std::any_of(pairs.begin(), pairs.end(), [&](const NearPair& pair) {
          return pair.a == a && pair.b == b;
        });
        if (gap_m < 0.0) {
          ++touching;
          EXPECT_TRUE(found) << step << ": " << a << " and " << b;
        }
        extra += found && gap_m > 3.0 * kWithin_m;
      }
    }
  }
  EXPECT_GT(touching, 1000);
  EXPECT_EQ(extra, 0);
  EXPECT_LT(near.searches(), kSteps / 3);
}

TEST(NearParts, LeavesOutPairsThatAreNotToMeet) {
  NearParts near(kWithin_m);
  RandomStream random(1);
  const ConvexBody box = DrawnBox(random);
  near.Add(box, {}, {1, 2});
  near.Add(box, {}, {1, 2});
  near.Add(box, {}, {2, 1});
  near.Add(box, {}, {2, 4});  // would not meet the first two, which would meet it
  const std::vector<NearPair>& pairs = near.Find();
  ASSERT_EQ(pairs.size(), 2u);
  EXPECT_EQ(pairs[0].b, 2);
  EXPECT_EQ(pairs[1].a, 1);
}

}  // namespace
}  // namespace dockyard
