#include "sim/scenario/start.h"

#include <algorithm>

#include "controller/base/check.h"

namespace dockyard {
namespace {

bool IsAngle(const StartNumber& number) { return number.unit == "deg"; }

}  // namespace

Start::Start(const DockingCoords& at)
    : numbers_{{"r_m", "m", Between(0.1, 100.0), "distance from the target", at.r},
               {"alpha_deg", "deg", Between(-180.0, 180.0),
                "bearing about the target, from its axis", at.alpha},
               {"heading_deg", "deg", Between(-180.0, 180.0), "heading against the target's axis",
                at.h}} {}

bool Start::HasNames(const Start& other) const {
  return std::equal(numbers_.begin(), numbers_.end(), other.numbers_.begin(), other.numbers_.end(),
                    [](const StartNumber& a, const StartNumber& b) { return a.name == b.name; });
}

double Start::Value(std::string_view name) const {
  const auto at = std::find_if(numbers_.begin(), numbers_.end(),
                               [&](const StartNumber& number) { return number.name == name; });
  DOCKYARD_CHECK(at != numbers_.end());
  return at->value;
}

bool Start::SetInFile(std::string_view name, double value) {
  const auto at = std::find_if(numbers_.begin(), numbers_.end(),
                               [&](const StartNumber& number) { return number.name == name; });
  if (at == numbers_.end()) return false;
  at->value = IsAngle(*at) ? Radians(value) : value;
  return true;
}

void Start::Visit(Keys& keys) {
  for (StartNumber& number : numbers_) {
    const Key key{number.name, number.unit, number.meaning, Presence::kRequired};
    if (IsAngle(number)) {
      keys.Degrees(key, number.value, number.range);
    } else {
      keys.Number(key, number.value, number.range);
    }
  }
}

DockingCoords Start::on_plane() const {
  return {Value("r_m"), Value("alpha_deg"), Value("heading_deg")};
}

}  // namespace dockyard
