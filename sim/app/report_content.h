// A results folder as the content of a report.
#pragma once

#include <filesystem>
#include <memory>
#include <vector>

#include "sim/app/invocation.h"
#include "sim/app/kept_campaign.h"
#include "sim/page/report_page.h"
#include "sim/plan/make_run.h"
#include "sim/run/system.h"

namespace dockyard {

/// What a content points into: it must live as long.
struct ReportSource {
  KeptCampaign kept;  // of a campaign
  std::vector<KnownSystem> known;
  std::unique_ptr<RunMaker> maker;     // null: a single run
  std::shared_ptr<Scenario> scenario;  // of a single run
};

/// Of a campaign's folder or a single run's. Failures are watched first. Throws UsageError,
/// ConfigError, ResultsError and IoError.
ReportContent ContentOf(const std::filesystem::path& dir, const Invocation& call,
                        ReportSource& source);

/// Lets the replays have the images that the logs do not keep: each such run is simulated again
/// when its log is read. `source` and `call` must live as long as the content.
void MakeAllImages(const ReportSource& source, const Invocation& call, ReportContent& content);

/// Writes the page of a campaign's folder into a file and says so. Throws as ContentOf.
void WriteReport(const std::filesystem::path& dir, const std::filesystem::path& file,
                 const Invocation& call, const std::vector<Requirement>& requirements = {});

/// Of one run whose log lies in the folder.
/// @param replay_command  to be pasted; empty: the folder does not stay
ReportContent ContentOfRun(const std::filesystem::path& dir, const System& system,
                           const Scenario& scenario, const RunResult& row,
                           std::string replay_command, ReportSource& source);

}  // namespace dockyard
