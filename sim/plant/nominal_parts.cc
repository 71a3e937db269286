#include "sim/plant/nominal_parts.h"

#include <array>
#include <optional>
#include <string>
#include <variant>

#include "models/read/config_error.h"

namespace dockyard {
namespace {

Json LensToJson(const KannalaBrandt& lens) {
  return {{"model", "kannala_brandt"},
          {"fx", lens.fx},
          {"fy", lens.fy},
          {"cx", lens.cx},
          {"cy", lens.cy},
          {"k", lens.k}};
}

Json LensToJson(const BrownPinhole& lens) {
  return {{"model", "brown"}, {"fx", lens.fx}, {"fy", lens.fy}, {"cx", lens.cx}, {"cy", lens.cy},
          {"k1", lens.k1},    {"k2", lens.k2}, {"p1", lens.p1}, {"p2", lens.p2}, {"k3", lens.k3}};
}

Json LensToJson(const Cahvore& lens) {
  const auto list = [](const Eigen::Vector3d& v) { return Json{v.x(), v.y(), v.z()}; };
  return {{"model", "cahvore"}, {"C", list(lens.C)}, {"A", list(lens.A)},
          {"H", list(lens.H)},  {"V", list(lens.V)}, {"O", list(lens.O)},
          {"R", list(lens.R)},  {"E", list(lens.E)}, {"linearity", lens.linearity}};
}

/// Focal lengths and centre, which every lens but CAHV* has.
template <typename L>
Json NamedLens(const char* model, const L& lens) {
  return {{"model", model}, {"fx", lens.fx}, {"fy", lens.fy}, {"cx", lens.cx}, {"cy", lens.cy}};
}

Json LensToJson(const RationalPinhole& lens) {
  Json json = NamedLens("rational", lens);
  json.update({{"k", lens.k}, {"p1", lens.p1}, {"p2", lens.p2}});
  return json;
}

Json LensToJson(const DoubleSphere& lens) {
  Json json = NamedLens("double_sphere", lens);
  json.update({{"xi", lens.xi}, {"alpha", lens.alpha}});
  return json;
}

Json LensToJson(const Eucm& lens) {
  Json json = NamedLens("eucm", lens);
  json.update({{"alpha", lens.alpha}, {"beta", lens.beta}});
  return json;
}

Json LensToJson(const Omni& lens) {
  Json json = NamedLens("omni", lens);
  json.update(
      {{"xi", lens.xi}, {"k1", lens.k1}, {"k2", lens.k2}, {"p1", lens.p1}, {"p2", lens.p2}});
  return json;
}

Json LensToJson(const FovPinhole& lens) {
  Json json = NamedLens("fov", lens);
  json.update({{"w_rad", lens.w_rad}});
  return json;
}

/// The lenses of other people's calibrations; none: the model is none of them.
std::optional<Lens> OtherLensFromJson(const std::string& model, const Json& json) {
  const auto with_focal = [&](auto lens) {
    lens.fx = json.at("fx");
    lens.fy = json.at("fy");
    lens.cx = json.at("cx");
    lens.cy = json.at("cy");
    return lens;
  };
  if (model == "rational") {
    return with_focal(RationalPinhole{
        .k = json.at("k").get<std::array<double, 6>>(), .p1 = json.at("p1"), .p2 = json.at("p2")});
  }
  if (model == "double_sphere") {
    return with_focal(DoubleSphere{.xi = json.at("xi"), .alpha = json.at("alpha")});
  }
  if (model == "eucm") return with_focal(Eucm{.alpha = json.at("alpha"), .beta = json.at("beta")});
  if (model == "omni") {
    return with_focal(Omni{.xi = json.at("xi"),
                           .k1 = json.at("k1"),
                           .k2 = json.at("k2"),
                           .p1 = json.at("p1"),
                           .p2 = json.at("p2")});
  }
  if (model == "fov") return with_focal(FovPinhole{.w_rad = json.at("w_rad")});
  return std::nullopt;
}

Lens LensFromJson(const Json& json) {
  const auto vector = [&](const char* key) {
    const auto v = json.at(key).get<std::array<double, 3>>();
    return Eigen::Vector3d(v[0], v[1], v[2]);
  };
  const std::string model = json.at("model");
  if (model == "cahvore") {
    return Cahvore{.C = vector("C"),
                   .A = vector("A"),
                   .H = vector("H"),
                   .V = vector("V"),
                   .O = vector("O"),
                   .R = vector("R"),
                   .E = vector("E"),
                   .linearity = json.at("linearity")};
  }
  if (model == "brown") {
    return BrownPinhole{.fx = json.at("fx"),
                        .fy = json.at("fy"),
                        .cx = json.at("cx"),
                        .cy = json.at("cy"),
                        .k1 = json.at("k1"),
                        .k2 = json.at("k2"),
                        .k3 = json.at("k3"),
                        .p1 = json.at("p1"),
                        .p2 = json.at("p2")};
  }
  if (model == "kannala_brandt") {
    return KannalaBrandt{.fx = json.at("fx"),
                         .fy = json.at("fy"),
                         .cx = json.at("cx"),
                         .cy = json.at("cy"),
                         .k = json.at("k").get<std::array<double, 4>>()};
  }
  if (const std::optional<Lens> lens = OtherLensFromJson(model, json)) return *lens;
  throw ConfigError(
      "lens model: expected kannala_brandt, brown, cahvore, rational, double_sphere, eucm, omni or "
      "fov, found '" +
      model + "'");
}

}  // namespace

Json CameraToJson(const Camera& camera) {
  Json json{{"width", camera.width}, {"height", camera.height}};
  json.update(std::visit([](const auto& lens) { return LensToJson(lens); }, camera.lens));
  return json;
}

Camera CameraFromJson(const Json& json) {
  return {.width = json.at("width"), .height = json.at("height"), .lens = LensFromJson(json)};
}

Json MotorToJson(const NominalMotor& motor) {
  return {{"rad_per_count", motor.rad_per_count},
          {"torque_per_amp_nm", motor.torque_per_amp_nm},
          {"no_load_current_a", motor.no_load_current_a},
          {"max_current_a", motor.max_current_a},
          {"max_speed_rad_s", motor.max_speed_rad_s},
          {"max_accel_rad_s2", motor.max_accel_rad_s2}};
}

NominalMotor MotorFromJson(const Json& json) {
  NominalMotor motor;
  motor.rad_per_count = json.at("rad_per_count");
  motor.torque_per_amp_nm = json.at("torque_per_amp_nm");
  motor.no_load_current_a = json.at("no_load_current_a");
  motor.max_current_a = json.at("max_current_a");
  motor.max_speed_rad_s = json.at("max_speed_rad_s");
  motor.max_accel_rad_s2 = json.at("max_accel_rad_s2");
  return motor;
}

}  // namespace dockyard
