#include "perception/survey_run.h"

#include <atomic>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>

namespace dockyard::axel {
namespace {

double ThreadCpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

struct Scored {
  SampleScore score;
  double cpu_s = 0.0;
};

Scored Locate(const YardViews& views, const YardSample& sample, const VisionSettings& settings) {
  const double begin = ThreadCpuSeconds();
  const LocateOutput out =
      LocateBoard(sample.images, views.calibration(), views.board(), sample.hints, settings);
  const double end = ThreadCpuSeconds();
  Scored scored{Score(sample, out), end - begin};
  scored.score.homography = HomographySums(out.report, views.calibration(), views.board());
  return scored;
}

void Gather(const char* name, const std::vector<std::optional<Scored>>& from, SurveyScores* to,
            std::string* failures) {
  for (const std::optional<Scored>& scored : from) {
    if (!scored) continue;
    to->scores.push_back(scored->score);
    to->cpu_s += scored->cpu_s;
    const SampleScore& s = scored->score;
    if (s.accepted && !s.wrong && s.wrong_marks == 0) continue;
    char line[240];
    std::snprintf(line, sizeof line,
                  "%s %4d r %.2f alpha %5.1f h %5.1f: marks %d, wrong %d, %s%s%s range %.2f cm "
                  "heading %.2f deg\n",
                  name, s.index, s.at.r, Degrees(s.at.alpha), Degrees(s.at.h), s.detections,
                  s.wrong_marks, s.stereo ? "stereo " : "", s.reason.c_str(),
                  s.wrong ? "WRONG" : "", 100.0 * s.range_error_m, Degrees(s.heading_error_rad));
    *failures += line;
  }
}

}  // namespace

void ForEachLook(const YardOptions& options, int count, int jobs,
                 const std::function<void(YardViews&, int)>& work) {
  // Threads of ours instead of Mesa's; its images do not depend on their number.
  if (jobs > 1) setenv("LP_NUM_THREADS", "0", 0);
  std::atomic<int> next{0};
  std::mutex one_at_a_time;  // worlds and renderers come and go alone
  std::exception_ptr failure;
  const auto turn = [&] {
    try {
      std::unique_ptr<YardViews> views;
      {
        const std::lock_guard lock(one_at_a_time);
        views = std::make_unique<YardViews>(options);
      }
      for (int i = next++; i < count; i = next++) work(*views, i);
      const std::lock_guard lock(one_at_a_time);
      views.reset();
    } catch (...) {
      const std::lock_guard lock(one_at_a_time);
      failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> threads;
  for (int j = 0; j < jobs; ++j) threads.emplace_back(turn);
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

SurveyFindings RunSurvey(const SurveyPlan& plan) {
  const std::size_t n = static_cast<std::size_t>(plan.count);
  std::vector<std::optional<Scored>> dockyard(n), tsai2013(n);
  ForEachLook(plan.yard, plan.count, plan.jobs, [&](YardViews& views, int i) {
    if (!views.Take(i, false).InView()) return;
    const YardSample sample = views.Take(i);
    const std::size_t at = static_cast<std::size_t>(i);
    dockyard[at] = Locate(views, sample, {});
    if (i >= plan.tsai_count) return;
    tsai2013[at] = Locate(views, sample,
                          {.pipeline = VisionPipeline::kTsai2013, .min_points = plan.min_points});
  });
  SurveyFindings findings;
  Gather("dockyard", dockyard, &findings.dockyard, &findings.failures);
  Gather("tsai2013", tsai2013, &findings.tsai2013, &findings.failures);
  return findings;
}

}  // namespace dockyard::axel
