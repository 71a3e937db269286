#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/judging.h"
#include "sim/app/number_option.h"
#include "sim/app/report_content.h"
#include "sim/app/terminal.h"
#include "sim/base/files.h"
#include "sim/page/markdown.h"

namespace dockyard {
namespace {

struct ReportArguments {
  std::string dir, out, format = "html";
  double reliability = 0.0, confidence = 0.95;
  int most_mib = 50;
  bool no_pictures = false;
};

struct Format {
  std::string name, extension;
};
const std::vector<Format> kFormats{
    {"html", ".html"}, {"json", ".json"}, {"markdown", ".md"}, {"junit", ".xml"}};

constexpr const char* kHelp =
    R"(Make a report of a campaign or of one run: an HTML file that opens without network.

Examples:
  dockyard report results/{campaign_name}
  dockyard report results/{campaign_name} --out out/yard.html --no-pictures
  dockyard report results/{campaign_name} --reliability 0.9 --confidence 0.95
  dockyard report results/{campaign_name} --format markdown --out out/yard.md

The page has success with exact intervals, failures by cause, a map of the starts, the sensitivity,
all runs in a table, and a replay of each run whose log is kept (`keep` in the campaign's file).)";

std::string ExtensionOf(const std::string& format) {
  const auto known = std::find_if(kFormats.begin(), kFormats.end(),
                                  [&](const Format& each) { return each.name == format; });
  return known->extension;
}

std::string ReportText(const std::string& format, const ReportContent& content,
                       const std::filesystem::path& dir) {
  if (format == "html") return ReportPage(content);
  if (format == "junit") {
    if (content.campaign == nullptr) {
      throw UsageError("--format junit: expected the results folder of a campaign");
    }
    return JUnitOf(*content.runs, *content.campaign, content.columns, dir, {});
  }
  const Json overview = OverviewPart(content.campaign, *content.runs, content.columns, content.aim);
  if (format == "json") return overview.dump(1) + "\n";
  return OverviewMarkdown(content.title, overview, content.replay_command);
}

int Report(const ReportArguments& arguments, const std::vector<System>& systems) {
  const std::filesystem::path dir = arguments.dir;
  ReportSource source;
  ReportContent content = ContentOf(dir, systems, source);
  content.pictures = !arguments.no_pictures;
  content.most_bytes = static_cast<std::size_t>(arguments.most_mib) << 20;
  if (arguments.reliability > 0.0) {
    content.aim = AcceptanceAim{arguments.reliability, arguments.confidence};
  }
  const std::filesystem::path file = arguments.out.empty()
                                         ? dir / ("report" + ExtensionOf(arguments.format))
                                         : std::filesystem::path(arguments.out);
  if (file.has_parent_path()) MakeFolder(file.parent_path());
  WriteWhole(file, ReportText(arguments.format, content, dir));
  PrintNote("report in " + file.string());
  return kExitDone;
}

}  // namespace

void AddReportCommand(CLI::App& app, const std::vector<System>& systems, int& exit_code) {
  auto arguments = std::make_shared<ReportArguments>();
  CLI::App* command = app.add_subcommand("report", kHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign or of one run")
      ->required();
  command->add_option("--out", arguments->out, "the file [DIR/report.html]");
  command->add_option("--format", arguments->format, "html, json, markdown or junit [html]")
      ->check(CLI::IsMember({"html", "json", "markdown", "junit"}));
  command
      ->add_option("--most-mib", arguments->most_mib,
                   "largest file; replays beyond it are left out, and told [50]")
      ->check(CLI::Range(2, 380));
  command->add_flag("--no-pictures", arguments->no_pictures, "replays without the cameras' images");
  command
      ->add_option("--reliability", arguments->reliability,
                   "say whether the runs show this share of successes")
      ->check(NumberWithin(1e-9, 1.0));
  command->add_option("--confidence", arguments->confidence, "of that verdict [0.95]")
      ->check(NumberWithin(0.5, 1.0 - 1e-12));
  command->callback([arguments, &systems, &exit_code] { exit_code = Report(*arguments, systems); });
}

}  // namespace dockyard
