#include "sim/rocky7/nominal_json.h"

#include "sim/plant/nominal_parts.h"

namespace dockyard {

template <Of<WheelPlan> W, class Visit>
void VisitMembers(W& wheel, const Visit& visit) {
  visit("name", wheel.name);
  visit("p_RW", wheel.p_RW);
  visit("steer_limit_rad", wheel.steer_limit_rad);
}

template <Of<ViewPlan> V, class Visit>
void VisitMembers(V& view, const Visit& visit) {
  visit("p_RC", view.p_RC);
  visit("azimuth_rad", view.azimuth_rad);
  visit("half_width_rad", view.half_width_rad);
  visit("near_m", view.near_m);
  visit("far_m", view.far_m);
}

template <Of<RoverPlan> P, class Visit>
void VisitMembers(P& plan, const Visit& visit) {
  visit("name", plan.name);
  visit("wheels", plan.wheels);
  visit("wheel_radius_m", plan.wheel_radius_m);
  visit("wheel_width_m", plan.wheel_width_m);
  visit("body", plan.body);
  visit("p_RP", plan.p_RP);
  visit("speed_m_s", plan.speed_m_s);
  visit("steer_rate_rad_s", plan.steer_rate_rad_s);
  visit("view", plan.view);
}

template <Of<StereoRig> R, class Visit>
void VisitMembers(R& rig, const Visit& visit) {
  visit("left", rig.left);
  visit("right", rig.right);
  visit("X_RL", rig.X_RL);
  visit("X_RQ", rig.X_RQ);
}

}  // namespace dockyard

namespace dockyard::rocky7 {

template <Of<NominalArm> A, class Visit>
void VisitMembers(A& arm, const Visit& visit) {
  visit("p_RA", arm.p_RA);
  visit("length_m", arm.length_m);
  visit("scoop_depth_m", arm.scoop_depth_m);
  visit("open_rad", arm.open_rad);
}

template <Of<NominalMast> M, class Visit>
void VisitMembers(M& mast, const Visit& visit) {
  visit("p_RM", mast.p_RM);
  visit("link1_m", mast.link1_m);
  visit("link2_m", mast.link2_m);
  visit("low_rad", mast.low_rad);
  visit("high_rad", mast.high_rad);
  visit("stowed_rad", mast.stowed_rad);
  visit("watch_rad", mast.watch_rad);
  visit("switch_radius_m", mast.switch_radius_m);
  visit("pair_K", mast.pair_K);
}

template <Of<NominalMasses> M, class Visit>
void VisitMembers(M& masses, const Visit& visit) {
  visit("rover_kg", masses.rover_kg);
  visit("p_RC", masses.p_RC);
  visit("arm_kg", masses.arm_kg);
  visit("arm_middle_m", masses.arm_middle_m);
  visit("link1_kg", masses.link1_kg);
  visit("link2_kg", masses.link2_kg);
  visit("link2_middle_m", masses.link2_middle_m);
}
static_assert(sizeof(NominalMasses) == 9 * sizeof(double));

template <Of<NesnasTracking> T, class Visit>
void VisitMembers(T& tracking, const Visit& visit) {
  visit("window_m", tracking.window_m);
  visit("image_share", tracking.image_share);
  visit("least_step_m", tracking.least_step_m);
  // Logs of before 2026-11-30 have none: then it was ours.
  if constexpr (!std::is_const_v<T>) tracking.front_end = FrontEnd::kSandAndStones;
  if (visit.Has("front_end", true)) {
    visit.Word("front_end", "front end", tracking.front_end,
               std::array{"blocks7", "sand_and_stones"});
  }
}
static_assert(sizeof(NesnasTracking) == 4 * sizeof(double));

template <Of<Nominal> N, class Visit>
void VisitMembers(N& n, const Visit& visit) {
  visit("plan", n.plan);
  visit("motors", n.motors);
  visit("rolling_radius_m", n.rolling_radius_m);
  visit("front", n.front);
  visit("back", n.back);
  visit("arm", n.arm);
  visit("mast", n.mast);
  visit.Word("task", "task", n.task, std::array{"reach", "grasp", "place"});
  visit("reach_m", n.reach_m);
  visit("target_px", n.target_px);
  visit("nesnas", n.nesnas);
  // Logs of before 2026-11-30 have neither.
  if constexpr (!std::is_const_v<N>) n.masses = {};
  if (visit.Has("masses", true)) visit("masses", n.masses);
  if constexpr (!std::is_const_v<N>) n.compute_s = 0.0;
  if (visit.Has("compute_s", true)) visit("compute_s", n.compute_s);
}

Json ToJson(const Nominal& nominal) { return WriteMember(nominal); }

Nominal NominalFromJson(const Json& json) { return ReadNominal<Nominal>(json, "Rocky 7's"); }

}  // namespace dockyard::rocky7
