// What one image of one camera costs in a room with a dock: camera_view_speed [COUNT [FOLDER]]
// prints processor time, and writes images for viewing.
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "plant/dock_room.h"
#include "render/stereo_renderer.h"
#include "sim/base/files.h"
#include "sim/images/png.h"

namespace dockyard {
namespace {

double Seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Sums of this thread's and of all threads' time.
struct Spent {
  double thread_s = 0.0, all_s = 0.0;
  template <typename Work>
  auto operator()(const Work& work) {
    const double thread = Seconds(CLOCK_THREAD_CPUTIME_ID), all = Seconds(CLOCK_PROCESS_CPUTIME_ID);
    auto result = work();
    thread_s += Seconds(CLOCK_THREAD_CPUTIME_ID) - thread;
    all_s += Seconds(CLOCK_PROCESS_CPUTIME_ID) - all;
    return result;
  }
};

Camera Pinhole(int width, int height, double field_rad) {
  const double f = 0.5 * width / std::tan(0.5 * field_rad);
  return {
      .width = width,
      .height = height,
      .lens = BrownPinhole{.fx = f, .fy = f, .cx = 0.5 * (width - 1), .cy = 0.5 * (height - 1)}};
}

void Measure(StereoRenderer& renderer, double sun, int count, const std::string& folder) {
  const DockRoom room(sun);
  const Camera camera = Pinhole(640, 480, Radians(70.0));
  Spent render, expose, png;
  for (int i = -2; i < count; ++i) {
    if (i == 0) render = expose = png = {};
    const double share = (i + 2.0) / (count + 2.0);
    const Pose3 X_WC = room.CameraAt(2.5 - 2.2 * share, 0.1 * std::sin(9.0 * share), 0.1 * share);
    const Scene scene = room.SceneAt(X_WC);
    RadianceImage light = render([&] { return renderer.RenderGrey(scene, camera, X_WC); });
    const GrayImage image = expose([&] {
      return ExposeGrey(std::move(light), camera,
                        {.full_well_e = 5500.0,
                         .read_noise_e = 10.5,
                         .vignetting_exponent = 2.0,
                         .blur_sigma_px = 0.6,
                         .noise_key = static_cast<std::uint64_t>(i + 3)});
    });
    const std::string bytes = png([&] { return EncodePng(image); });
    if (!folder.empty() && (i + 1) % 8 == 0) {
      WriteWhole(folder + "/sun_" + std::to_string(sun) + "_" + std::to_string(i) + ".png", bytes);
    }
  }
  std::printf("sun %.1f, ms an image (this thread / all threads):", sun);
  const auto print = [count](const char* name, const Spent& spent) {
    std::printf("  %s %.2f / %.2f", name, 1e3 * spent.thread_s / count, 1e3 * spent.all_s / count);
  };
  print("render", render);
  print("expose", expose);
  print("png", png);
  std::printf("\n");
}

}  // namespace
}  // namespace dockyard

int main(int count, char** words) {
  dockyard::StereoRenderer renderer;
  const int images = count > 1 ? std::atoi(words[1]) : 25;
  const std::string folder = count > 2 ? words[2] : "";
  for (const double sun : {0.6, 0.0}) dockyard::Measure(renderer, sun, images, folder);
}
