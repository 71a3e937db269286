#include "sim/app/all_images.h"

#include "controller/base/number_text.h"
#include "sim/app/film_files.h"
#include "sim/app/terminal.h"

namespace dockyard {

LoggedRun WithAllImages(LoggedRun log, CampaignRun run, const std::vector<std::string>& labels,
                        const Invocation& call) {
  if (log.header.image_gap_s == 0.0) return log;
  const std::string thinned = "the log keeps an image of a camera in " +
                              NumberText(log.header.image_gap_s) +
                              " s and those at changes of phase";
  if (!run.scenario.command.empty()) {
    PrintNote(thinned + "; the run's controller is a program, so the others are not made");
    return log;
  }
  PrintNote(thinned + "; the others are made by simulating the run again");
  run.scenario.log_image_gap_s = 0.0;
  return LogAnew(FindSystem(call.systems, run.scenario.system), run,
                 {.log_dir = {}, .labels = labels});
}

}  // namespace dockyard
