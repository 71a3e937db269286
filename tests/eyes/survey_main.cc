// Rates and errors of the controller's perception on rendered pairs over the workspace.
#include <CLI/CLI.hpp>
#include <cstdio>
#include <map>
#include <string>
#include <vector>

#include "eyes/survey_score.h"

namespace dockyard {
namespace {

void PrintRow(const char* name, const SurveyTally& t) {
  std::printf(
      "%-7s looks %4d in view %4d found %4d accepted %4d stereo %4d wrong %d wrong marks %d  "
      "centre %.3f px (%d) cut %.3f px (%d)  range %.2f cm heading %.2f deg\n",
      name, t.looks, t.in_view, t.found, t.accepted, t.stereo, t.wrong, t.wrong_marks,
      t.plain_rms_px(), t.plain, t.cut_rms_px(), t.cut, 100.0 * t.range_rms_m(),
      Degrees(t.heading_rms_rad()));
}

int Main(int argc, char** argv) {
  CLI::App app("Survey of the perception on rendered pairs");
  YardOptions options;
  std::string light = "even";
  int first = 0, count = 60;
  bool verbose = false;
  app.add_option("--light", light)->check(CLI::IsMember({"even", "speckled", "hard_shadow"}));
  app.add_option("--first", first);
  app.add_option("--count", count);
  app.add_option("--width", options.width);
  app.add_option("--r-min", options.r_min_m);
  app.add_option("--r-max", options.r_max_m);
  app.add_option("--cache", options.cache);
  app.add_flag("--verbose", verbose);
  std::string pipeline = "dockyard";
  VisionSettings settings;
  app.add_option("--pipeline", pipeline)->check(CLI::IsMember({"dockyard", "tsai2013"}));
  app.add_option("--min-points", settings.min_points);
  CLI11_PARSE(app, argc, argv);
  if (pipeline == "tsai2013") settings.pipeline = VisionPipeline::kTsai2013;
  options.height = options.width * 3 / 4;
  for (const Light kind : {Light::kEven, Light::kSpeckled, Light::kHardShadow}) {
    if (light == LightName(kind)) options.light = kind;
  }
  YardViews views(options);
  std::vector<LookScore> scores;
  for (int i = first; i < first + count; ++i) {
    const bool in_view = views.Take(i, false).InView();
    const YardLook look = views.Take(i, in_view);
    if (!in_view) {
      scores.push_back({.index = i, .at = look.at});
      continue;
    }
    const LocateOutput out =
        LocateBoard(look.images, views.calibration(), views.board(), look.hints, settings);
    const LookScore s = Score(look, out);
    scores.push_back(s);
    if (verbose && (!s.accepted || s.wrong || s.wrong_marks > 0)) {
      int visible[2] = {0, 0};
      for (int e = 0; e < 2; ++e) {
        for (const YardMark& m : look.marks[static_cast<std::size_t>(e)]) visible[e] += m.InView();
      }
      std::printf(
          "%4d r %.2f alpha %5.1f h %5.1f pitch %5.1f: visible %d %d detected %d %d marks %d wrong "
          "marks %d %s %s range %.2f cm heading %.2f deg\n",
          i, s.at.r, Degrees(s.at.alpha), Degrees(s.at.h), Degrees(look.pitch_rad), visible[0],
          visible[1], out.report.detected_left, out.report.detected_right, s.detections,
          s.wrong_marks, s.wrong ? "WRONG" : "", s.reason.c_str(), 100 * s.range_error_m,
          Degrees(s.heading_error_rad));
    }
  }
  for (int r = 0; r < 7; ++r) {
    PrintRow((std::to_string(r) + "-" + std::to_string(r + 1) + " m").c_str(),
             TallyOf(scores, r, r + 1));
  }
  PrintRow("0-5 m", TallyOf(scores, 0, 5));
  PrintRow("0-6 m", TallyOf(scores, 0, 6));
  PrintRow("all", TallyOf(scores, 0, 100));
  return 0;
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) { return dockyard::Main(argc, argv); }
