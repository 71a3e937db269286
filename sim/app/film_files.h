// Pictures of a logged run from outside, as files.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "sim/run/loop.h"
#include "sim/run/system.h"
#include "sim/spectator/outside_view.h"

namespace dockyard {

/// --size, --from and --at.
struct OutsideArguments {
  std::string size = "960x540";
  std::vector<double> from_D;  // x, y, z [m], or empty
  std::string at;              // empty: robot and target

  /// Throws UsageError, also for a point that these shapes do not have.
  OutsideOptions options(const StageShapes& shapes) const;
};
void AddOutsideOptions(CLI::App& command, OutsideArguments& arguments);

/// What is drawn of a system's world. Throws UsageError for one that cannot be shown.
StageShapes ShapesToDraw(const System& system, const Scenario& scenario);

/// frame_00001.png and so on: one frame each `period_s` of simulated time and one of the end.
/// Returns how many. Throws DataError and IoError.
int WriteFilm(const LoggedRun& log, const StageShapes& shapes, const OutsideOptions& options,
              double period_s, const std::filesystem::path& out_dir);

/// One image of the world as it was at that time, or at the end of a shorter run; returns the
/// time.
double WriteOutside(const LoggedRun& log, const StageShapes& shapes, const OutsideOptions& options,
                    double time_s, const std::filesystem::path& file);

/// The log of the run, simulated again in a folder that passes.
LoggedRun LogAnew(const System& system, const CampaignRun& run, RunOptions options);

}  // namespace dockyard
