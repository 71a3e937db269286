#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "controller/base/number_text.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/judging.h"
#include "sim/app/number_option.h"
#include "sim/app/report_content.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/log/belief_error.h"
#include "sim/page/markdown.h"
#include "sim/report/run_plots.h"
#include "sim/report/starts_plot.h"
#include "sim/report/until_accepted.h"

namespace dockyard {
namespace {

struct ReportArguments {
  std::string dir, out, format = "html";
  double reliability = 0.0, confidence = 0.95;
  JudgingOptions judging;  // without a file
  int most_mib = 50;
  bool no_images = false, all_images = false, svg = false, json = false;
};

struct Format {
  std::string name, extension;
};
const std::vector<Format> kFormats{
    {"html", ".html"}, {"json", ".json"}, {"markdown", ".md"}, {"junit", ".xml"}};

constexpr const char* kReportHelp =
    R"(Make a report of a campaign or of one run: an HTML file that opens without network.

Examples:
  dockyard report results/{campaign_name}
  dockyard report results/{campaign_name} --out out/yard.html --no-pictures
  dockyard report results/{campaign_name} --reliability 0.9 --confidence 0.95
  dockyard report results/{campaign_name} --require 'success >= 0.9' --out out/aim.html
  dockyard report out/typical --all-images
  dockyard report results/{campaign_name} --format markdown --out out/yard.md
  dockyard report results/{campaign_name} --svg --out out/figures

The page has success with exact intervals, failures by cause, a map of the starts, curves over the
numbers that the campaign varies, the sensitivity, all runs in a table, and a replay of each run
whose log is kept (`keep` in the campaign's file). Where a log keeps some of the images alone
(log_image_gap_s) --all-images simulates the run again for the others. --reliability and --require
on `success` draw their limit into the curves.

--svg writes static figures instead, into the folder --out: of a campaign starts.svg, the starts
from above with how they ended; of a run path.svg and history.svg, its path and its channels over
time.)";

std::string ExtensionOf(const std::string& format) {
  const auto known = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const Format& each) { return each.name == format; });
  return known->extension;
}

std::string ReportText(const std::string& format, const ReportContent& content,
                       const std::filesystem::path& dir, const Invocation& call) {
  if (format == "html") return ReportPage(content);
  if (format == "junit") {
    if (content.campaign == nullptr) {
      throw UsageError("--format junit: expected the results folder of a campaign");
    }
    std::vector<Judgement> judged;
    for (const Requirement& requirement : content.requirements) {
      judged.push_back(Judge(requirement, content.columns, content.runs->results));
    }
    return JUnitOf(*content.runs, *content.campaign, content.columns, dir, judged, call);
  }
  const Json overview = OverviewPart(content.campaign, *content.runs, content.columns, content.aim,
                                     content.requirements);
  if (format == "json") return overview.dump(1) + "\n";
  return OverviewMarkdown(content.title, overview, content.replay_command);
}

/// "axel_typical, seed 7: docked after 99 s"
std::string TitleOf(const ReportContent& content, const RunResult& row) {
  return content.title + ", seed " + std::to_string(row.seed) + ": " + row.outcome + " after " +
         Fixed(row.sim_time_s, 0) + " s";
}

void PrintWritten(const std::vector<std::filesystem::path>& files,
                  const std::vector<std::string>& warnings) {
  Json names = Json::array();
  for (const std::filesystem::path& file : files) names.push_back(file.string());
  const Json answer{{"files", names}, {"warnings", warnings}};
  std::printf("%s\n", answer.dump(1).c_str());
}

int WriteFigures(const ReportContent& content, const std::filesystem::path& out, bool json,
                 const std::vector<std::string>& warnings) {
  MakeFolder(out);
  if (content.campaign == nullptr) {
    const LoggedRun log = content.watched.front().log();
    const std::string title = TitleOf(content, content.runs->results.front());
    WriteWhole(out / "path.svg", PathPlot(title, log));
    std::vector<Column> channels = content.channels;
    channels.insert(channels.end(), BeliefErrorColumns().begin(), BeliefErrorColumns().end());
    WriteWhole(out / "history.svg", HistoryPlot(title, log, channels));
    PrintNote("path.svg and history.svg in " + out.string());
    if (json) PrintWritten({out / "path.svg", out / "history.svg"}, warnings);
    return kExitDone;
  }
  if (content.starts.empty()) {
    PrintError("the rows do not tell where the runs started; there is nothing to draw");
    return kExitIncomplete;
  }
  WriteWhole(out / "starts.svg",
             StartsPlot(content.title, SuccessWord(content.columns, content.runs->results),
                        content.runs->results, content.starts));
  PrintNote("starts.svg in " + out.string());
  if (json) PrintWritten({out / "starts.svg"}, warnings);
  return kExitDone;
}

int Report(const ReportArguments& arguments, const Invocation& call) {
  const std::filesystem::path dir = arguments.dir;
  ReportSource source;
  ReportContent content = ContentOf(dir, call, source);
  if (arguments.svg) {
    const std::filesystem::path out = arguments.out.empty() ? dir.string() : arguments.out;
    return WriteFigures(content, out, arguments.json, call.warnings);
  }
  content.pictures = !arguments.no_images;
  if (arguments.all_images) MakeAllImages(source, call, content);
  content.most_bytes = static_cast<std::size_t>(arguments.most_mib) << 20;
  if (arguments.reliability > 0.0) {
    content.aim = AcceptanceAim{arguments.reliability, arguments.confidence};
    const std::string why = content.campaign == nullptr ? "" : WhyNotSequential(*content.campaign);
    if (!why.empty()) {
      PrintNote("note: no verdict, as " + why + "; dockyard accept judges points and arms");
    }
  }
  if (!arguments.judging.require.empty()) {
    if (content.campaign == nullptr) {
      throw UsageError("--require: expected the results folder of a campaign");
    }
    content.requirements = ReadRequirements(arguments.judging, content.columns, *content.campaign);
  }
  const std::filesystem::path file = arguments.out.empty()
                                         ? dir / ("report" + ExtensionOf(arguments.format))
                                         : std::filesystem::path(arguments.out);
  if (file.has_parent_path()) MakeFolder(file.parent_path());
  WriteWhole(file, ReportText(arguments.format, content, dir, call));
  PrintNote("report in " + file.string());
  if (arguments.json) PrintWritten({file}, call.warnings);
  return kExitDone;
}

}  // namespace

void AddReportCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", kReportHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign or of one run")
      ->required()
      ->type_name("DIR");
  command->add_option("--out", arguments->out,
                      "the file [DIR/report.html]; with --svg a folder [DIR]");
  command->add_option("--format", arguments->format, "html, json, markdown or junit [html]")
      ->check(CLI::IsMember({"html", "json", "markdown", "junit"}));
  command
      ->add_option("--most-mib", arguments->most_mib,
                   "largest file; replays beyond it are left out, and told [50]")
      ->check(CLI::Range(2, 380));
  CLI::Option* svg = command->add_flag("--svg", arguments->svg, "instead: figures as SVG files");
  command->add_flag("--json", arguments->json, "print what was written as JSON");
  CLI::Option* no_images = command->add_flag("--no-pictures", arguments->no_images,
                                             "replays without the cameras' images");
  command
      ->add_flag("--all-images", arguments->all_images,
                 "simulate again the runs whose logs keep some of their images alone")
      ->excludes(no_images, svg);
  command
      ->add_option("--reliability", arguments->reliability,
                   "say whether the runs show this share of successes")
      ->check(NumberWithin(1e-9, 1.0));
  command->add_option(
      "--require", arguments->judging.require,
      "say whether the results meet it, such as 'success >= 0.9'; may be given again");
  command->add_option("--confidence", arguments->confidence, "of that verdict [0.95]")
      ->check(NumberWithin(0.5, 1.0 - 1e-12));
  AddSecretOption(*command, call);
  command->callback([arguments, &call] { call.exit_code = Report(*arguments, call); });
}

}  // namespace dockyard
