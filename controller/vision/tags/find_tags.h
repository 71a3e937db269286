// Square tags in an image: which they are, and their corners to a small part of a pixel.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "controller/geometry/camera.h"
#include "controller/geometry/image.h"
#include "controller/vision/tags/found_tag.h"

namespace dockyard {

/// Finds the tags of one family. It keeps tables of the family's codes; a search leaves nothing
/// behind. One thread.
class TagFinder {
 public:
  /// @param family  one of TagFamilyNames
  explicit TagFinder(const std::string& family);
  ~TagFinder();
  TagFinder(TagFinder&&) noexcept;
  TagFinder& operator=(TagFinder&&) noexcept;

  /// All tags of the image, by id, equal ids from left to right. AprilTag families by libapriltag,
  /// ArUco's by OpenCV. The corners are then fitted anew: the known pattern of squares, blurred, is
  /// laid over the image by least squares. Where the fit fails, the detector's corners stay.
  /// @param camera  with it, edges are straight before the lens; without, in the image
  std::vector<FoundTag> Find(const GrayImage& image, const Camera* camera) const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

/// The same for one image.
std::vector<FoundTag> FindTags(const GrayImage& image, const std::string& family,
                               const Camera* camera);

}  // namespace dockyard
