// The width of all help.
#include <gtest/gtest.h>

#include <regex>
#include <sstream>

#include "app/program.h"
#include "support/program_path.h"

namespace dockyard {
namespace {

/// The help of the commands that the words name, and of all inside, with the program's short name.
std::string AllHelp(const std::string& words) {
  const std::string text =
      std::regex_replace(Dockyard(words + "--help").out, std::regex(ProgramPath()), "dockyard");
  std::string all = text, line;
  const std::size_t inner = text.find("\nSubcommands:\n");
  std::istringstream lines(words.empty() ? text : inner == text.npos ? "" : text.substr(inner));
  std::smatch name;
  while (std::getline(lines, line)) {
    if (std::regex_search(line, name, std::regex("^  ([a-z]\\w*) {2,}\\S"))) {
      all += AllHelp(words + name[1].str() + " ");
    }
  }
  return all;
}

TEST(Help, HasNoLineLongerThan100Columns) {
  const std::string all =
      AllHelp("") +
      Dockyard("detect --robot models/raposa/raposa.yaml --help").out;  // of a system's own
  EXPECT_NE(all.find("camera ray"), all.npos);
  EXPECT_NE(all.find("--g-px"), all.npos);
  EXPECT_NE(all.find("--pitch-deg"), all.npos);
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) {
    const bool shows_call = line.find(ProgramPath()) != line.npos;
    EXPECT_TRUE(shows_call || line.size() <= 100u) << line.size() << ": " << line;
  }
}

}  // namespace
}  // namespace dockyard
