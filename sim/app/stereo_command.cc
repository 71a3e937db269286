#include <Eigen/Geometry>
#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>

#include "controller/stereo/elevation.h"
#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/image_files.h"
#include "sim/app/number_option.h"
#include "sim/app/stereo_files.h"
#include "sim/app/stereo_truth.h"
#include "sim/app/stereo_warnings.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/base/json.h"

namespace dockyard {
namespace {

struct StereoArguments {
  std::string left, right, rig, matcher = "semi-global", disparity, elevation, points, truth;
  std::optional<double> ground_m;
  double pitch_deg = 0.0, roll_deg = 0.0, cell_m = 0.005, most_m = 1.5;
  int block_px = 0, count_px = 0;
  bool json = false;
};

constexpr const char* kStereoHelp = R"(Distances from a pair of images.

Examples:
  dockyard stereo out/view/left.png out/view/right.png --rig {cameras} --json
  dockyard stereo out/view/left.png out/view/right.png --rig {cameras} \
    --elevation out/heights.csv
  dockyard stereo out/view/left.png out/view/right.png --rig {cameras} \
    --ground 0.29 --json
  dockyard stereo out/view/left.png out/view/right.png --rig {cameras} \
    --points out/points.ply

The images are brought to one plane by the rig's cameras; those of a rig that is rectified already
stay as they are. Then they are matched: semi-global finds most, on stones too; blocks are exact on
sand, if the cameras are known to a fraction of a pixel. Corners of the left image are searched for
in the right one: a warning says where the images are exchanged, turned, off in their rows, or no
pair.
--ground says how far the ground lies below the origin of the rig's frame, and --pitch-deg and
--roll-deg how that frame is tilted against it: nose-down and to the right positive. The ground's
disparity is then taken out before the search, which is sharper and needs few disparities.
--disparity: a PNG of 16 bits has 256 times the disparity of the left rectified image's pixels, 0
where there is none, up to 255.99 px; a .pfm has floats without limit, infinity for none.
--elevation: x_m ahead and y_m to the left of the rig's origin, height_m over the ground (over the
rig's origin, without --ground), sigma_m, points; a row for each cell with points.
--points: x, y, z in the rig's frame, in metres, and the pixel's grey. --truth scores the
disparities by true ones of the left rectified image: a PFM, or a PNG of 16 bits (1/256 px) or 8
bits (whole px).
--json: rotation_left_wxyz turns the left camera's axes to those of the rectified image
(p_rectified = R p_left); Q is OpenCV's, for reprojectImageTo3D.)";

// The ground in the rig's frame: level but for pitch and roll, below the origin.
Plane GroundOf(const StereoArguments& in) {
  const Eigen::Matrix3d R_ER = RotY(Radians(in.pitch_deg)) * RotX(Radians(in.roll_deg));
  return {R_ER.transpose() * Eigen::Vector3d::UnitZ(), -in.ground_m.value_or(0.0)};
}

// As many disparities as leave half of the image's columns a whole search, up to the default.
int FittingCount(int width, int most_px, int block_px) {
  const int room_px = std::max(width / 2, std::min(width - block_px, 16));
  return std::clamp(room_px / 16 * 16, 16, most_px);
}

PlaneDisparity GroundDisparity(const StereoArguments& in, const RectifiedPair& pair) {
  try {
    return DisparityOf(pair, GroundOf(in));
  } catch (const std::invalid_argument& error) {
    throw UsageError(std::string("--ground: ") + error.what());
  }
}

MatchSettings SettingsOf(const StereoArguments& in, const RectifiedPair& pair) {
  MatchSettings settings;
  settings.matcher = in.matcher == "blocks" ? Matcher::kBlocks : Matcher::kSemiGlobal;
  settings.block_px = in.block_px > 0 ? in.block_px : settings.matcher == Matcher::kBlocks ? 15 : 5;
  int most_px = settings.count_px;
  if (in.ground_m) {
    settings.ground = GroundDisparity(in, pair);
    settings.least_px = -16;
    most_px = 48;
  }
  settings.count_px = in.count_px > 0 ? (in.count_px + 15) / 16 * 16
                                      : FittingCount(pair.width, most_px, settings.block_px);
  const std::string why_not = WhyNoSearch(pair.width, pair.height, settings);
  if (why_not.empty()) return settings;
  if (in.count_px > 0 || in.block_px > 0) {
    throw UsageError("--disparities, --block: " + why_not);
  }
  throw ConfigError(in.left + ": " + why_not);
}

// Arguments that parse but cannot be met.
void CheckArguments(const StereoArguments& in) {
  constexpr double kMostCells = 4000.0;  // along a side
  if (in.most_m / in.cell_m > kMostCells) {
    throw UsageError("--reach must be at most 4000 times --cell");
  }
  if (in.block_px > 0 && in.block_px % 2 == 0) throw UsageError("--block must be odd");
  if (in.block_px == 3 && in.matcher == "blocks") {
    throw UsageError("--matcher blocks needs a --block of 5 or more");
  }
  if (!in.disparity.empty()) DisparityFormatOf(in.disparity);
}

StereoImages LoadPair(const StereoArguments& in) {
  StereoImages images{LoadGray(in.left), LoadGray(in.right)};
  if (images.left.width != images.right.width || images.left.height != images.right.height) {
    throw ConfigError(in.right + ": expected an image of " + std::to_string(images.left.width) +
                      " x " + std::to_string(images.left.height) + " pixels, as " + in.left +
                      ", found " + std::to_string(images.right.width) + " x " +
                      std::to_string(images.right.height));
  }
  return images;
}

Rectifier RectifierOf(const StereoArguments& in, const StereoImages& images) {
  const StereoRig rig = LoadRig(in.rig, images.left.width, images.left.height, Rays::kMasked);
  RectifySettings rectify;
  rectify.keep_rectified = true;
  if (in.ground_m) rectify.ground_R = GroundOf(in);
  try {
    return Rectifier(rig, rectify);
  } catch (const std::invalid_argument& error) {
    throw ConfigError(in.rig + ": " + error.what());
  }
}

// Of the pixels that the left camera sees.
double MatchedShare(const Rectifier& rectifier, const Disparities& found) {
  long in_view = 0, matched = 0;
  for (int v = 0; v < found.height; ++v) {
    for (int u = 0; u < found.width; ++u) {
      if (!rectifier.IsSeen(u, v, false)) continue;
      ++in_view;
      matched += found.at(u, v) > 0.0F;
    }
  }
  return in_view > 0 ? static_cast<double>(matched) / static_cast<double>(in_view) : 0.0;
}

Json PairJson(const Rectifier& rectifier) {
  const RectifiedPair& pair = rectifier.pair();
  Eigen::Quaterniond turn(pair.X_RC.R.transpose() * rectifier.rig().X_RL.R);
  if (turn.w() < 0.0) turn.coeffs() *= -1.0;
  const Eigen::Matrix4d Q = ReprojectionOf(pair);
  Json rows = Json::array();
  for (int i = 0; i < 4; ++i) rows.push_back({Q(i, 0), Q(i, 1), Q(i, 2), Q(i, 3)});
  return {{"width_px", pair.width},
          {"height_px", pair.height},
          {"focal_px", pair.focal_px},
          {"principal_point_px", ToJson(pair.centre_px)},
          {"doffs_px", pair.doffs_px},
          {"baseline_m", pair.baseline_m},
          {"rotation_left_wxyz", {turn.w(), turn.x(), turn.y(), turn.z()}},
          {"rectified_in_rig", ToJson(pair.X_RC)},
          {"Q", rows},
          {"kept_as_it_was", rectifier.IsKept()}};
}

void WriteFiles(const StereoArguments& in, const Rectifier& rectifier, const StereoImages& images,
                const Disparities& found, int block_px) {
  if (!in.disparity.empty()) WriteDisparities(in.disparity, found);
  if (!in.elevation.empty()) {
    ElevationSettings cells;
    cells.cell_m = in.cell_m;
    cells.x_high_m = in.most_m;
    cells.y_low_m = -0.5 * in.most_m;
    cells.y_high_m = 0.5 * in.most_m;
    WriteWhole(in.elevation,
               HeightsCsv(MapHeights(rectifier.pair(), found, GroundOf(in), block_px, cells)));
  }
  if (!in.points.empty()) {
    WriteWhole(in.points, PointsPly(rectifier.pair(), found, rectifier.Rectified(images).left));
  }
}

int PrintStereo(const StereoArguments& in, Invocation& call) {
  CheckArguments(in);
  const StereoImages images = LoadPair(in);
  const Rectifier rectifier = RectifierOf(in, images);
  const RectifiedPair& pair = rectifier.pair();
  const MatchSettings settings = SettingsOf(in, pair);
  std::optional<Disparities> truth;
  if (!in.truth.empty()) truth = LoadTruth(in.truth, pair.width, pair.height);
  const Disparities found = Match(rectifier, images, settings);
  const double share = MatchedShare(rectifier, found);
  WriteFiles(in, rectifier, images, found, settings.block_px);
  const int most_px = in.ground_m ? 0 : settings.least_px + settings.count_px - 1;
  const PairVerdict verdict = JudgePair(rectifier, images, most_px);
  for (const std::string& warning : verdict.warnings) Warn(warning, &call.warnings);
  std::optional<StereoScore> score;
  if (truth) score = ScoreOf(found, *truth);
  if (score && score->matched == 0) Warn(NothingScored(in.truth, *score), &call.warnings);
  if (in.json) {
    Json json = PairJson(rectifier);
    json["disparities"] = {{"least_px", settings.least_px}, {"count", settings.count_px}};
    json["matched_share"] = share;
    json["pair_check"] = ToJson(verdict.check);
    if (score) json["truth"] = ToJson(*score);
    json["warnings"] = call.warnings;
    std::printf("%s\n", json.dump(2).c_str());
    return kExitDone;
  }
  std::printf("%s %d x %d px, %.1f px/rad, baseline %.4f m\n%.1f %% of the pixels matched\n",
              rectifier.IsKept() ? "rectified already:" : "rectified to", pair.width, pair.height,
              pair.focal_px, pair.baseline_m, 100.0 * share);
  if (score) std::printf("%s", TextOf(*score).c_str());
  return kExitDone;
}

}  // namespace

void AddStereoCommand(CLI::App& app, Invocation& call) {
  auto in = std::make_shared<StereoArguments>();
  CLI::App* command = app.add_subcommand("stereo", kStereoHelp);
  command->add_option("left", in->left, "image of the left camera")->required();
  command->add_option("right", in->right, "image of the right camera")->required();
  command->add_option("--rig", in->rig, "file of the pair of cameras, or two, LEFT,RIGHT")
      ->required();
  command->add_option("--ground", in->ground_m, "m that the ground lies below the rig's origin")
      ->check(NumberWithin(0.001, 1e3));
  command->add_option("--pitch-deg", in->pitch_deg, "of the rig's frame against the ground [0]")
      ->check(NumberWithin(-60.0, 60.0));
  command->add_option("--roll-deg", in->roll_deg, "of the rig's frame against the ground [0]")
      ->check(NumberWithin(-60.0, 60.0));
  command->add_option("--matcher", in->matcher, "semi-global, or blocks [semi-global]")
      ->check(CLI::IsMember({"blocks", "semi-global"}));
  command->add_option("--block", in->block_px, "side of a block in px, odd [5; 15 of blocks]")
      ->check(CLI::Range(3, 63));
  command
      ->add_option("--disparities", in->count_px,
                   "that are tried [128; 48 with --ground; fewer for small images]")
      ->check(CLI::Range(16, 1024));
  command->add_option("--disparity", in->disparity, "file .png or .pfm for the disparities");
  command->add_option("--elevation", in->elevation, "CSV file for the heights");
  command->add_option("--points", in->points, "PLY file for the points");
  command->add_option("--truth", in->truth, "file .pfm or .png of true disparities, to score by");
  command->add_option("--cell", in->cell_m, "m, side of a cell of heights [0.005]")
      ->check(NumberWithin(0.001, 1.0));
  command->add_option("--reach", in->most_m, "m ahead, and across in all, of the heights [1.5]")
      ->check(NumberWithin(0.05, 100.0));
  command->add_flag("--json", in->json, "the figures as JSON");
  command->callback([in, &call] { call.exit_code = PrintStereo(*in, call); });
}

}  // namespace dockyard
