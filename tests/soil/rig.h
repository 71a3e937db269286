// The soils and wheels of the tests, from the files that everybody uses.
#pragma once

#include <string>

#include "sim/soil/single_wheel.h"
#include "sim/soil/wheel_soil.h"

namespace dockyard::soil_test {

SoilModel Soil(const std::string& name);    // models/soils/NAME.yaml
WheelModel Wheel(const std::string& name);  // models/wheels/NAME.yaml
/// About Axel's wheel, with any number of paddles: rim 0.30 m, 0.15 m wide, paddles 3 cm high.
WheelModel AxelWheel(int paddle_count);

}  // namespace dockyard::soil_test
