#include "models/read/urdf_numbers.h"

#include <algorithm>

#include "controller/base/number_text.h"

namespace dockyard {

std::vector<std::string_view> WordsOf(const char* attribute) {
  constexpr std::string_view kSpace = " \t\r\n";
  const std::string_view text = attribute == nullptr ? "" : attribute;
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(kSpace); at != std::string_view::npos;) {
    const std::size_t end = std::min(text.find_first_of(kSpace, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = text.find_first_not_of(kSpace, end);
  }
  return words;
}

std::optional<std::vector<double>> NumbersOf(const char* attribute) {
  std::vector<double> numbers;
  for (const std::string_view word : WordsOf(attribute)) {
    double value = 0.0;
    if (!ParseNumber(word, value)) return std::nullopt;
    numbers.push_back(value);
  }
  return numbers;
}

}  // namespace dockyard
