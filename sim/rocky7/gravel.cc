#include "sim/rocky7/gravel.h"

#include <algorithm>

#include "sim/base/random.h"
#include "sim/rigid/rocks.h"

namespace dockyard::rocky7 {
namespace {

/// Half the width of what lies at the origin of D.
double HalfTarget_m(const Rocky7Keys& keys) {
  return 0.5 * (keys.task == Task::kPlace ? keys.boulder_m : keys.diameter_m);
}

}  // namespace

std::vector<ConvexBody> GravelAbout(const Rocky7Keys& keys, const RockField& rocks,
                                    const HeightGrid& ground,
                                    const std::vector<ConvexBody>& stones_G, const Seed& seed) {
  std::vector<ConvexBody> gravel;
  if (rocks.cover <= 0.0 || keys.gravel_m >= rocks.least_m) return gravel;
  RockField small = rocks;
  small.given.clear();
  small.least_m = keys.gravel_m;
  small.largest_m = rocks.least_m;
  small.clear_m = HalfTarget_m(keys);
  const double within_m = keys.gravel_within_m;
  const GroundArea area{-within_m, within_m, -within_m, within_m};
  for (const Rock& rock : PlaceRocks(small, area, {{0.0, 0.0}}, StreamKey(seed, "gravel"))) {
    const double half_m = 0.5 * rock.size.diameter_m;
    const bool covered =
        std::any_of(stones_G.begin(), stones_G.end(), [&](const ConvexBody& stone) {
          return (stone.centre.head<2>() - rock.p_D).norm() < stone.radius_m + half_m;
        });
    if (covered || rock.p_D.norm() > within_m) continue;
    const double up_m = ground.Height(rock.p_D.x(), rock.p_D.y());
    gravel.push_back(Pose3::Translation(0.0, 0.0, up_m) * rock.body);
  }
  return gravel;
}

}  // namespace dockyard::rocky7
