#include "sim/campaign/slurm_options.h"

#include <cctype>
#include <sstream>
#include <string_view>

namespace dockyard {
namespace {

/// An option that a user must not add, and where to go on. Names as in sbatch(1), Slurm 22.05.
struct Taken {
  std::string_view name;
  char letter;  // its short form; 0: none
  std::string_view advice;
};

constexpr std::string_view kShards = "the script numbers its own tasks; --shards says how many";
constexpr std::string_view kProcessors =
    "the script sets it; --cpus-per-task says how many runs a task has at once";
constexpr std::string_view kMemory = "use --mem of dockyard submit";
constexpr std::string_view kLog = "the script sets it; logs are in submit/log of the results";
constexpr std::string_view kStop =
    "the script sets it, so that a stopped or lost task can go on where it was";

constexpr Taken kTaken[] = {
    {"array", 'a', kShards},
    {"nodes", 'N', kProcessors},
    {"ntasks", 'n', kProcessors},
    {"tasks", 0, kProcessors},
    {"ntasks-per-node", 0, kProcessors},
    {"cpus-per-task", 'c', "use --cpus-per-task of dockyard submit"},
    {"mem", 0, kMemory},
    {"mem-per-cpu", 0, kMemory},
    {"time", 't', "use --time of dockyard submit"},
    {"partition", 'p', "use --partition of dockyard submit"},
    {"constraint", 'C', "use --constraint of dockyard submit"},
    {"job-name", 'J', "the script sets it, from the campaign's name"},
    {"output", 'o', kLog},
    {"open-mode", 0, kLog},
    {"signal", 0, kStop},
    {"requeue", 0, kStop},
    {"no-requeue", 0, kStop},
    {"parsable", 0, "the script sets it"},
    {"wrap", 0, "the script is the job"},
    {"test-only", 0, "use --dry-run of dockyard submit"},
    {"wait", 'W', "submit does not wait; `dockyard merge` says which runs are missing"},
    {"help", 'h', "sbatch --help prints it"},
    {"usage", 0, "sbatch --usage prints it"},
    {"version", 'V', "sbatch --version prints it"},
};

// sbatch takes a name cut short, as getopt_long(3) does. It knows no name in capitals: such a one
// would fail only when the jobs are submitted, so it is taken for the option that was meant.
const Taken* FindLong(std::string_view given) {
  std::string name;
  for (const char c : given) {
    name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  }
  for (const Taken& taken : kTaken) {
    if (taken.name == name) return &taken;
  }
  for (const Taken& taken : kTaken) {
    if (!name.empty() && taken.name.starts_with(name)) return &taken;
  }
  return nullptr;
}

const Taken* FindShort(char letter) {
  for (const Taken& taken : kTaken) {
    if (letter != 0 && taken.letter == letter) return &taken;
  }
  return nullptr;
}

[[noreturn]] void Refuse(const std::string& option, const Taken& taken) {
  throw SlurmError("--slurm: sbatch's --" + std::string(taken.name) + " cannot be added, as in '" +
                   option + "': " + std::string(taken.advice));
}

[[noreturn]] void RefuseForm(const std::string& option) {
  throw SlurmError("--slurm: expected one option of sbatch such as --account=rover, found '" +
                   option + "'");
}

std::vector<std::string> WordsOf(const std::string& text) {
  std::istringstream in(text);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

bool IsOption(std::string_view word) {
  return word.size() > 1 && word[0] == '-' &&
         std::isdigit(static_cast<unsigned char>(word[1])) == 0;
}

void CheckOne(const std::string& option) {
  // What follows the first = is one quoted value in the script.
  const std::string name = option.substr(0, option.find('='));
  if (name.find_first_of("\"'") != name.npos) RefuseForm(option);
  const std::vector<std::string> words = WordsOf(name);
  for (const std::string& word : words) {
    if (!IsOption(word)) continue;
    const bool is_long = word.starts_with("--");
    const Taken* taken = is_long ? FindLong(std::string_view(word).substr(2)) : FindShort(word[1]);
    if (taken != nullptr) Refuse(option, *taken);
  }
  for (std::size_t i = 1; i < words.size(); ++i) {
    if (IsOption(words[i])) RefuseForm(option);
  }
  if (!option.starts_with("--") || words.front() == "--") RefuseForm(option);
  for (const char c : option) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f || c == '\\') {
      throw SlurmError("--slurm: sbatch cannot take a backslash or control character, as in '" +
                       option + "'");
    }
  }
}

}  // namespace

void CheckFurtherOptions(const std::vector<std::string>& options) {
  for (const std::string& option : options) CheckOne(option);
}

}  // namespace dockyard
