#include "controller/vision/tags/tag_pose.h"

#include <algorithm>
#include <string>

#include "controller/vision/planar_pose.h"

namespace dockyard {
namespace {

/// The corners of all tags as marks of a board, four for each tag. Points, not discs.
FiducialBoard CornersAsMarks(const FiducialBoard& board) {
  FiducialBoard marks{.disc_diameter_m = 0.0, .fiducials = {}};
  for (const SquareTag& tag : board.tags) {
    for (const Eigen::Vector2d& corner : CornersOf(tag))
      marks.fiducials.push_back({.p_BF = corner});
  }
  return marks;
}

struct BoardTag {
  int tag = 0;  // index into FiducialBoard::tags
  FoundTag found;
};

/// Those of the board, each found once.
std::vector<BoardTag> TagsOfBoard(const std::vector<FoundTag>& found, const std::string& family,
                                  const FiducialBoard& board) {
  std::vector<BoardTag> tags;
  for (const FoundTag& tag : found) {
    const auto alike = [&](const FoundTag& other) { return other.id == tag.id; };
    if (std::count_if(found.begin(), found.end(), alike) > 1) continue;
    for (std::size_t i = 0; i < board.tags.size(); ++i) {
      if (board.tags[i].family != family || board.tags[i].id != tag.id) continue;
      tags.push_back({static_cast<int>(i), tag});
    }
  }
  return tags;
}

TagSighting PoseOf(const std::vector<BoardTag>& tags, const CameraView& view,
                   const FiducialBoard& board, const RefineOptions& options) {
  TagSighting sighting;
  std::vector<MarkPixel> marks;
  for (const BoardTag& tag : tags) {
    sighting.used.push_back(tag.tag);
    for (int k = 0; k < 4; ++k) {
      marks.push_back({.id = 4 * tag.tag + k,
                       .pixel = tag.found.corners[static_cast<std::size_t>(k)],
                       .sigma_px = tag.found.sigma_px});
    }
  }
  const FiducialBoard corners = CornersAsMarks(board);
  for (const PlanarBranch& branch : PlanarPose(marks, view.camera, corners)) {
    const RefinedPose refined =
        RefinePose(marks, {view}, corners, view.X_RC * branch.X_CB, options);
    sighting.branches.push_back({.X_RB = refined.X_RB,
                                 .rms_px = refined.rms_px,
                                 .cost = refined.cost,
                                 .freedom = refined.freedom,
                                 .covariance = refined.covariance});
  }
  std::stable_sort(sighting.branches.begin(), sighting.branches.end(),
                   [](const TagBranch& a, const TagBranch& b) { return a.cost < b.cost; });
  return sighting;
}

}  // namespace

TagSighting TagBoardPose(const std::vector<FoundTag>& found, const std::string& family,
                         const CameraView& view, const FiducialBoard& board,
                         const RefineOptions& options) {
  return PoseOf(TagsOfBoard(found, family, board), view, board, options);
}

TagSighting LocateTagBoard(const GrayImage& image, const CameraView& view,
                           const FiducialBoard& board, const RefineOptions& options) {
  std::vector<std::string> families;
  for (const SquareTag& tag : board.tags) {
    if (std::find(families.begin(), families.end(), tag.family) == families.end()) {
      families.push_back(tag.family);
    }
  }
  std::vector<BoardTag> tags;
  for (const std::string& family : families) {
    const std::vector<FoundTag> found = FindTags(image, family, &view.camera);
    for (BoardTag& tag : TagsOfBoard(found, family, board)) tags.push_back(std::move(tag));
  }
  return PoseOf(tags, view, board, options);
}

}  // namespace dockyard
