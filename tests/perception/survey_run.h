// Image pairs of a survey, shared out among threads, each with its own world and renderer.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "controller/io/vision_settings.h"
#include "perception/survey_score.h"

namespace dockyard::axel {

/// Calls work(views, i) once for each i in [0, count), views built anew from `options` in each of
/// `jobs` threads. Any thread may take any i: work writes its results to a place of i's own.
void ForEachLook(const YardOptions& options, int count, int jobs,
                 const std::function<void(YardViews&, int)>& work);

struct SurveyPlan {
  YardOptions yard;
  int count = 0;       // poses of the Halton sequence; those out of view are skipped
  int tsai_count = 0;  // the first so many are shown to tsai2013 too, which is slow
  int min_points = 4;  // of tsai2013
  int jobs = 1;
};

/// One pipeline's results on the image pairs in view, in the order of the sequence.
struct SurveyScores {
  std::vector<SampleScore> scores;
  double cpu_s = 0.0;  // of the pipeline alone
};
struct SurveyFindings {
  SurveyScores dockyard, tsai2013;
  std::string failures;  // a line for each image pair that failed
};

/// The findings do not depend on the number of jobs, except the times.
SurveyFindings RunSurvey(const SurveyPlan& plan);

}  // namespace dockyard::axel
