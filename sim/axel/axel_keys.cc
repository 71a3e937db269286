#include "sim/axel/axel_keys.h"

#include <cmath>

#include "models/read/config_error.h"
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
  keys.Mapping(
      {"tsai2013", "", "what Tsai et al. (2013) leave open of their controller and perception"},
      [&](Keys& in) { VisitTsai2013Keys(in, values.vision.tsai2013, values.tsai2013); });
}

AxelKeys ReadAxelKeys(const Scenario& scenario) {
  AxelKeys values;
  ReadKeys(scenario.of_system, "axel", [&](Keys& keys) { VisitAxelKeys(keys, values); });
  if (!std::isnan(values.start.body_pitch_rad) && !std::isnan(values.start.arm_rad)) {
    const YamlNode& angle = *scenario.of_system.Find("start")->Find("arm_deg");
    throw ConfigError(angle.place.Text() +
                      ": axel.start.arm_deg: expected none beside body_pitch_deg; with the tip on "
                      "the ground one gives the other");
  }
  return values;
}

}  // namespace dockyard::axel
