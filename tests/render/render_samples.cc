// Writes sample images for viewing: render_samples FOLDER [WIDTH HEIGHT]. Prints timings.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include <opencv2/imgcodecs.hpp>

#include "render/scene_samples.h"

namespace dockyard {
namespace {

void Write(const std::string& path, const GrayImage& image) {
  const cv::Mat view(image.height, image.width, CV_8UC1,
                     const_cast<std::uint8_t*>(image.pixels.data()));
  if (!cv::imwrite(path, view)) std::fprintf(stderr, "cannot write %s\n", path.c_str());
}

// Processor time, so that a busy machine does not count; LP_NUM_THREADS=0 keeps it to one core.
double Now() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void WriteSamples(const std::string& folder, int width, int height) {
  StereoRenderer renderer;
  const StereoRig rig = SampleRig(width, height);
  const SensorOptions sensor{.vignetting_exponent = 1.0, .blur_sigma_px = 0.5};
  struct Sun {
    const char* name;
    double azimuth, elevation;
    bool canopy;
  };
  const Sun suns[] = {{"front_left", -0.9, 0.6, false},
                      {"behind", 0.4, 0.9, false},
                      {"against", 2.6, 0.45, false},
                      {"canopy", 0.7, 0.7, true}};
  for (const double range : {1.5, 2.0, 4.0, 6.0}) {
    for (const Sun& sun : suns) {
      auto yard = SampleYard(range, SunAt(sun.azimuth, sun.elevation));
      if (sun.canopy) AddCanopy(*yard);
      double t[4] = {Now()};
      auto pair = renderer.RenderRadiance(yard->scene, rig, yard->X_WR);
      t[1] = Now();
      pair = renderer.RenderRadiance(yard->scene, rig, yard->X_WR);
      t[2] = Now();
      const StereoImages images = ExposeStereo(pair, rig, sensor);
      t[3] = Now();
      std::printf("%.1f m %-10s first %.0f ms, again %.0f ms, sensor %.0f ms\n", range, sun.name,
                  1e3 * (t[1] - t[0]), 1e3 * (t[2] - t[1]), 1e3 * (t[3] - t[2]));
      char name[80];
      std::snprintf(name, sizeof name, "/%.1fm_%s", range, sun.name);
      Write(folder + name + std::string("_left.png"), images.left);
      Write(folder + name + std::string("_right.png"), images.right);
    }
  }
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::fprintf(stderr, "usage: render_samples FOLDER [WIDTH HEIGHT]\n");
    return 2;
  }
  dockyard::WriteSamples(argv[1], argc == 4 ? std::atoi(argv[2]) : 1024,
                         argc == 4 ? std::atoi(argv[3]) : 768);
  return 0;
}
