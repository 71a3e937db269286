#include "sim/app/examples.h"

#include <filesystem>
#include <sstream>
#include <utility>
#include <vector>

namespace dockyard {
namespace {

using Word = std::pair<std::string, std::string>;  // in the help, in its place

/// False when a file that the line needs is empty.
bool Fill(std::string& line, const std::vector<Word>& files) {
  for (const auto& [word, file] : files) {
    for (std::size_t at = 0; (at = line.find(word, at)) != std::string::npos;) {
      if (file.empty()) return false;
      line.replace(at, word.size(), file);
      at += file.size();
    }
  }
  return true;
}

}  // namespace

std::string WithExamples(const std::string& help, const std::string& program,
                         const ExampleFiles& files) {
  const std::string name = std::filesystem::path(files.campaign).stem().string();
  const std::vector<Word> words{
      {"{scenario}", files.scenario}, {"{campaign}", files.campaign},
      {"{campaign_name}", name},      {"{sweep}", files.sweep},
      {"{cameras}", files.cameras},   {"{robot}", files.robot},
      {"{target}", files.target},     {"{reproduction}", files.reproduction}};
  const std::string called = "  dockyard ";
  std::istringstream in(help);
  std::string text, line;
  while (std::getline(in, line)) {
    for (std::string more; line.ends_with('\\') && std::getline(in, more);) line += "\n" + more;
    if (!Fill(line, words)) continue;
    if (line.rfind(called, 0) == 0) line.replace(0, called.size(), "  " + program + " ");
    text += (text.empty() ? "" : "\n") + line;
  }
  return text;
}

std::filesystem::path FindExample(const std::string& file) {
  std::error_code ignored;
  const std::filesystem::path above =
      std::filesystem::read_symlink("/proc/self/exe", ignored).parent_path().parent_path();
  for (const std::filesystem::path& folder :
       {above / "share/dockyard", above, std::filesystem::path()}) {
    if (std::filesystem::exists(folder / file, ignored)) return folder / file;
  }
  return {};
}

}  // namespace dockyard
