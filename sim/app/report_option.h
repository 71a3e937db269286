// `--report [FILE]`, with one meaning in every command that has it: a page that shows the result.
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

namespace dockyard {

struct ReportOption {
  bool asked = false;
  std::string file;  // empty: report.html in the results folder

  /// Where the page goes; empty if none was asked for. Throws UsageError without a file and folder.
  std::filesystem::path FileIn(const std::filesystem::path& results_dir) const;
};

/// @param folder  what names the results folder, for the help
void AddReportOption(CLI::App& command, ReportOption& option, const std::string& folder);

/// The option as it was given, as words of a command line, a space before each.
std::string WordsOf(const ReportOption& option);

}  // namespace dockyard
