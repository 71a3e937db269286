#include "bench/vision_speed.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <vector>

#include "axel/sim/scenarios.h"
#include "bench/physics_speed.h"
#include "controller/vision/board/fiducials.h"
#include "controller/vision/board/locate.h"
#include "render/stereo_renderer.h"
#include "sim/axel/axel_view.h"
#include "sim/plant/built_cameras.h"

namespace dockyard::axel {
namespace {

double Time(const std::function<void()>& work) {
  const double start = CpuSeconds();
  work();
  return CpuSeconds() - start;
}

double Middle(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// A rover at the start of a scenario, and its cameras' images there.
class StartView {
 public:
  explicit StartView(const std::vector<std::string>& overrides)
      : scenario_(TypicalScenario(overrides)),
        built_(Build(scenario_)),
        world_(built_.world),
        truth_(world_.truth()),
        builder_(built_.world.rover, built_.world.station, built_.world.soil, built_.lighting,
                 SiteOf(scenario_), scenario_.seed) {}

  const BuiltRun& built() const { return built_; }
  StereoImages Render(int index) {
    return renderer_.Render(builder_.Make(truth_, world_.ground()), built_.built_rig, truth_.X_WR,
                            CameraSensor(built_.world.rover.stereo, scenario_.seed, index));
  }

 private:
  Scenario scenario_;
  BuiltRun built_;
  World world_;
  Truth truth_;
  SceneBuilder builder_;
  StereoRenderer renderer_;
};

}  // namespace

VisionSpeed TimeVision(int width, int height) {
  StartView view(
      {"camera.width_px=" + std::to_string(width), "camera.height_px=" + std::to_string(height)});
  const BuiltRun& built = view.built();
  StereoImages images;
  const auto render = [&](int index) { images = view.Render(index); };
  render(0);  // shaders and meshes are made once
  constexpr int kRounds = 8;
  VisionSpeed speed;
  speed.pair_s = Time([&] {
                   for (int i = 1; i <= kRounds; ++i) render(i);
                 }) /
                 kRounds;
  // Correspondence and pose are a small difference of large times: of each round, then the median.
  std::size_t found = 0;
  std::vector<double> detect_s, locate_s, alone_s;
  for (int i = 0; i < 2 * kRounds + 1; ++i) {
    detect_s.push_back(Time([&] {
      for (const GrayImage* image : {&images.left, &images.right}) {
        found += DetectFiducials(*image, built.nominal.board).size();
      }
    }));
    locate_s.push_back(Time([&] {
      found += static_cast<bool>(
          LocateBoard(images, built.nominal.rig, built.nominal.board, {}).sighting);
    }));
    alone_s.push_back(locate_s.back() - detect_s.back());
  }
  speed.detect_s = 0.5 * Middle(detect_s);
  speed.locate_s = Middle(locate_s);
  speed.alone_s = Middle(alone_s);
  if (found == 0) std::printf("  nothing was found in the image\n");
  return speed;
}

double PairSeconds(const std::string& light, const std::string& range_m) {
  StartView view({"light=" + light, "start.r_m=" + range_m});
  double least_s = 1e9;
  for (int i = 0; i < 9; ++i) {
    const double pair_s = Time([&] { view.Render(i); });
    if (i > 0) least_s = std::min(least_s, pair_s);  // shaders and meshes are made once
  }
  return least_s;
}

}  // namespace dockyard::axel
