// One run's result as a table for people: grouped by what is measured, rounded, with units.
#pragma once

#include <string>

#include "sim/log/record.h"

namespace dockyard {

/// "0.2302", "1234", "-0.87": four significant digits, without an exponent down to a millionth.
std::string FourDigits(double value);

/// Lines of a name, a rounded value with its unit, and what it means. The numbers that a campaign's
/// summary shows come first, then the others by their unit. Numbers that do not apply are named in
/// one line. The last lines have the seed and the hash, with all digits.
/// @param name  of the scenario
std::string RunTable(const std::string& name, const RunRecord& record);

/// "docked after 99.5 s: tip 230 mm deep"
std::string RunSentence(const RunRecord& record);

}  // namespace dockyard
