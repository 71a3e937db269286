// How fast the charger's simulator alone is: its robot drives at the dock, its camera takes images
// of 640 x 480 at 10 Hz, no controller has them. custom_image_speed [LIGHT ...]: of each light the
// simulated seconds per second of processor time, what an image costs, and a hash of all images'
// pixels, which is the same where two builds draw the same bits.
#include <cinttypes>
#include <cstdio>
#include <ctime>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "custom/charger_rig.h"
#include "sim/base/hash.h"
#include "sim/custom/custom_plant.h"

namespace dockyard::custom {
namespace {

double Seconds(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// A drive at the dock: where it starts, how fast the wheels' treads run, for how long. Slow near
/// the dock, as a controller drives.
struct Drive {
  const char *start_r, *alpha_deg;
  double left_m_s, right_m_s, seconds;
};
constexpr Drive kDrives[] = {{"2.6", "-30", 0.32, 0.30, 2.0},
                             {"1.5", "15", 0.20, 0.20, 2.0},
                             {"0.9", "10", 0.10, 0.12, 2.0},
                             {"0.45", "0", 0.05, 0.05, 1.0}};

struct Spent {
  double simulated_s = 0.0, all_s = 0.0, images_s = 0.0, own_images_s = 0.0;
  int images = 0;
  std::uint64_t hash = kHashSeed;
};

void DriveAndMeasure(const Drive& drive, const std::string& light,
                     const std::shared_ptr<KeptRenderer>& renderer, Spent& spent) {
  const Scenario scenario =
      ChargerScenario({"light=" + light, std::string("start.r_m=") + drive.start_r,
                       std::string("start.alpha_deg=") + drive.alpha_deg,
                       "start.heading_deg=" + std::string(drive.alpha_deg)});
  CustomPlant plant(scenario, BuildRun(scenario, LoadModels(scenario)), renderer);
  const Commands commands{.motors = DriveAt(plant.built().world, drive.left_m_s, drive.right_m_s)};
  renderer->Get();
  constexpr int kPerImage = 100 / kControlPeriod;
  const int images = static_cast<int>(10.0 * drive.seconds);
  const double began_s = Seconds(CLOCK_PROCESS_CPUTIME_ID);
  for (int i = 0; i < images * kPerImage; ++i) {
    plant.Sense();
    if (i % kPerImage == 0) {
      const double all_s = Seconds(CLOCK_PROCESS_CPUTIME_ID);
      const double own_s = Seconds(CLOCK_THREAD_CPUTIME_ID);
      const CameraImage image = std::move(plant.TakeImages({0}, 0.0).front());
      spent.images_s += Seconds(CLOCK_PROCESS_CPUTIME_ID) - all_s;
      spent.own_images_s += Seconds(CLOCK_THREAD_CPUTIME_ID) - own_s;
      const GrayImage& pixels = std::get<GrayImage>(image.pixels);
      for (const std::uint8_t pixel : pixels.pixels) spent.hash = HashByte(spent.hash, pixel);
      ++spent.images;
    }
    plant.Advance(commands);
  }
  spent.all_s += Seconds(CLOCK_PROCESS_CPUTIME_ID) - began_s;
  spent.simulated_s += drive.seconds;
}

void Report(const std::string& light, const Spent& spent) {
  std::printf(
      "%-12s %.2f simulated s per CPU s; an image %.1f ms (this thread %.1f ms), the rest %.1f ms "
      "per 0.1 s; images %016" PRIx64 "\n",
      light.c_str(), spent.simulated_s / spent.all_s, 1e3 * spent.images_s / spent.images,
      1e3 * spent.own_images_s / spent.images, 1e3 * (spent.all_s - spent.images_s) / spent.images,
      spent.hash);
}

}  // namespace
}  // namespace dockyard::custom

int main(int count, char** words) {
  using namespace dockyard::custom;
  std::vector<std::string> lights(words + 1, words + count);
  if (lights.empty()) lights = {"even", "speckled", "hard_shadow"};
  dockyard::DrawWithoutThreads();
  const auto renderer = std::make_shared<dockyard::KeptRenderer>();
  for (const std::string& light : lights) {
    Spent spent;
    for (const Drive& drive : kDrives) DriveAndMeasure(drive, light, renderer, spent);
    Report(light, spent);
  }
}
