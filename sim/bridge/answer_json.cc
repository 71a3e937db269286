#include "sim/bridge/answer_json.h"

#include <algorithm>
#include <cmath>

namespace dockyard {
namespace {

constexpr double kFarthest_m = 1e6;  // beyond it a pose is no place in any yard

/// How deep objects and lists lie within each other, by their brackets outside of texts. Parsed
/// JSON is destroyed and compared level by level, which a million levels do not survive.
int DepthOf(const std::string& text) {
  int depth = 0, deepest = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    if (quoted) {
      if (c == '\\') ++i;
      if (c == '"') quoted = false;
    } else if (c == '"') {
      quoted = true;
    } else if (c == '{' || c == '[') {
      deepest = std::max(deepest, ++depth);
    } else if (c == '}' || c == ']') {
      --depth;
    }
  }
  return deepest;
}

double NumberOf(const Json& json, const char* what) {
  if (!json.is_number()) throw AnswerError(std::string(what) + " that is no number");
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw AnswerError(std::string(what) + " that is not finite");
  return value;
}

double PoseNumber(const Json& answer, const char* name, double most) {
  const auto at = answer.find(name);
  if (at == answer.end()) throw AnswerError(std::string("a pose without ") + name);
  const double value = NumberOf(*at, name);
  if (std::abs(value) > most) throw AnswerError(std::string(name) + " beyond 1e6");
  return value;
}

}  // namespace

Json AnswerFrom(const std::string& text) {
  if (DepthOf(text) > kDeepestAnswer) {
    throw AnswerError("more than " + std::to_string(kDeepestAnswer) + " levels of JSON");
  }
  Json json = Json::parse(text, nullptr, /*allow_exceptions=*/false);
  if (json.is_discarded()) throw AnswerError("text that is no JSON, or a number out of range");
  if (!json.is_object()) throw AnswerError("JSON that is no object");
  return json;
}

void TakeNumbers(const Json& answer, Belief& belief) {
  if (answer.contains("x_m") || answer.contains("y_m") || answer.contains("heading_rad")) {
    const Pose2 X_DR{PoseNumber(answer, "x_m", kFarthest_m), PoseNumber(answer, "y_m", kFarthest_m),
                     WrapPi(PoseNumber(answer, "heading_rad", kFarthest_m))};
    belief.located = true;
    belief.X_DR = X_DR;
  }
  const auto values = answer.find("values");
  if (values == answer.end()) return;
  if (!values->is_object()) throw AnswerError("values that are no object");
  if (values->size() > kMostValues) {
    throw AnswerError("more than " + std::to_string(kMostValues) + " values");
  }
  belief.values.clear();
  for (const auto& [name, value] : values->items()) {
    if (name.size() > kLongestName) {
      throw AnswerError("a value's name of more than " + std::to_string(kLongestName) + " bytes");
    }
    belief.values.push_back({name, NumberOf(value, "a value")});
  }
}

}  // namespace dockyard
