#include "models/read/load_wheel.h"

namespace dockyard {

void VisitPaddles(Keys& keys, WheelModel& wheel) {
  keys.Mapping("paddles", [&](Keys& in) {
    in.Integer("count", wheel.paddle_count, 0, 64);
    in.Number("height_m", wheel.paddle_height_m, NonNegative(0.5));
    in.Number("thickness_m", wheel.paddle_thickness_m, NonNegative(0.1));
    in.Check("count",
             wheel.paddle_count == 0 || (wheel.paddle_height_m > 0 && wheel.paddle_thickness_m > 0),
             "0, or a height_m and a thickness_m above 0");
  });
}

void VisitWheelShape(Keys& keys, WheelModel& wheel) {
  keys.Number("radius_m", wheel.rim_radius_m, Positive(2.0));
  keys.Number("width_m", wheel.width_m, Positive(2.0));
  VisitPaddles(keys, wheel);
}

WheelFile LoadWheel(const std::string& file) {
  WheelFile wheel;
  ReadKeys(LoadYaml(file), "", [&](Keys& keys) {
    keys.Text("name", wheel.name);
    keys.Text("source", wheel.source);
    VisitWheelShape(keys, wheel.wheel);
  });
  return wheel;
}

}  // namespace dockyard
