// Shared by the plots of curves and bars: colours, and words for their axes.
#pragma once

#include <array>
#include <string>

#include "sim/log/column.h"

namespace dockyard {

inline const char* CurveColor(std::size_t i) {
  static constexpr std::array<const char*, 6> kColors{"#1f5fa8", "#d9772b", "#2e8b57",
                                                      "#b8323c", "#7b5ea7", "#666666"};
  return kColors[i % kColors.size()];
}

/// "alpha_deg" of "start.alpha_deg".
inline std::string LastName(const std::string& key) { return key.substr(key.rfind('.') + 1); }

/// The column's name without its unit, which comes after it in brackets: "depth [m]".
std::string AxisLabel(const Column& column);

}  // namespace dockyard
