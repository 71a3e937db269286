// Prints how detection and pose do over the workspace on synthetic images, and their times:
// vision_survey [image pairs for each row]
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "controller/vision/board/fiducials.h"
#include "sim/base/random.h"
#include "vision/survey.h"

namespace dockyard {
namespace {

double Milliseconds(std::chrono::steady_clock::duration span) {
  return std::chrono::duration<double, std::milli>(span).count();
}

void PrintTimes(int width) {
  const StereoRig rig = TestRig(width, width * 3 / 4);
  SyntheticScene scene;
  scene.X_DR = RoverAt({3.0, Radians(15.0), 0.0}, 0.0);
  const StereoImages images = SyntheticPair(scene, rig);
  constexpr int kTimes = 20;
  const auto begin = std::chrono::steady_clock::now();
  std::size_t found = 0;
  for (int i = 0; i < kTimes; ++i) found += DetectFiducials(images.left, scene.board).size();
  const auto middle = std::chrono::steady_clock::now();
  for (int i = 0; i < kTimes; ++i) {
    found += LocateBoard(images, rig, scene.board, {}).report.marks.size();
  }
  const auto end = std::chrono::steady_clock::now();
  const double detect_ms = Milliseconds(middle - begin) / kTimes;
  std::printf("%d px wide: detection %.1f ms an image, whole sighting %.1f ms a pair (%zu marks)\n",
              width, detect_ms, Milliseconds(end - middle) / kTimes, found);
}

void PrintRow(const char* name, const SurveyOptions& options, int count) {
  int accepted = 0, stereo = 0, wrong = 0;
  double range = 0.0, heading = 0.0;
  const std::vector<PoseSample> pairs = Survey(options, count);
  for (const PoseSample& sample : pairs) {
    if (!sample.out.sighting) continue;
    ++accepted;
    stereo += sample.out.sighting->stereo ? 1 : 0;
    wrong += sample.wrong_marks;
    range += sample.range_error_m * sample.range_error_m;
    heading += sample.heading_error_rad * sample.heading_error_rad;
  }
  const double n = accepted > 0 ? accepted : 1;
  std::printf(
      "%-14s %4d px %.1f-%.1f m: %3d of %3zu located, %3d by both cameras, %d wrong marks, "
      "rms range %5.2f cm, heading %5.2f deg\n",
      name, options.width, options.r_min_m, options.r_max_m, accepted, pairs.size(), stereo, wrong,
      100.0 * std::sqrt(range / n), Degrees(std::sqrt(heading / n)));
}

void PrintTable(int width, int count) {
  SurveyOptions options{.width = width, .height = width * 3 / 4};
  PrintRow("even", options, count);
  options.arrange = [](SyntheticScene& scene, int) { scene.speckle = 0.5; };
  PrintRow("broken shade", options, count);
  options.arrange = [](SyntheticScene& scene, int i) {
    RandomStream random(StreamKey(static_cast<std::uint64_t>(i), "shadow"));
    scene.shadow = SyntheticScene::ShadowEdge{
        .through_B = {random.Uniform(-0.3, 0.3), random.Uniform(-0.15, 0.15)},
        .normal_rad = random.Uniform(0.0, 2.0 * kPi),
        .shade = random.Uniform(0.15, 0.35)};
  };
  PrintRow("hard shadow", options, count);
  options.arrange = {};
  options.miscalibrated = true;
  for (const double r : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0}) {
    options.r_min_m = options.r_max_m = r;
    PrintRow("miscalibrated", options, count);
  }
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) {
  const int count = argc > 1 ? std::atoi(argv[1]) : 20;
  if (count < 1) {
    std::fprintf(stderr, "vision_survey [image pairs for each row, at least 1]\n");
    return 2;
  }
  for (const int width : {1024, 640}) {
    dockyard::PrintTimes(width);
    dockyard::PrintTable(width, count);
  }
  return 0;
}
