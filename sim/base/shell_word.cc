#include "sim/base/shell_word.h"

namespace dockyard {

std::string ShellWord(std::string_view text) {
  constexpr std::string_view kPlain =
      "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./=-";
  if (!text.empty() && text.find_first_not_of(kPlain) == text.npos) return std::string(text);
  std::string word = "'";
  for (const char c : text) word += c == '\'' ? "'\\''" : std::string(1, c);
  return word + "'";
}

std::string CommandText(const std::string& program, const std::vector<std::string>& words) {
  std::string text = program;
  for (const std::string& word : words) text += " " + ShellWord(word);
  return text;
}

}  // namespace dockyard
