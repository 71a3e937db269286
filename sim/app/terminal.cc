#include "sim/app/terminal.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "models/read/text_file.h"

namespace dockyard {
namespace {

bool ColorWanted() {
  const char* no_color = std::getenv("NO_COLOR");
  return ::isatty(STDERR_FILENO) && (no_color == nullptr || *no_color == '\0');
}

}  // namespace

void PrintError(const std::string& message) {
  std::fflush(stdout);
  const char* word = ColorWanted() ? "\x1b[1;31merror:\x1b[0m" : "error:";
  std::fprintf(stderr, "%s %s\n", word, WithControlsShown(message).c_str());
}

void PrintNote(const std::string& message) {
  std::fflush(stdout);  // in a file that both go to, in the order in which they are said
  std::fprintf(stderr, "%s\n", WithControlsShown(message).c_str());
}

void Warn(const std::string& text, std::vector<std::string>* warnings) {
  PrintNote("warning: " + text);
  warnings->push_back(WithControlsShown(text));
}

int UsableProcessors() {
  return std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
}

}  // namespace dockyard
