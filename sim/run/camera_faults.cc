#include "sim/run/camera_faults.h"

#include <cmath>
#include <utility>

#include "controller/base/split_mix.h"

namespace dockyard {

std::vector<int> CameraClock::Due(const std::vector<int>& asked, Tick now) {
  if (times_.empty()) return asked;
  for (const int camera : asked) asked_[static_cast<std::size_t>(camera)] = true;
  std::vector<int> due;
  for (std::size_t i = 0; i < times_.size(); ++i) {
    if (!asked_[i] || now < next_[i]) continue;
    due.push_back(static_cast<int>(i));
    asked_[i] = false;
    next_[i] = now + times_[i].period;
  }
  return due;
}

ImageLink::ImageLink(const CameraFaults& faults, const Seed& run_seed,
                     std::vector<CameraTimes> times)
    : delay_(std::llround(faults.delay_s / kTickSeconds)),
      lost_(faults.lost),
      clock_offset_s_(faults.clock_offset_s),
      clock_drift_ppm_(faults.clock_drift_ppm),
      random_(StreamKey(run_seed, "lost images")),
      times_(std::move(times)) {}

Tick ImageLink::StampOf(Tick now) const {
  const double gained = 1e-6 * clock_drift_ppm_ * static_cast<double>(now);
  return now + std::llround(clock_offset_s_ / kTickSeconds + gained);
}

bool ImageLink::Send(std::vector<CameraImage> images, Tick now) {
  if (times_.empty()) on_the_way_.clear();
  if (random_.Uniform() < lost_) return false;
  for (CameraImage& image : images) {
    image.exposed = StampOf(now);
    const Tick latency =
        times_.empty() ? 0 : times_[static_cast<std::size_t>(image.camera)].latency;
    on_the_way_.push_back({std::move(image), now + delay_ + latency});
  }
  return true;
}

std::vector<CameraImage> ImageLink::Receive(Tick now) {
  std::vector<CameraImage> images;
  for (OnTheWay& each : on_the_way_) {
    if (now >= each.due) images.push_back(std::move(each.image));
  }
  std::erase_if(on_the_way_, [&](const OnTheWay& each) { return now >= each.due; });
  return images;
}

SensorOptions WithFaults(SensorOptions sensor, const CameraFaults& faults, const Seed& run_seed) {
  std::size_t view = 0;
  for (const EyeFaults* eye : {&faults.left, &faults.right}) {
    sensor.windows[view] = {
        .distance_m = faults.window_m,
        .pupil_m = faults.pupil_m,
        .cover_share = eye->cover_share,
        .cover_side_rad = eye->cover_side_rad,
        .dust_share = eye->dust_share,
        .dust_clump_m = eye->dust_clump_m,
        .dust_scatter = eye->dust_scatter,
        .dust_key = SplitMix(StreamKey(run_seed, "window"), static_cast<std::uint64_t>(view))};
    sensor.eyes[view] = eye->picture == EyeFaults::Picture::kDark   ? EyeState::kDark
                        : eye->picture == EyeFaults::Picture::kNone ? EyeState::kSilent
                                                                    : EyeState::kAlive;
    ++view;
  }
  return sensor;
}

}  // namespace dockyard
