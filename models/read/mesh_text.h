// Refusals of meshes in text.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace dockyard {

/// Throws ConfigError with line and column: what was expected at `begin`, and what is there up to
/// `end`, or its first 40 bytes.
[[noreturn]] void RefuseMeshText(const std::string& file, std::string_view text, std::size_t begin,
                                 std::size_t end, const std::string& expected);

}  // namespace dockyard
