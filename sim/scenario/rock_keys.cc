#include "sim/scenario/rock_keys.h"

#include <cmath>

#include "models/read/config_error.h"
#include "sim/scenario/key_path.h"

namespace dockyard {
namespace {

constexpr std::size_t kMostGiven = 200;

/// The ground's rectangle in D.
bool InYard(const YardModel& yard, double x_m, double y_m) {
  return x_m >= -kYardBehind_m && x_m <= yard.length_m - kYardBehind_m &&
         std::abs(y_m) <= 0.5 * yard.width_m;
}

GivenRock ReadGiven(const YamlNode& node, const std::string& path, const YardModel& yard) {
  GivenRock rock;
  ReadKeys(node, path, [&](Keys& keys) {
    using enum Presence;
    keys.Number({"x_m", "m", "of its middle in the target's frame D", kRequired}, rock.x_m,
                Between(-200.0, 200.0));
    keys.Number({"y_m", "m", "the same", kRequired}, rock.y_m, Between(-200.0, 200.0));
    keys.Number({"diameter_m", "m", "mean of its length and width", kRequired}, rock.diameter_m,
                Between(0.02, 2.0));
    keys.Number({"height_m", "m", "above the ground at its middle", kRequired}, rock.height_m,
                Between(0.005, 1.0));
    keys.Degrees({"turn_deg", "deg", "about the vertical"}, rock.turn_rad, Between(-180.0, 180.0));
  });
  if (!InYard(yard, rock.x_m, rock.y_m)) {
    throw ConfigError(node.place.Text() + ": " + path + ": expected a rock inside the yard");
  }
  return rock;
}

[[noreturn]] void RefusePair(const YamlNode& root, const char* lower, const char* upper) {
  const YamlNode* at = FindPath(root, lower);
  if (at == nullptr) at = FindPath(root, upper);
  throw ConfigError((at == nullptr ? root : *at).place.Text() + ": " + lower +
                    ": expected at most " + upper);
}

}  // namespace

void VisitRocks(Keys& keys, Scenario& s) {
  using enum Presence;
  RockField& rocks = s.rocks;
  keys.Number({"cover", "", "share of the ground under rocks of any size"}, rocks.cover,
              NonNegative(0.3));
  keys.Number({"least_m", "m", "least diameter of the field's rocks"}, rocks.least_m,
              Between(0.02, 1.0));
  keys.Number({"largest_m", "m", "largest diameter of the field's rocks"}, rocks.largest_m,
              Between(0.02, 2.0));
  keys.Number({"clear_m", "m", "radius about start and target without a rock of the field"},
              rocks.clear_m, Between(0.0, 20.0));
  keys.Number({"flattest", "", "least height over diameter of the field's rocks"}, rocks.flattest,
              Between(0.1, 1.0));
  keys.Number({"steepest", "", "greatest height over diameter of the field's rocks"},
              rocks.steepest, Between(0.1, 1.0));
  keys.Number({"buried", "", "share of every rock's height below the ground"}, rocks.buried,
              Between(0.05, 0.5));
  keys.Number({"friction", "", "of the robot on rock"}, rocks.friction, Between(0.05, 2.0));
  keys.Tree(
      {"given", "", "rocks at given places: x_m, y_m, diameter_m, height_m, turn_deg", kUnset},
      s.given_rocks, YamlNode::Kind::kSequence);
}

void ReadRocks(Scenario& s, const YamlNode& root, const KnownSystem& system) {
  RockField& rocks = s.rocks;
  rocks.given.clear();
  if (s.given_rocks.items.size() > kMostGiven) {
    throw ConfigError(s.given_rocks.place.Text() + ": rocks.given: expected at most " +
                      std::to_string(kMostGiven) + " rocks, found " +
                      std::to_string(s.given_rocks.items.size()));
  }
  for (std::size_t i = 0; i < s.given_rocks.items.size(); ++i) {
    rocks.given.push_back(
        ReadGiven(s.given_rocks.items[i], YamlReader::PathOf("rocks.given", i), s.yard));
  }
  if (rocks.least_m > rocks.largest_m) RefusePair(root, "rocks.least_m", "rocks.largest_m");
  if (rocks.flattest > rocks.steepest) RefusePair(root, "rocks.flattest", "rocks.steepest");
  if (HasRocks(rocks) && !system.rocks) {
    throw ConfigError(s.rocks_place + ": expected no rocks, as the system " + system.name +
                      " has none");
  }
}

bool HasRocks(const RockField& rocks) { return rocks.cover > 0.0 || !rocks.given.empty(); }

}  // namespace dockyard
