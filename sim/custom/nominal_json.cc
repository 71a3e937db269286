#include "sim/custom/nominal_json.h"

#include "sim/plant/nominal_parts.h"

namespace dockyard::custom {

template <Of<JointDrive> D, class Visit>
void VisitMembers(D& drive, const Visit& visit) {
  visit("joint", drive.joint);
  visit("motor", drive.motor);
  visit("travel_per_rad", drive.travel_per_rad);
}

template <Of<RobotWheel> W, class Visit>
void VisitMembers(W& wheel, const Visit& visit) {
  visit("link", wheel.link);
  visit("p_RK", wheel.p_RK);
  visit("axle_R", wheel.axle_R);
  visit("radius_m", wheel.radius_m);
  visit("width_m", wheel.width_m);
  visit("ball", wheel.ball);
  visit("drive", wheel.drive);
  visit("steering", wheel.steering);
  visit("swivels", wheel.swivels);
  visit("p_RS", wheel.p_RS);
}

template <Of<RobotCamera> C, class Visit>
void VisitMembers(C& camera, const Visit& visit) {
  visit("name", camera.name);
  visit("camera", camera.camera);
  visit("X_RC", camera.X_RC);
  visit("colour", camera.colour);
  visit("period_s", camera.period_s);
  visit("latency_s", camera.latency_s);
}

template <Of<DockBoard> B, class Visit>
void VisitMembers(B& board, const Visit& visit) {
  visit("name", board.name);
  visit("board", board.board);
  visit("X_DB", board.X_DB);
}

template <Of<DockingOptions> O, class Visit>
void VisitMembers(O& options, const Visit& visit) {
  visit("k_phi", options.k_phi);
  visit("k_delta", options.k_delta);
  visit("beta", options.beta);
  visit("lambda", options.lambda);
  visit("slowdown_m", options.slowdown_m);
  visit("least_m_s", options.least_m_s);
  visit("most_m_s", options.most_m_s);
  visit("most_rad_s", options.most_rad_s);
  visit("accel_m_s2", options.accel_m_s2);
  visit("accel_rad_s2", options.accel_rad_s2);
  visit("dead_m_s", options.dead_m_s);
  visit("dead_rad_s", options.dead_rad_s);
  visit("staging_m", options.staging_m);
  visit("perception_s", options.perception_s);
  visit("approach_s", options.approach_s);
  visit("wait_charge_s", options.wait_charge_s);
  visit("retries", options.retries);
  visit("wiggle_rad", options.wiggle_rad);
  visit("aligned_m", options.aligned_m);
  visit("aligned_rad", options.aligned_rad);
  visit("press_m", options.press_m);
  visit("press_m_s", options.press_m_s);
  visit("search_rad_s", options.search_rad_s);
  visit("docked_along_m", options.docked_along_m);
  visit("docked_aside_m", options.docked_aside_m);
  visit("docked_rad", options.docked_rad);
}

template <Of<Nominal> N, class Visit>
void VisitMembers(N& nominal, const Visit& visit) {
  visit("name", nominal.name);
  visit("control_period_s", nominal.control_period_s);
  visit("motors", nominal.motors);
  visit("wheels", nominal.wheels);
  visit("height_m", nominal.height_m);
  visit("cameras", nominal.cameras);
  visit("boards", nominal.boards);
  visit("sensors", nominal.sensors);
  visit("X_RP", nominal.X_RP);
  visit("X_DQ", nominal.X_DQ);
  visit("contact", nominal.contact);
  visit("contact_voltage_v", nominal.contact_voltage_v);
  visit("has_imu", nominal.has_imu);
  visit("docking", nominal.docking);
}

Json ToJson(const Nominal& nominal) { return WriteMember(nominal); }

Nominal NominalFromJson(const Json& json) {
  return ReadNominal<Nominal>(json, "those of a robot and a dock by files");
}

}  // namespace dockyard::custom
