#include "sim/app/raposa/alpha_command.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "controller/geometry/pose.h"
#include "controller/raposa/mark_angle.h"
#include "sim/app/raposa/words.h"
#include "sim/base/json.h"

namespace dockyard::raposa {
namespace {

const char* const kHelp =
    R"(Say from which angle and distance RAPOSA's pyramid is viewed.

Examples:
  dockyard alpha --c-px 20.208456 --g-px 16.157382 --h-m 0.06 --m-m 0.0981256 --f-px 377

A command of the system raposa, by eqs. (2) and (7) of Ferreira and Ventura (2009). alpha is without
a side. It is ambiguous where a second angle up to 110 deg fits the same lengths, or none does.
Where c / g is too large for any, alpha is that of the turning point, 73 deg for the pyramid.)";

struct Lengths {
  double c_px = 0.0, g_px = 0.0, h_m = 0.0, m_m = 0.0, f_px = 0.0;
  bool json = false;
};

void AddLengths(CLI::App& app, Lengths& in) {
  const CLI::Validator positive(
      [](const std::string& text) {
        double value = 0.0;
        const bool good = CLI::detail::lexical_cast(text, value) && value > 0.0 && value < 1e12;
        return good ? std::string() : "expected a number > 0, found '" + text + "'";
      },
      "");
  app.add_option("--c-px", in.c_px, "from the orange ellipse's middle to the blue's far end")
      ->required()
      ->check(positive);
  app.add_option("--g-px", in.g_px, "height of the blue rectangle")->required()->check(positive);
  app.add_option("--h-m", in.h_m, "edge of the blue square")->required()->check(positive);
  app.add_option("--m-m", in.m_m, "from the guide's middle to the square's")
      ->required()
      ->check(positive);
  app.add_option("--f-px", in.f_px, "focal length of the camera")->required()->check(positive);
  app.add_flag("--json", in.json, "JSON on standard output");
}

}  // namespace

std::vector<CommandOption> AlphaOptions() {
  Lengths unread;
  CLI::App app;
  AddLengths(app, unread);
  return OptionsOf(app);
}

int Alpha(const std::string& program, const std::vector<std::string>& words) {
  Lengths in;
  CLI::App app(WithProgram(kHelp, program), program + " alpha");
  AddLengths(app, in);
  if (const auto ended = ParseWords(app, words, program + " help alpha")) return *ended;
  const MarkAngle angle = AngleOfMarks(in.c_px, in.g_px, in.h_m, in.m_m, in.f_px);
  if (in.json) {
    const Json json{{"alpha_deg", Degrees(angle.alpha_rad)},
                    {"d_m", angle.d_m},
                    {"ambiguous", angle.ambiguous},
                    {"warnings", Json::array()}};
    std::printf("%s\n", json.dump(2).c_str());
    return 0;
  }
  std::printf("alpha %.4f deg, d %.5f m", Degrees(angle.alpha_rad), angle.d_m);
  if (angle.beyond_root) {
    std::printf("; no angle fits, this is the turning point");
  } else if (angle.ambiguous && angle.alpha_rad < 0.0) {
    std::printf("; no angle from 0 to 110 deg fits");
  } else if (angle.ambiguous) {
    std::printf("; %.4f deg fits as well", Degrees(angle.other_rad));
  }
  std::printf("\n");
  return 0;
}

}  // namespace dockyard::raposa
