#include "sim/page/images_part.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "sim/page/pictures.h"

namespace dockyard {
namespace {

constexpr double kSameTime_s = 1e-6;

/// The times of images without a sighting, rising.
std::vector<double> TimesOf(const LoggedRun& run) {
  std::set<double> times_s;
  for (const Timed<LoggedImage>& image : run.images) times_s.insert(image.time_s);
  std::vector<double> without;
  for (const double time_s : times_s) {
    const bool sighted = std::any_of(
        run.sightings.begin(), run.sightings.end(),
        [&](const SightingSample& each) { return std::abs(each.time_s - time_s) < kSameTime_s; });
    if (!sighted) without.push_back(time_s);
  }
  return without;
}

std::vector<double> Thinned(const std::vector<double>& times_s, std::size_t most) {
  if (times_s.size() <= most) return times_s;
  if (most == 1) return {times_s.front()};
  std::vector<double> some;
  for (std::size_t i = 0; i < most; ++i) {
    some.push_back(times_s[i * (times_s.size() - 1) / (most - 1)]);
  }
  return some;
}

}  // namespace

Json ImagesPart(const LoggedRun& run, std::size_t most, Payload& payload) {
  const std::vector<double> all_s = TimesOf(run);
  if (all_s.empty() || run.cameras.empty()) return nullptr;
  const std::vector<double> times_s =
      Thinned(all_s, std::max<std::size_t>(1, most / run.cameras.size()));
  std::vector<const LoggedImage*> images;  // by time, by camera
  for (const double time_s : times_s) {
    for (const LoggedCamera& camera : run.cameras) {
      images.push_back(run.ImageAt(camera.name, time_s));
    }
  }
  const std::vector<std::string> small = SmallPictures(images);
  Json list = Json::array();
  const std::string* next = small.data();
  for (const double time_s : times_s) {
    Json cameras = Json::array();
    for (const LoggedCamera& camera : run.cameras) {
      const std::string& image = *next++;
      if (image.empty()) continue;
      cameras.push_back({{"name", camera.name},
                         {"width", camera.width},
                         {"height", camera.height},
                         {"picture", payload.Add(image)}});
    }
    if (!cameras.empty()) list.push_back({{"sample", run.SampleAt(time_s)}, {"cameras", cameras}});
  }
  if (list.empty()) return nullptr;
  return {{"taken", all_s.size()}, {"shown", list}};
}

}  // namespace dockyard
