#include "sim/axel/nominal_json.h"

#include "sim/plant/nominal_parts.h"

namespace dockyard::axel {

template <Of<MappedRock> R, class Visit>
void VisitMembers(R& rock, const Visit& visit) {
  visit("x_m", rock.x_m);
  visit("y_m", rock.y_m);
  visit("radius_m", rock.radius_m);
  visit("height_m", rock.height_m);
}

template <Of<RockMap> M, class Visit>
void VisitMembers(M& map, const Visit& visit) {
  visit("rocks", map.rocks);
  visit("sigma_m", map.sigma_m);
}

/// Of the blob filter of Tsai et al. (2013).
template <class Vision, class Visit>
void VisitTsai2013Blobs(Vision& vision, const Visit& visit) {
  visit("least_area_px", vision.least_area_px);
  visit("most_area_share", vision.most_area_share);
  visit("least_axis_ratio", vision.least_axis_ratio);
  visit("most_holes", vision.most_holes);
  visit("coincidence", vision.coincidence);
  visit("least_white", vision.least_white);
  visit("most_white", vision.most_white);
  visit("fullness", vision.fullness);
  visit("pattern_within", vision.pattern_within);
}

/// What Tsai et al. (2013) leave open.
template <class Vision, class Options, class Visit>
void VisitTsai2013(Vision& vision, Options& options, const Visit& visit) {
  visit.Word("first", "tsai2013 first", vision.first,
             std::array{"lowest", "topmost", "leftmost", "largest"});
  visit("black_below_mean", vision.black_below_mean);
  visit("window_share", vision.window_share);
  visit("closeness_px", vision.closeness_px);
  visit("closeness_radii", vision.closeness_radii);
  visit("agreeing_points", vision.agreeing_points);
  if (visit.Has("least_area_px", true)) VisitTsai2013Blobs(vision, visit);  // not in earlier logs
  visit("align_r_m", options.align_r_m);
  visit("mate_r_m", options.mate_r_m);
  visit("mate_gap_m", options.mate_gap_m);
  visit("recover_r_m", options.recover_r_m);
  visit("heading_rad", options.heading_rad);
  visit("tip_offset_m", options.tip_offset_m);
  visit("contact_depth_m", options.contact_depth_m);
  visit("contact_within_m", options.contact_within_m);
  visit("reel_in_m", options.reel_in_m);
  visit("turn_cost_m", options.turn_cost_m);
  visit("least_radius_m", options.least_radius_m);
  visit("most_turn_rad", options.most_turn_rad);
  visit("drive_m_s", options.drive_m_s);
  visit("mate_m_s", options.mate_m_s);
  visit("reel_m_s", options.reel_m_s);
  visit("wheel_accel_rad_s2", options.wheel_accel_rad_s2);
  visit("taut_n", options.taut_n);
  visit("tighten_m_s", options.tighten_m_s);
  visit("blind_looks", options.blind_looks);
  visit("look_pitch_rad", options.look_pitch_rad);
}

template <Of<TetherSensor> S, class Visit>
void VisitMembers(S& sensor, const Visit& visit) {
  visit("tension_noise_n", sensor.tension_noise_n);
  visit("direction_noise_rad", sensor.direction_noise_rad);
}

template <Of<Nominal> N, class Visit>
void VisitMembers(N& n, const Visit& visit) {
  visit("left_camera", n.rig.left);
  visit("right_camera", n.rig.right);
  visit("X_RL", n.rig.X_RL);
  visit("X_RQ", n.rig.X_RQ);
  visit("shutter_s", n.shutter_s);
  visit("board", n.board);
  visit.Within("vision", [&](const auto& in) {
    in.Word("pipeline", "vision pipeline", n.vision.pipeline, std::array{"dockyard", "tsai2013"});
    in("min_points", n.vision.min_points);
    in("while_driving", n.vision.while_driving);
    in("bracket_stops", n.vision.bracket_stops);
  });
  visit("X_DB", n.X_DB);
  visit("motors", n.motors);
  visit("wheel_radius_m", n.wheel_radius_m);
  visit("paddle_pitch_m", n.paddle_pitch_m);
  visit("track_m", n.track_m);
  visit("arm_length_m", n.arm_length_m);
  visit("arm_at_zero_rad", n.arm_at_zero_rad);
  visit("drum_radius_m", n.drum_radius_m);
  visit("mouth_height_m", n.mouth_height_m);
  visit("anchor_depth_m", n.anchor_depth_m);
  visit("spool_friction_n", n.spool_friction_n);
  if (visit.Has("gravity_m_s2", true)) visit("gravity_m_s2", n.gravity_m_s2);  // as the next two
  if (visit.Has("rover_mass_kg", true)) {                                      // the same
    visit("rover_mass_kg", n.rover_mass_kg);
    visit("arm_down_nm", n.arm_down_nm);
    visit("seated_play_rad", n.seated_play_rad);
  }
  if (visit.Has("station_weight_n", true)) {  // logs of earlier versions have none
    visit("station_weight_n", n.station_weight_n);
    visit("station_friction", n.station_friction);
  }
  if (visit.Has("station_back_m", true)) {  // as these
    visit("station_back_m", n.station_back_m);
    visit("station_spread_m", n.station_spread_m);
  }
  visit("throat_depth_m", n.throat_depth_m);
  visit("seat_depth_m", n.seat_depth_m);
  visit("mating_depth_m", n.mating_depth_m);
  visit("tether_sensor", n.tether_sensor);
  if (visit.Has("tsai2013", true)) {  // logs of earlier versions have none
    visit.Within("tsai2013",
                 [&](const auto& in) { VisitTsai2013(n.vision.tsai2013, n.tsai2013, in); });
  }
  if (visit.Has("rock_map", !n.rock_map.rocks.empty())) visit("rock_map", n.rock_map);
  if (visit.Has("excursion_m", n.excursion_m > 0.0)) visit("excursion_m", n.excursion_m);
}

Json ToJson(const Nominal& nominal) { return WriteMember(nominal); }

Nominal NominalFromJson(const Json& json) { return ReadNominal<Nominal>(json, "Axel's"); }

}  // namespace dockyard::axel
