// A cable with mass against closed forms: catenary, drag on flat ground, Hooke's law, momentum.
#include "sim/cable/cable.h"

#include <gtest/gtest.h>

#include "cable/cords.h"

namespace dockyard {
namespace {

/// An elastic catenary between level supports (Irvine, Cable Structures, 1981, 1.4): unstretched
/// length, sag and end tension at a horizontal tension.
struct Catenary {
  double rest_m = 0.0, sag_m = 0.0, end_n = 0.0;
};
Catenary ElasticCatenary(const CableModel& cable, double span_m, double horizontal_n) {
  const double w = cable.mass_kg_per_m * kG, a = horizontal_n / w;
  double low = 0.5 * span_m, high = 2.0 * span_m;
  for (int i = 0; i < 100; ++i) {
    const double rest = 0.5 * (low + high);
    const double spans =
        horizontal_n * rest / cable.axial_stiffness_n + 2.0 * a * std::asinh(0.5 * rest / a);
    (spans < span_m ? low : high) = rest;
  }
  const double x = 0.5 * low / a;
  return {low, w * low * low / (8.0 * cable.axial_stiffness_n) + a * (std::hypot(1.0, x) - 1.0),
          std::hypot(horizontal_n, 0.5 * w * low)};
}

/// Hung between two level points with the unstretched length of that catenary, until at rest.
struct Hung {
  double sag_m = 0.0, end_n = 0.0;
};
Hung HangBetween(double span_m, double rest_m, double step_s) {
  const CableModel model = Cord();
  const Eigen::Vector3d from(0.0, 0.0, 2.0), to(span_m, 0.0, 2.0);
  const double piece = model.spacing_m;
  Cable cable(model);
  cable.LayOut(from, to - Eigen::Vector3d(piece, 0.0, 0.0), 48);
  const FixedCableEnd end(model, to, piece);
  CableStep step;
  step.step_s = step_s;
  step.gravity_G = kDown;
  step.p_GF = from;
  step.end = &end;
  step.end_rest_m = piece;
  const double feed = rest_m - piece - cable.rest_m();
  const int steps = static_cast<int>(40.0 / step_s), feeding = static_cast<int>(2.0 / step_s);
  for (int i = 0; i < steps; ++i) {
    step.fed_m = i < feeding ? feed / feeding : 0.0;
    cable.Step(step);
  }
  Hung hung;
  for (int i = 0; i < cable.masses(); ++i)
    hung.sag_m = std::max(hung.sag_m, 2.0 - cable.p_G(i).z());
  hung.end_n = cable.force_on_fed_end_G().norm();
  return hung;
}

TEST(Cable, HangsAsACatenaryFromTwoToAHundredNewtons) {
  for (const double horizontal : {2.0, 10.0, 100.0}) {
    const Catenary wanted = ElasticCatenary(Cord(), 4.0, horizontal);
    const Hung hung = HangBetween(4.0, wanted.rest_m, 2e-3);
    RecordProperty("end_n_" + std::to_string(static_cast<int>(horizontal)),
                   std::to_string(hung.end_n));
    EXPECT_NEAR(hung.end_n, wanted.end_n, 1e-3 * wanted.end_n) << horizontal;
    EXPECT_NEAR(hung.sag_m, wanted.sag_m, 1e-3 * wanted.sag_m) << horizontal;
  }
}

TEST(Cable, TakesFrictionTimesItsWeightToBeDraggedOverFlatGround) {
  const CableModel model = Cord();
  const HeightGrid ground = LevelGrid(-1.0, 6.0, 2.0, 0.05);
  const double height = 0.5 * model.diameter_m, length = 3.0;
  const int masses = 40;
  Cable cable(model);
  cable.LayOut({3.0, 0.0, height}, {0.0, 0.0, height}, masses);
  CableStep step;
  step.gravity_G = kDown;
  step.ground = &ground;
  step.p_GF = {3.0, 0.0, height};
  step.v_GF_G = {0.05, 0.0, 0.0};
  step.end = &kLoose;
  // Half of the first segment rides on the hand that drags; the air takes 0.5 1/s of the momentum.
  const double moved_kg = model.mass_kg_per_m * (length - 0.5 * length / masses);
  const double wanted = moved_kg * (model.friction_on_ground * kG + 0.5 * 0.05);
  for (int i = 0; i < 8000; ++i) {
    cable.Step(step);
    step.p_GF += step.step_s * step.v_GF_G;
    if (i < 4000) continue;
    EXPECT_NEAR(cable.tension_at_fed_end_n(), wanted, 1e-3 * wanted);
  }
}

TEST(Cable, LiesStillUnderAPullThatFrictionHolds) {
  const CableModel model = Cord();
  const HeightGrid ground = LevelGrid(-1.0, 6.0, 2.0, 0.05);
  const double height = 0.5 * model.diameter_m;
  Cable cable(model);
  cable.LayOut({3.0, 0.0, height}, {0.0, 0.0, height}, 40);
  const ConstantEnd pull({-0.5, 0.0, 0.0});  // of 0.74 N that friction holds
  CableStep step;
  step.gravity_G = kDown;
  step.ground = &ground;
  step.p_GF = {3.0, 0.0, height};
  step.end = &pull;
  for (int i = 0; i < 2000; ++i) cable.Step(step);
  const Eigen::Vector3d before = cable.p_G(39);
  for (int i = 0; i < 5000; ++i) cable.Step(step);
  EXPECT_LT((cable.p_G(39) - before).norm(), 1e-9);
  EXPECT_LT(cable.tension_at_fed_end_n(), 0.01);  // the pull is gone before the fed end
}

TEST(Cable, StretchesUnderAHungLoadByHookesLaw) {
  const CableModel model = Cord();
  const ConstantEnd load({0.0, 0.0, -300.0});
  Cable cable(model);
  cable.LayOut({0, 0, 4}, {0, 0, 1}, 40);
  CableStep step;
  step.p_GF = {0, 0, 4};
  step.end = &load;
  for (int i = 0; i < 3000; ++i) cable.Step(step);
  EXPECT_NEAR(cable.length_m(step.p_GF) - 3.0, 300.0 * 3.0 / model.axial_stiffness_n, 1e-9);
  EXPECT_NEAR(cable.tension_at_fed_end_n(), 300.0, 1e-6);
}

TEST(Cable, ComesToRestOnTheGroundWithItsWeightOnItAndGainsNoEnergy) {
  const CableModel model = Cord();
  const HeightGrid ground = LevelGrid(-1.0, 6.0, 2.0, 0.05);
  Cable cable(model);
  const Eigen::Vector3d fed(0.0, 0.0, 0.003);
  cable.LayOut(fed, {3, 0, 0.8}, 40);
  CableStep step;
  step.gravity_G = kDown;
  step.ground = &ground;
  step.p_GF = fed;
  step.end = &kLoose;
  double energy = cable.Energy(kDown, fed), gained = 0.0;
  for (int i = 0; i < 6000; ++i) {
    cable.Step(step);
    const double now = cable.Energy(kDown, fed);
    gained = std::max(gained, now - energy);
    energy = now;
  }
  const double carried = model.mass_kg_per_m * kG * (cable.rest_m() - 0.5 * cable.rest_m(0));
  EXPECT_NEAR(cable.force_of_ground_G().z(), carried, 1e-4 * carried);
  EXPECT_LT(cable.fastest_m_s(), 1e-6);
  // The ground's spring takes some of it and gives it back: a thousandth of what falls.
  EXPECT_LT(gained, 1e-3 * 0.6);
  RecordProperty("gained_j", std::to_string(gained));
}

TEST(Cable, IsPaidOutAndDrawnInWithoutAJumpOfTheTension) {
  for (const double rate : {-0.1, 0.1}) {
    const ConstantEnd load({30.0, 0.0, 0.0});
    Cable cable(Cord());
    cable.LayOut({0, 0, 0}, {3, 0, 0}, 40);
    CableStep step;
    step.end = &load;
    const int before = cable.masses();
    for (int i = 0; i < 10000; ++i) {
      step.fed_m = rate * step.step_s;
      cable.Step(step);
      if (i < 2000) continue;
      EXPECT_NEAR(cable.tension_at_fed_end_n(), 30.0, 0.2) << rate << " " << i;
    }
    EXPECT_GT(std::abs(cable.masses() - before), 10);  // masses came and went
  }
}

TEST(Cable, TakesFromAllThatItTouchesWhatItsMomentumGains) {
  const CableModel model = Cord();
  const HeightGrid ground = LevelGrid(-3.0, 6.0, 4.0, 0.05);
  std::vector<CableBody> bodies{CableBox({0.4, 0.6, 0.5}, 0.3)};
  bodies[0].motion.X_GL.p = {0.0, 0.0, 0.25};
  bodies[0].motion.w_GL_G = {0.0, 0.0, 0.2};
  Cable cable(model);
  const Eigen::Vector3d fed(-1.0, 0.0, 0.7);
  cable.LayOut(fed, {2.0, 0.3, 0.7}, 40);
  const ConstantEnd load({-0.2, 0.0, 0.0});
  CableStep step;
  step.gravity_G = kDown;
  step.ground = &ground;
  step.bodies = &bodies;
  step.p_GF = fed;
  step.end = &load;
  const double mass = model.mass_kg_per_m * cable.rest_m(0);
  const auto Momentum = [&] {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (int i = 0; i < cable.masses(); ++i) {
      sum += (i + 1 < cable.masses() ? 1.0 : 0.5) * mass * cable.v_G(i);
    }
    return sum;
  };
  bool touched = false;
  for (int i = 0; i < 3000; ++i) {
    const Eigen::Vector3d before = Momentum();
    cable.Step(step);
    Eigen::Vector3d force = cable.rest_m() * model.mass_kg_per_m * kDown -
                            cable.force_on_fed_end_G() + cable.force_of_end_G() +
                            cable.force_of_ground_G() + cable.force_of_air_G();
    for (const CableLoad& of : cable.loads()) force -= of.force_G;
    touched = touched || !cable.loads().empty();
    const Eigen::Vector3d gained = (Momentum() - before) / step.step_s;
    ASSERT_LT((gained - force).norm(), 1e-8 * (1.0 + force.norm())) << i;
  }
  EXPECT_TRUE(touched);
}

TEST(Cable, HangsAlikeWhateverTheStep) {
  const Catenary wanted = ElasticCatenary(Cord(), 4.0, 5.0);
  const Hung coarse = HangBetween(4.0, wanted.rest_m, 4e-3);
  const Hung middle = HangBetween(4.0, wanted.rest_m, 2e-3);
  const Hung fine = HangBetween(4.0, wanted.rest_m, 1e-3);
  EXPECT_NEAR(coarse.sag_m, fine.sag_m, 1e-5);
  EXPECT_NEAR(middle.end_n, fine.end_n, 1e-3);
}

TEST(Cable, MovesTheSameToTheBitWhenRepeated) {
  const auto Run = [] {
    const HeightGrid ground = LevelGrid(-3.0, 6.0, 4.0, 0.05);
    std::vector<CableBody> bodies{CableBox({0.4, 0.6, 0.5}, 0.3)};
    Cable cable(Cord());
    const Eigen::Vector3d fed(-1.0, 0.0, 0.7);
    cable.LayOut(fed, {2.0, 0.3, 0.7}, 40);
    CableStep step;
    step.gravity_G = kDown;
    step.ground = &ground;
    step.bodies = &bodies;
    step.p_GF = fed;
    step.end = &kLoose;
    for (int i = 0; i < 2000; ++i) {
      step.fed_m = 1e-4;
      cable.Step(step);
    }
    return cable.StateHash(1);
  };
  EXPECT_EQ(Run(), Run());
}

}  // namespace
}  // namespace dockyard
