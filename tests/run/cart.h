// A world for the tests of what systems share: a cart on a line over a grid of four heights.
#pragma once

#include <string>
#include <utility>

#include "sim/base/json.h"
#include "sim/run/world_plant.h"

namespace dockyard::cart {

struct Setup {
  double speed_m_s = 0.0;
};

struct Nominal {
  double length_m = 0.0;
};
inline Json ToJson(const Nominal& nominal) { return {{"length_m", nominal.length_m}}; }
inline Nominal FromJson(const Json& json) { return {json.at("length_m").get<double>()}; }

struct Built {
  Setup world;
  Nominal nominal;
};

struct Truth {
  double time_s = 0.0, x_m = 0.0;
};
template <class Visit>
void VisitChannels(const Truth& truth, const Visit& visit) {
  visit("time_s", "s", "since the start", truth.time_s);
  visit("x_m", "m", "along the line", truth.x_m);
}

class World {
 public:
  explicit World(const Setup& setup)
      : setup_(setup),
        ground_{.x0_m = -1.0,
                .y0_m = -2.0,
                .cell_m = 0.5,
                .nx = 2,
                .ny = 2,
                .heights_m = {0, 1, 2, 3},
                .undisturbed_m = {}} {}
  Tick tick() const { return tick_; }
  Truth truth() const {
    const double time_s = static_cast<double>(tick_) * kTickSeconds;
    return {time_s, setup_.speed_m_s * time_s};
  }
  std::uint64_t StateHash(std::uint64_t seed) const { return HashDouble(seed, truth().x_m); }
  const HeightGrid& ground() const { return ground_; }
  void Press(std::size_t place, double depth_m) {
    ground_.heights_m.at(place) -= depth_m;
    ++ground_.revision;
  }
  void Advance(Tick period) { tick_ += period; }

 private:
  Setup setup_;
  HeightGrid ground_;
  Tick tick_ = 0;
};

class CartPlant final : public WorldPlant<World, Built> {
 public:
  using Base = WorldPlant<World, Built>;
  using Base::StageOn;
  using Base::StepsIn;
  CartPlant(const Scenario& scenario, Built built, std::shared_ptr<KeptRenderer> renderer)
      : Base(scenario, std::move(built), std::move(renderer)) {}

  SensorFrame Sense() override {
    RefreshTruth();
    SensorFrame frame;
    frame.tick = tick();
    return frame;
  }
  std::vector<CameraImage> TakeImages(const std::vector<int>&, double) override { return {}; }
  void Advance(const Commands& commands) override {
    motor_ = MotorsOf<1>(commands)[0];
    world_.Advance(20);
  }
  RobotPose X_DR() const override { return {truth_.x_m, 0.0, 0.0}; }
  RobotPose MeasuredPose(const SightingReport&) const override { return {}; }

  const MotorCommand& motor() const { return motor_; }
  const KeptRenderer* renderer() const { return renderer_.get(); }

 private:
  MotorCommand motor_;
};

}  // namespace dockyard::cart
