// Parts of any robot's nominal parameters as JSON.
#pragma once

#include "controller/geometry/camera.h"
#include "controller/io/nominal_motor.h"
#include "sim/plant/json_members.h"

namespace dockyard {

Json ToJson(const Camera& camera);
/// Throws ConfigError for a lens that is none, nlohmann::json::exception for other JSON.
void FromJson(const Json& json, Camera& camera);

template <Of<NominalMotor> M, class Visit>
void VisitMembers(M& motor, const Visit& visit) {
  visit("rad_per_count", motor.rad_per_count);
  visit("torque_per_amp_nm", motor.torque_per_amp_nm);
  visit("no_load_current_a", motor.no_load_current_a);
  visit("max_current_a", motor.max_current_a);
  visit("max_speed_rad_s", motor.max_speed_rad_s);
  visit("max_accel_rad_s2", motor.max_accel_rad_s2);
}
static_assert(sizeof(NominalMotor) == 6 * sizeof(double));

}  // namespace dockyard
