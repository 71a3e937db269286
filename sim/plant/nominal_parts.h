// Parts of any robot's nominal parameters as JSON.
#pragma once

#include "controller/geometry/camera.h"
#include "controller/io/nominal_motor.h"
#include "sim/base/json.h"

namespace dockyard {

Json CameraToJson(const Camera& camera);
/// Throws ConfigError for a lens that is none, nlohmann::json::exception for other JSON.
Camera CameraFromJson(const Json& json);
Json MotorToJson(const NominalMotor& motor);
/// Throws nlohmann::json::exception.
NominalMotor MotorFromJson(const Json& json);

}  // namespace dockyard
