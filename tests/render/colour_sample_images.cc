// Writes colour pictures for viewing: render_colour_samples FOLDER. Prints processor times.
#include <cstdio>
#include <ctime>
#include <string>

#include <opencv2/imgcodecs.hpp>

#include "render/colour_samples.h"
#include "render/shutter.h"

namespace dockyard {
namespace {

void Write(const std::string& path, const RgbImage& image) {
  cv::Mat picture(image.height, image.width, CV_8UC3);
  for (std::size_t i = 0; i < image.pixels.size(); ++i) {
    picture.data[i - i % 3 + 2 - i % 3] = image.pixels[i];
  }
  if (!cv::imwrite(path, picture)) std::fprintf(stderr, "cannot write %s\n", path.c_str());
}

// Processor time of all threads, so that a busy machine does not count.
double Now_ms() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void WriteSamples(const std::string& folder) {
  StereoRenderer renderer;
  const CameraResponse camera = CheapCamera();
  ColourSensorOptions sensor;
  sensor.auto_balance = false;
  sensor.balance = BalanceFor(PlanckLight(5000.0), camera);
  for (const double distance : {0.3, 0.7, 1.1, 2.0}) {
    for (const double temperature : {3000.0, 5000.0, 6500.0}) {
      const auto marks = MarksAt(distance, PlanckLight(temperature));
      const ColourTable table = MakeColourTable(marks->spectra, camera);
      ColourSensorState state;
      const RgbImage picture =
          ExposeColourView(renderer.RenderThrough(marks->scene, table, MarksView(), {marks->X_WC}),
                           sensor, 0.1, 1, state);
      char name[80];
      std::snprintf(name, sizeof name, "/marks_%.1fm_%.0fK.png", distance, temperature);
      Write(folder + name, picture);
    }
  }
}

void PrintTimes() {
  StereoRenderer renderer;
  const ColourView view = MarksView();
  struct Case {
    const char* name;
    double sun;
    int lamps;
    double turn_rad_s;
  };
  for (const double distance : {0.3, 0.7, 2.0}) {
    for (const Case& c :
         {Case{"even light", 0.0, 0, 0.0}, Case{"sun", 1.0, 0, 0.0},
          Case{"sun, two lamps", 1.0, 2, 0.0}, Case{"even, 10 deg/s", 0.0, 0, 0.1745}}) {
      auto marks = MarksAt(distance, DaylightLight(5500.0));
      marks->scene.light.sun_irradiance = c.sun;
      for (int i = 0; i < c.lamps; ++i) {
        marks->scene.lamps.push_back({.p_W = {0.0, 0.1 - 0.2 * i, 0.1},
                                      .axis_W = {1, 0, 0},
                                      .half_angle_rad = 0.5,
                                      .irradiance_1m = 0.1});
      }
      const ColourTable table = MakeColourTable(marks->spectra, CheapCamera());
      ColourSensorState state;
      const double motion = MotionInExposure_px(view.camera, c.turn_rad_s, 0.0, 1.0, 0.02);
      double draw = 0.0, sense = 0.0;
      constexpr int kFrames = 50;
      for (int i = -5; i < kFrames; ++i) {
        Pose3 X_WC = marks->X_WC;
        X_WC.p.x() += 1e-4 * i;
        const double start = Now_ms();
        const ColourRadiance light = renderer.RenderThrough(
            marks->scene, table, view,
            PosesInExposure(X_WC, {0, 0, 0}, {0, 0, c.turn_rad_s}, 0.02, motion));
        const double middle = Now_ms();
        ExposeColourView(light, {}, 0.1, static_cast<std::uint64_t>(i + 5), state);
        const double end = Now_ms();
        if (i < 0) continue;
        draw += (middle - start) / kFrames;
        sense += (end - middle) / kFrames;
      }
      std::printf("%.1f m, %-15s draw %.2f ms, sensor %.2f ms\n", distance, c.name, draw, sense);
    }
  }
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: render_colour_samples FOLDER\n");
    return 2;
  }
  dockyard::WriteSamples(argv[1]);
  dockyard::PrintTimes();
  return 0;
}
