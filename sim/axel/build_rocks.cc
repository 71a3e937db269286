#include "sim/axel/build_rocks.h"

#include <algorithm>
#include <stdexcept>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "sim/axel/world.h"
#include "sim/base/random.h"
#include "sim/rigid/rocks.h"
#include "sim/scenario/rock_keys.h"

namespace dockyard::axel {
namespace {

// Albedo of rocks against that of the soil: freshly broken faces are darker than dust. Assumed,
// 0.4-1.
constexpr double kRockToSoil = 0.65;
// Beyond the soles' centres: their own radius and what the station may slip [m].
constexpr double kBesideSole_m = 0.1;
// Ahead of the arm's tip, as the rover may roll off a paddle while it settles [m].
constexpr double kAheadOfTip_m = 0.1;
// Of a rock below a wheel: 1 over 0.375, the field's flattest.
constexpr double kWidthOfHeight = 1.0 / 0.375;

// The ground below the station, in D.
struct Footprint {
  Eigen::Vector2d low{0, 0}, high{0, 0};

  double DistanceTo(const Eigen::Vector2d& p) const {
    return (p - p.cwiseMax(low).cwiseMin(high)).norm();
  }
  double Reach() const { return low.cwiseAbs().cwiseMax(high.cwiseAbs()).norm(); }
};

Footprint FootprintOf(const StationModel& station) {
  Footprint print;
  const auto Hold = [&](const Eigen::Vector2d& p) {
    print.low = print.low.cwiseMin(p);
    print.high = print.high.cwiseMax(p);
  };
  const Eigen::Vector2d beside(kBesideSole_m, kBesideSole_m);
  for (const FootModel& foot : station.feet) {
    Hold(foot.p_SF.head<2>() - beside);
    Hold(foot.p_SF.head<2>() + beside);
  }
  return print;
}

void CheckClear(const Scenario& scenario, const ModelSet& models, const Footprint& print) {
  const double arm_m = models.rover.arm_length_m + kAheadOfTip_m;
  const double least_m = std::max(arm_m, print.Reach());
  if (scenario.rocks.clear_m >= least_m) return;
  throw ConfigError(scenario.rocks_place + ": expected clear_m of at least " + Fixed(least_m, 2) +
                    " m, as far as station and arm reach, found " +
                    NumberText(scenario.rocks.clear_m));
}

GivenRock UnderWheel(const Scenario& scenario, const AxelModels& models) {
  const double height_m = models.keys.start.rock_m;
  const Eigen::Vector2d p_RL(0.0, 0.5 * models.built.rover.track_m());
  const Eigen::Vector2d p_DL = FromDockingCoords(scenario.start.on_plane()) * p_RL;
  GivenRock rock;
  rock.x_m = p_DL.x();
  rock.y_m = p_DL.y();
  rock.diameter_m = kWidthOfHeight * height_m;
  rock.height_m = height_m;
  return rock;
}

}  // namespace

bool HasRocks(const Scenario& scenario, const AxelModels& models) {
  return HasRocks(scenario.rocks) || models.keys.start.rock_m > 0.0;
}

RockBed BuildRocks(const Scenario& scenario, const AxelModels& models, const HeightGrid& ground) {
  RockBed bed;
  RockField field = scenario.rocks;
  const std::size_t listed = field.given.size();
  if (models.keys.start.rock_m > 0.0) field.given.push_back(UnderWheel(scenario, models));
  if (!HasRocks(scenario, models)) return bed;
  bed.friction = field.friction;
  const Footprint print = FootprintOf(models.built.station);
  if (field.cover > 0.0) CheckClear(scenario, models.built, print);
  const YardModel& yard = scenario.yard;
  const GroundArea area{-kYardBehind_m, yard.length_m - kYardBehind_m, -0.5 * yard.width_m,
                        0.5 * yard.width_m};
  const Pose2 start = FromDockingCoords(scenario.start.on_plane());
  std::vector<Rock> rocks;
  try {
    rocks = PlaceRocks(field, area, {{0.0, 0.0}, {start.x, start.y}},
                       StreamKey(scenario.seed, "rocks"));
  } catch (const std::length_error&) {
    throw ConfigError(scenario.rocks_place + ": expected at most " + std::to_string(kMostRocks) +
                      " rocks in the yard; a lower cover, a larger least_m or a smaller yard has "
                      "fewer");
  }
  const Pose2 X_GD = WorldSetup{}.X_GD;
  for (std::size_t i = 0; i < rocks.size(); ++i) {
    const Rock& rock = rocks[i];
    if (i < listed && print.DistanceTo(rock.p_D) < 0.5 * rock.size.diameter_m) {
      throw ConfigError(scenario.given_rocks.items[i].place.Text() + ": rocks.given[" +
                        std::to_string(i) + "]: expected a rock that is not under the station");
    }
    const Eigen::Vector2d p_G = X_GD * rock.p_D;
    bed.rocks.push_back(FromGround(X_GD, ground.Height(p_G.x(), p_G.y())) * rock.body);
  }
  return bed;
}

Eigen::Vector3d RockAlbedo(const SoilModel& soil) { return kRockToSoil * soil.rgb; }

RenderMesh RockMesh(const RockBed& bed) {
  RenderMesh mesh;
  for (const ConvexBody& rock : bed.rocks) {
    for (const auto& triangle : rock.triangles) {
      const auto first = static_cast<std::uint32_t>(mesh.vertices.size());
      for (const std::uint32_t i : triangle)
        mesh.vertices.push_back(rock.vertices[i].cast<float>());
      mesh.triangles.push_back({first, first + 1, first + 2});
    }
  }
  return mesh;
}

}  // namespace dockyard::axel
