// Numbers as text and back: one spelling for files, tables and messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace dockyard {

/// Shortest decimal form that reads back to the same bits; "nan", "inf" and "-inf" for the rest.
std::string NumberText(double value);
/// With this many digits after the point.
std::string Fixed(double value, int decimals);

/// The whole text as a number, nan and inf included; otherwise none. No spaces, no hexadecimal.
std::optional<double> NumberFromText(std::string_view text);
/// The whole text as a finite number; otherwise false, and `value` keeps its old value.
bool ParseNumber(std::string_view text, double& value);

}  // namespace dockyard
