#include "sim/axel/tsai2013_json.h"

#include "models/read/config_error.h"

namespace dockyard::axel {
namespace {

constexpr const char* kFirst[] = {"lowest", "topmost", "leftmost", "largest"};

/// Names every number once, for writing and for reading.
template <class Vision, class Options, class Each>
void ForEach(Vision& vision, Options& options, const Each& each) {
  each("black_below_mean", vision.black_below_mean);
  each("window_share", vision.window_share);
  each("closeness_px", vision.closeness_px);
  each("closeness_radii", vision.closeness_radii);
  each("agreeing_points", vision.agreeing_points);
  each("align_r_m", options.align_r_m);
  each("mate_r_m", options.mate_r_m);
  each("mate_gap_m", options.mate_gap_m);
  each("recover_r_m", options.recover_r_m);
  each("heading_rad", options.heading_rad);
  each("tip_offset_m", options.tip_offset_m);
  each("contact_depth_m", options.contact_depth_m);
  each("contact_within_m", options.contact_within_m);
  each("reel_in_m", options.reel_in_m);
  each("turn_cost_m", options.turn_cost_m);
  each("least_radius_m", options.least_radius_m);
  each("most_turn_rad", options.most_turn_rad);
  each("drive_m_s", options.drive_m_s);
  each("mate_m_s", options.mate_m_s);
  each("reel_m_s", options.reel_m_s);
  each("wheel_accel_rad_s2", options.wheel_accel_rad_s2);
  each("taut_n", options.taut_n);
  each("tighten_m_s", options.tighten_m_s);
  each("blind_looks", options.blind_looks);
  each("look_pitch_rad", options.look_pitch_rad);
}

}  // namespace

Json Tsai2013ToJson(const Tsai2013Vision& vision, const Tsai2013Options& options) {
  Json json{{"first", kFirst[static_cast<std::size_t>(vision.first)]}};
  ForEach(vision, options, [&](const char* key, const auto& value) { json[key] = value; });
  return json;
}

void ReadTsai2013(const Json& nominal, Tsai2013Vision* vision, Tsai2013Options* options) {
  if (!nominal.contains("tsai2013")) return;
  const Json& json = nominal.at("tsai2013");
  ForEach(*vision, *options, [&](const char* key, auto& value) { json.at(key).get_to(value); });
  const std::string first = json.at("first");
  for (std::size_t i = 0; i < std::size(kFirst); ++i) {
    if (first != kFirst[i]) continue;
    vision->first = static_cast<Tsai2013First>(i);
    return;
  }
  throw ConfigError("tsai2013 first: expected lowest, topmost, leftmost or largest, found '" +
                    first + "'");
}

}  // namespace dockyard::axel
