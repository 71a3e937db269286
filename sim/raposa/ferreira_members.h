// The names of ferreira2009's motion and vision, once for files and scenarios.
#pragma once

#include "controller/raposa/nominal/ferreira_options.h"

namespace dockyard::raposa {

/// Calls visit(name, member) for each member.
template <class Motion, class Visit>
void VisitMotion(Motion& m, Visit&& visit) {
  visit("region_one_rad", m.region_one_rad);
  visit("tolerance_rad", m.tolerance_rad);
  visit("tolerance_from_m", m.tolerance_from_m);
  visit("tolerance_to_m", m.tolerance_to_m);
  visit("dead_zone_m", m.dead_zone_m);
  visit("orange_far_m", m.orange_far_m);
  visit("final_m", m.final_m);
  visit("slow_below_m", m.slow_below_m);
  visit("k_linear_per_s", m.k_linear_per_s);
  visit("k_angular_rad_s_px", m.k_angular_rad_s_px);
  visit("k_arm_rad_px", m.k_arm_rad_px);
  visit("final_speed_m_s", m.final_speed_m_s);
  visit("final_s", m.final_s);
  visit("settle_s", m.settle_s);
  visit("doors_s", m.doors_s);
  visit("close_s", m.close_s);
  visit("steer_final", m.steer_final);
  visit("standoff_m", m.standoff_m);
  visit("travel_m_s", m.travel_m_s);
  visit("turn_rad_s", m.turn_rad_s);
  visit("visual_turn_rad_s", m.visual_turn_rad_s);
  visit("search_turn_rad_s", m.search_turn_rad_s);
  visit("first_search_rad", m.first_search_rad);
  visit("most_search_rad", m.most_search_rad);
  visit("turn_tolerance_rad", m.turn_tolerance_rad);
  visit("way_tolerance_m", m.way_tolerance_m);
  visit("turn_gain_per_s", m.turn_gain_per_s);
  visit("way_gain_per_s", m.way_gain_per_s);
  visit("lead_m", m.lead_m);
  visit("look_s", m.look_s);
  visit("creep_m_s", m.creep_m_s);
  visit("blue_sweep", m.blue_sweep);
  visit("doubt_s", m.doubt_s);
  visit("arm_below_m", m.arm_below_m);
  visit("level_arm_rad", m.level_arm_rad);
  visit("least_arm_rad", m.least_arm_rad);
  visit("most_arm_rad", m.most_arm_rad);
}
// A member that is added changes the size.
static_assert(sizeof(FerreiraMotion) == 37 * sizeof(double));

/// The same for the numbers of its vision.
template <class Vision, class Visit>
void VisitVision(Vision& v, Visit&& visit) {
  visit("least_area_px2", v.least_area_px2);
  visit("least_axis_ratio", v.least_axis_ratio);
  visit("most_deviation", v.most_deviation);
  visit("tight_deviation", v.tight_deviation);
  visit("most_area_factor", v.most_area_factor);
  visit("tight_area_factor", v.tight_area_factor);
  visit("ball_px", v.ball_px);
  visit("lost_frames", v.lost_frames);
  visit("area_at_one_m_px2", v.area_at_one_m_px2);
}

}  // namespace dockyard::raposa
