#include "sim/app/help.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <sstream>
#include <utility>

#include "models/read/near_names.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"

namespace dockyard {
namespace {

constexpr std::size_t kColumns = 100;          // of a line of help
constexpr std::size_t kMostWordsColumns = 60;  // of an option, in its heading

constexpr const char* kHelpHelp = R"(Show all commands, or the help of one.

Examples:
  dockyard help
  dockyard help run
  dockyard help camera project)";

/// Groups in the order in which they first come.
std::vector<std::string> GroupsOf(const CLI::App& app) {
  std::vector<std::string> groups;
  for (const CLI::App* command : app.get_subcommands({})) {
    const std::string& group = command->get_group();
    const bool known = std::find(groups.begin(), groups.end(), group) != groups.end();
    if (!group.empty() && !known) groups.push_back(group);
  }
  return groups;
}

std::string Screen(const CLI::App& app) {
  std::size_t widest = 0;
  for (const std::string& name : CommandNames(app)) widest = std::max(widest, name.size());
  const std::string program = app.get_name();
  std::string text = app.get_description() + "\nUsage: " + program + " COMMAND [ARGUMENTS]\n";
  for (const std::string& group : GroupsOf(app)) {
    text += group + ":\n";
    for (const CLI::App* command : app.get_subcommands({})) {
      if (command->get_group() != group) continue;
      const std::string& name = command->get_name();
      text += "  " + name + std::string(widest + 2 - name.size(), ' ') + Summary(*command) + "\n";
    }
  }
  return text + program + " help COMMAND shows arguments and examples, " + program +
         " --version the version.\n";
}

/// The command that the words name one after the other, with the words that are left.
struct Named {
  const CLI::App* command;
  std::vector<std::string> path;
};

Named Find(const CLI::App& app, const std::vector<std::string>& words) {
  Named named{&app, {}};
  for (const std::string& word : words) {
    const auto inner = named.command->get_subcommands(
        [&word](const CLI::App* command) { return command->get_name() == word; });
    if (inner.empty()) {
      throw UsageError("help: expected a command, found '" + word + "'" +
                       DidYouMean(word, CommandNames(*named.command)));
    }
    named.command = inner.front();
    named.path.push_back(word);
  }
  return named;
}

int Help(const CLI::App& app, const std::vector<std::string>& words,
         const std::vector<System>& systems) {
  for (const System& system : systems) {
    for (const SystemCommand& own : system.commands) {
      if (!words.empty() && own.name == words[0]) return own.run(app.get_name(), {"--help"});
    }
  }
  const Named named = Find(app, words);
  // CLI11 puts the command's own name at the end.
  std::string before = named.path.empty() ? "" : app.get_name();
  for (std::size_t i = 0; i + 1 < named.path.size(); ++i) before += " " + named.path[i];
  std::cout << app.get_formatter()->make_help(
      named.command, named.path.empty() ? "" : before + " " + named.path.back(),
      CLI::AppFormatMode::Normal);
  return kExitDone;
}

/// The text with line breaks between words, so that no line is longer than `most`, unless a word
/// is.
std::string Folded(const std::string& text, std::size_t most) {
  std::istringstream in(text);
  std::string folded;
  std::size_t length = 0;
  for (std::string word; in >> word; folded += word, length += word.size()) {
    if (length == 0) continue;
    const bool fits = length + 1 + word.size() <= most;
    folded += fits ? ' ' : '\n';
    length = fits ? length + 1 : 0;
  }
  return folded;
}

/// "0 to 1" of "INT in [0 - 1]".
std::string BoundsOf(const std::string& text, std::size_t open) {
  const std::size_t close = text.find(']', open), dash = text.find(" - ", open);
  if (close == text.npos || dash == text.npos || dash > close) return "";
  return text.substr(open + 1, dash - open - 1) + " to " + text.substr(dash + 3, close - dash - 3);
}

}  // namespace

std::string TypeInWords(const std::string& type) {
  const std::size_t colon = type.find(':');
  std::string kind = type.substr(0, colon);
  const std::string check = colon == type.npos ? "" : type.substr(colon + 1);
  if (kind == "FLOAT") kind = "NUMBER";
  if (kind == "INT" || kind == "UINT") kind = "INTEGER";
  if (check.empty()) return kind;
  if (check.front() == '{' && check.back() == '}') {
    std::string words = check.substr(1, check.size() - 2);
    std::replace(words.begin(), words.end(), ',', '|');
    return words.size() <= kMostWordsColumns ? words : kind;  // else the description has them
  }
  const std::size_t open = check.find(" in [");
  if (open != check.npos) return kind + " from " + BoundsOf(check, open + 4);
  return kind + " " + check;
}

std::vector<std::string> CommandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) names.push_back(command->get_name());
  }
  return names;
}

std::string Summary(const CLI::App& command) {
  const std::string text = command.get_description();
  return text.substr(0, text.find('\n'));
}

std::string HelpFormatter::make_help(const CLI::App* app, std::string name,
                                     CLI::AppFormatMode mode) const {
  if (app->get_parent() == nullptr) return Screen(*app);
  return CLI::Formatter::make_help(app, std::move(name), mode);
}

std::string HelpFormatter::make_subcommand(const CLI::App* command) const {
  std::ostringstream out;
  CLI::detail::format_help(out, command->get_name(), Summary(*command), get_column_width());
  return out.str();
}

std::string HelpFormatter::make_option_opts(const CLI::Option* option) const {
  if (option->get_type_size() == 0 || !option->get_option_text().empty()) {
    return CLI::Formatter::make_option_opts(option);
  }
  std::string text =
      option->get_type_name().empty() ? "" : " " + TypeInWords(option->get_type_name());
  const int most = option->get_expected_max();
  if (most == CLI::detail::expected_max_vector_size) text += " ...";
  if (option->get_required()) text += " REQUIRED";
  return text;
}

std::string HelpFormatter::make_option_desc(const CLI::Option* option) const {
  return Folded(CLI::Formatter::make_option_desc(option), kColumns - get_column_width());
}

std::string FirstSteps(const CLI::App& app, const ExampleFiles& files) {
  std::vector<std::pair<std::string, const char*>> steps;
  if (!files.scenario.empty()) steps.emplace_back("run " + files.scenario, "simulate one docking");
  if (!files.campaign.empty()) steps.emplace_back("campaign " + files.campaign, "simulate many");
  steps.emplace_back("help", "all commands");
  steps.emplace_back("help run", "one command, with examples");
  steps.emplace_back("doctor", "what this computer has for runs");
  std::size_t widest = 0;
  for (const auto& [words, what] : steps) widest = std::max(widest, words.size());
  std::string text = Summary(app) + "\n\n";
  for (const auto& [words, what] : steps) {
    text += "  " + app.get_name() + " " + words + std::string(widest + 2 - words.size(), ' ') +
            what + "\n";
  }
  return text;
}

void AddHelpCommand(CLI::App& app, Invocation& call) {
  auto words = std::make_shared<std::vector<std::string>>();
  CLI::App* command = app.add_subcommand("help", kHelpHelp);
  command->add_option("COMMAND", *words, "one of those that help lists");
  command->callback([&app, words, &call] { call.exit_code = Help(app, *words, call.systems); });
}

}  // namespace dockyard
