#include "models/read/other_kind.h"

#include <algorithm>
#include <string_view>

namespace dockyard {
namespace {

constexpr std::string_view kGoOn =
    " of another kind needs a system of its own: docs/contributing.md tells how to add one, "
    "docs/reference/models.md what files can change";

/// A key of the file itself that is missing: the place is right before the message.
bool LacksPart(std::string_view message) {
  const std::size_t at = message.find(": missing key '");
  return at != message.npos && at > 0 && message[at - 1] >= '0' && message[at - 1] <= '9';
}

/// An unknown key near the file's root, such as `rocks.given[0].mesh`. A deeper one is a slip.
bool HasStrangePart(std::string_view message) {
  const std::size_t end = message.find(": unknown key, known are");
  if (end == message.npos) return false;
  const std::size_t begin = message.rfind(' ', end);
  const std::string_view path = message.substr(begin == message.npos ? 0 : begin + 1);
  const std::string_view key = path.substr(0, path.find(": unknown"));
  return std::count(key.begin(), key.end(), '.') <= 2;
}

bool TellsOfOtherKind(std::string_view message) {
  for (const std::string_view sign : {"', known are", "the root link", "expected a joint named",
                                      "expected a link named", ": system: expected one of"}) {
    if (message.find(sign) != message.npos) return true;
  }
  return LacksPart(message) || HasStrangePart(message);
}

}  // namespace

std::string WithAdvice(const std::string& message, const std::string& advice) {
  if (!TellsOfOtherKind(message) || message.find(advice) != message.npos) return message;
  return message + "; " + advice;
}

std::string WithOtherKind(const std::string& message, const std::string& what) {
  if (message.find(kGoOn) != message.npos) return message;
  return WithAdvice(message, "a " + what + std::string(kGoOn));
}

}  // namespace dockyard
