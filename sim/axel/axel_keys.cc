#include "sim/axel/axel_keys.h"

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
  });
  keys.Degrees({"tip_angle_deg", "deg",
                "how far the cone is tipped forward; else the station's own", Presence::kUnset},
               values.tip_angle_rad, Between(0.0, 30.0));
  keys.Number({"board_dust", "", "mean share of the board's face under dust"}, values.board_dust,
              NonNegative(0.6));
}

AxelKeys ReadAxelKeys(const Scenario& scenario) {
  AxelKeys values;
  ReadKeys(scenario.of_system, "axel", [&](Keys& keys) { VisitAxelKeys(keys, values); });
  return values;
}

}  // namespace dockyard::axel
