#include "controller/vision/tags/find_tags.h"

#include <algorithm>
#include <map>
#include <optional>

#include "controller/base/check.h"
#include "controller/vision/tags/april_finder.h"
#include "controller/vision/tags/aruco_finder.h"
#include "controller/vision/tags/tag_code.h"
#include "controller/vision/tags/tag_fit.h"

namespace dockyard {

struct TagFinder::Parts {
  TagFamily family;
  std::optional<AprilFinder> april;
};

TagFinder::TagFinder(const std::string& family) : parts_(std::make_unique<Parts>()) {
  const std::optional<TagFamily> named = TagFamilyNamed(family);
  DOCKYARD_CHECK(named.has_value());
  parts_->family = *named;
  if (!named->aruco) parts_->april.emplace(family);
}
TagFinder::~TagFinder() = default;
TagFinder::TagFinder(TagFinder&&) noexcept = default;
TagFinder& TagFinder::operator=(TagFinder&&) noexcept = default;

std::vector<FoundTag> TagFinder::Find(const GrayImage& image, const Camera* camera) const {
  // Of corners that the detector gave and no fit confirms. Assumed, 0.2-0.5.
  constexpr double kDetectorSigma_px = 0.3;
  const TagFamily& family = parts_->family;
  std::vector<FoundTag> found =
      parts_->april ? parts_->april->Find(image) : FindAruco(image, family.name);
  std::vector<int> ids;
  for (const FoundTag& tag : found) ids.push_back(tag.id);
  const std::vector<TagCells> cells = CellsOf(family, ids);
  for (std::size_t i = 0; i < found.size(); ++i) {
    FoundTag& tag = found[i];
    const std::optional<TagFit> fit = FitTag(image, cells[i], tag.corners, camera);
    tag.fitted = fit.has_value();
    tag.sigma_px = fit ? fit->sigma_px : kDetectorSigma_px;
    if (fit) tag.corners = fit->corners;
    const CellReading reading = ReadCells(image, cells[i], tag.corners);
    tag.decision_margin = reading.margin;
    if (family.aruco) tag.hamming = reading.wrong;
  }
  std::sort(found.begin(), found.end(), [](const FoundTag& a, const FoundTag& b) {
    if (a.id != b.id) return a.id < b.id;
    if (a.corners[0].x() != b.corners[0].x()) return a.corners[0].x() < b.corners[0].x();
    return a.corners[0].y() < b.corners[0].y();
  });
  return found;
}

std::vector<FoundTag> FindTags(const GrayImage& image, const std::string& family,
                               const Camera* camera) {
  return TagFinder(family).Find(image, camera);
}

}  // namespace dockyard
