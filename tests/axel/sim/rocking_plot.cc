// Draws docs/images/rocking.svg: rocking_plot FILE. Built and run by scripts/rocking_plot.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>

#include "axel/sim/product.h"
#include "axel/sim/rocking.h"
#include "sim/report/svg.h"

namespace dockyard::axel {
namespace {

constexpr const char *kLoose = "#d9772b", *kCompact = "#1f5fa8";

void DrawPanel(SvgDocument& svg, double top, const char* label, const Spectrum& loose,
               const Spectrum& compact) {
  DataRange y{0.0, 0.0};
  for (const Spectrum* spectrum : {&loose, &compact}) {
    for (double power : spectrum->power) y.Hold(1.05 * std::sqrt(2.0 * power));
  }
  const PlotArea area{{70, top}, 560, 190, {0.0, 2.5}, y};
  area.DrawAxes(svg, "frequency [Hz]", label);
  for (int n = 1; n * kPaddles_hz < area.x.high; ++n) {
    svg.Line(area.At(n * kPaddles_hz, y.low), area.At(n * kPaddles_hz, y.high),
             {"#888888", 0.8, "4 3", 1.0});
  }
  for (const auto& [spectrum, color] : {std::pair{&compact, kCompact}, std::pair{&loose, kLoose}}) {
    std::vector<Px> line;
    for (std::size_t i = 0; i < spectrum->hertz.size(); ++i) {
      line.push_back(area.At(spectrum->hertz[i], std::sqrt(2.0 * spectrum->power[i])));
    }
    svg.Polyline(line, {color, 1.5, "", 1.0});
  }
}

int Draw(const char* file) {
  const RockingSpectra loose = MeanSpectra(LooseSand()), compact = MeanSpectra(CompactGravel());
  SvgDocument svg(660, 580, "rocking");
  svg.Text({70, 26}, "Rover reeled in at 0.06 m/s on free wheels: amplitude by frequency",
           {15, "#111111", Anchor::kStart, true});
  DrawLegend(svg, {70, 48},
             {{"compact gravel", {kCompact, 2.4, "", 1.0}},
              {"loose sand", {kLoose, 2.4, "", 1.0}},
              {"multiples of the paddles' 0.38 Hz", {"#888888", 1.0, "4 3", 1.0}}});
  DrawPanel(svg, 76, "roll [deg]", loose.roll, compact.roll);
  DrawPanel(svg, 330, "heading [deg]", loose.heading, compact.heading);
  std::ofstream out(file);
  out << svg.Finish();
  out.close();
  if (out) return 0;
  std::fprintf(stderr, "%s: cannot be written\n", file);
  return 1;
}

}  // namespace
}  // namespace dockyard::axel

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fprintf(stderr, "usage: %s FILE.svg\n", argv[0]);
    return 2;
  }
  return dockyard::axel::Draw(argv[1]);
}
