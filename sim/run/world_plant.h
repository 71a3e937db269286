// What plants have in common whose world is computed step by step.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <utility>

#include "controller/base/check.h"
#include "sim/base/hash.h"
#include "sim/plant/ground_view.h"
#include "sim/plant/renderer.h"
#include "sim/run/plant.h"
#include "sim/scenario/scenario.h"

namespace dockyard {

/// `Built` is the run as its scenario builds it, with the world's setup as `world`. The namespace
/// of `Truth`, which `World::truth()` returns, has VisitChannels(truth, visit).
template <class World, class Built>
class WorldPlant : public Plant {
 public:
  using Truth = decltype(std::declval<const World&>().truth());

  Tick tick() const override { return world_.tick(); }
  void AppendChannels(std::vector<double>& values) const override {
    VisitChannels(truth_, [&](const char*, const char*, const auto&, double value) {
      values.push_back(value);
    });
  }
  std::uint64_t StateHash(std::uint64_t seed) const override { return world_.StateHash(seed); }
  // The ruts sum up all that the wheels did: once, at the end, is enough.
  std::uint64_t FinalHash(std::uint64_t seed) const override {
    for (const double height : world_.ground().heights_m) seed = HashDouble(seed, height);
    return world_.StateHash(seed);
  }

  const Built& built() const { return built_; }
  /// The truth at the last sensor reading.
  const Truth& truth() const { return truth_; }
  void TakeTruth(const Truth& now) { truth_ = now; }
  void RefreshTruth() { TakeTruth(world_.truth()); }
  World& world() { return world_; }

 protected:
  /// The renderer may serve other plants too.
  WorldPlant(const Scenario& scenario, Built built, std::shared_ptr<KeptRenderer> renderer)
      : seed_(scenario.seed),
        step_s_(scenario.physics_step_s),
        built_(std::move(built)),
        world_(built_.world),
        renderer_(std::move(renderer)),
        truth_(world_.truth()) {}

  long StepsIn(Tick period) const {
    return std::lround(static_cast<double>(period) * kTickSeconds / step_s_);
  }
  /// A stage of the ground alone. X_WD: the target's frame.
  Stage StageOn(const Pose3& X_WG, const Pose3& X_WD, const Eigen::Vector3d& ground_rgb) const {
    const GroundView ground = ViewOf(world_.ground(), X_WG, ground_rgb);
    Stage stage;
    stage.ground = {ground.X_WG, ground.x0_m,      ground.y0_m,     ground.cell_m, ground.nx,
                    ground.ny,   ground.heights_m, ground.revision, ground.albedo};
    stage.X_WD = X_WD;
    return stage;
  }
  template <std::size_t N>
  static std::array<MotorCommand, N> MotorsOf(const Commands& commands) {
    DOCKYARD_CHECK(commands.motors.size() == N);
    std::array<MotorCommand, N> motors;
    std::copy(commands.motors.begin(), commands.motors.end(), motors.begin());
    return motors;
  }

  Seed seed_;
  double step_s_;
  Built built_;
  World world_;
  std::shared_ptr<KeptRenderer> renderer_;
  Truth truth_;
};

}  // namespace dockyard
