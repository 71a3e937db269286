// The mating's contacts against Bullet's on a cone of fine wedges, and a tip that enters the cone.
#include <gtest/gtest.h>

#include <BulletCollision/BroadphaseCollision/btDbvtBroadphase.h>
#include <BulletCollision/CollisionDispatch/btCollisionWorld.h>
#include <BulletCollision/CollisionDispatch/btDefaultCollisionConfiguration.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

#include "axel/sim/afloat.h"
#include "axel/sim/product.h"
#include "models/axel/mating_fit.h"
#include "sim/axel/cone_shapes.h"
#include "sim/axel/contact_world.h"
#include "sim/axel/tether_path.h"
#include "sim/base/random.h"
#include "sim/rigid/bullet_math.h"

namespace dockyard::axel {
namespace {

/// The cone as convex wedges, each one sector of face, funnel and socket: the material outside
/// funnel and socket is convex in every axial cut. The polygon's middle radius is the model's.
void AddWedges(const ConeModel& cone, int count, double margin_m, LinkShape& shape) {
  const double half_angle = kPi / count;
  const double to_facet = 2.0 * std::cos(half_angle) / (1.0 + std::cos(half_angle));
  const double mouth = cone.mouth_radius_m * to_facet, throat = cone.throat_radius_m * to_facet;
  const std::array<Eigen::Vector2d, 5> cut = {{{0.0, mouth},
                                               {-cone.funnel_length_m, throat},
                                               {-cone.socket_end_m, throat},
                                               {-cone.socket_end_m, cone.face_outer_radius_m},
                                               {0.0, cone.face_outer_radius_m}}};
  for (int k = 0; k < count; ++k) {
    const double azimuth = (2 * k + 1) * half_angle;
    const Eigen::Vector3d out(0.0, std::sin(azimuth), std::cos(azimuth));
    const Eigen::Vector3d side(0.0, std::cos(azimuth), -std::sin(azimuth));
    std::vector<Eigen::Vector3d> corners;
    for (const Eigen::Vector2d& c : cut) {
      const double width = c.y() * std::tan(half_angle) + margin_m;
      const Eigen::Vector3d middle = c.x() * Eigen::Vector3d::UnitX() + c.y() * out;
      corners.push_back(middle - width * side);
      corners.push_back(middle + width * side);
    }
    shape.Add({"wedge", HullShape{corners}, Pose3{}}, Pose3{});
  }
}

/// Bullet's distance between the arm and the wedges.
class WedgeQuery {
 public:
  WedgeQuery(const ConeModel& cone, int wedges, const std::vector<Collision>& arm_parts) {
    AddWedges(cone, wedges, 2e-4, cone_shape_);
    for (int i = 0; i < cone_shape_.pieces(); ++i) {
      cone_shape_.compound()->getChildShape(i)->setMargin(0.0);
    }
    for (const Collision& part : arm_parts) arm_shape_.Add(part, Pose3{});
    cone_.setCollisionShape(cone_shape_.compound());
    arm_.setCollisionShape(arm_shape_.compound());
  }

  double Distance(const Pose3& X_MA) {
    arm_.setWorldTransform(ToBullet(X_MA));
    ClosestPoint found;
    found.m_closestDistanceThreshold = 0.01;
    world_.contactPairTest(&cone_, &arm_, found);
    return found.distance;
  }

 private:
  struct ClosestPoint : btCollisionWorld::ContactResultCallback {
    double distance = 1.0;
    btScalar addSingleResult(btManifoldPoint& point, const btCollisionObjectWrapper*, int, int,
                             const btCollisionObjectWrapper*, int, int) override {
      distance = std::min(distance, double{point.getDistance()});
      return 0.0;
    }
  };
  LinkShape cone_shape_, arm_shape_;
  btCollisionObject cone_, arm_;
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_{&configuration_};
  btDbvtBroadphase broadphase_;
  btCollisionWorld world_{&dispatcher_, &broadphase_, &configuration_};
};

double LeastGap(const Mating& mating, const Pose3& X_MA, double within_m = 0.02) {
  std::vector<BoreContact> contacts;
  mating.Find(X_MA, within_m, contacts);
  double least = 1.0;
  for (const BoreContact& contact : contacts) least = std::min(least, contact.gap_m);
  return least;
}

TEST(Mating, GapsAreThoseOfAConeOfFineWedges) {
  ConeModel cone = Station().cone;
  cone.stop_depth_m = 0.0;
  const std::vector<Collision> arm = ArmCollisions(Axel());
  const Mating mating(cone, arm);
  constexpr int kWedges = 192;
  WedgeQuery wedges(cone, kWedges, arm);
  // The polygon's sagitta where it is widest, half on either side.
  const double polygon = 0.5 * cone.face_outer_radius_m * (1.0 - std::cos(kPi / kWedges));
  RandomStream random(11);
  int compared = 0;
  int nearer = 0;
  double farthest = 0.0;
  for (int i = 0; i < 4000; ++i) {
    // The arm towards the cone, its tip somewhere in it, moved aside until it nearly touches.
    const Eigen::Matrix3d R = RotZ(kPi) * RotX(random.Uniform(-kPi, kPi)) *
                              RotY(random.Uniform(-0.35, 0.35)) * RotX(random.Uniform(-kPi, kPi));
    const double depth = random.Uniform(-0.005, 0.26), turn = random.Uniform(-kPi, kPi);
    const double wanted = random.Uniform(-0.2e-3, 0.4e-3);
    const auto At = [&](double aside_m) {
      const Eigen::Vector3d tip(-depth, aside_m * std::cos(turn), aside_m * std::sin(turn));
      return Pose3{R, tip - R.col(0)};
    };
    double low = -0.2, high = 0.2;  // the gap falls from one to the other
    if (LeastGap(mating, At(0.0)) < wanted) continue;
    low = 0.0;
    for (int k = 0; k < 40; ++k) {
      const double middle = 0.5 * (low + high);
      (LeastGap(mating, At(middle)) > wanted ? low : high) = middle;
    }
    const double gap = LeastGap(mating, At(low));
    if (std::abs(gap - wanted) > 1e-6) continue;
    ++compared;
    const double error = wedges.Distance(At(low)) - gap;
    farthest = std::min(farthest, error);
    nearer += error > polygon + 2e-5 ? 1 : 0;
  }
  std::printf("%d arms: farther than Bullet by %.4f mm (polygon %.4f), nearer in %d\n", compared,
              -1e3 * farthest, 1e3 * polygon, nearer);
  EXPECT_GT(compared, 500);
  EXPECT_GT(farthest, -(polygon + 2e-5));  // no contact is missed
  // Ours is the distance of two points of the bodies, so a longer one is Bullet's error: at edges
  // GJK ends up to 0.12 mm early.
  EXPECT_LT(nearer, 0.03 * compared);
}

TEST(Mating, BallInTheFunnelIsAsFarFromItAsTheLineSays) {
  const ConeModel cone = Station().cone;
  const double ball = 0.02;
  const Mating mating(cone, {{"ball", SphereShape{ball}, Pose3::Translation(1.0, 0.0, 0.0)}});
  const double rise = cone.mouth_radius_m - cone.throat_radius_m, run = cone.funnel_length_m;
  for (double aside : {0.0, 0.01, 0.04}) {
    const Eigen::Vector3d centre(-0.06, 0.0, aside);
    const Pose3 X_MA{RotZ(kPi), centre + Eigen::Vector3d(1.0, 0.0, 0.0)};
    const double to_wall =
        ((cone.mouth_radius_m - aside) * run + centre.x() * rise) / std::hypot(rise, run);
    EXPECT_NEAR(LeastGap(mating, X_MA, 0.1), to_wall - ball, 1e-12) << aside;
  }
}

TEST(Mating, BoxOnTheAxisIsNearestWithItsInnerCorners) {
  const ConeModel cone = Station().cone;
  const double half = 0.01, e = kCollisionMargin_m;  // edges are rounded
  const Mating mating(cone, {{"box", BoxShape{{2 * half, 2 * half, 2 * half}}, Pose3{}}});
  const double rise = cone.mouth_radius_m - cone.throat_radius_m, run = cone.funnel_length_m;
  const double across = std::sqrt(2.0) * (half - e), x = -0.06 - (half - e);
  const double to_wall = ((cone.mouth_radius_m - across) * run + x * rise) / std::hypot(rise, run);
  EXPECT_NEAR(LeastGap(mating, Pose3::Translation(-0.06, 0.0, 0.0), 0.1), to_wall - e, 1e-12);
}

/// Largest tilt of a disc and a collar in a tube: with the tip's disc at its far wall and the
/// collar at the near one, play = length x sin(tilt) + diameter x (cos(tilt) - 1), to first order.
TEST(Mating, SeatedArmTiltsByItsPlayOverItsLength) {
  ConeModel cone = Station().cone;
  cone.stop_depth_m = 0.0;
  const RoverModel rover = Axel();
  const Mating mating(cone, ArmCollisions(rover));
  const double r = rover.tip.radius_m, R = cone.throat_radius_m;
  // Contacts: the front rim of the disc, the rear rim of the collar's cylinder.
  const double rear = rover.collar.front_m - rover.collar.lead_in_m - rover.collar.length_m;
  const double edge = kCollisionMargin_m;  // edges are rounded
  const double length = rover.arm_length_m - rear - 2.0 * edge;
  const auto Gap = [&](double tilt) {
    // Turned about the middle between the two.
    const Eigen::Matrix3d turn = RotZ(kPi) * RotY(tilt);
    const Eigen::Vector3d middle(-0.26 + 0.5 * (rover.arm_length_m - rear), 0.0, 0.0);
    return LeastGap(
        mating,
        {turn, middle - turn * Eigen::Vector3d(0.5 * (rover.arm_length_m + rear), 0.0, 0.0)});
  };
  double low = 0.0, high = 0.1;
  for (int i = 0; i < 50; ++i) (Gap(0.5 * (low + high)) > 0.0 ? low : high) = 0.5 * (low + high);
  // 2 (r - e) cos + length sin + 2 e = 2 R, e the rounding.
  const double closed = 2.0 * (r - edge) * std::cos(low) + length * std::sin(low) + 2.0 * edge;
  EXPECT_NEAR(closed, 2.0 * R, 2e-8);
  EXPECT_NEAR(Degrees(low), Degrees(2.0 * (R - r) / length), 0.03);
}

/// Largest gap that the arm, its tip at the floor and turned by this much, can have in the socket.
double WidestGap(const Mating& mating, double depth_m, double turn_rad) {
  double widest = -1.0;
  for (double aside_m = -0.003; aside_m <= 0.003; aside_m += 1e-5) {
    const Pose3 X_tip{Eigen::Matrix3d(RotZ(kPi + turn_rad)), {-depth_m, aside_m, 0.0}};
    const Pose3 X_MA = X_tip * Pose3{Eigen::Matrix3d::Identity(), {-1.0, 0.0, 0.0}};
    widest = std::max(widest, LeastGap(mating, X_MA, 0.002));
  }
  return widest;
}

TEST(Mating, SeatedArmTurnsByItsPlayBeforeTheContactsMeet) {
  ConeModel cone = Station().cone;
  const double depth_m = cone.stop_depth_m, play_rad = SeatedPlay(Axel(), cone);
  cone.stop_depth_m = 0.0;  // the floor's own contacts are none of the play
  const Mating mating(cone, ArmCollisions(Axel()));
  EXPECT_GT(WidestGap(mating, depth_m, 0.97 * play_rad), 0.0);
  EXPECT_LT(WidestGap(mating, depth_m, 1.03 * play_rad), 0.0);
}

/// The motion of a tip that is drawn into the funnel from 10 cm aside and 10 deg askew: an arm on a
/// floating rover, pulled by its tether alone.
struct Entered {
  double time_s = 0.0, lateral_m = 0.0, depth_m = 0.0;
  double peak_n = 0.0;  // of the force in the cone
};
Entered DrawIn(double step_s, double damping_ns_per_m) {
  StationModel model = Station();
  model.cone.contact_damping_ns_per_m = damping_ns_per_m;
  model.module.mass_kg = 1e6;  // stands fast
  model.module.I_LCom_L = 1e6 * Eigen::Matrix3d::Identity();
  const Pose3 X_GM = MouthInStation(model);
  // The tip 0.15 m before the mouth, 10 cm aside; the arm along the axis but for 10 deg of yaw.
  const Eigen::Matrix3d R = X_GM.R * RotZ(kPi - Radians(10.0));
  const Eigen::Vector3d tip = X_GM * Eigen::Vector3d(0.15, 0.1, 0.0);
  Afloat world(Axel(), model, kWeightless, {R, tip - R * Eigen::Vector3d(1.0, 0.0, 0.0)}, 0.0);
  RoverBody& rover = world.rover;
  Entered entered;
  for (long i = 0; i < std::lround(8.0 / step_s); ++i) {
    // The joints held, the body slowed as by soil: 400 N s/m, 300 Nm s.
    const LinkMotion& body = rover.motion(RoverLink::kBody);
    rover.AddForce(RoverLink::kBody, -400.0 * body.v_GL_G, body.X_GL.p);
    rover.AddTorque(RoverLink::kBody, -300.0 * body.w_GL_G);
    for (int joint = 1; joint < 4; ++joint) {
      const RoverLink link = static_cast<RoverLink>(joint);
      rover.AddJointTorque(link, -2e4 * rover.joint_rad(link) - 200.0 * rover.joint_rad_s(link));
    }
    const LinkMotion& arm = rover.motion(RoverLink::kArm);
    const Eigen::Vector3d tip_G = arm.X_GL * Eigen::Vector3d(1.0, 0.0, 0.0);
    const Eigen::Vector3d p_MT = X_GM.R.transpose() * (tip_G - X_GM.p);
    const TetherPath path = FindTetherPath(model.cone, model.anchor_depth_m,
                                           {p_MT.x(), std::hypot(p_MT.y(), p_MT.z())});
    const Eigen::Vector3d aside(0.0, p_MT.y(), p_MT.z());
    const Eigen::Vector3d next_M = path.nodes[1].x() * Eigen::Vector3d::UnitX() +
                                   path.nodes[1].y() * aside / std::max(1e-9, aside.norm());
    rover.AddForce(RoverLink::kArm, 60.0 * (X_GM * next_M - tip_G).normalized(), tip_G);
    world.contacts.Step(step_s);
    const double force_n = world.contacts.arm_contact().total_G.norm();
    entered.peak_n = std::max(entered.peak_n, force_n);
    if (entered.time_s == 0.0 && p_MT.x() < -0.2) entered.time_s = i * step_s;
    entered.depth_m = -p_MT.x();
    entered.lateral_m = aside.norm();
  }
  std::printf("drawn in at %.2f ms, %.0f N s/m: %.4f s, depth %.4f m, aside %.3f mm, peak %.1f N\n",
              1e3 * step_s, damping_ns_per_m, entered.time_s, entered.depth_m,
              1e3 * entered.lateral_m, entered.peak_n);
  return entered;
}

/// Differences from the finest of three halved steps go with the step, (4 - 1) / (2 - 1), or
/// faster, and are at most so large at the middle one.
void ExpectConverging(const std::array<Entered, 3>& runs, double Entered::*what, double most) {
  const double middle = std::abs(runs[1].*what - runs[2].*what);
  EXPECT_LT(middle, most);
  EXPECT_LT(middle, std::abs(runs[0].*what - runs[2].*what) / 2.5);
}

std::array<Entered, 3> DrawInAt(const std::array<double, 3>& steps_s, double damping_ns_per_m) {
  return {DrawIn(steps_s[0], damping_ns_per_m), DrawIn(steps_s[1], damping_ns_per_m),
          DrawIn(steps_s[2], damping_ns_per_m)};
}

TEST(Cone, TipTenCentimetresAsideAndTenDegreesAskewEntersAlikeAtEveryStep) {
  const ConeModel cone = Station().cone;
  for (double of_damping : {1.0, 0.5}) {
    const std::array runs =
        DrawInAt({2e-3, 1e-3, 0.5e-3}, of_damping * cone.contact_damping_ns_per_m);
    for (const Entered& entered : runs) {
      EXPECT_GT(entered.depth_m, cone.stop_depth_m);  // on the socket's floor
      // The disc's clearance of 0.8 mm, and what the arm's slant in the socket and the pull add.
      EXPECT_LT(entered.lateral_m, 1e-3);
      EXPECT_NEAR(entered.time_s, runs[2].time_s, 0.006 * runs[2].time_s);
      EXPECT_NEAR(entered.depth_m, runs[2].depth_m, 3e-5);
    }
    ExpectConverging(runs, &Entered::lateral_m, 1e-5);
  }
}

TEST(Cone, BlowOfTheCollarsLeadInConvergesWithTheStep) {
  // It lasts as long as the damping over the stiffness, some milliseconds, so that it takes finer
  // steps than the way of the arm does: at 1 ms its peak is a quarter too low.
  const double damping = Station().cone.contact_damping_ns_per_m;
  const std::array fine = DrawInAt({0.5e-3, 0.25e-3, 0.125e-3}, damping);
  ExpectConverging(fine, &Entered::peak_n, 0.03 * fine[2].peak_n);
  EXPECT_NEAR(DrawIn(1e-3, damping).peak_n, fine[2].peak_n, 0.25 * fine[2].peak_n);
}

}  // namespace
}  // namespace dockyard::axel
