#include "controller/io/belief.h"

namespace dockyard {

double ValueOf(const Belief& belief, std::string_view name, double fallback) {
  for (const NamedValue& value : belief.values) {
    if (value.name == name) return value.value;
  }
  return fallback;
}

}  // namespace dockyard
