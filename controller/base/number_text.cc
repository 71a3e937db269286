#include "controller/base/number_text.h"

#include <charconv>
#include <cmath>
#include <cstdio>

namespace dockyard {

std::string NumberText(double value) {
  if (std::isnan(value)) return "nan";  // one spelling, whatever its sign bit
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, value).ptr;
  return {text, end};
}

// No sign on a zero, whichever side it was rounded from.
std::string Fixed(double value, int decimals) {
  char text[64];
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  const std::string_view digits(text);
  const bool is_zero = digits.find_first_not_of("-0.") == digits.npos;
  return text[0] == '-' && is_zero ? text + 1 : text;
}

std::optional<double> NumberFromText(std::string_view text) {
  double value = 0.0;
  const char* end = text.data() + text.size();
  const auto read = std::from_chars(text.data(), end, value);
  if (text.empty() || read.ec != std::errc() || read.ptr != end) return std::nullopt;
  return value;
}

bool ParseNumber(std::string_view text, double& value) {
  const std::optional<double> number = NumberFromText(text);
  if (!number || !std::isfinite(*number)) return false;
  value = *number;
  return true;
}

}  // namespace dockyard
