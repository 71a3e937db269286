#include "sim/spectator/looks.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sim/images/decode.h"

namespace dockyard {

std::vector<Look> LooksOf(const LoggedRun& run) {
  std::set<double> times_s;
  for (const Timed<LoggedImage>& image : run.images) times_s.insert(image.time_s);
  std::vector<Look> looks;
  for (const double time_s : times_s) {
    Look look{.time_s = time_s, .images = {}};
    for (const LoggedCamera& camera : run.cameras) {
      look.images.push_back(run.ImageAt(camera.name, time_s));
    }
    const auto told = std::find_if(
        run.sightings.begin(), run.sightings.end(),
        [&](const SightingSample& sample) { return std::abs(sample.time_s - time_s) < 1e-6; });
    if (told != run.sightings.end()) look.sighting = &*told;
    looks.push_back(std::move(look));
  }
  return looks;
}

std::string WordOf(const Look& look) {
  if (look.sighting == nullptr) return "not reported";
  return look.sighting->report.accepted ? "accepted" : look.sighting->report.reason;
}

std::optional<RgbImage> PictureOf(const Look& look, std::size_t camera) {
  if (camera >= look.images.size() || look.images[camera] == nullptr) return std::nullopt;
  return DecodeColour(look.images[camera]->bytes);
}

}  // namespace dockyard
