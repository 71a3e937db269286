#include <algorithm>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "controller/custom/sighting.h"
#include "controller/vision/tags/tag_pose.h"

namespace dockyard::custom {
namespace {

/// Finders keep tables of codes, and nothing from image to image.
using Finders = std::vector<std::pair<std::string, TagFinder>>;

Finders FindersOf(const Nominal& nominal) {
  Finders finders;
  for (const DockBoard& board : nominal.boards) {
    for (const SquareTag& tag : board.board.tags) {
      const bool known = std::any_of(finders.begin(), finders.end(),
                                     [&](const auto& each) { return each.first == tag.family; });
      if (!known) finders.emplace_back(tag.family, TagFinder(tag.family));
    }
  }
  return finders;
}

struct FamilyTags {
  std::string family;
  std::vector<FoundTag> found;
};

BoardSighting Locate(const std::vector<FamilyTags>& families, const CameraImage& taken,
                     const RobotCamera& camera, const FiducialBoard& board, int index) {
  BoardSighting sighting{.exposed = taken.exposed, .camera = taken.camera, .board = index};
  const CameraView view{camera.camera, Pose3{}};
  for (const FamilyTags& tags : families) {
    if (board.tags.empty() || board.tags[0].family != tags.family) continue;
    sighting.detected = static_cast<int>(tags.found.size());
    const TagSighting found =
        TagBoardPose(tags.found, tags.family, view, board, {.fit_turn = false});
    for (const TagBranch& branch : found.branches) {
      sighting.branches.push_back(
          {branch.X_RB, branch.rms_px, branch.cost, branch.freedom, branch.covariance});
    }
    for (const int used : found.used) {
      const int id = board.tags[static_cast<std::size_t>(used)].id;
      for (const FoundTag& tag : tags.found) {
        if (tag.id != id) continue;
        for (int k = 0; k < 4; ++k) {
          const Eigen::Vector2d& corner = tag.corners[static_cast<std::size_t>(k)];
          sighting.marks.push_back({4 * used + k, taken.camera, corner.x(), corner.y()});
        }
      }
    }
  }
  if (sighting.branches.empty()) sighting.failure = "no tag of the board";
  return sighting;
}

}  // namespace

Result<Perceive, Refusal> PerceiveTags(const Nominal& nominal) {
  for (const DockBoard& board : nominal.boards) {
    const std::vector<SquareTag>& tags = board.board.tags;
    if (tags.empty()) return Refusal{"board " + board.name + ": expected tags on it"};
    for (const SquareTag& tag : tags) {
      if (tag.family == tags[0].family) continue;
      return Refusal{"board " + board.name + ": expected tags of one family, found " +
                     tags[0].family + " and " + tag.family};
    }
  }
  const auto finders = std::make_shared<const Finders>(FindersOf(nominal));
  return Perceive([nominal, finders](const CameraImage& image, const Eigen::Vector3d&) {
    const RobotCamera& camera = nominal.cameras[static_cast<std::size_t>(image.camera)];
    const GrayImage grey = GreyOf(image);
    std::vector<FamilyTags> families;
    for (const auto& [family, finder] : *finders) {
      families.push_back({family, finder.Find(grey, &camera.camera)});
    }
    std::vector<BoardSighting> sightings;
    for (std::size_t i = 0; i < nominal.boards.size(); ++i) {
      sightings.push_back(
          Locate(families, image, camera, nominal.boards[i].board, static_cast<int>(i)));
    }
    return sightings;
  });
}

}  // namespace dockyard::custom
