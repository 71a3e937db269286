#include "perception/yard_views.h"

#include <algorithm>
#include <cmath>
#include <fstream>

#include "axel/sim/scenarios.h"
#include "perception/shaded_shares.h"
#include "sim/base/files.h"
#include "sim/base/random.h"
#include "sim/plant/built_cameras.h"

namespace dockyard::axel {
namespace {

/// The truth with the rover put somewhere else: level axle on its wheels, body pitched, arm down to
/// the ground or, before the station, up to the mouth, tether straight from its tip to the anchor.
Truth Placed(const Truth& at_start, const BuiltRun& built, const YardSample& sample) {
  Truth truth = at_start;
  const RoverModel& rover = built.world.rover;
  const double axle_m = built.nominal.wheel_radius_m;
  const Pose3 X_WH = built.X_WD * FromGround(FromDockingCoords(sample.at), axle_m);
  truth.X_WR = X_WH * Pose3{RotY(sample.pitch_rad), Eigen::Vector3d::Zero()};
  truth.X_W_left_wheel = X_WH * Pose3{Eigen::Matrix3d::Identity(), rover.p_R_left_wheel};
  truth.X_W_right_wheel = X_WH * Pose3{Eigen::Matrix3d::Identity(), rover.p_R_right_wheel};
  const bool near = sample.at.r < rover.arm_length_m + 0.5;
  const double tip_m = near ? built.nominal.mouth_height_m : rover.tip.radius_m;
  const double down_rad = std::asin((axle_m - tip_m) / rover.arm_length_m);
  truth.X_WA = X_WH * Pose3{RotY(down_rad), Eigen::Vector3d::Zero()};
  const Eigen::Vector3d tip_W = truth.X_WA * Eigen::Vector3d(rover.arm_length_m, 0.0, 0.0);
  const StationModel& station = built.world.station;
  const Eigen::Vector3d anchor_M(-station.anchor_depth_m, 0.0, 0.0);
  truth.tether_W = {tip_W, truth.X_WS * (MouthInStation(station) * anchor_M)};
  return truth;
}

void WritePgm(const std::string& path, const GrayImage& image) {
  std::string bytes =
      "P5\n" + std::to_string(image.width) + " " + std::to_string(image.height) + "\n255\n";
  bytes.append(reinterpret_cast<const char*>(image.pixels.data()), image.pixels.size());
  WriteWhole(path, bytes);
}

bool ReadPgm(const std::string& path, GrayImage* image) {
  std::ifstream in(path, std::ios::binary);
  std::string magic;
  int levels = 0;
  if (!(in >> magic >> image->width >> image->height >> levels) || magic != "P5") return false;
  in.get();
  image->pixels.resize(static_cast<std::size_t>(image->width) * image->height);
  return static_cast<bool>(in.read(reinterpret_cast<char*>(image->pixels.data()),
                                   static_cast<std::streamsize>(image->pixels.size())));
}

}  // namespace

double Halton(int index, int base) {
  double value = 0.0, share = 1.0 / base;
  for (int i = index; i > 0; i /= base, share /= base) value += share * (i % base);
  return value;
}

bool YardSample::InView() const {
  return std::any_of(marks.begin(), marks.end(), [](const std::vector<YardMark>& view) {
    return std::count_if(view.begin(), view.end(), [](const YardMark& m) { return m.InView(); }) >=
           5;
  });
}

YardViews::YardViews(const YardOptions& options) : options_(options) {
  scenario_ = TypicalScenario({"camera.width_px=" + std::to_string(options.width),
                               "camera.height_px=" + std::to_string(options.height),
                               std::string("light=") + LightName(options.light)});
  scenario_.seed = options.seed;
  built_ = Build(scenario_);
  world_ = std::make_unique<World>(built_.world);
  if (!options.cache.empty()) MakeFolder(options.cache);
}
YardViews::~YardViews() = default;

YardSample YardViews::Take(int i, bool render) {
  const auto spread = [&](int base, double half) {
    return half * (2.0 * Halton(i + 1, base) - 1.0);
  };
  const double r = options_.r_min_m + (options_.r_max_m - options_.r_min_m) * Halton(i + 1, 2);
  return TakeAt(i, {r, spread(3, options_.alpha_rad), spread(5, options_.h_rad)},
                spread(7, options_.pitch_rad), render);
}

YardSample YardViews::TakeAt(int i, const DockingCoords& at, double pitch_rad, bool render) {
  const std::uint64_t seed = WorldSeed(options_.seed, static_cast<std::uint64_t>(i), 0);
  YardSample sample;
  sample.index = i;
  sample.at = at;
  sample.pitch_rad = pitch_rad;
  const BuiltRun& built = built_;
  const Truth truth = Placed(world_->truth(), built, sample);
  sample.X_WR = truth.X_WR;
  sample.built_rig = BuiltRig(built.world.rover.stereo, seed);
  sample.sensor = CameraSensor(built.world.rover.stereo, seed, 0);
  const Lighting lighting =
      MakeLighting(scenario_.light, built.X_WD, BoardInDock(built.world.station).p, seed);
  builder_ = std::make_unique<SceneBuilder>(built.world.rover, built.world.station,
                                            built.world.soil, lighting, SiteOf(scenario_), seed);
  scene_ = builder_->Make(truth, world_->ground());
  sample.X_RB = Inverse(truth.X_WR) * scene_.boards[0].X_WB;
  sample.X_DB = Inverse(built.X_WD) * scene_.boards[0].X_WB;
  const std::array<const Camera*, 2> cameras{&sample.built_rig.left, &sample.built_rig.right};
  const std::array<Pose3, 2> X_RC{sample.built_rig.X_RL, sample.built_rig.X_RQ};
  const std::vector<double> shaded = ShadedShares(scene_);
  for (std::size_t view = 0; view < 2; ++view) {
    const auto pixels = TrueFiducials(scene_, *cameras[view], truth.X_WR * X_RC[view]);
    for (std::size_t id = 0; id < pixels.size(); ++id) {
      sample.marks[view].push_back({.truth = pixels[id], .shaded = shaded[id]});
    }
  }
  // What the attitude filter gives, bias and noise of the rover's file.
  RandomStream imu(StreamKey(seed, "imu"));
  const double sigma =
      std::hypot(built.world.rover.imu.attitude_bias_rad, built.world.rover.imu.attitude_noise_rad);
  const Eigen::Matrix3d R_WR_sensed = RotY(sigma * imu.Normal()) * RotX(sigma * imu.Normal());
  sample.hints.up_R = R_WR_sensed.transpose() * truth.X_WR.R.transpose() * Eigen::Vector3d::UnitZ();
  if (!options_.has_board) {
    scene_.boards[0].X_WB.p.z() = -5.0;  // under the ground
    for (auto& view : sample.marks) view.clear();
  }
  if (render) Draw(sample, &sample.images);
  return sample;
}

void YardViews::Draw(const YardSample& sample, StereoImages* images) {
  const std::string stem = options_.cache + "/" + std::to_string(sample.index);
  if (!options_.cache.empty() && ReadPgm(stem + "_left.pgm", &images->left) &&
      ReadPgm(stem + "_right.pgm", &images->right)) {
    return;
  }
  if (!renderer_) renderer_ = std::make_unique<StereoRenderer>();
  *images = renderer_->Render(scene_, sample.built_rig, sample.X_WR, sample.sensor);
  if (options_.cache.empty()) return;
  WritePgm(stem + "_left.pgm", images->left);
  WritePgm(stem + "_right.pgm", images->right);
}

}  // namespace dockyard::axel
