// Not a test: what ferreira2009 finds in images of the pyramid, place by place: orange pixels in
// the band, pairs, the errors of c and g, the angle by eq. (7). Writes the tables of
// docs/raposa.md.
//   detection_survey VIEWS SCENARIO [KEY=VALUE...]
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "controller/raposa/ferreira2009.h"
#include "raposa/sim/pictures.h"
#include "sim/raposa/raposa_system.h"
#include "sim/run/system.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard::raposa {
namespace {

struct Place {
  double r_m, alpha_deg;
};
const Place kPlaces[] = {{0.5, 0},  {0.5, 60},  {1.33, 0},  {1.33, 30}, {1.33, 60}, {1.5, 80},
                         {1.5, 90}, {1.5, 100}, {1.5, 110}, {2.0, 0},   {2.0, 30},  {2.0, 60},
                         {2.5, 0},  {2.7, 0},   {2.8, 0},   {3.0, 0}};

/// Of the views of one place.
struct Tally {
  int whole = 0, orange = 0, pairs = 0;
  double least_px2 = 1e9, most_px2 = 0.0;
  std::vector<double> dc_px, dg_px, alpha_deg, truth_deg;
};

double MeanOf(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double v : values) sum += v;
  return values.empty() ? 0.0 : sum / static_cast<double>(values.size());
}

/// Where the guide truly is, the pixels in the band.
double OrangePixels(const Picture& view, const HsvBand& band) {
  const ColourSearch search(view.image);
  double most = 0.0;
  for (const ColourBlob& blob : search.Blobs(band, 1.0)) {
    if ((blob.ellipse.centre_px - view.guide_px).norm() < 4.0) most = std::max(most, blob.area_px2);
  }
  return most;
}

void Add(const Picture& view, Tally& tally) {
  const FerreiraVision& vision = view.nominal.ferreira_vision;
  ++tally.whole;
  const double px2 = OrangePixels(view, vision.orange);
  tally.least_px2 = std::min(tally.least_px2, px2);
  tally.most_px2 = std::max(tally.most_px2, px2);
  const auto found = FindMarks(ColourSearch(view.image), view.nominal, vision, std::nullopt);
  tally.orange += found.orange.has_value();
  if (!found.pair) return;
  ++tally.pairs;
  const Marks& marks = view.nominal.marks;
  tally.dc_px.push_back(found.pair->c_px - view.c_px);
  tally.dg_px.push_back(found.pair->g_px - view.g_px);
  tally.alpha_deg.push_back(Degrees(found.pair->angle.alpha_rad));
  tally.truth_deg.push_back(
      Degrees(AngleOfMarks(view.c_px, view.g_px, marks.edge_m, marks.behind_m, 1.0).alpha_rad));
}

void Survey(int views, const std::string& file, const std::vector<std::string>& overrides) {
  const auto renderer = std::make_shared<KeptRenderer>();
  const std::vector<System> systems{RaposaSystem({{"ferreira2009", MakeFerreira2009Controller}})};
  std::printf("  r, alpha | whole | orange px2 | orange | pairs | dc, dg px | ");
  std::printf("(7): of the truth, found: mean; each\n");
  for (const Place& place : kPlaces) {
    Tally tally;
    for (int i = 0; i < views; ++i) {
      // Both sides of the axis, turned by up to 3 deg, nearer and farther by 3 %; the ends of the
      // range as they are.
      RandomStream random(StreamKey(static_cast<std::uint64_t>(i) + 7, "survey"));
      const double side = i % 2 == 0 ? 1.0 : -1.0;
      const double share = place.r_m > 2.1 ? 0.0 : 0.03;
      const double r_m = place.r_m * (1.0 + random.Uniform(-share, share));
      const double alpha_deg = side * (place.alpha_deg + random.Uniform(-3.0, 3.0));
      std::vector<std::string> all = overrides;
      all.push_back("start.r_m=" + NumberText(r_m));
      all.push_back("start.alpha_deg=" + NumberText(alpha_deg));
      all.push_back("raposa.off_guide_deg=" + NumberText(random.Uniform(-3.0, 3.0)));
      all.push_back("seed=" + std::to_string(i + 1));
      const Picture view = PictureOf(LoadScenario(file, all, KnownSystems(systems)), renderer);
      if (view.whole) Add(view, tally);
    }
    std::printf("  %4.2f %3.0f | %2d | %3.0f-%3.0f | %2d | %2d | %+.1f %+.1f | %5.1f %5.1f;",
                place.r_m, place.alpha_deg, tally.whole, tally.least_px2, tally.most_px2,
                tally.orange, tally.pairs, MeanOf(tally.dc_px), MeanOf(tally.dg_px),
                MeanOf(tally.truth_deg), MeanOf(tally.alpha_deg));
    for (const double deg : tally.alpha_deg) std::printf(" %.0f", deg);
    std::printf("\n");
    std::fflush(stdout);
  }
}

}  // namespace
}  // namespace dockyard::raposa

int main(int argc, char** argv) {
  if (argc < 3) return std::fprintf(stderr, "expected VIEWS and a scenario\n"), 2;
  dockyard::raposa::Survey(std::atoi(argv[1]), argv[2], {argv + 3, argv + argc});
}
