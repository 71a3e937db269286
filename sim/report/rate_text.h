// Rates and numbers as the reports print them: each rate with its interval.
#pragma once

#include <string>

namespace dockyard {

/// "31/40 (78 %, 62-89 %)", with the 95 % interval of Clopper and Pearson; "0/0" without trials.
std::string RateText(int successes, int trials);
/// "78 % (62-89)", the same interval.
std::string ShortRate(int successes, int trials);
/// A chance for people, at four decimals: "0.0391", "< 0.0001"; "nan" where there is none.
std::string ChanceText(double p);
/// "p = 0.0391", "p < 0.0001"
std::string PText(double p);
/// Four figures: "0.2103", "4e-05", "nan".
std::string BriefNumber(double value);

}  // namespace dockyard
