#include "sim/run/camera_faults.h"

#include <cmath>
#include <utility>

#include "controller/base/split_mix.h"

namespace dockyard {

ImageLink::ImageLink(const CameraFaults& faults, const Seed& run_seed)
    : delay_(std::llround(faults.delay_s / kTickSeconds)),
      lost_(faults.lost),
      random_(StreamKey(run_seed, "lost images")) {}

bool ImageLink::Send(std::vector<CameraImage> images, Tick now) {
  on_the_way_.reset();
  if (random_.Uniform() < lost_) return false;
  for (CameraImage& image : images) image.exposed = now;
  on_the_way_ = OnTheWay{std::move(images), now + delay_};
  return true;
}

std::vector<CameraImage> ImageLink::Receive(Tick now) {
  if (!on_the_way_ || now < on_the_way_->due) return {};
  std::vector<CameraImage> images = std::move(on_the_way_->images);
  on_the_way_.reset();
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
