#include "sim/bridge/answer_json.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

namespace dockyard {
namespace {

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

double PoseNumber(const Json& answer, const char* name, double most) {
  const auto at = answer.find(name);
  if (at == answer.end()) throw AnswerError(std::string("a pose without ") + name);
  const double value = NumberOf(*at, name);
  if (std::abs(value) > most) throw AnswerError(std::string(name) + " beyond 1e6");
  return value;
}

/// Bytes of the control character with which a text begins; 0 if it begins with another one.
std::size_t ControlAt(std::string_view text) {
  const auto byte = [&](std::size_t i) {
    return i < text.size() ? static_cast<unsigned char>(text[i]) : 0u;
  };
  if (byte(0) < 0x20 || byte(0) == 0x7F) return 1;
  if (byte(0) == 0xC2 && byte(1) < 0xA0) return 2;  // C1: terminals take U+009B for an escape
  if (byte(0) != 0xE2) return 0;
  // U+2028 to 202E and 2066 to 2069 end lines or turn the direction of all that follows.
  const bool turns = (byte(1) == 0x80 && byte(2) >= 0xA8 && byte(2) <= 0xAE) ||
                     (byte(1) == 0x81 && byte(2) >= 0xA6 && byte(2) <= 0xA9);
  return turns ? 3 : 0;
}

/// A name as tables, logs and pages show it.
std::string ValueName(const std::string& name) {
  if (name.empty()) throw AnswerError("a value without a name");
  if (name.size() > kLongestName) {
    throw AnswerError("a value's name of more than " + std::to_string(kLongestName) + " bytes");
  }
  return WithoutControls(name);
}

}  // namespace

double NumberOf(const Json& json, const std::string& what) {
  if (!json.is_number()) throw AnswerError(what + " that is no number");
  const double value = json.get<double>();
  if (!std::isfinite(value)) throw AnswerError(what + " that is not finite");
  return value;
}

std::string WithoutControls(const std::string& text) {
  std::string line;
  for (std::size_t i = 0; i < text.size();) {
    const std::size_t length = ControlAt(std::string_view(text).substr(i));
    line += length > 0 ? '?' : text[i];
    i += std::max<std::size_t>(length, 1);
  }
  return line;
}

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
  const auto given = [&](const char* name) { return answer.contains(name); };
  if (given("x_m") || given("y_m") || given("heading_rad") || given("z_m") || given("roll_rad") ||
      given("pitch_rad")) {
    const auto number = [&](const char* name, bool required) {
      return required || given(name) ? PoseNumber(answer, name, kFarthestPose_m) : 0.0;
    };
    const Eigen::Vector3d p(number("x_m", true), number("y_m", true), number("z_m", false));
    const RollPitchYaw angles{.roll = number("roll_rad", false),
                              .pitch = number("pitch_rad", false),
                              .yaw = WrapPi(number("heading_rad", true))};
    belief.X_DR = RobotPose::FromAngles(p, angles);
    belief.located = true;
  }
  const auto values = answer.find("values");
  if (values == answer.end()) return;
  if (!values->is_object()) throw AnswerError("values that are no object");
  if (values->size() > kMostValues) {
    throw AnswerError("more than " + std::to_string(kMostValues) + " values");
  }
  belief.values.clear();
  std::set<std::string> names;
  for (const auto& [name, value] : values->items()) {
    belief.values.push_back({ValueName(name), NumberOf(value, "a value")});
    if (!names.insert(belief.values.back().name).second) {
      throw AnswerError("two values of one name, once control characters are '?'");
    }
  }
}

}  // namespace dockyard
