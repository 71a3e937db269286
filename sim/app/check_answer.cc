#include "sim/app/check_answer.h"

#include <charconv>
#include <filesystem>
#include <string_view>

#include "sim/base/json.h"

namespace dockyard {
namespace {

/// A whole number at the front that ends in ':', both taken off; 0 for another text.
int TakeNumber(std::string_view& text) {
  int number = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end == text.data() + text.size() || *end != ':') return 0;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()) + 1);
  return number > 0 ? number : 0;
}

Json ToJson(const PlacedFault& fault) {
  const auto number = [](int value) { return value > 0 ? Json(value) : Json(); };
  return {{"file", fault.file},
          {"line", number(fault.line)},
          {"column", number(fault.column)},
          {"text", fault.text}};
}

}  // namespace

PlacedFault PlaceOf(const std::string& message, const std::string& checked) {
  // A file's name may hold colons: the first one with two numbers behind it ends it.
  for (std::size_t at = message.find(':'); at != std::string::npos;
       at = message.find(':', at + 1)) {
    std::string_view rest = std::string_view(message).substr(at + 1);
    const int line = TakeNumber(rest), column = line > 0 ? TakeNumber(rest) : 0;
    if (column == 0 || !rest.starts_with(' ')) continue;
    return {message.substr(0, at), line, column, std::string(rest.substr(1))};
  }
  const std::size_t colon = message.find(": ");
  std::error_code error;
  if (colon != std::string::npos) {
    const std::string file = message.substr(0, colon);
    if (file == checked || std::filesystem::exists(file, error)) {
      return {file, 0, 0, message.substr(colon + 2)};
    }
  }
  return {checked, 0, 0, message};
}

std::string CheckAnswer(const std::vector<CheckedFile>& files,
                        const std::vector<std::string>& warnings) {
  Json answer{{"files", Json::array()},
              {"faults", Json::array()},
              {"left_out", Json::object()},
              {"warnings", warnings}};
  std::map<std::string, int> left_out;
  for (const CheckedFile& checked : files) {
    Json faults = Json::array();
    for (const std::string& message : checked.faults) {
      faults.push_back(ToJson(PlaceOf(message, checked.file)));
      answer["faults"].push_back(faults.back());
    }
    for (const auto& [name, count] : checked.check.left_out) left_out[name] += count;
    const bool good = checked.faults.empty();
    answer["files"].push_back({{"file", checked.file},
                               {"kind", good ? Json(checked.check.kind) : Json()},
                               {"summary", good ? Json(checked.check.summary) : Json()},
                               {"faults", faults},
                               {"left_out", Json(checked.check.left_out)},
                               {"warnings", checked.check.warnings}});
  }
  for (const auto& [name, count] : left_out) answer["left_out"][name] = count;
  return answer.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace dockyard
