#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace dockyard {

/// Of an even number the upper of the two in the middle. There is at least one value.
template <class Number>
Number Median(std::vector<Number> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace dockyard
