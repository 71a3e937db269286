#include "sim/log/logged_run.h"

#include <algorithm>
#include <cmath>

namespace dockyard {

std::size_t LoggedRun::SampleAt(double time_s) const {
  constexpr double kRounding_s = 1e-6;
  const auto at = std::lower_bound(times_s.begin(), times_s.end(), time_s - kRounding_s);
  return std::min(static_cast<std::size_t>(at - times_s.begin()), times_s.size() - 1);
}

const LoggedImage* LoggedRun::ImageAt(const std::string& camera, double time_s) const {
  constexpr double kRounding_s = 1e-6;
  const auto found = std::find_if(images.begin(), images.end(), [&](const auto& image) {
    return image.value.camera == camera && std::abs(image.time_s - time_s) < kRounding_s;
  });
  return found == images.end() ? nullptr : &found->value;
}

}  // namespace dockyard
