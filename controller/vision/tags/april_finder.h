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
  std::vector<FoundTag> Find(const GrayImage& image) const;

 private:
  AprilFamily family_;
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector_;
};

}  // namespace dockyard
