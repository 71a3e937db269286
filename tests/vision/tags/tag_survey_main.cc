// Not a test: errors of corners and poses of a rendered tag by range and angle, as a table.
//   tag_survey FAMILY FOV_DEG [WEAR [SHADE]]
// WEAR is the share of ink that is gone; SHADE the share of light beyond the edge of a shade that
// crosses the tag.
#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "controller/geometry/pose.h"
#include "controller/vision/tags/tag_pose.h"
#include "vision/tags/tag_views.h"

namespace dockyard {
namespace {

constexpr double kSize_m = 0.1;
constexpr int kId = 7, kViews = 24;

struct Sums {
  int found = 0, wrong = 0;  // wrong: the worse branch fits better
  double corner_px2 = 0.0, corner_sigma_px2 = 0.0, across_m2 = 0.0, range_m2 = 0.0, yaw_rad2 = 0.0,
         yaw_sigma_rad2 = 0.0;
};

TagPlace PlaceOf(double range_m, double yaw_deg, int i) {
  return {.range_m = range_m,
          .yaw_rad = Radians(yaw_deg + 0.2 * i),
          .pitch_rad = Radians(i % 5 - 2),
          .roll_rad = Radians(3.0 * (i % 7) - 9.0),
          .aim_rad = {Radians(0.31 * i - 3.0), Radians(0.17 * i)}};
}

void Add(const TagImage& view, const FiducialBoard& board, const TagFinder& finder, Sums* sums) {
  const std::vector<FoundTag> tags = finder.Find(view.image, &view.camera);
  if (tags.size() != 1) return;
  sums->corner_sigma_px2 += std::pow(tags[0].sigma_px, 2);
  const auto truth = TrueCorners(view, board.tags[0]);
  for (std::size_t k = 0; k < 4; ++k) {
    sums->corner_px2 += (tags[0].corners[k] - truth[k]).squaredNorm() / 8.0;
  }
  RefineOptions options;  // the renderer's camera and print are known exactly
  options.spread = {.focal = 0.0, .centre_px = 0.0, .radial_px = 0.0, .mounting_rad = 0.0};
  options.model_px = 0.0;
  const TagSighting sighting =
      TagBoardPose(tags, board.tags[0].family, {view.camera, {}}, board, options);
  if (sighting.branches.empty()) return;
  const auto off = [&](const TagBranch& branch) {
    return Eigen::AngleAxisd(branch.X_RB.R.transpose() * view.X_CB.R).angle();
  };
  const TagBranch* right = &sighting.branches[0];
  for (const TagBranch& branch : sighting.branches) {
    if (off(branch) < off(*right)) right = &branch;
  }
  ++sums->found;
  sums->wrong += right != &sighting.branches[0];
  const Eigen::AngleAxisd turn(right->X_RB.R * view.X_CB.R.transpose());
  const Eigen::Vector3d error = right->X_RB.p - view.X_CB.p;
  // Along the line of sight and across it.
  const Eigen::Vector3d sight = view.X_CB.p.normalized();
  sums->range_m2 += std::pow(error.dot(sight), 2);
  sums->across_m2 += 0.5 * (error - error.dot(sight) * sight).squaredNorm();
  sums->yaw_rad2 += std::pow(turn.angle() * turn.axis().y(), 2);
  sums->yaw_sigma_rad2 += right->covariance(4, 4);
}

struct Spoiled {
  double wear = 0.0, shade = 1.0;
};

/// The edge of a shade near a corner, half a square wide.
void Shade(const SquareTag& tag, double share, int i, TagImage* view) {
  const auto corners = TrueCorners(*view, tag);
  const Eigen::Vector2d side = corners[1] - corners[0];
  const Eigen::Vector2d at = 0.7 * corners[static_cast<std::size_t>(i % 4)] +
                             0.3 * corners[static_cast<std::size_t>((i + 2) % 4)];
  view->image = Shaded(view->image, at, 0.7 * i, 0.2 * side.norm(), share);
}

void Survey(const std::string& family, double fov_deg, const Spoiled& spoiled) {
  StereoRenderer renderer;
  const Camera camera = Pinhole(640, 480, Radians(fov_deg));
  const FiducialBoard board = OneTag(family, kId, kSize_m);
  const TagFinder finder(family);
  std::printf(
      "| range m | yaw deg | found | corner px | predicted | across mm | range mm | yaw deg | "
      "predicted |"
      " wrong branch | offset mm |\n|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const double range_m : {0.3, 0.5, 1.0, 1.5, 2.0, 2.5}) {
    for (const double yaw_deg : {0.0, 20.0, 40.0}) {
      Sums sums;
      for (int i = 0; i < kViews; ++i) {
        const TagPlace place = PlaceOf(range_m, yaw_deg, i);
        BoardView printed{.board = board, .X_WB = {}, .dusty_spots = {}};
        printed.wear = spoiled.wear;
        printed.wear_seed = static_cast<std::uint64_t>(i + 1);
        TagImage view =
            RenderTags(renderer, printed, camera, place, static_cast<std::uint64_t>(i + 1));
        if (spoiled.shade < 1.0) Shade(board.tags[0], spoiled.shade, i, &view);
        Add(view, board, finder, &sums);
      }
      const double n = std::max(sums.found, 1);
      const double yaw_rad = std::sqrt(sums.yaw_rad2 / n);
      std::printf("| %.1f | %.0f | %d/%d | %.3f | %.3f | %.2f | %.2f | %.2f | %.2f | %d | %.1f |\n",
                  range_m, yaw_deg, sums.found, kViews, std::sqrt(sums.corner_px2 / n),
                  std::sqrt(sums.corner_sigma_px2 / n), 1e3 * std::sqrt(sums.across_m2 / n),
                  1e3 * std::sqrt(sums.range_m2 / n), Degrees(yaw_rad),
                  Degrees(std::sqrt(sums.yaw_sigma_rad2 / n)), sums.wrong, 1e3 * range_m * yaw_rad);
    }
  }
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) {
  dockyard::Survey(
      argc > 1 ? argv[1] : "tag36h11", argc > 2 ? std::atof(argv[2]) : 60.0,
      {.wear = argc > 3 ? std::atof(argv[3]) : 0.0, .shade = argc > 4 ? std::atof(argv[4]) : 1.0});
}
