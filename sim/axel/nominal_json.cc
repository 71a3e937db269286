#include "sim/axel/nominal_json.h"

#include "models/read/config_error.h"
#include "sim/axel/tsai2013_json.h"

namespace dockyard::axel {
namespace {

using dockyard::ToJson;

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
  throw ConfigError("lens model: expected kannala_brandt, brown or cahvore, found '" + model + "'");
}

Json CameraToJson(const Camera& camera) {
  Json json{{"width", camera.width}, {"height", camera.height}};
  json.update(std::visit([](const auto& lens) { return LensToJson(lens); }, camera.lens));
  return json;
}

Camera CameraFromJson(const Json& json) {
  return {.width = json.at("width"), .height = json.at("height"), .lens = LensFromJson(json)};
}

Json BoardToJson(const FiducialBoard& board) {
  Json fiducials = Json::array();
  for (const Fiducial& fiducial : board.fiducials) {
    fiducials.push_back({{"p_m", ToJson(fiducial.p_BF)}, {"rotation_rad", fiducial.rotation}});
  }
  Json json{{"width_m", board.width_m},
            {"height_m", board.height_m},
            {"disc_diameter_m", board.disc_diameter_m},
            {"bar_length_m", board.bar_length_m},
            {"bar_width_m", board.bar_width_m},
            {"fiducials", fiducials}};
  const Upright& upright = board.upright;
  if (upright.against == Upright::Against::kPlumb) return json;
  json["upright_in"] = upright.against == Upright::Against::kGravity ? "gravity" : "image";
  json["upright_within_rad"] = upright.within_rad;
  return json;
}

FiducialBoard BoardFromJson(const Json& json) {
  FiducialBoard board;
  board.width_m = json.at("width_m");
  board.height_m = json.at("height_m");
  board.disc_diameter_m = json.at("disc_diameter_m");
  board.bar_length_m = json.at("bar_length_m");
  board.bar_width_m = json.at("bar_width_m");
  for (const Json& entry : json.at("fiducials")) {
    Fiducial fiducial;
    fiducial.p_BF =
        Eigen::Vector2d(entry.at("p_m").at(0).get<double>(), entry.at("p_m").at(1).get<double>());
    fiducial.rotation = entry.at("rotation_rad");
    board.fiducials.push_back(fiducial);
  }
  if (json.contains("upright_in")) {
    const std::string against = json.at("upright_in");
    if (against != "gravity" && against != "image") {
      throw ConfigError("upright_in: expected gravity or image, found '" + against + "'");
    }
    board.upright.against =
        against == "gravity" ? Upright::Against::kGravity : Upright::Against::kImage;
    board.upright.within_rad = json.at("upright_within_rad");
  }
  return board;
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

VisionSettings VisionFromJson(const Json& json) {
  VisionSettings vision;
  const std::string name = json.at("pipeline");
  if (name == PipelineName(VisionPipeline::kTsai2013)) {
    vision.pipeline = VisionPipeline::kTsai2013;
  } else if (name != PipelineName(VisionPipeline::kDockyard)) {
    throw ConfigError("vision pipeline: expected dockyard or tsai2013, found '" + name + "'");
  }
  vision.min_points = json.at("min_points");
  vision.while_driving = json.at("while_driving");
  vision.bracket_stops = json.at("bracket_stops");
  return vision;
}

Json RocksToJson(const RockMap& map) {
  Json rocks = Json::array();
  for (const MappedRock& rock : map.rocks) {
    rocks.push_back({{"x_m", rock.x_m},
                     {"y_m", rock.y_m},
                     {"radius_m", rock.radius_m},
                     {"height_m", rock.height_m}});
  }
  return {{"rocks", rocks}, {"sigma_m", map.sigma_m}};
}

RockMap RocksFromJson(const Json& json) {
  RockMap map{.rocks = {}, .sigma_m = json.at("sigma_m")};
  for (const Json& rock : json.at("rocks")) {
    map.rocks.push_back({rock.at("x_m"), rock.at("y_m"), rock.at("radius_m"), rock.at("height_m")});
  }
  return map;
}

Nominal Read(const Json& json) {
  Nominal nominal;
  nominal.rig.left = CameraFromJson(json.at("left_camera"));
  nominal.rig.right = CameraFromJson(json.at("right_camera"));
  nominal.rig.X_RL = Pose3FromJson(json.at("X_RL"));
  nominal.rig.X_RQ = Pose3FromJson(json.at("X_RQ"));
  nominal.shutter_s = json.at("shutter_s");
  nominal.board = BoardFromJson(json.at("board"));
  nominal.vision = VisionFromJson(json.at("vision"));
  ReadTsai2013(json, &nominal.vision.tsai2013, &nominal.tsai2013);
  nominal.X_DB = Pose3FromJson(json.at("X_DB"));
  for (std::size_t i = 0; i < nominal.motors.size(); ++i) {
    nominal.motors[i] = MotorFromJson(json.at("motors").at(i));
  }
  nominal.wheel_radius_m = json.at("wheel_radius_m");
  nominal.paddle_pitch_m = json.at("paddle_pitch_m");
  nominal.track_m = json.at("track_m");
  nominal.arm_length_m = json.at("arm_length_m");
  nominal.arm_at_zero_rad = json.at("arm_at_zero_rad");
  nominal.drum_radius_m = json.at("drum_radius_m");
  nominal.mouth_height_m = json.at("mouth_height_m");
  nominal.anchor_depth_m = json.at("anchor_depth_m");
  nominal.spool_friction_n = json.at("spool_friction_n");
  nominal.throat_depth_m = json.at("throat_depth_m");
  nominal.seat_depth_m = json.at("seat_depth_m");
  nominal.mating_depth_m = json.at("mating_depth_m");
  if (json.contains("rock_map")) nominal.rock_map = RocksFromJson(json.at("rock_map"));
  nominal.excursion_m = json.value("excursion_m", 0.0);
  return nominal;
}

}  // namespace

Json ToJson(const Nominal& nominal) {
  Json motors = Json::array();
  for (const NominalMotor& motor : nominal.motors) motors.push_back(MotorToJson(motor));
  Json json{{"left_camera", CameraToJson(nominal.rig.left)},
            {"right_camera", CameraToJson(nominal.rig.right)},
            {"X_RL", ToJson(nominal.rig.X_RL)},
            {"X_RQ", ToJson(nominal.rig.X_RQ)},
            {"shutter_s", nominal.shutter_s},
            {"board", BoardToJson(nominal.board)},
            {"vision",
             {{"pipeline", PipelineName(nominal.vision.pipeline)},
              {"min_points", nominal.vision.min_points},
              {"while_driving", nominal.vision.while_driving},
              {"bracket_stops", nominal.vision.bracket_stops}}},
            {"X_DB", ToJson(nominal.X_DB)},
            {"motors", motors},
            {"wheel_radius_m", nominal.wheel_radius_m},
            {"paddle_pitch_m", nominal.paddle_pitch_m},
            {"track_m", nominal.track_m},
            {"arm_length_m", nominal.arm_length_m},
            {"arm_at_zero_rad", nominal.arm_at_zero_rad},
            {"drum_radius_m", nominal.drum_radius_m},
            {"mouth_height_m", nominal.mouth_height_m},
            {"anchor_depth_m", nominal.anchor_depth_m},
            {"spool_friction_n", nominal.spool_friction_n},
            {"throat_depth_m", nominal.throat_depth_m},
            {"seat_depth_m", nominal.seat_depth_m},
            {"mating_depth_m", nominal.mating_depth_m},
            {"tsai2013", Tsai2013ToJson(nominal.vision.tsai2013, nominal.tsai2013)}};
  if (!nominal.rock_map.rocks.empty()) json["rock_map"] = RocksToJson(nominal.rock_map);
  if (nominal.excursion_m > 0.0) json["excursion_m"] = nominal.excursion_m;
  return json;
}

Nominal NominalFromJson(const Json& json) {
  try {
    return Read(json);
  } catch (const Json::exception& error) {
    throw ConfigError(std::string("nominal parameters: expected Axel's, found others: ") +
                      error.what());
  }
}

}  // namespace dockyard::axel
