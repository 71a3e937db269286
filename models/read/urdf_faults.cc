#include "models/read/urdf_faults.h"

#include <algorithm>
#include <utility>

namespace dockyard {

std::string UrdfFaults::PlaceOf(const TiXmlElement& at) const {
  return name_ + ":" + std::to_string(at.Row()) + ":" + std::to_string(at.Column());
}

void UrdfFaults::Add(const TiXmlElement& at, const std::string& what) {
  AddMessage(at, PlaceOf(at) + ": <" + at.Value() + ">: " + what);
}

void UrdfFaults::AddMessage(const TiXmlElement& at, const std::string& message) {
  if (wanted_ == Wanted::kFirst) throw ConfigError(message);
  for (const TiXmlNode* node = &at; node != nullptr; node = node->Parent()) faulty_.insert(node);
  const std::string line = OneLine(message);
  if (known_.insert(line).second) faults_.push_back({at.Row(), at.Column(), line});
}

std::vector<std::string> UrdfFaults::Sorted() const {
  std::vector<Fault> sorted = faults_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Fault& a, const Fault& b) {
    return std::pair(a.row, a.column) < std::pair(b.row, b.column);
  });
  std::vector<std::string> messages;
  for (Fault& fault : sorted) messages.push_back(std::move(fault.message));
  return messages;
}

}  // namespace dockyard
