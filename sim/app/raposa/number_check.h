// Ranges of the numbers that RAPOSA's commands take.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdio>
#include <string>

namespace dockyard::raposa {

inline CLI::Validator NumberBetween(double low, double high) {
  return CLI::Validator(
      [low, high](const std::string& text) {
        double value = 0.0;
        const bool good = CLI::detail::lexical_cast(text, value) && value >= low && value <= high;
        char range[64];
        std::snprintf(range, sizeof range, "%g to %g", low, high);
        return good ? std::string() : "expected " + std::string(range) + ", found '" + text + "'";
      },
      "");
}

}  // namespace dockyard::raposa
