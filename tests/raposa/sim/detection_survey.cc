// Not a test: how many pictures of the pyramid from the paper's grid give g and c within 10 %, by
// colour bands and strip width. Writes the table of docs/raposa.md.
//   detection_survey [VIEWS [STRIP_MM...]]
//   detection_survey OUT.png R_M ALPHA_DEG KEYS CHANGES [GROUND]   one picture, and what `tune`
//   makes of it
#include <cstdio>
#include <cstdlib>
#include <map>
#include <vector>

#include "controller/raposa/tune_bands.h"
#include "raposa/sim/pictures.h"
#include "sim/base/files.h"
#include "sim/images/png.h"

namespace dockyard::raposa {
namespace {

struct Place {
  double r_m, alpha_deg;
};
const Place kPlaces[] = {{0.5, 0},   {0.5, 60}, {1.33, 0}, {1.33, 30},
                         {1.33, 60}, {2.0, 0},  {2.0, 30}, {2.0, 60}};

struct Bands {
  const char* name;
  HsvBand orange, blue;
};

/// The user's way: bands from pictures at several places, the wider ends of all.
HsvBand Union(const HsvBand& a, const HsvBand& b) {
  return {std::min(a.hue_from, b.hue_from),
          std::max(a.hue_to, b.hue_to),
          std::min(a.saturation_from, b.saturation_from),
          std::max(a.saturation_to, b.saturation_to),
          std::min(a.value_from, b.value_from),
          std::max(a.value_to, b.value_to)};
}

void Print(const char* name, const HsvBand& band) {
  std::printf("  %s hue %d-%d saturation %d- value %d-\n", name, band.hue_from, band.hue_to,
              band.saturation_from, band.value_from);
}

void Survey(double strip_mm, int views, const std::shared_ptr<KeptRenderer>& renderer) {
  const std::string changes =
      "pyramid: {marks: {strip_m: " + std::to_string(1e-3 * strip_mm) + "}}";
  const auto tuned = [&](double r_m, double alpha_deg) {
    const Picture picture =
        PictureOf(ScenarioAt(r_m, Radians(alpha_deg), {}, changes, 1000), renderer);
    return TuneBands(picture.image, picture.nominal);
  };
  std::vector<Bands> all;
  const FerreiraVision now;
  all.push_back({"default", now.orange, now.blue});
  const auto near = tuned(0.8, 30.0), far = tuned(2.0, 30.0);
  if (near) all.push_back({"tuned at 0.8 m", near->orange, near->blue});
  if (far) all.push_back({"tuned at 2 m", far->orange, far->blue});
  if (near && far) {
    all.push_back({"both", Union(near->orange, far->orange), Union(near->blue, far->blue)});
  }
  std::printf("strip %.0f mm\n", strip_mm);
  for (const Bands& bands : all) {
    std::printf(" %s\n", bands.name);
    Print("orange", bands.orange);
    Print("blue", bands.blue);
  }
  std::printf("  r, alpha: of whole views, pair/g/c/both right, by bands\n");
  for (const Place& place : kPlaces) {
    std::vector<std::array<int, 4>> counts(all.size(), {0, 0, 0, 0});
    int whole = 0;
    for (int i = 0; i < views; ++i) {
      // Both sides of the axis, turned by up to 3 deg, nearer and farther by 3 %.
      RandomStream random(StreamKey(static_cast<std::uint64_t>(i) + 7, "survey"));
      const double side = i % 2 == 0 ? 1.0 : -1.0;
      const double r_m = place.r_m * (1.0 + random.Uniform(-0.03, 0.03));
      const double alpha = side * Radians(place.alpha_deg + random.Uniform(-3.0, 3.0));
      const std::string off = "off_guide_deg: " + std::to_string(random.Uniform(-3.0, 3.0));
      const Picture picture = PictureOf(
          ScenarioAt(r_m, alpha, off, changes, static_cast<std::uint64_t>(i) + 1), renderer);
      if (!picture.whole) continue;
      ++whole;
      for (std::size_t b = 0; b < all.size(); ++b) {
        const MarksFound found = FindIn(picture, all[b].orange, all[b].blue);
        counts[b][0] += found.pair;
        counts[b][1] += found.g_right;
        counts[b][2] += found.c_right;
        counts[b][3] += found.right();
      }
    }
    std::printf("  %4.2f %3.0f: %3d", place.r_m, place.alpha_deg, whole);
    for (const auto& n : counts) std::printf(" | %3d %3d %3d %3d", n[0], n[1], n[2], n[3]);
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace dockyard::raposa

int main(int argc, char** argv) {
  if (argc > 5) {
    using namespace dockyard::raposa;
    const Picture picture =
        PictureOf(ScenarioAt(std::atof(argv[2]), dockyard::Radians(std::atof(argv[3])), argv[4],
                             argv[5], 1000, argc > 6 ? argv[6] : "hard_floor"),
                  std::make_shared<dockyard::KeptRenderer>());
    dockyard::WriteWhole(argv[1], dockyard::EncodePng(picture.image));
    std::printf("c %.1f g %.1f px\n", picture.c_px, picture.g_px);
    if (const auto tuned = TuneBands(picture.image, picture.nominal)) {
      std::printf("tuned: c %.1f g %.1f px\n", tuned->pair.c_px, tuned->pair.g_px);
      Print("orange", tuned->orange);
      Print("blue", tuned->blue);
    }
    return 0;
  }
  const int views = argc > 1 ? std::atoi(argv[1]) : 20;
  const auto renderer = std::make_shared<dockyard::KeptRenderer>();
  std::vector<double> strips{10.0, 12.0, 15.0};
  if (argc > 2) strips.clear();
  for (int i = 2; i < argc; ++i) strips.push_back(std::atof(argv[i]));
  for (const double strip_mm : strips) dockyard::raposa::Survey(strip_mm, views, renderer);
}
