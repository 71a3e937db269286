// What the cameras saw in a logged run, look by look, with what the controller found.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "sim/log/logged_run.h"

namespace dockyard {

/// The images of one time.
struct Look {
  double time_s = 0.0;
  std::vector<const LoggedImage*> images;    // by camera; null: it took none
  const SightingSample* sighting = nullptr;  // null: the log has no word on it
};

/// In the order of time. The run must outlive them.
std::vector<Look> LooksOf(const LoggedRun& run);

/// "accepted", the reason why it was not, or "not reported".
std::string WordOf(const Look& look);

/// A camera's image in colour; none: there is no image, or its bytes are no PNG of ours.
std::optional<RgbImage> PictureOf(const Look& look, std::size_t camera);

}  // namespace dockyard
