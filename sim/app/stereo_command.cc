#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/stereo/elevation.h"
#include "models/read/config_error.h"
#include "models/read/load_cameras.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/image_files.h"
#include "sim/app/number_option.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/images/png.h"

namespace dockyard {
namespace {

struct StereoArguments {
  std::string left, right, rig, matcher = "semi-global", disparity, elevation;
  std::optional<double> ground_m;
  double pitch_deg = 0.0, roll_deg = 0.0, cell_m = 0.005, most_m = 1.5;
  int block_px = 0, count_px = 0;
  bool json = false;
};

constexpr const char* kStereoHelp = R"(Distances from a pair of pictures.

Examples:
  dockyard stereo out/view/left.png out/view/right.png --rig {cameras} --json
  dockyard stereo out/view/left.png out/view/right.png --rig {cameras} --elevation out/heights.csv
  dockyard stereo out/view/left.png out/view/right.png --rig {cameras} --ground 0.29 --json

The pictures are brought to one plane by the rig's cameras. Then they are matched: semi-global finds
most, on stones too; blocks are exact on sand, if the cameras are known to a fraction of a pixel.
--ground says how far the ground lies below the origin of the rig's frame, and --pitch-deg and
--roll-deg how that frame is tilted against it: nose-down and to the right positive. The ground's
disparity is then taken out before the search, which is sharper and needs few disparities.
The file of heights is CSV: x_m ahead and y_m to the left of that origin, height_m over the ground
(over the rig's origin, without --ground), sigma_m, points; a row for each cell that was seen. The
file of disparities is a PNG of 16 bits: 256 times the disparity of the left rectified picture's
pixels, 0 where there is none.)";

// The ground in the rig's frame: level but for pitch and roll, below the origin.
Plane GroundOf(const StereoArguments& in) {
  const Eigen::Matrix3d R_ER = RotY(Radians(in.pitch_deg)) * RotX(Radians(in.roll_deg));
  return {R_ER.transpose() * Eigen::Vector3d::UnitZ(), -in.ground_m.value_or(0.0)};
}

MatchSettings SettingsOf(const StereoArguments& in, const RectifiedPair& pair) {
  MatchSettings settings;
  settings.matcher = in.matcher == "blocks" ? Matcher::kBlocks : Matcher::kSemiGlobal;
  settings.block_px = in.block_px > 0 ? in.block_px : settings.matcher == Matcher::kBlocks ? 15 : 5;
  if (in.ground_m) {
    settings.ground = DisparityOf(pair, GroundOf(in));
    settings.least_px = -16;
    settings.count_px = 48;
  }
  if (in.count_px > 0) settings.count_px = (in.count_px + 15) / 16 * 16;
  return settings;
}

std::string HeightsCsv(const ElevationMap& map) {
  std::string text = "x_m,y_m,height_m,sigma_m,points\n";
  char row[128];
  for (int iy = 0; iy < map.ny; ++iy) {
    for (int ix = 0; ix < map.nx; ++ix) {
      const auto cell = static_cast<std::size_t>(iy * map.nx + ix);
      if (map.points[cell] == 0) continue;
      std::snprintf(row, sizeof row, "%.5f,%.5f,%.5f,%.5f,%d\n", map.x0_m + ix * map.cell_m,
                    map.y0_m + iy * map.cell_m, static_cast<double>(map.height_m[cell]),
                    static_cast<double>(map.sigma_m[cell]), map.points[cell]);
      text += row;
    }
  }
  return text;
}

DeepImage DisparityPicture(const Disparities& disparities) {
  DeepImage image{disparities.width, disparities.height, 16, {}};
  for (const float px : disparities.px) {
    const double scaled = px > 0.0F ? std::round(256.0 * static_cast<double>(px)) : 0.0;
    image.pixels.push_back(static_cast<std::uint16_t>(std::min(scaled, 65535.0)));
  }
  return image;
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
}

int PrintStereo(const StereoArguments& in) {
  CheckArguments(in);
  const StereoImages images{LoadGray(in.left), LoadGray(in.right)};
  if (images.left.width != images.right.width || images.left.height != images.right.height) {
    throw ConfigError(in.right + ": expected an image of " + std::to_string(images.left.width) +
                      " x " + std::to_string(images.left.height) + " pixels, as " + in.left);
  }
  const StereoRig rig = LoadRig(in.rig, images.left.width, images.left.height, Rays::kMasked);
  const Plane ground = GroundOf(in);
  RectifySettings rectify;
  if (in.ground_m) rectify.ground_R = ground;
  const Rectifier rectifier(rig, rectify);
  const RectifiedPair& pair = rectifier.pair();
  const MatchSettings settings = SettingsOf(in, pair);
  const Disparities found = Match(rectifier, images, settings);
  long seen = 0, matched = 0;
  for (int v = 0; v < found.height; ++v) {
    for (int u = 0; u < found.width; ++u) {
      if (!rectifier.IsSeen(u, v, false)) continue;
      ++seen;
      matched += found.at(u, v) > 0.0F;
    }
  }
  if (!in.disparity.empty()) WriteWhole(in.disparity, EncodePng(DisparityPicture(found)));
  if (!in.elevation.empty()) {
    ElevationSettings cells;
    cells.cell_m = in.cell_m;
    cells.x_high_m = in.most_m;
    cells.y_low_m = -0.5 * in.most_m;
    cells.y_high_m = 0.5 * in.most_m;
    WriteWhole(in.elevation, HeightsCsv(MapHeights(pair, found, ground, settings.block_px, cells)));
  }
  const double share = seen > 0 ? static_cast<double>(matched) / static_cast<double>(seen) : 0.0;
  if (in.json) {
    const Json json{{"width_px", pair.width},
                    {"height_px", pair.height},
                    {"focal_px", pair.focal_px},
                    {"baseline_m", pair.baseline_m},
                    {"matched_share", share}};
    std::printf("%s\n", json.dump(2).c_str());
  } else {
    std::printf(
        "rectified to %d x %d px, %.1f px/rad, baseline %.4f m\n%.1f %% of the pixels matched\n",
        pair.width, pair.height, pair.focal_px, pair.baseline_m, 100.0 * share);
  }
  return kExitDone;
}

}  // namespace

void AddStereoCommand(CLI::App& app, int& exit_code) {
  auto in = std::make_shared<StereoArguments>();
  CLI::App* command = app.add_subcommand("stereo", kStereoHelp);
  command->add_option("left", in->left, "picture of the left camera")->required();
  command->add_option("right", in->right, "picture of the right camera")->required();
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
  command->add_option("--disparities", in->count_px, "that are tried [128; 48 with --ground]")
      ->check(CLI::Range(16, 1024));
  command->add_option("--disparity", in->disparity, "PNG file for the disparities");
  command->add_option("--elevation", in->elevation, "CSV file for the heights");
  command->add_option("--cell", in->cell_m, "m, side of a cell of heights [0.005]")
      ->check(NumberWithin(0.001, 1.0));
  command->add_option("--reach", in->most_m, "m ahead, and across in all, of the heights [1.5]")
      ->check(NumberWithin(0.05, 100.0));
  command->add_flag("--json", in->json, "the figures as JSON");
  command->callback([in, &exit_code] { exit_code = PrintStereo(*in); });
}

}  // namespace dockyard
