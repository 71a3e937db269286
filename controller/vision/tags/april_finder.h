// Internal to the tags room. Tags by libapriltag.
#pragma once

#include <cstdint>
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
  /// Tags that plain grey levels show; where these show none, those of a scale that a shade's edge
  /// confuses less, but small oblique tags more.
  std::vector<FoundTag> Find(const GrayImage& image) const;

 private:
  std::vector<FoundTag> FindIn(int width, int height, std::vector<std::uint8_t> pixels) const;

  AprilFamily family_;
  std::unique_ptr<apriltag_detector_t, void (*)(apriltag_detector_t*)> detector_;
};

}  // namespace dockyard
