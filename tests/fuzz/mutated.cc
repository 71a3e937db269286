#include "fuzz/mutated.h"

#include <vector>

namespace dockyard {
namespace {

std::size_t Below(RandomStream& random, std::size_t n) {
  return n == 0 ? 0 : static_cast<std::size_t>(random.NextBits() % n);
}

}  // namespace

std::string Mutated(std::string bytes, RandomStream& random) {
  static const std::vector<std::string> words{
      "nan", "-.inf", "1e308",    "-1",   "99999999999999999999",
      "[",   "]",     "{",        "}",    ":",
      "&a",  "*a",    "<<:",      "- ",   "\n",
      "\t",  "\"",    "'",        "<",    "/>",
      "</",  "&#0;",  "%",        "../",  std::string(1, '\0'),
      "#",   "!!x",   "\xef\xbb", "\xff", "0"};
  const std::size_t edits = 1 + Below(random, 4);
  for (std::size_t i = 0; i < edits; ++i) {
    const std::size_t at = Below(random, bytes.size() + 1);
    switch (Below(random, 6)) {
      case 0:
        if (at < bytes.size()) bytes[at] = static_cast<char>(random.NextBits());
        break;
      case 1:
        bytes.erase(at, 1 + Below(random, 40));
        break;
      case 2:
        bytes.insert(at, bytes.substr(Below(random, bytes.size() + 1), 1 + Below(random, 60)));
        break;
      case 3:
        if (Below(random, 4) == 0) bytes.resize(at);
        break;
      default:
        bytes.insert(at, words[Below(random, words.size())]);
        break;
    }
  }
  return bytes;
}

}  // namespace dockyard
