#include "sim/app/number_option.h"

#include <cstdio>

namespace dockyard {

CLI::Validator NumberWithin(double low, double high) {
  char range[80];
  std::snprintf(range, sizeof range, "from %g to %g", low, high);
  const std::string wanted = range;
  return CLI::Validator(
      [low, high, wanted](std::string& text) {
        double value = 0.0;
        const bool read = CLI::detail::lexical_cast(text, value);
        if (read && value >= low && value <= high) return std::string();
        return "expected a number " + wanted + ", found '" + text + "'";
      },
      wanted);
}

}  // namespace dockyard
