#include "sim/base/called_as.h"

#include "sim/base/shell_word.h"

namespace dockyard {
namespace {

std::string& Name() {
  static std::string name = "dockyard";
  return name;
}

}  // namespace

void SetCalledAs(const std::string& argv_0) {
  if (!argv_0.empty()) Name() = argv_0;
}

std::string CalledAs() { return ShellWord(Name()); }

std::string CommandText(const std::vector<std::string>& words) {
  std::string text = CalledAs();
  for (const std::string& word : words) text += " " + ShellWord(word);
  return text;
}

}  // namespace dockyard
