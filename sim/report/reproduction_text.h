// A reproduction's findings in words and as JSON.
#pragma once

#include <string>

#include "sim/base/json.h"
#include "sim/report/reproduction.h"

namespace dockyard {

/// Tables in plain text, under 110 columns where the names allow, and the verdict at the end.
std::string ReproductionText(const ReproductionFinding& found);
/// One sentence: "outside: all, boundary".
std::string VerdictText(const ReproductionFinding& found);
/// Everything that the text has, numbers in SI and degrees as their names say.
Json ReproductionJson(const ReproductionFinding& found);

}  // namespace dockyard
