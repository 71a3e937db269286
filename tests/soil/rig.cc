#include "soil/rig.h"

#include <algorithm>

#include "models/read/load_soil.h"
#include "models/read/load_wheel.h"
#include "support/source_tree.h"

namespace dockyard::soil_test {

SoilModel Soil(const std::string& name) {
  return LoadSoil(SourceFile("models/soils/" + name + ".yaml"));
}

WheelModel Wheel(const std::string& name) {
  return LoadWheel(SourceFile("models/wheels/" + name + ".yaml")).wheel;
}

double PlateModulus(const SoilModel& soil, double width_m) {
  double k_phi = soil.k_phi;
  if (soil.widest_plate_m > 0.0) {
    const double counted_m =
        std::max(soil.narrowest_plate_m, std::min(soil.widest_plate_m, width_m));
    k_phi *= counted_m / soil.narrowest_plate_m;
  }
  return soil.k_c / width_m + k_phi;
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
