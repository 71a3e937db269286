// A world in which nothing moves computes no step, and its results do not change.
#include <gtest/gtest.h>

#include <memory>

#include "axel/sim/product.h"

namespace dockyard::axel {
namespace {

/// Braked and fallen asleep.
std::unique_ptr<World> Asleep(const SoilModel& soil, bool may_rest) {
  WorldSetup setup = TestSetup(soil, {3.5, 0.1, 3.0});
  setup.slack_start_m = 0.3;
  setup.may_rest = may_rest;
  auto world = std::make_unique<World>(setup);
  Play(*world, AllBraked(), 12.0);
  return world;
}

TEST(Rest, ComesToABrakedRoverAndEndsWithACommand) {
  for (const SoilModel& soil : {LooseSand(), CompactGravel()}) {
    const auto world = Asleep(soil, true);
    EXPECT_TRUE(world->at_rest()) << soil.name;
    world->Step(Drive(0.2, 45.0));
    EXPECT_FALSE(world->at_rest()) << soil.name;
    EXPECT_FALSE(Asleep(soil, false)->at_rest()) << soil.name;
  }
}

TEST(Rest, LeavesNoTraceHoweverLongItLasts) {
  const auto a = Asleep(LooseSand(), true), b = Asleep(LooseSand(), true);
  Play(*b, AllBraked(), 3.217);  // at rest while a waits for it
  Play(*a, Drive(0.2, 45.0), 2.0);
  Play(*b, Drive(0.2, 45.0), 2.0);
  const Truth first = a->truth(), second = b->truth();
  EXPECT_EQ(first.X_WR.p, second.X_WR.p);
  EXPECT_EQ(first.X_WR.R, second.X_WR.R);
  EXPECT_EQ(first.v_MT, second.v_MT);
  EXPECT_EQ(first.motor_angle_rad, second.motor_angle_rad);
  EXPECT_EQ(first.motor_current_a, second.motor_current_a);
  EXPECT_EQ(first.tether_tension_n, second.tether_tension_n);
  EXPECT_EQ(a->ground().heights_m, b->ground().heights_m);
}

TEST(Rest, IsWhereAWorldThatStepsOnStands) {
  const auto resting = Asleep(CompactGravel(), true), stepping = Asleep(CompactGravel(), false);
  EXPECT_LT((resting->truth().X_WR.p - stepping->truth().X_WR.p).norm(), 1e-8);
  Play(*resting, Drive(0.2, 45.0), 2.0);
  Play(*stepping, Drive(0.2, 45.0), 2.0);
  EXPECT_LT((resting->truth().X_WR.p - stepping->truth().X_WR.p).norm(), 1e-6);
}

}  // namespace
}  // namespace dockyard::axel
