// The members of structs as JSON, named once for both ways. The namespace of a struct has a visitor
// that names its members in their order:
//
//   template <Of<Flag> F, class Visit>
//   void VisitMembers(F& flag, const Visit& visit) {
//     visit("x_m", flag.x_m);
//   }
//
// A member is a number, a text, a vector of Eigen's, a list of members, a struct with a visitor, or
// a type with ToJson(value) and FromJson(json, value) in its namespace.
#pragma once

#include <concepts>
#include <optional>
#include <string>
#include <type_traits>

#include "models/read/config_error.h"
#include "sim/base/json.h"

namespace dockyard {

/// T is U, or U that is only read.
template <class T, class U>
concept Of = std::same_as<std::remove_const_t<T>, U>;

inline void FromJson(const Json& json, Pose3& pose) { pose = Pose3FromJson(json); }

template <class T>
Json WriteMember(const T& value);
template <class T>
void ReadMember(const Json& json, T& value);

class JsonWriter {
 public:
  explicit JsonWriter(Json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, const T& value) const {
    json_[name] = WriteMember(value);
  }
  template <class T>
  void operator()(const char* name, const std::optional<T>& value) const {
    if (value) (*this)(name, *value);
  }
  /// An enumeration whose values 0, 1, ... are called by the words. whose: for the message.
  template <class Enum, class Words>
  void Word(const char* name, const char* /*whose*/, const Enum& value, const Words& words) const {
    json_[name] = words[static_cast<std::size_t>(value)];
  }
  /// Whether the member is there: here `written`, to the reader what the JSON holds.
  bool Has(const char* /*name*/, bool written) const { return written; }
  /// Members within an object of their own.
  template <class Visit>
  void Within(const char* name, const Visit& visit) const {
    visit(JsonWriter(json_[name]));
  }

 private:
  Json& json_;
};

class JsonReader {
 public:
  explicit JsonReader(const Json& json) : json_(json) {}

  template <class T>
  void operator()(const char* name, T& value) const {
    ReadMember(json_.at(name), value);
  }
  template <class T>
  void operator()(const char* name, std::optional<T>& value) const {
    if (json_.contains(name)) ReadMember(json_.at(name), value.emplace());
  }
  template <class Enum, class Words>
  void Word(const char* name, const char* whose, Enum& value, const Words& words) const {
    const std::string word = json_.at(name);
    std::string known;
    for (std::size_t i = 0; i < std::size(words); ++i) {
      if (word == words[i]) {
        value = static_cast<Enum>(i);
        return;
      }
      known += (i == 0 ? "" : i + 1 < std::size(words) ? ", " : " or ") + std::string(words[i]);
    }
    throw ConfigError(std::string(whose) + ": expected " + known + ", found '" + word + "'");
  }
  bool Has(const char* name, bool /*written*/) const { return json_.contains(name); }
  template <class Visit>
  void Within(const char* name, const Visit& visit) const {
    visit(JsonReader(json_.at(name)));
  }

 private:
  const Json& json_;
};

template <class T>
Json WriteMember(const T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::same_as<T, std::string>) {
    return value;
  } else if constexpr (requires { T::SizeAtCompileTime; }) {
    Json json = Json::array();
    for (const double number : value) json.push_back(number);
    return json;
  } else if constexpr (requires { VisitMembers(value, std::declval<const JsonWriter&>()); }) {
    Json json = Json::object();
    VisitMembers(value, JsonWriter(json));
    return json;
  } else if constexpr (requires { value.begin(); }) {
    Json json = Json::array();
    for (const auto& item : value) json.push_back(WriteMember(item));
    return json;
  } else {
    return ToJson(value);
  }
}

/// A list that grows takes what there is, another as much as it holds.
template <class T>
void ReadMember(const Json& json, T& value) {
  if constexpr (std::is_arithmetic_v<T> || std::same_as<T, std::string>) {
    json.get_to(value);
  } else if constexpr (requires { T::SizeAtCompileTime; }) {
    for (Eigen::Index i = 0; i < value.size(); ++i)
      json.at(static_cast<std::size_t>(i)).get_to(value(i));
  } else if constexpr (requires { VisitMembers(value, std::declval<const JsonReader&>()); }) {
    VisitMembers(value, JsonReader(json));
  } else if constexpr (requires { value.emplace_back(); }) {
    value.clear();
    for (const Json& item : json) ReadMember(item, value.emplace_back());
  } else if constexpr (requires { value.begin(); }) {
    for (std::size_t i = 0; i < value.size(); ++i) ReadMember(json.at(i), value[i]);
  } else {
    FromJson(json, value);
  }
}

/// Throws ConfigError when they are those of another system. whose: "Axel's".
template <class Nominal>
Nominal ReadNominal(const Json& json, const char* whose) {
  try {
    Nominal nominal;
    ReadMember(json, nominal);
    return nominal;
  } catch (const Json::exception& error) {
    throw ConfigError(std::string("nominal parameters: expected ") + whose +
                      ", found others: " + error.what());
  }
}

}  // namespace dockyard
