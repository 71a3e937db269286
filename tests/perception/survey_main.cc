// Rates and errors of both pipelines on rendered pairs over the workspace, in even light and under
// a hard shadow: a table, curves.csv and curves.svg.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>
#include <vector>

#include "perception/survey_plot.h"
#include "perception/survey_run.h"
#include "sim/base/files.h"
#include "sim/report/rate_text.h"

namespace dockyard::axel {
namespace {

struct Arguments {
  int count = 300, hard_count = 0, tsai_count = 300, width = 1024, min_points = 4, jobs = 1;
  double r_max_m = 7.0;
  std::string out, cache;
  bool verbose = false;
};

void PrintRow(const std::string& name, const SurveyTally& t) {
  std::printf(
      "  %-8s in view %4d  found %-30s accepted %-30s wrong %-30s | centre %.3f px (%d), cut %.3f "
      "px "
      "(%d) | range %6.2f cm, heading %5.2f deg; of %d with six right marks in each image %6.2f "
      "cm, %5.2f deg | nees %.1f\n",
      name.c_str(), t.in_view, RateText(t.found, t.in_view).c_str(),
      RateText(t.accepted, t.in_view).c_str(), RateText(t.wrong, t.accepted).c_str(),
      t.plain_rms_px(), t.plain, t.cut_rms_px(), t.cut, 100.0 * t.range_rms_m(),
      Degrees(t.heading_rms_rad()), t.named, 100.0 * t.named_range_rms_m(),
      Degrees(t.named_heading_rms_rad()), t.accepted > 0 ? t.nees / t.accepted : 0.0);
}

void PrintCurve(const SurveyCurve& curve, const SurveyScores& found, const Arguments& arguments) {
  std::printf(
      "%s, %d px: %.1f ms of CPU a pair\n", curve.name.c_str(), arguments.width,
      1e3 * found.cpu_s / static_cast<double>(std::max<std::size_t>(found.scores.size(), 1)));
  for (int r = 0; r < arguments.r_max_m; ++r) {
    const SurveyTally tally = TallyOf(curve.scores, r, r + 1);
    if (tally.in_view == 0) continue;
    PrintRow(std::to_string(r) + "-" + std::to_string(r + 1) + " m", tally);
  }
  PrintRow("1.5-2.5", TallyOf(curve.scores, 1.5, 2.5));
  PrintRow("4.5-5.5", TallyOf(curve.scores, 4.5, 5.5));
  PrintRow("to 5 m", TallyOf(curve.scores, 0.0, 5.0));
  PrintRow("to 6 m", TallyOf(curve.scores, 0.0, 6.0));
  PrintRow("all", TallyOf(curve.scores, 0.0, 100.0));
}

/// Of images whose marks are all rightly named.
void PrintHomographies(const SurveyScores& found, double r_max_m) {
  const auto print = [&](const std::string& name, double low_m, double high_m) {
    std::vector<HomographySum> sums;
    for (const SampleScore& score : found.scores) {
      if (score.at.r <= low_m || score.at.r > high_m || score.wrong_marks > 0) continue;
      sums.insert(sums.end(), score.homography.begin(), score.homography.end());
    }
    std::printf("  homography, %-7s %s\n", name.c_str(), SumsText(sums).c_str());
  };
  for (int r = 1; r < r_max_m; ++r) {
    print(std::to_string(r) + "-" + std::to_string(r + 1) + " m", r, r + 1);
  }
  print("1-5 m", 1.0, 5.0);
}

/// Both pipelines on the same images.
std::vector<SurveyCurve> Survey(Light light, const Arguments& arguments) {
  const bool even = light == Light::kEven;
  const int count = even || arguments.hard_count == 0 ? arguments.count : arguments.hard_count;
  SurveyPlan plan{.yard = {.light = light,
                           .width = arguments.width,
                           .height = arguments.width * 3 / 4,
                           .r_max_m = arguments.r_max_m},
                  .count = count,
                  .tsai_count = std::min(arguments.tsai_count, count),
                  .min_points = arguments.min_points,
                  .jobs = arguments.jobs};
  if (!arguments.cache.empty()) plan.yard.cache = arguments.cache + "/" + LightName(light);
  const SurveyFindings found = RunSurvey(plan);
  if (arguments.verbose) std::printf("%s", found.failures.c_str());
  const std::string word = even ? "even" : "hard shadow";
  const std::string color = even ? "#1f5fbf" : "#c8321e";
  std::vector<SurveyCurve> curves{{"dockyard, " + word, color, "", found.dockyard.scores, true}};
  PrintCurve(curves[0], found.dockyard, arguments);
  if (plan.tsai_count > 0) {
    curves.push_back({"tsai2013, " + word, color, "5 4", found.tsai2013.scores, false});
    PrintCurve(curves[1], found.tsai2013, arguments);
    PrintHomographies(found.tsai2013, arguments.r_max_m);
  }
  std::fflush(stdout);
  return curves;
}

int Main(int argc, char** argv) {
  CLI::App app("Survey of the perception on rendered pairs");
  Arguments arguments;
  app.add_option("--count", arguments.count, "poses for each light");
  app.add_option("--hard-count", arguments.hard_count, "under the hard shadow, if fewer");
  app.add_option("--tsai-count", arguments.tsai_count, "of them for tsai2013, at most");
  app.add_option("--jobs", arguments.jobs, "threads")->check(CLI::Range(1, 64));
  app.add_option("--width", arguments.width, "of the images [px]")->check(CLI::Range(320, 2048));
  app.add_option("--r-max", arguments.r_max_m, "largest range [m]")->check(CLI::Range(2.0, 9.0));
  app.add_option("--min-points", arguments.min_points, "of tsai2013")->check(CLI::Range(4, 5));
  app.add_option("--out", arguments.out, "folder for curves.csv and curves.svg");
  app.add_option("--cache", arguments.cache, "folder that keeps the images");
  app.add_flag("--verbose", arguments.verbose, "a line for each image pair that failed");
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
}  // namespace dockyard::axel

int main(int argc, char** argv) { return dockyard::axel::Main(argc, argv); }
