// Checks of options that take a number.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace dockyard {

/// A finite number from low to high. CLI::Range lets NaN through.
CLI::Validator NumberWithin(double low, double high);

}  // namespace dockyard
