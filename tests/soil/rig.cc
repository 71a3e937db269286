#include "soil/rig.h"

#include "models/read/load_soil.h"
#include "models/read/load_wheel.h"

namespace dockyard::soil_test {

SoilModel Soil(const std::string& name) {
  return LoadSoil(DOCKYARD_SOURCE_DIR "/models/soils/" + name + ".yaml");
}

WheelModel Wheel(const std::string& name) {
  return LoadWheel(DOCKYARD_SOURCE_DIR "/models/wheels/" + name + ".yaml").wheel;
}

WheelModel AxelWheel(int paddle_count) {
  WheelModel wheel;
  wheel.rim_radius_m = 0.30;
  wheel.width_m = 0.15;
  if (paddle_count == 0) return wheel;
  wheel.paddle_count = paddle_count;
  wheel.paddle_height_m = 0.03;
  wheel.paddle_thickness_m = 0.006;
  return wheel;
}

}  // namespace dockyard::soil_test
