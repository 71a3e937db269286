#include "sim/raposa/nominal_json.h"

#include "sim/plant/nominal_parts.h"
#include "sim/raposa/ferreira_members.h"

namespace dockyard {

static Json ToJson(const HsvBand& band) {
  return {band.hue_from,      band.hue_to,     band.saturation_from,
          band.saturation_to, band.value_from, band.value_to};
}

static void FromJson(const Json& json, HsvBand& band) {
  const auto at = [&](std::size_t i) { return json.at(i).get<std::uint8_t>(); };
  band = {at(0), at(1), at(2), at(3), at(4), at(5)};
}

}  // namespace dockyard

namespace dockyard::raposa {

// A member that is added changes the struct's size, and the check below its visitor then fails.
template <Of<Marks> M, class Visit>
void VisitMembers(M& m, const Visit& visit) {
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

template <Of<BandChange> C, class Visit>
void VisitMembers(C& change, const Visit& visit) {
  visit("at_s", change.at_s);
  visit("orange", change.orange);
  visit("blue", change.blue);
}

template <Of<FerreiraVision> V, class Visit>
void VisitMembers(V& v, const Visit& visit) {
  visit("orange", v.orange);
  visit("blue", v.blue);
  VisitVision(v, visit);
  visit("band_changes", v.band_changes);
}
static_assert(sizeof(FerreiraVision) ==
              13 * sizeof(double) + sizeof(std::vector<BandChange>) - 2 * sizeof(double));

template <Of<FerreiraMotion> M, class Visit>
void VisitMembers(M& motion, const Visit& visit) {
  VisitMotion(motion, visit);
}

template <Of<GreyBox> B, class Visit>
void VisitMembers(B& box, const Visit& visit) {
  visit("low", box.low);
  visit("high", box.high);
}

template <Of<Nominal> N, class Visit>
void VisitMembers(N& n, const Visit& visit) {
  visit("motors", n.motors);
  visit("camera", n.camera);
  visit("X_RC", n.X_RC);
  visit("camera_delay_s", n.camera_delay_s);
  visit("half_view_rad", n.half_view_rad);
  visit("marks", n.marks);
  visit("grey_boxes", n.grey_boxes);
  visit("sprocket_radius_m", n.sprocket_radius_m);
  visit("gauge_m", n.gauge_m);
  visit("effective_gauge_m", n.effective_gauge_m);
  visit("body_belt_m", n.body_belt_m);
  visit("arm_length_m", n.arm_length_m);
  visit("door_pinion_radius_m", n.door_pinion_radius_m);
  visit("door_travel_m", n.door_travel_m);
  visit("p_RS", n.p_RS);
  visit("ferreira_vision", n.ferreira_vision);
  visit("ferreira_motion", n.ferreira_motion);
}

Json ToJson(const Nominal& nominal) { return WriteMember(nominal); }

Nominal NominalFromJson(const Json& json) { return ReadNominal<Nominal>(json, "RAPOSA's"); }

}  // namespace dockyard::raposa
