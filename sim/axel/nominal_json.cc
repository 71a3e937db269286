#include "sim/axel/nominal_json.h"

#include "models/read/config_error.h"
#include "sim/axel/tsai2013_json.h"
#include "sim/plant/nominal_parts.h"

namespace dockyard::axel {
namespace {

using dockyard::ToJson;

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
