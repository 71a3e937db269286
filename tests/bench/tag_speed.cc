// Time of our detector and of AprilTag 3 on the same few views: marks of the same size at the same
// places, in the same yard, drawn by the same renderer. Time alone; tag_compare has the rates.
#include <algorithm>
#include <cstdio>
#include <functional>

#include "bench/physics_speed.h"
#include "bench/tags.h"
#include "controller/vision/board/fiducials.h"
#include "perception/yard_views.h"

namespace dockyard::axel {
namespace {

/// CPU time [ms] an image; each pair's least of three.
double MillisecondsAnImage(const StereoImages& images,
                           const std::function<void(const GrayImage&)>& detect) {
  double least_s = 1e9;
  for (int i = 0; i < 3; ++i) {
    const double start = CpuSeconds();
    detect(images.left);
    detect(images.right);
    least_s = std::min(least_s, CpuSeconds() - start);
  }
  return 0.5e3 * least_s;
}

void Report() {
  StereoRenderer renderer;
  TagDetector full(1.0f), quick(2.0f);
  double ours_ms = 0.0, full_ms = 0.0, quick_ms = 0.0;
  int pairs = 0;
  for (const Light light : {Light::kEven, Light::kSpeckled, Light::kHardShadow}) {
    YardViews yard({.light = light, .seed = 43});
    const YardSample sample = yard.TakeAt(pairs++, {3.0, Radians(15.0), 0.0}, 0.0);
    const StereoImages tags =
        ExposeStereo(RenderPrinted(renderer, yard.last_scene(), sample.built_rig, sample.X_WR,
                                   full.Images(yard.board())),
                     sample.built_rig, sample.sensor);
    ours_ms += MillisecondsAnImage(
        sample.images, [&](const GrayImage& image) { DetectFiducials(image, yard.board()); });
    full_ms += MillisecondsAnImage(tags, [&](const GrayImage& image) { full.Detect(image); });
    quick_ms += MillisecondsAnImage(tags, [&](const GrayImage& image) { quick.Detect(image); });
  }
  std::printf(
      "detection, %d pairs at 3 m, 1024 x 768: %.1f ms an image; AprilTag 3 %.1f ms (ours is %.1f "
      "times as\n"
      "  fast), at quad_decimate 2 %.1f ms (%.1f times). Without: a board's pose; a tag has its "
      "own "
      "name\n",
      pairs, ours_ms / pairs, full_ms / pairs, full_ms / ours_ms, quick_ms / pairs,
      quick_ms / ours_ms);
}

}  // namespace
}  // namespace dockyard::axel

int main() { dockyard::axel::Report(); }
