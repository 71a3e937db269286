#include "sim/custom/custom_view.h"

#include <algorithm>
#include <cmath>

#include "sim/plant/drawn_mesh.h"
#include "sim/plant/ground_spectrum.h"
#include "sim/plant/ground_view.h"
#include "sim/plant/scenery.h"
#include "sim/plant/sun_motion.h"
#include "sim/run/shade_body.h"

namespace dockyard::custom {
namespace {

// Nickel on brass; linear. Assumed.
const Eigen::Vector3d kPinRgb(0.55, 0.45, 0.2);
// Of a pin's barrel, as common ones have it; assumed, 2-6 mm.
constexpr double kPinDiameter_m = 0.004;
// A pad lies this far out of its surface in images.
constexpr double kPadOut_m = 5e-4;

// Linear red, green and blue of the ground; assumed: a mid-grey floor covering, brown soil, grass,
// brick, grey.
Eigen::Vector3d ColourOf(GroundMaterialKind material) {
  switch (material) {
    case GroundMaterialKind::kSoil:
      return {0.45, 0.36, 0.28};
    case GroundMaterialKind::kGrass:
      return {0.10, 0.18, 0.05};
    case GroundMaterialKind::kBrick:
      return {0.35, 0.14, 0.09};
    case GroundMaterialKind::kGrey:
      return {0.3, 0.3, 0.3};
    case GroundMaterialKind::kFloor:
      break;
  }
  return {0.32, 0.31, 0.29};
}

// A smooth reflectance with these shares of short, middle and long waves. Bounds and widths are
// assumed, 480-500, 570-600 and 8-20 nm.
Spectrum SpectrumOf(const Eigen::Vector3d& rgb) {
  return Spectrum::From([&](double nm) {
    const double blue = 1.0 / (1.0 + std::exp((nm - 490.0) / 12.0));
    const double red = 1.0 / (1.0 + std::exp((585.0 - nm) / 12.0));
    return red * rgb.x() + (1.0 - red - blue) * rgb.y() + blue * rgb.z();
  });
}

int MaterialOf(const Spectrum& reflectance, SceneSpectra& spectra) {
  for (std::size_t i = 0; i < spectra.materials.size(); ++i) {
    if (spectra.materials[i] == reflectance) return static_cast<int>(i);
  }
  spectra.materials.push_back(reflectance);
  return static_cast<int>(spectra.materials.size()) - 1;
}

// A cylinder along x of its frame, from x = -length to 0.
RenderMesh PinMesh(double length_m) {
  Pose3 along_x;
  along_x.R = RotY(0.5 * kPi);
  const double radius_m = 0.5 * kPinDiameter_m;
  return TurnedMesh({{-length_m, 0.0}, {-length_m, radius_m}, {-5e-4, radius_m}, {0.0, 0.0}},
                    along_x);
}

void AddPins(const ElectricalParts& parts, std::size_t link, std::vector<DrawnPart>& drawn) {
  for (const SpringPin& pin : parts.pins) {
    if (static_cast<std::size_t>(pin.link) != link) continue;
    const Eigen::Matrix3d R =
        Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitX(), pin.out_L).toRotationMatrix();
    drawn.push_back(
        {std::make_shared<const RenderMesh>(PinMesh(pin.stroke_m)), Pose3{R, pin.p_L}, kPinRgb});
  }
  for (const ContactPad& pad : parts.pads) {
    if (static_cast<std::size_t>(pad.link) != link) continue;
    Pose3 X_LP = pad.X_LP;
    X_LP.p -= kPadOut_m * X_LP.R.col(2);
    drawn.push_back({std::make_shared<const RenderMesh>(SolidMesh(
                         SceneryItem::Kind::kBox, {pad.width_m, pad.height_m, 2.0 * kPadOut_m})),
                     X_LP, kPinRgb});
  }
}

bool HasColour(const RobotModel& robot) {
  return std::any_of(robot.cameras.begin(), robot.cameras.end(),
                     [](const CameraFit& camera) { return camera.model.colour; });
}

}  // namespace

std::vector<SceneBuilder::Link> SceneBuilder::LinksOf(const LinkTree& tree, const char* root) {
  std::vector<Link> links;
  for (int i = 0; i < tree.link_count(); ++i) {
    const std::string name = i == 0 ? root : std::string(root) + "/" + tree.link(i).name;
    links.push_back({name, DrawnParts(tree.link(i).visuals)});
  }
  return links;
}

SceneBuilder::SceneBuilder(const BuiltRun& built, const Seed& run_seed)
    : robot_(LinksOf(built.world.robot.tree, "robot")),
      dock_(LinksOf(built.world.dock.tree, "station")),
      boards_(built.world.dock.boards),
      lighting_(built.lighting),
      X_WG_(SiteInWorld(built.world.X_WG, built.world.slope)),
      floor_rgb_(ColourOf(built.floor.material)),
      grain_(built.floor.grain),
      texture_seed_(StreamKey(run_seed, "texture")),
      dust_seed_(StreamKey(run_seed, "dust")) {
  for (std::size_t i = 0; i < robot_.size(); ++i) {
    AddPins(built.world.robot.electrical, i, robot_[i].parts);
  }
  for (std::size_t i = 0; i < dock_.size(); ++i) {
    AddPins(built.world.dock.electrical, i, dock_[i].parts);
  }
  const NamedFrame& P = *built.world.robot.tree.Frame(built.world.robot_frame);
  const NamedFrame& Q = *built.world.dock.tree.Frame(built.world.dock_frame);
  link_P_ = P.link;
  p_LP_ = P.X_LF.p;
  link_Q_ = Q.link;
  p_LQ_ = Q.X_LF.p;
  if (HasColour(built.world.robot)) TakeColours(built);
  for (const CameraFit& camera : built.world.robot.cameras) {
    cameras_.push_back({camera.model.name, robot_[static_cast<std::size_t>(camera.link)].name,
                        camera.model.X_LC.p});
  }
}

// The ground is the first material.
void SceneBuilder::TakeColours(const BuiltRun& built) {
  SceneSpectra spectra;
  spectra.materials = {SpectrumOf(built.floor.material)};
  for (std::vector<Link>* links : {&robot_, &dock_}) {
    for (Link& link : *links) {
      for (DrawnPart& part : link.parts) {
        part.material = MaterialOf(SpectrumOf(part.albedo), spectra);
      }
    }
  }
  for (SceneryObject& thing : lighting_.scenery) {
    thing.object.material = MaterialOf(thing.reflectance, spectra);
  }
  colours_ = MakeColourTable(spectra, CheapCamera());
}

Scene SceneBuilder::Make(const Truth& truth, const HeightGrid& ground, int carrier) const {
  Scene scene;
  for (std::size_t i = 0; i < robot_.size(); ++i) {
    const std::size_t first = scene.objects.size();
    AddParts(robot_[i].parts, truth.X_WL[i], scene.objects);
    if (static_cast<int>(i) != carrier) continue;
    for (std::size_t k = first; k < scene.objects.size(); ++k) scene.objects[k].seen = false;
  }
  for (std::size_t i = 0; i < dock_.size(); ++i) {
    AddParts(dock_[i].parts, truth.X_WK[i], scene.objects);
  }
  AddSurroundings(lighting_, scene.objects);
  scene.ground = ViewOf(ground, X_WG_, floor_rgb_, texture_seed_);
  scene.ground.grain = grain_;
  scene.light = LightAt(lighting_, truth.time_s);
  for (const BoardFit& fit : boards_) {
    BoardView view;
    view.board = fit.board;
    view.X_WB = truth.X_WK[static_cast<std::size_t>(fit.link)] * fit.X_LB;
    view.dust_cover = fit.dust;
    view.wear = fit.wear;
    view.flatness_m = fit.flatness_m;
    view.bow_rad = fit.bow_rad;
    view.dust_seed = dust_seed_;
    view.dust_albedo = floor_rgb_;
    scene.boards.push_back(view);
  }
  return scene;
}

StageShapes SceneBuilder::Shapes() const {
  StageShapes shapes;
  const auto add = [&](const std::vector<Link>& links, bool robot) {
    for (const Link& link : links) {
      shapes.bodies.push_back({link.name, robot, {}});
      AddParts(link.parts, Pose3{}, shapes.bodies.back());
    }
  };
  add(robot_, true);
  add(dock_, false);
  for (StageBody& body : SurroundingBodies(lighting_)) shapes.bodies.push_back(std::move(body));
  for (const BoardFit& board : boards_) {
    shapes.boards.push_back(
        {dock_[static_cast<std::size_t>(board.link)].name, board.X_LB, board.board});
  }
  shapes.light = lighting_.sun_and_sky;
  shapes.to_pole_W = lighting_.to_pole_W;
  shapes.ground_rgb = floor_rgb_;
  shapes.ground_texture_seed = texture_seed_;
  shapes.ground_grain = grain_;
  shapes.points = cameras_;
  shapes.points.push_back({"contacts", robot_[static_cast<std::size_t>(link_P_)].name, p_LP_});
  shapes.points.push_back({"pads", dock_[static_cast<std::size_t>(link_Q_)].name, p_LQ_});
  return shapes;
}

}  // namespace dockyard::custom
