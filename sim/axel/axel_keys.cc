#include "sim/axel/axel_keys.h"

#include <cmath>

#include "controller/base/number_text.h"
#include "models/read/config_error.h"
#include "models/read/yaml_path.h"
#include "sim/axel/tsai2013_keys.h"

namespace dockyard::axel {

void VisitAxelKeys(Keys& keys, AxelKeys& values) {
  keys.File({"station", "", "the docking station's file", Presence::kRequired},
            values.station_file);
  keys.Mapping({"vision", "", "the controller's perception"}, [&](Keys& in) {
    const std::vector<std::string> pipelines{PipelineName(VisionPipeline::kDockyard),
                                             PipelineName(VisionPipeline::kTsai2013)};
    in.Choice({"pipeline", "", "ours, or as Tsai et al. (2013) describe theirs"},
              values.vision.pipeline, pipelines);
    in.Integer({"min_points", "", "tsai2013: detections given to the homography"},
               values.vision.min_points, 4, 5);
    in.Bool({"while_driving", "", "dockyard: pictures under way, too, where they are not blurred"},
            values.vision.while_driving);
    in.Number({"bracket_stops", "", "exposures merged: stops to either side; 0: never; else 2",
               Presence::kUnset},
              values.bracket_stops, NonNegative(3.0));
  });
  keys.Degrees({"tip_angle_deg", "deg",
                "how far the cone is tipped forward; else the station's own", Presence::kUnset},
               values.tip_angle_rad, Between(0.0, 30.0));
  keys.Number({"board_dust", "", "mean share of the board's face under dust"}, values.board_dust,
              NonNegative(0.6));
  keys.Mapping({"dirty_marks", "", "marks of the board that are dirtier than the rest of it"},
               [&](Keys& in) {
                 in.Integer({"count", "", "how many; which ones, the seed tells"},
                            values.dirty_marks.count, 0, 64);
                 in.Number({"dust", "", "mean share of each under dust"}, values.dirty_marks.dust,
                           NonNegative(0.95));
               });
  keys.Mapping(
      {"station_moved", "", "somebody carries the station aside during the run"}, [&](Keys& in) {
        StationMove& move = values.station_move;
        in.Number({"at_s", "s", "when; none: never", Presence::kUnset}, move.at_s,
                  NonNegative(1e5));
        in.Number({"forward_m", "m", "the way that it faces"}, move.forward_m, Between(-0.5, 0.5));
        in.Number({"left_m", "m", "to its left"}, move.left_m, Between(-0.5, 0.5));
        in.Degrees({"turn_deg", "deg", "to its left, about its mouth"}, move.turn_rad,
                   Between(-30.0, 30.0));
      });
  keys.Number(
      {"excursion_m", "m",
       "the rover starts seated and goes this far out before it docks; 0: it starts outside"},
      values.excursion_m, NonNegative(20.0));
  keys.Choice(
      {"soil_marks", "", "smooth ruts; with prints of the paddles; all: of tip and body, too"},
      values.soil_marks, {"ruts", "prints", "all"});
  keys.Mapping(
      {"start", "", "how the rover lies at the start, its arm's tip on the ground"}, [&](Keys& in) {
        in.Choice({"arm", "", "the tip ahead of the axle or behind it"}, values.start.arm,
                  {"leading", "trailing"});
        in.Degrees(
            {"body_pitch_deg", "deg", "body about the axle, nose-down, 180 upside down; else level",
             Presence::kUnset},
            values.start.body_pitch_rad, Between(-180.0, 180.0));
        in.Degrees(
            {"arm_deg", "deg", "arm against the body, tip-down, in place of the body's pitch",
             Presence::kUnset},
            values.start.arm_rad, Between(-180.0, 180.0));
        in.Number({"rock_m", "m", "height of a rock under the left wheel; 0: none"},
                  values.start.rock_m, NonNegative(0.3));
      });
  keys.Mapping({"rock_map", "", "rocks that the controller is told of"}, [&](Keys& in) {
    RockMapKeys& map = values.rock_map;
    in.Bool({"made", "", "from the rocks of the world, with a survey's errors"}, map.made);
    in.Number({"sigma_m", "m", "of each coordinate of a place in the map; told, too"}, map.sigma_m,
              NonNegative(1.0));
    in.Number({"least_height_m", "m", "lower rocks are not in a made map"}, map.least_height_m,
              NonNegative(1.0));
    in.Tree({"given", "", "instead: rocks by x_m, y_m, radius_m, height_m", Presence::kUnset},
            map.given, YamlNode::Kind::kSequence);
  });
  keys.Mapping(
      {"tsai2013", "", "what Tsai et al. (2013) leave open of their controller and perception"},
      [&](Keys& in) { VisitTsai2013Keys(in, values.vision.tsai2013, values.tsai2013); });
}

namespace {

constexpr std::size_t kMostMapped = 200;

MappedRock ReadMapped(const YamlNode& node, const std::string& path) {
  MappedRock rock;
  ReadKeys(node, path, [&](Keys& keys) {
    using enum Presence;
    keys.Number({"x_m", "m", "of its middle in the dock's frame D", kRequired}, rock.x_m,
                Between(-200.0, 200.0));
    keys.Number({"y_m", "m", "the same", kRequired}, rock.y_m, Between(-200.0, 200.0));
    keys.Number({"radius_m", "m", "of a disc that holds it", kRequired}, rock.radius_m,
                Between(0.01, 2.0));
    keys.Number({"height_m", "m", "above the ground", kRequired}, rock.height_m,
                Between(0.005, 2.0));
  });
  return rock;
}

void ReadRockMap(RockMapKeys& map) {
  const std::vector<YamlNode>& given = map.given.items;
  if (given.empty()) return;
  const std::string where = map.given.place.Text() + ": axel.rock_map.given: expected ";
  if (map.made) throw ConfigError(where + "none beside made: true");
  if (given.size() > kMostMapped) {
    throw ConfigError(where + "at most " + std::to_string(kMostMapped) + " rocks, found " +
                      std::to_string(given.size()));
  }
  for (std::size_t i = 0; i < given.size(); ++i) {
    map.rocks.push_back(ReadMapped(given[i], YamlReader::PathOf("axel.rock_map.given", i)));
  }
}

// Beyond the told way the rover needs room for its arm, its body, and a drum that counts short.
// Assumed, range 2-4 m.
constexpr double kRoomBeyond_m = 3.0;

// The other built-in controllers would leave such a key unused.
void RequireDockyard(const Scenario& scenario, const std::string& key) {
  if (!scenario.command.empty() || scenario.controller == "dockyard") return;
  throw ConfigError(FindPath(scenario.of_system, key)->place.Text() + ": axel." + key +
                    ": expected the controller dockyard or a program, found '" +
                    scenario.controller + "'");
}

void CheckExcursion(const Scenario& scenario, const AxelKeys& values) {
  if (values.excursion_m == 0.0) return;
  const YamlNode& excursion = *scenario.of_system.Find("excursion_m");
  const auto Refuse = [](const YamlNode& at, const std::string& what) {
    throw ConfigError(at.place.Text() + ": " + what);
  };
  RequireDockyard(scenario, "excursion_m");
  const StartKeys& start = values.start;
  if (start.arm != ArmPlace::kLeading || !std::isnan(start.body_pitch_rad) ||
      !std::isnan(start.arm_rad) || start.rock_m != 0.0) {
    Refuse(*scenario.of_system.Find("start"),
           "axel.start: expected none beside excursion_m; the rover starts seated");
  }
  const double most_m = scenario.yard.length_m - kYardBehind_m - kRoomBeyond_m;
  if (values.excursion_m <= most_m) return;
  Refuse(excursion, "axel.excursion_m: expected at most " + NumberText(most_m) +
                        " in a yard of yard.length_m " + NumberText(scenario.yard.length_m) +
                        ", found '" + NumberText(values.excursion_m) + "'");
}

}  // namespace

AxelKeys ReadAxelKeys(const Scenario& scenario) {
  AxelKeys values;
  ReadKeys(scenario.of_system, "axel", [&](Keys& keys) { VisitAxelKeys(keys, values); });
  if (!std::isnan(values.start.body_pitch_rad) && !std::isnan(values.start.arm_rad)) {
    const YamlNode& angle = *scenario.of_system.Find("start")->Find("arm_deg");
    throw ConfigError(angle.place.Text() +
                      ": axel.start.arm_deg: expected none beside body_pitch_deg; with the tip on "
                      "the ground one gives the other");
  }
  ReadRockMap(values.rock_map);
  if (values.rock_map.made || !values.rock_map.rocks.empty()) RequireDockyard(scenario, "rock_map");
  if (values.vision.while_driving) RequireDockyard(scenario, "vision.while_driving");
  CheckExcursion(scenario, values);
  return values;
}

}  // namespace dockyard::axel
