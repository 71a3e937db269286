// Counts in sentences.
#pragma once

#include <string>

namespace dockyard {

/// "1 run", "2 runs"; "1 vertex", "3 vertices". A whole phrase may follow the number: "1 run has no
/// partner", "2 runs have no partner".
/// @param many  empty: `one` with an s
template <class Integer>
std::string CountText(Integer count, const std::string& one, const std::string& many = "") {
  return std::to_string(count) + " " + (count == 1 ? one : many.empty() ? one + "s" : many);
}

}  // namespace dockyard
