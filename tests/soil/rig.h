// The soils and wheels of the tests, from the files that everybody uses.
#pragma once

#include <string>

#include "sim/soil/single_wheel.h"
#include "sim/soil/wheel_soil.h"

namespace dockyard::soil_test {

SoilModel Soil(const std::string& name);    // models/soils/NAME.yaml
WheelModel Wheel(const std::string& name);  // models/wheels/NAME.yaml
/// Bekker's k_c / b + k_phi of a plate of this width, k_phi in proportion to it between the soil's
/// plates [N/m^(n+2)]. Apart from the simulation's own.
double PlateModulus(const SoilModel& soil, double width_m);
/// About Axel's wheel, with any number of paddles: rim 0.30 m, 0.15 m wide, paddles 3 cm high.
WheelModel AxelWheel(int paddle_count);

}  // namespace dockyard::soil_test
