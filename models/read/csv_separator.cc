#include "models/read/csv_separator.h"

#include <vector>

namespace dockyard {
namespace {

/// The places of a character outside quotations.
std::vector<std::size_t> PlacesOf(char mark, std::string_view line) {
  std::vector<std::size_t> places;
  bool quoted = false;
  for (std::size_t at = 0; at < line.size(); ++at) {
    if (line[at] == '"') quoted = !quoted;
    if (line[at] == mark && !quoted) places.push_back(at);
  }
  return places;
}

bool IsDigit(std::string_view line, std::size_t at) {
  return at < line.size() && line[at] >= '0' && line[at] <= '9';
}

}  // namespace

std::optional<OtherSeparator> FindOtherSeparator(std::string_view line) {
  if (!PlacesOf(',', line).empty()) return std::nullopt;
  const std::size_t begin = line.find_first_not_of(' ');
  if (begin == std::string_view::npos) return std::nullopt;
  const std::string_view cells = line.substr(begin, line.find_last_not_of(' ') + 1 - begin);
  std::optional<OtherSeparator> found;
  std::size_t most = 0;
  const auto take = [&](char mark, const char* name) {
    const std::vector<std::size_t> places = PlacesOf(mark, cells);
    if (places.size() <= most) return;
    most = places.size();
    found = OtherSeparator{mark, name, begin + places.front()};
  };
  take(';', "';' (semicolons)");
  take('\t', "tabs");
  take('|', "'|' (vertical bars)");
  if (!found) take(' ', "spaces");
  return found;
}

bool HasDecimalComma(std::string_view line, char mark) {
  for (const std::size_t at : PlacesOf(',', line)) {
    std::size_t end = at + 1;
    while (IsDigit(line, end)) ++end;
    const bool has_digits = at > 0 && IsDigit(line, at - 1) && end > at + 1;
    if (has_digits && (end == line.size() || line[end] == mark || line[end] == ' ')) return true;
  }
  return false;
}

}  // namespace dockyard
