#include "sim/app/report_option.h"

#include "sim/app/commands.h"
#include "sim/base/shell_word.h"

namespace dockyard {
namespace {

bool IsPage(const std::string& file) {
  const std::string ending = std::filesystem::path(file).extension().string();
  return ending == ".html" || ending == ".htm";
}

}  // namespace

std::filesystem::path ReportOption::FileIn(const std::filesystem::path& results_dir) const {
  if (!asked) return {};
  if (!file.empty()) return file;
  if (results_dir.empty()) {
    throw UsageError("--report: expected a file .html, or --out DIR for DIR/report.html");
  }
  return results_dir / "report.html";
}

void AddReportOption(CLI::App& command, ReportOption& option, const std::string& folder) {
  command
      .add_option_function<std::string>(
          "--report",
          [&option](const std::string& given) {
            option.asked = true;
            option.file = given;
          },
          "make a page that shows the result [report.html in " + folder + "]")
      ->type_name("FILE.html")
      ->expected(0, 1)
      // The next word may have been meant as another argument: it is refused, not written over.
      ->check([](const std::string& file) {
        return file.empty() || IsPage(file) ? ""
                                            : "expected a file .html, found '" + file +
                                                  "'; put --report last, or --report=FILE.html";
      });
}

std::string WordsOf(const ReportOption& option) {
  if (!option.asked) return "";
  return " --report" + (option.file.empty() ? "" : " " + ShellWord(option.file));
}

}  // namespace dockyard
