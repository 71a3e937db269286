#include "models/read/load_wheel.h"

namespace dockyard {

void ReadPaddles(const YamlReader& in, WheelModel& wheel) {
  const YamlReader paddles(in.Child("paddles"), in.PathOf("paddles"),
                           {"count", "height_m", "thickness_m"});
  wheel.paddle_count = paddles.Integer("count", 0, 64);
  wheel.paddle_height_m = paddles.Number("height_m", NonNegative(0.5));
  wheel.paddle_thickness_m = paddles.Number("thickness_m", NonNegative(0.1));
  if (wheel.paddle_count > 0 && !(wheel.paddle_height_m > 0 && wheel.paddle_thickness_m > 0)) {
    paddles.Refuse("count", "0, or a height_m and a thickness_m above 0");
  }
}

WheelModel ReadWheelShape(const YamlReader& in) {
  WheelModel wheel;
  wheel.rim_radius_m = in.Number("radius_m", Positive(2.0));
  wheel.width_m = in.Number("width_m", Positive(2.0));
  ReadPaddles(in, wheel);
  return wheel;
}

WheelFile LoadWheel(const std::string& file) {
  const YamlNode root = LoadYaml(file);
  const YamlReader in(root, "", {"name", "source", "radius_m", "width_m", "paddles"});
  WheelFile wheel;
  wheel.name = in.Text("name");
  wheel.source = in.Text("source");
  wheel.wheel = ReadWheelShape(in);
  return wheel;
}

}  // namespace dockyard
