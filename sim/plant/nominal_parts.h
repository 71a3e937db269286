// Parts of any robot's nominal parameters as JSON.
#pragma once

#include <array>

#include "controller/geometry/board.h"
#include "controller/geometry/camera.h"
#include "controller/io/nominal_motor.h"
#include "sim/plant/json_members.h"

namespace dockyard {

Json ToJson(const Camera& camera);
/// Throws ConfigError for a lens that is none, nlohmann::json::exception for other JSON.
void FromJson(const Json& json, Camera& camera);

template <Of<Fiducial> F, class Visit>
void VisitMembers(F& fiducial, const Visit& visit) {
  visit("p_m", fiducial.p_BF);
  visit("rotation_rad", fiducial.rotation);
}

/// Without its cells, which follow from family and id.
template <Of<SquareTag> T, class Visit>
void VisitMembers(T& tag, const Visit& visit) {
  visit("family", tag.family);
  visit("id", tag.id);
  visit("p_m", tag.p_BT);
  visit("size_m", tag.size_m);
  visit("rotation_rad", tag.rotation);
}

template <Of<FiducialBoard> B, class Visit>
void VisitMembers(B& board, const Visit& visit) {
  visit("width_m", board.width_m);
  visit("height_m", board.height_m);
  visit("disc_diameter_m", board.disc_diameter_m);
  visit("bar_length_m", board.bar_length_m);
  visit("bar_width_m", board.bar_width_m);
  visit("fiducials", board.fiducials);
  if (visit.Has("tags", !board.tags.empty())) visit("tags", board.tags);
  auto& upright = board.upright;
  if (!visit.Has("upright_in", upright.against != Upright::Against::kPlumb)) return;
  int index = static_cast<int>(upright.against) - 1;
  visit.Word("upright_in", "upright_in", index, std::array{"gravity", "image"});
  if constexpr (!std::is_const_v<B>) upright.against = static_cast<Upright::Against>(index + 1);
  visit("upright_within_rad", upright.within_rad);
}

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
