#include "sim/app/parse_fault.h"

#include <algorithm>
#include <vector>

#include "models/read/near_names.h"
#include "sim/app/help.h"

namespace dockyard {
namespace {

/// The command that was being read, with the commands that it is in.
struct Reached {
  const CLI::App* command;
  std::string name;  // "camera project"; empty for the program itself
};

Reached ReachedIn(const CLI::App& app) {
  Reached reached{&app, ""};
  while (!reached.command->get_subcommands().empty()) {
    reached.command = reached.command->get_subcommands().front();
    reached.name += (reached.name.empty() ? "" : " ") + reached.command->get_name();
  }
  return reached;
}

std::vector<std::string> OptionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back(name);
  }
  return names;
}

bool IsOption(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && (word[1] < '0' || word[1] > '9');
}

std::string UnknownOption(const Reached& reached, const std::string& word,
                          const std::string& program) {
  const std::string name = word.substr(0, word.find('='));
  // Without the dashes, which all have in common.
  const std::string near =
      NearestName(name.substr(name.find_first_not_of('-')), OptionNames(*reached.command));
  const std::string of = reached.name.empty() ? "" : " of " + reached.name;
  const std::string help = program + " help" + (reached.name.empty() ? "" : " ") + reached.name;
  return "unknown option '" + name + "'" + of +
         (near.empty() ? "; " + help + " lists the options" : ", did you mean '--" + near + "'?");
}

}  // namespace

std::string UnknownCommand(const CLI::App& app, const std::string& word,
                           const std::string& program) {
  const std::string near = DidYouMean(word, CommandNames(app));
  return "expected a command, found '" + word + "'" +
         (near.empty() ? "; " + program + " help lists them" : near);
}

std::string ParseFault(const CLI::App& app, const CLI::ParseError& error,
                       const std::string& program) {
  const Reached reached = ReachedIn(app);
  if (reached.command->get_prefix_command()) return error.what();  // a system's, which read it
  const std::vector<std::string> left = reached.command->remaining();
  // A wrong option comes first: its value may be at the place of a missing argument.
  const auto option = std::find_if(left.begin(), left.end(), IsOption);
  if (option != left.end()) return UnknownOption(reached, *option, program);
  const std::string help = "; " + program + " help" +
                           (reached.name.empty() ? "" : " " + reached.name) +
                           " shows its arguments";
  if (!left.empty() && !CommandNames(*reached.command).empty()) {
    return UnknownCommand(*reached.command, left.front(), program);
  }
  if (!left.empty()) return "expected no further argument, found '" + left.front() + "'" + help;
  return error.what() + help;
}

}  // namespace dockyard
