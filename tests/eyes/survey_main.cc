// Rates and errors of both pipelines on rendered pairs over the workspace, in even light and under
// a hard shadow: a table, curves.csv and curves.svg.
#include <CLI/CLI.hpp>
#include <chrono>
#include <cstdio>
#include <string>
#include <vector>

#include "eyes/survey_plot.h"
#include "sim/campaign/statistics.h"
#include "sim/log/files.h"

namespace dockyard {
namespace {

struct Arguments {
  int count = 300, width = 1024, min_points = 4;
  double r_max_m = 7.0;
  std::string out, cache;
  bool verbose = false;
};

void PrintRow(const std::string& name, const SurveyTally& t) {
  std::printf(
      "  %-8s in view %4d  found %-26s accepted %-26s wrong %3d | centre %.3f px (%d), cut %.3f px "
      "(%d) | range %6.2f cm, heading %5.2f deg; of %d with six right marks in each picture %6.2f "
      "cm, %5.2f deg | nees %.1f\n",
      name.c_str(), t.in_view, RateText(t.found, t.in_view).c_str(),
      RateText(t.accepted, t.in_view).c_str(), t.wrong, t.plain_rms_px(), t.plain, t.cut_rms_px(),
      t.cut, 100.0 * t.range_rms_m(), Degrees(t.heading_rms_rad()), t.named,
      100.0 * t.named_range_rms_m(), Degrees(t.named_heading_rms_rad()),
      t.accepted > 0 ? t.nees / t.accepted : 0.0);
}

void PrintLook(const LookScore& s, const LocateOutput& out) {
  std::printf(
      "%4d r %.2f alpha %5.1f h %5.1f: discs %d %d, marks %d, wrong %d, %s %s%s "
      "range %.2f cm heading %.2f deg\n",
      s.index, s.at.r, Degrees(s.at.alpha), Degrees(s.at.h), out.report.detected_left,
      out.report.detected_right, s.detections, s.wrong_marks, out.report.method.c_str(),
      s.reason.c_str(), s.wrong ? "WRONG" : "", 100.0 * s.range_error_m,
      Degrees(s.heading_error_rad));
}

/// Both pipelines on the same pictures.
std::vector<SurveyCurve> Survey(Light light, const Arguments& arguments) {
  YardOptions options{.light = light, .width = arguments.width, .height = arguments.width * 3 / 4};
  options.r_max_m = arguments.r_max_m;
  if (!arguments.cache.empty()) {
    options.cache = arguments.cache + "/" + LightName(light);
  }
  const bool even = light == Light::kEven;
  const std::string word = even ? "even" : "hard shadow";
  std::vector<SurveyCurve> curves{{"dockyard, " + word, even ? "#1f5fbf" : "#c8321e", "", {}},
                                  {"tsai2013, " + word, even ? "#1f5fbf" : "#c8321e", "5 4", {}}};
  YardViews views(options);
  double seconds[2] = {0.0, 0.0};
  int looks = 0;
  for (int i = 0; i < arguments.count; ++i) {
    if (!views.Take(i, false).InView()) continue;
    const YardLook look = views.Take(i);
    ++looks;
    for (std::size_t p = 0; p < 2; ++p) {
      const VisionSettings settings{
          .pipeline = p == 0 ? VisionPipeline::kDockyard : VisionPipeline::kTsai2013,
          .min_points = arguments.min_points};
      const auto begin = std::chrono::steady_clock::now();
      const LocateOutput out =
          LocateBoard(look.images, views.calibration(), views.board(), look.hints, settings);
      seconds[p] += std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
      curves[p].scores.push_back(Score(look, out));
      const LookScore& score = curves[p].scores.back();
      if (arguments.verbose && (!score.accepted || score.wrong || score.wrong_marks > 0)) {
        PrintLook(score, out);
      }
    }
  }
  for (std::size_t p = 0; p < 2; ++p) {
    std::printf("%s, %d px: %.1f ms a pair\n", curves[p].name.c_str(), arguments.width,
                1e3 * seconds[p] / std::max(looks, 1));
    for (int r = 0; r < arguments.r_max_m; ++r) {
      PrintRow(std::to_string(r) + "-" + std::to_string(r + 1) + " m",
               TallyOf(curves[p].scores, r, r + 1));
    }
    PrintRow("1.5-2.5", TallyOf(curves[p].scores, 1.5, 2.5));
    PrintRow("4.5-5.5", TallyOf(curves[p].scores, 4.5, 5.5));
    PrintRow("to 5 m", TallyOf(curves[p].scores, 0.0, 5.0));
    PrintRow("to 6 m", TallyOf(curves[p].scores, 0.0, 6.0));
    PrintRow("all", TallyOf(curves[p].scores, 0.0, 100.0));
  }
  std::fflush(stdout);
  return curves;
}

int Main(int argc, char** argv) {
  CLI::App app("Survey of the perception on rendered pairs");
  Arguments arguments;
  app.add_option("--count", arguments.count, "poses for each light");
  app.add_option("--width", arguments.width, "of the images [px]")->check(CLI::Range(320, 2048));
  app.add_option("--r-max", arguments.r_max_m, "largest range [m]")->check(CLI::Range(2.0, 9.0));
  app.add_option("--min-points", arguments.min_points, "of tsai2013")->check(CLI::Range(4, 5));
  app.add_option("--out", arguments.out, "folder for curves.csv and curves.svg");
  app.add_option("--cache", arguments.cache, "folder that keeps the pictures");
  app.add_flag("--verbose", arguments.verbose, "a line for each look that failed");
  CLI11_PARSE(app, argc, argv);
  std::vector<SurveyCurve> curves;
  for (const Light light : {Light::kEven, Light::kHardShadow}) {
    for (SurveyCurve& curve : Survey(light, arguments)) curves.push_back(std::move(curve));
  }
  if (arguments.out.empty()) return 0;
  MakeFolder(arguments.out);
  WriteWhole(arguments.out + "/curves.csv", SurveyCsv(curves, arguments.r_max_m));
  WriteWhole(arguments.out + "/curves.svg",
             SurveyPlot("Perception on rendered pairs, " + std::to_string(arguments.width) + " x " +
                            std::to_string(arguments.width * 3 / 4),
                        curves, arguments.r_max_m));
  return 0;
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) { return dockyard::Main(argc, argv); }
