#include "sim/raposa/nominal_json.h"

#include "models/read/config_error.h"
#include "sim/plant/nominal_parts.h"
#include "sim/raposa/ferreira_members.h"

namespace dockyard::raposa {
namespace {

using dockyard::ToJson;

// Each visitor names every member once, for both ways. A member that is added changes the struct's
// size, and the check below it then fails.
template <class Marks_, class Visit>
void VisitMarks(Marks_& m, Visit&& visit) {
  visit("edge_m", m.edge_m);
  visit("behind_m", m.behind_m);
  visit("guide_diameter_m", m.guide_diameter_m);
  visit("guide_length_m", m.guide_length_m);
  visit("guide_height_m", m.guide_height_m);
  visit("strip_m", m.strip_m);
  visit("rise_rad", m.rise_rad);
  visit("guide_half_angle_rad", m.guide_half_angle_rad);
  visit("guide_up_rad", m.guide_up_rad);
  visit("rod_radius_m", m.rod_radius_m);
  visit("guide_blunt_radius_m", m.guide_blunt_radius_m);
}
static_assert(sizeof(Marks) == 11 * sizeof(double));

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
static_assert(sizeof(FerreiraVision) ==
              13 * sizeof(double) + sizeof(std::vector<BandChange>) - 2 * sizeof(double));

struct Write {
  Json& json;
  template <class Value>
  void operator()(const char* name, const Value& value) const {
    json[name] = value;
  }
};
struct Read {
  const Json& json;
  template <class Value>
  void operator()(const char* name, Value& value) const {
    json.at(name).get_to(value);
  }
};

Json BandToJson(const HsvBand& band) {
  return {band.hue_from,      band.hue_to,     band.saturation_from,
          band.saturation_to, band.value_from, band.value_to};
}

HsvBand BandFromJson(const Json& json) {
  const auto at = [&](std::size_t i) { return json.at(i).get<std::uint8_t>(); };
  return {at(0), at(1), at(2), at(3), at(4), at(5)};
}

Json VisionToJson(const FerreiraVision& vision) {
  Json json{{"orange", BandToJson(vision.orange)}, {"blue", BandToJson(vision.blue)}};
  VisitVision(vision, Write{json});
  json["band_changes"] = Json::array();
  for (const BandChange& change : vision.band_changes) {
    json["band_changes"].push_back({{"at_s", change.at_s},
                                    {"orange", BandToJson(change.orange)},
                                    {"blue", BandToJson(change.blue)}});
  }
  return json;
}

FerreiraVision VisionFromJson(const Json& json) {
  FerreiraVision vision;
  vision.orange = BandFromJson(json.at("orange"));
  vision.blue = BandFromJson(json.at("blue"));
  VisitVision(vision, Read{json});
  for (const Json& change : json.at("band_changes")) {
    vision.band_changes.push_back(
        {change.at("at_s"), BandFromJson(change.at("orange")), BandFromJson(change.at("blue"))});
  }
  return vision;
}

Json CornerToJson(const Eigen::Vector3d& p) { return {p.x(), p.y(), p.z()}; }
Eigen::Vector3d CornerFromJson(const Json& json) {
  const auto p = json.get<std::array<double, 3>>();
  return {p[0], p[1], p[2]};
}

Nominal ReadNominal(const Json& json) {
  Nominal nominal;
  for (std::size_t i = 0; i < nominal.motors.size(); ++i) {
    nominal.motors[i] = MotorFromJson(json.at("motors").at(i));
  }
  nominal.camera = CameraFromJson(json.at("camera"));
  nominal.X_RC = Pose3FromJson(json.at("X_RC"));
  nominal.camera_delay_s = json.at("camera_delay_s");
  nominal.half_view_rad = json.at("half_view_rad");
  VisitMarks(nominal.marks, Read{json.at("marks")});
  for (const Json& box : json.at("grey_boxes")) {
    nominal.grey_boxes.push_back({CornerFromJson(box.at("low")), CornerFromJson(box.at("high"))});
  }
  nominal.sprocket_radius_m = json.at("sprocket_radius_m");
  nominal.gauge_m = json.at("gauge_m");
  nominal.effective_gauge_m = json.at("effective_gauge_m");
  nominal.body_belt_m = json.at("body_belt_m");
  nominal.arm_length_m = json.at("arm_length_m");
  nominal.door_pinion_radius_m = json.at("door_pinion_radius_m");
  nominal.door_travel_m = json.at("door_travel_m");
  nominal.p_RS = CornerFromJson(json.at("p_RS"));
  nominal.ferreira_vision = VisionFromJson(json.at("ferreira_vision"));
  VisitMotion(nominal.ferreira_motion, Read{json.at("ferreira_motion")});
  return nominal;
}

}  // namespace

Json ToJson(const Nominal& nominal) {
  Json motors = Json::array();
  for (const NominalMotor& motor : nominal.motors) motors.push_back(MotorToJson(motor));
  Json marks, motion, boxes = Json::array();
  for (const GreyBox& box : nominal.grey_boxes) {
    boxes.push_back({{"low", CornerToJson(box.low)}, {"high", CornerToJson(box.high)}});
  }
  VisitMarks(nominal.marks, Write{marks});
  VisitMotion(nominal.ferreira_motion, Write{motion});
  return {{"motors", motors},
          {"camera", CameraToJson(nominal.camera)},
          {"X_RC", ToJson(nominal.X_RC)},
          {"camera_delay_s", nominal.camera_delay_s},
          {"half_view_rad", nominal.half_view_rad},
          {"marks", marks},
          {"grey_boxes", boxes},
          {"sprocket_radius_m", nominal.sprocket_radius_m},
          {"gauge_m", nominal.gauge_m},
          {"effective_gauge_m", nominal.effective_gauge_m},
          {"body_belt_m", nominal.body_belt_m},
          {"arm_length_m", nominal.arm_length_m},
          {"door_pinion_radius_m", nominal.door_pinion_radius_m},
          {"door_travel_m", nominal.door_travel_m},
          {"p_RS", CornerToJson(nominal.p_RS)},
          {"ferreira_vision", VisionToJson(nominal.ferreira_vision)},
          {"ferreira_motion", motion}};
}

Nominal NominalFromJson(const Json& json) {
  try {
    return ReadNominal(json);
  } catch (const Json::exception& error) {
    throw ConfigError(std::string("nominal parameters: expected RAPOSA's, found others: ") +
                      error.what());
  }
}

}  // namespace dockyard::raposa
