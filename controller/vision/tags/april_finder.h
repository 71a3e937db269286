// Internal to the tags room. Tags by libapriltag.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/vision/tags/april_families.h"
#include "controller/vision/tags/found_tag.h"

namespace dockyard {

class AprilFinder {
 public:
  /// @param name  one of AprilFamilyNames
  explicit AprilFinder(const std::string& name);
  /// Tags in the image as it is. Where it shows none: in smaller ones, then on scales of grey that
  /// the edge of a shade confuses less, but small oblique tags more.
  std::vector<FoundTag> Find(const GrayImage& image) const;

 private:
  std::vector<FoundTag> FindIn(GrayImage image) const;

  AprilFamily family_;
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector_;
};

}  // namespace dockyard
