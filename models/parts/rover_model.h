// A rover on wheels, as it is built: body, suspension, wheels and their motors.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "controller/geometry/rover_plan.h"
#include "models/parts/arm_model.h"
#include "models/parts/contact_material.h"
#include "models/parts/joint_stop.h"
#include "models/parts/link.h"
#include "models/parts/mast_model.h"
#include "models/parts/motor.h"
#include "models/parts/wheel.h"

namespace dockyard {

enum class SuspensionKind : std::uint8_t {
  kRigid,        // all wheels on the body
  kRockerBogie,  // each side a rocker on the body and a bogie on the rocker, and a differential
                 // between the rockers: their angles are equal and opposite
};

/// Hinges turn about y. Places in R's x; heights above the wheels' axles on level ground.
struct SuspensionModel {
  SuspensionKind kind = SuspensionKind::kRigid;
  double pivot_x_m = 0.0, pivot_z_m = 0.0;             // of the rockers on the body
  double bogie_x_m = 0.0, bogie_z_m = 0.0;             // of the bogies on the rockers
  double rocker_kg = 0.0, bogie_kg = 0.0;              // one of two
  double friction_nm = 0.0;                            // of each hinge
  double rocker_stop_rad = 0.0, bogie_stop_rad = 0.0;  // either way
  JointStop stop;                                      // of rockers and bogies
};

/// How parts press on stones and on each other; how they rub is the stones'.
struct RoverContacts {
  ContactMaterial wheels{2.5e4, 60.0};  // 1 mm under 25 N; assumed, 1e4-1e5 N/m and 20-200 N s/m
  // A contact yields by half a millimetre under 10 N, as a lip of sheet metal does; assumed,
  // 1e4-1e5 N/m and 20-100 N s/m. Of arm and scoops, and of body, suspension and mast.
  ContactMaterial arm{2e4, 40.0}, body{2e4, 40.0};
};

struct RoverModel {
  RoverPlan plan;
  LinkModel body;  // its frame: R's place in plan, at the height of the axles
  SuspensionModel suspension;
  std::vector<bool> on_bogie;  // by wheel; the others are on the rocker
  WheelModel tyre;             // of every wheel
  double wheel_kg = 0.0;
  double bracket_kg = 0.0;  // of a steered wheel
  MotorModel drive, steer;
  std::optional<ArmModel> arm;
  std::optional<MastModel> mast;
  RoverContacts contacts;

  double mass_kg() const;
};

inline double RoverModel::mass_kg() const {
  double sum = body.mass_kg + wheel_kg * static_cast<double>(plan.wheels.size());
  for (const WheelPlan& wheel : plan.wheels) {
    if (wheel.steer_limit_rad > 0.0) sum += bracket_kg;
  }
  if (suspension.kind == SuspensionKind::kRockerBogie) {
    sum += 2.0 * (suspension.rocker_kg + suspension.bogie_kg);
  }
  if (arm) sum += arm->mass_kg + 2.0 * arm->scoop.mass_kg;
  if (mast) sum += mast->mass_kg();
  return sum;
}

}  // namespace dockyard
