// Numbers in attributes of URDF: words apart by white space.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace dockyard {

/// None where there is no attribute.
std::vector<std::string_view> WordsOf(const char* attribute);
/// Nothing where a word is no finite number.
std::optional<std::vector<double>> NumbersOf(const char* attribute);

}  // namespace dockyard
