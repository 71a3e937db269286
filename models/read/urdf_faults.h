// The faults of one URDF file: the first, thrown at once, or all of them.
#pragma once

#include <tinyxml.h>

#include <set>
#include <string>
#include <vector>

#include "models/read/config_error.h"

namespace dockyard {

class UrdfFaults {
 public:
  enum class Wanted { kFirst, kAll };
  /// @param name  of the file, as messages begin
  UrdfFaults(std::string name, Wanted wanted) : name_(std::move(name)), wanted_(wanted) {}

  /// "file:line:col" of an element.
  std::string PlaceOf(const TiXmlElement& at) const;
  /// "file:line:col: <tag>: what". Throws it as a ConfigError where the first fault is wanted.
  void Add(const TiXmlElement& at, const std::string& what);
  /// A message that names its own place; `at` gives its order among the others.
  void AddMessage(const TiXmlElement& at, const std::string& message);
  /// Takes the ConfigError that the call throws.
  template <class Read>
  void Catch(const TiXmlElement& at, const Read& read) {
    try {
      read();
    } catch (const ConfigError& error) {
      AddMessage(at, error.what());
    }
  }

  bool any() const { return !faults_.empty(); }
  /// Whether the element, or one in it, has a fault.
  bool In(const TiXmlElement& at) const { return faulty_.count(&at) > 0; }
  /// In the order of the file, each once.
  std::vector<std::string> Sorted() const;

 private:
  struct Fault {
    int row, column;
    std::string message;
  };

  std::string name_;
  Wanted wanted_;
  std::vector<Fault> faults_;
  std::set<std::string> known_;
  std::set<const TiXmlNode*> faulty_;
};

}  // namespace dockyard
