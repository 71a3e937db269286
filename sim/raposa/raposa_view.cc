#include "sim/raposa/raposa_view.h"

#include <cmath>

#include "render/shading.h"
#include "sim/base/random.h"
#include "sim/plant/drawn_mesh.h"
#include "sim/plant/ground_spectrum.h"
#include "sim/plant/ground_view.h"
#include "sim/plant/sun_motion.h"
#include "sim/raposa/mark_meshes.h"
#include "sim/raposa/robot_parts.h"
#include "sim/run/shade_body.h"

namespace dockyard::raposa {
namespace {

// Indices of the materials that every scene has.
constexpr int kGround = 0, kOrange = 1, kBlue = 2;
constexpr double kDaylightFrom_k = 4000.0;
// Of cable and rod, and of the bare faces. Assumed, 0.03-0.1 and 0.2-0.4.
constexpr double kRubber = 0.06, kBareFaces = 0.30;
// From this blur on one ray a pixel is enough: its steps of a pixel are 1 px / sqrt(12) = 0.3 px.
constexpr double kRayBlur_px = 0.6;
// Linear colours for spectators alone.
const Eigen::Vector3d kOrangeRgb(0.71, 0.12, 0.02), kBlueRgb(0.01, 0.09, 0.34);

std::vector<StagePart> PartsOf(std::vector<RobotPart> parts) {
  std::vector<StagePart> out;
  for (RobotPart& part : parts) {
    out.push_back({std::make_shared<const RenderMesh>(std::move(part.mesh)), Pose3{}, part.rgb});
  }
  return out;
}

}  // namespace

Spectrum LightOf(double temperature_k) {
  return temperature_k < kDaylightFrom_k ? PlanckLight(temperature_k)
                                         : DaylightLight(temperature_k);
}

SceneBuilder::SceneBuilder(const BuiltRun& built, Lighting lighting, const Seed& run_seed)
    : lighting_(std::move(lighting)),
      lamps_(built.world.robot.lamps),
      X_WG_(SiteInWorld(built.world.X_WG, built.world.slope)),
      cable_m_(built.world.pyramid.cable.diameter_m),
      grain_(built.ground.grain),
      mark_reach_m_(built.world.pyramid.marks.behind_m),
      p_RC_(built.world.robot.camera.X_RC.p),
      hide_pyramid_(built.keys.hide_pyramid),
      texture_seed_(StreamKey(run_seed, "texture")) {
  const RaposaKeys& keys = built.keys;
  spectra_.sun = LightOf(keys.light_k);
  spectra_.sky = std::isnan(keys.fill_light_k) ? spectra_.sun : LightOf(keys.fill_light_k);
  spectra_.lamps = {WhiteDiodeLight()};
  spectra_.materials = {SpectrumOf(built.ground.material), OrangePaint(), BluePaint()};
  spectra_.ground = kGround;
  const RobotModel& robot = built.world.robot;
  const PyramidModel& pyramid = built.world.pyramid;
  body_ = Convert(robot.body.visuals);
  arm_ = Convert(robot.arm.visuals);
  left_door_ = Convert(robot.left_door.visuals);
  right_door_ = Convert(robot.right_door.visuals);
  socket_ = PartsOf(SocketParts(robot));
  left_plate_ = PartsOf(DoorParts(robot.doors, true));
  right_plate_ = PartsOf(DoorParts(robot.doors, false));
  pyramid_ = Convert(pyramid.body.visuals);
  const auto mark = [&](RenderMesh mesh, const Eigen::Vector3d& rgb, int material) {
    pyramid_.push_back({std::make_shared<const RenderMesh>(std::move(mesh)), {}, rgb, material});
  };
  mark(GuideMesh(pyramid.guide), kOrangeRgb, kOrange);
  mark(StripsMesh(pyramid.marks), kBlueRgb, kBlue);
  mark(FacesMesh(pyramid.marks), Eigen::Vector3d::Constant(kBareFaces), GreyMaterial(kBareFaces));
  mark(RodMesh(pyramid), Eigen::Vector3d::Constant(kRubber), GreyMaterial(kRubber));
  cable_material_ = GreyMaterial(kRubber);
  for (SceneryObject& thing : lighting_.scenery) {
    thing.object.material = MaterialOf(thing.reflectance);
  }
  const CameraResponse response = CheapCamera();
  ground_rgb_ = ColourOf(DaylightLight(6500.0), spectra_.materials[kGround], response)
                    .cwiseProduct(BalanceFor(DaylightLight(6500.0), response));
  colours_ = MakeColourTable(spectra_, response);
}

int SceneBuilder::GreyMaterial(double reflectance) { return MaterialOf(EvenGrey(reflectance)); }

int SceneBuilder::MaterialOf(const Spectrum& reflectance) {
  for (std::size_t i = kBlue + 1; i < spectra_.materials.size(); ++i) {
    if (spectra_.materials[i] == reflectance) return static_cast<int>(i);
  }
  spectra_.materials.push_back(reflectance);
  return static_cast<int>(spectra_.materials.size()) - 1;
}

std::vector<DrawnPart> SceneBuilder::Convert(const std::vector<Visual>& visuals) {
  std::vector<DrawnPart> parts = DrawnParts(visuals);
  for (DrawnPart& part : parts) part.material = GreyMaterial(Luminance(part.albedo));
  return parts;
}

Scene SceneBuilder::Make(const Truth& truth, const HeightGrid& ground, bool lamps_on) const {
  Scene scene;
  // The camera looks out of the robot: of its own body it sees the shadow.
  AddParts(body_, truth.X_WR, scene.objects);
  AddParts(arm_, truth.X_WA, scene.objects);
  AddParts(left_door_, truth.X_W_left_door, scene.objects);
  AddParts(right_door_, truth.X_W_right_door, scene.objects);
  for (SceneObject& own : scene.objects) own.seen = false;
  if (!hide_pyramid_) AddParts(pyramid_, truth.X_WP, scene.objects);
  AddSurroundings(lighting_, scene.objects);
  scene.ground = ViewOf(ground, X_WG_, ground_rgb_, texture_seed_);
  scene.ground.grain = grain_;
  scene.ground.material = kGround;
  scene.tether.points_W = truth.cable_W;
  scene.tether.diameter_m = cable_m_;
  scene.tether.material = cable_material_;
  scene.light = LightAt(lighting_, truth.time_s);
  scene.interest =
      Interest{truth.X_WP * Eigen::Vector3d(-0.5 * mark_reach_m_, 0.0, 0.0), mark_reach_m_};
  if (!lamps_on) return scene;
  for (const double side : {-0.5, 0.5}) {
    const Eigen::Vector3d p_R = lamps_.p_R + Eigen::Vector3d(0.0, side * lamps_.apart_m, 0.0);
    scene.lamps.push_back({.p_W = truth.X_WR * p_R,
                           .axis_W = -truth.X_WR.R.col(0),
                           .half_angle_rad = lamps_.half_angle_rad,
                           .irradiance_1m = 0.5 * lamps_.irradiance_at_1m,
                           .kind = 0});
  }
  return scene;
}

StageShapes SceneBuilder::Shapes() const {
  StageShapes shapes;
  const auto add = [&](const char* name, bool robot, const std::vector<DrawnPart>& parts) {
    shapes.bodies.push_back({name, robot, {}});
    AddParts(parts, Pose3{}, shapes.bodies.back());
  };
  const auto add_parts = [&](const std::vector<StagePart>& parts) {
    std::vector<StagePart>& all = shapes.bodies.back().parts;
    all.insert(all.end(), parts.begin(), parts.end());
  };
  add("robot", true, body_);
  add_parts(socket_);
  add("arm", true, arm_);
  add("left_door", true, {});
  add_parts(left_plate_);
  add("right_door", true, {});
  add_parts(right_plate_);
  add("pyramid", false, pyramid_);
  for (StageBody& body : SurroundingBodies(lighting_)) shapes.bodies.push_back(std::move(body));
  shapes.light = lighting_.sun_and_sky;
  shapes.to_pole_W = lighting_.to_pole_W;
  shapes.ground_rgb = ground_rgb_;
  shapes.ground_texture_seed = texture_seed_;
  shapes.ground_grain = grain_;
  shapes.points = {{"target", "pyramid"}, {"gripper", "left_door"}, {"camera", "robot", p_RC_}};
  return shapes;
}

ColourView ViewOf(const BackCameraModel& camera) {
  return {.camera = camera.camera,
          .hole = {.half_angle_rad = camera.half_view_rad, .distance_m = camera.hole_m},
          .vignetting_exponent = camera.vignetting_exponent,
          .rays = camera.blur_sigma_px >= kRayBlur_px ? 1.0 : 2.0};
}

ColourSensorOptions SensorOf(const BackCameraModel& camera, double balance_k, bool auto_balance) {
  return {.blur_sigma_px = camera.blur_sigma_px,
          .full_well_e = camera.full_well_e,
          .read_noise_e = camera.read_noise_e,
          .target_level = camera.exposed_level,
          .auto_balance = auto_balance,
          .balance = BalanceFor(LightOf(balance_k), CheapCamera())};
}

}  // namespace dockyard::raposa
