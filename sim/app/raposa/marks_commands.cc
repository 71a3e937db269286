// `dockyard detect` and `dockyard tune` for a robot that looks for two colours.
#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>

#include "controller/raposa/dockyard.h"
#include "controller/raposa/ferreira2009.h"
#include "controller/raposa/marks.h"
#include "controller/raposa/tune_bands.h"
#include "models/raposa/load_pyramid.h"
#include "models/raposa/load_robot.h"
#include "models/raposa/make_nominal.h"
#include "models/read/config_error.h"
#include "models/read/near_names.h"
#include "models/read/text_file.h"
#include "sim/app/raposa/alpha_command.h"
#include "sim/app/raposa/belt_command.h"
#include "sim/app/raposa/eye_command.h"
#include "sim/app/raposa/raposa_commands.h"
#include "sim/app/raposa/socket_command.h"
#include "sim/app/raposa/words.h"
#include "sim/base/count_text.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/images/decode.h"
#include "sim/images/png.h"
#include "sim/raposa/build_run.h"
#include "sim/raposa/raposa_system.h"
#include "sim/scenario/load_scenario.h"

namespace dockyard::raposa {
namespace {

const char* const kDetectHelp =
    R"(Find the pyramid in an image, as the controller of that name does.

Examples:
  dockyard detect examples/raposa_back.png --scenario scenarios/raposa_point_9.yaml \
    --draw out/marks.png
  dockyard detect examples/raposa_back.png --robot models/raposa/raposa.yaml --pipeline dockyard \
    --draw out/pyramid.png

A scenario's robot, pyramid, colour bands and limits of the search (raposa.bands, raposa.vision)
hold; with --robot those of the files, and the controller's own bands and limits.
Exit code 0: both marks, as a pair; 4: no pair.)";
const char* const kTuneHelp =
    R"(Write the bands of hue, saturation and value of the pyramid's marks, from one image of it.

Examples:
  dockyard tune examples/raposa_back.png --scenario scenarios/raposa_point_9.yaml

A command of the system raposa. The image should show both marks whole, from 0.5 to 1.5 m and 20 to
60 deg off the axis. Exit code 4: no pair of marks fits the pyramid's dimensions.)";
constexpr int kNoPair = 4;

struct Arguments {
  std::string image, scenario, robot, pyramid = "models/raposa/pyramid/pyramid.yaml";
  std::string pipeline = "ferreira2009", draw;
  double pitch_deg = 0.0;
  bool json = false;
};

void AddOptions(CLI::App& app, Arguments& in) {
  app.add_option("IMAGE", in.image, "PNG, JPEG, PGM, PPM or WebP")->required();
  CLI::Option* scenario =
      app.add_option("--scenario", in.scenario, "of whose robot and pyramid the image is");
  app.add_option("--robot", in.robot, "instead: RAPOSA's file ...")->excludes(scenario);
  app.add_option("--pyramid", in.pyramid, "... and the pyramid's")
      ->capture_default_str()
      ->excludes(scenario);
  app.add_flag("--json", in.json, "JSON on standard output");
}

RgbImage Load(const std::string& file, const Camera& camera) {
  const auto bytes = ReadWhole(file);
  if (!bytes) {
    throw ConfigError(file + ": expected an image, found no file that can be read" +
                      DidYouMeanFile(file));
  }
  std::optional<RgbImage> image = DecodeColour(*bytes);
  if (!image) {
    throw ConfigError(file + ": expected a whole image, found one that cannot be decoded");
  }
  if (image->width != camera.width || image->height != camera.height) {
    throw ConfigError(file + ": expected the camera's size, " + std::to_string(camera.width) +
                      " x " + std::to_string(camera.height) + ", found " +
                      std::to_string(image->width) + " x " + std::to_string(image->height));
  }
  return std::move(*image);
}

Nominal NominalOfFiles(const Arguments& in) {
  if (!in.scenario.empty()) {
    const std::vector<System> systems{RaposaSystem(
        {{"dockyard", MakeDockyardController}, {"ferreira2009", MakeFerreira2009Controller}})};
    const Scenario scenario = LoadScenario(in.scenario, {}, KnownSystems(systems));
    return BuildRun(scenario, LoadModels(scenario)).nominal;
  }
  if (in.robot.empty())
    throw ConfigError("expected --scenario FILE or --robot FILE, found neither");
  return MakeNominal(LoadRobot(in.robot), LoadPyramid(in.pyramid));
}

void DrawBox(RgbImage& image, const BlobBounds& box, const std::uint8_t (&rgb)[3]) {
  const auto put = [&](int u, int v) {
    if (u < 0 || v < 0 || u >= image.width || v >= image.height) return;
    std::uint8_t* p =
        &image.pixels[3 * (static_cast<std::size_t>(v) * static_cast<std::size_t>(image.width) +
                           static_cast<std::size_t>(u))];
    std::copy(rgb, rgb + 3, p);
  };
  const int left = static_cast<int>(box.left_px) - 1, right = static_cast<int>(box.right_px) + 1;
  const int top = static_cast<int>(box.top_px) - 1, bottom = static_cast<int>(box.bottom_px) + 1;
  for (int u = left; u <= right; ++u) put(u, top), put(u, bottom);
  for (int v = top; v <= bottom; ++v) put(left, v), put(right, v);
}

BlobBounds BoundsOf(const OrangeMark& orange) {
  const Eigen::Vector2d c = orange.ellipse.centre_px;
  const double a = orange.ellipse.semi_axes_px().y();
  return {c.x() - a, c.y() - a, c.x() + a, c.y() + a};
}

Json BandJson(const HsvBand& band) {
  return {{"hue", {band.hue_from, band.hue_to}},
          {"saturation", {band.saturation_from, band.saturation_to}},
          {"value", {band.value_from, band.value_to}}};
}

void PrintMarks(const MarksSeen& seen, bool as_json) {
  Json json{{"oranges", seen.oranges}, {"blues", seen.blues}, {"pairs", seen.pairs}};
  if (seen.pair) {
    json["pair"] = {{"c_px", seen.pair->c_px},
                    {"g_px", seen.pair->g_px},
                    {"alpha_deg", Degrees(seen.pair->alpha_rad)},
                    {"d_m", seen.pair->angle.d_m},
                    {"r_m", seen.pair->angle.r_m},
                    {"ambiguous", seen.pair->angle.ambiguous}};
  }
  if (as_json) {
    json["warnings"] = Json::array();
    std::printf("%s\n", json.dump(2).c_str());
  } else if (seen.pair) {
    std::printf("pair: alpha %.1f deg, r %.3f m (c %.1f px, g %.1f px)%s\n",
                Degrees(seen.pair->alpha_rad), seen.pair->angle.r_m, seen.pair->c_px,
                seen.pair->g_px, seen.pair->angle.ambiguous ? "; ambiguous" : "");
  } else {
    std::printf("no pair: %s, %s\n", CountText(seen.oranges, "orange ellipse").c_str(),
                CountText(seen.blues, "blue rectangle").c_str());
  }
}

int Tune(const std::string& program, const std::vector<std::string>& words) {
  Arguments in;
  CLI::App app(WithProgram(kTuneHelp, program), program + " tune");
  AddOptions(app, in);
  if (const auto ended = ParseWords(app, words, program + " help tune")) return *ended;
  const Nominal nominal = NominalOfFiles(in);
  const std::optional<TunedBands> tuned = TuneBands(Load(in.image, nominal.camera), nominal);
  if (!tuned) {
    std::fprintf(stderr, "%s: no pair of marks fits the pyramid's dimensions\n",
                 WithControlsShown(in.image).c_str());
    return kNoPair;
  }
  const Json json{{"orange", BandJson(tuned->orange)},
                  {"blue", BandJson(tuned->blue)},
                  {"warnings", Json::array()}};
  if (in.json) {
    std::printf("%s\n", json.dump(2).c_str());
    return 0;
  }
  for (const auto& [name, band] : {std::pair("orange", tuned->orange), {"blue", tuned->blue}}) {
    std::printf("%s: {hue: [%d, %d], saturation: [%d, %d], value: [%d, %d]}\n", name, band.hue_from,
                band.hue_to, band.saturation_from, band.saturation_to, band.value_from,
                band.value_to);
  }
  return 0;
}

std::vector<CommandOption> TuneOptions() {
  Arguments unread;
  CLI::App app;
  AddOptions(app, unread);
  return OptionsOf(app);
}

void AddDetectOptions(CLI::App& app, Arguments& in) {
  AddOptions(app, in);
  app.add_option("--pipeline", in.pipeline, "whose perception")
      ->check(CLI::IsMember({"ferreira2009", "dockyard"}))
      ->capture_default_str();
  app.add_option("--draw", in.draw, "PNG of the image with the marks outlined");
  app.add_option("--pitch-deg", in.pitch_deg, "of the camera, down; for dockyard")
      ->check(CLI::Range(-60.0, 60.0))
      ->capture_default_str();
}

int DetectMarks(const std::string& program, const std::vector<std::string>& words) {
  Arguments in;
  // Without a robot of this system the help is that of another search.
  const std::string help = program + " detect --robot FILE --help";
  CLI::App app(WithProgram(kDetectHelp, program), program + " detect");
  AddDetectOptions(app, in);
  if (const auto ended = ParseWords(app, words, help)) return *ended;
  if (!std::isfinite(in.pitch_deg)) {  // CLI::Range lets it through
    throw ConfigError("--pitch-deg: expected a number from -60 to 60");
  }
  const Nominal nominal = NominalOfFiles(in);
  RgbImage image = Load(in.image, nominal.camera);
  if (in.pipeline == "dockyard") {
    const PyramidSighting seen = PyramidFinder(nominal).Find(image, Radians(in.pitch_deg));
    if (!in.draw.empty()) {
      DrawPyramid(nominal, seen, image);
      WriteWhole(in.draw, EncodePng(image));
    }
    PrintPyramid(seen, in.json);
    return seen.fits.empty() ? kNoPair : 0;
  }
  const MarksSeen seen =
      FindMarks(ColourSearch(image), nominal, nominal.ferreira_vision, std::nullopt);
  if (!in.draw.empty()) {
    if (seen.orange) DrawBox(image, BoundsOf(*seen.orange), {255, 160, 0});
    if (seen.blue) DrawBox(image, *seen.blue, {0, 160, 255});
    WriteWhole(in.draw, EncodePng(image));
  }
  PrintMarks(seen, in.json);
  return seen.pair ? 0 : kNoPair;
}

}  // namespace

SystemCommand DetectCommand() {
  Arguments unread;
  CLI::App app;
  AddDetectOptions(app, unread);
  return {"detect", "Find RAPOSA's pyramid in an image.", DetectMarks, OptionsOf(app)};
}

std::vector<SystemCommand> RaposaCommands() {
  return {
      {"alpha", "Say from which angle and distance RAPOSA's pyramid is viewed.", Alpha,
       AlphaOptions()},
      {"belt", "Drive one belt over a ground, or turn the robot in place.", BeltOnGround,
       BeltOptions()},
      {"socket", "Say what RAPOSA's socket lets in.", Socket, SocketOptions()},
      {"tune", "Write the colour bands of RAPOSA's pyramid from one image.", Tune, TuneOptions()}};
}

}  // namespace dockyard::raposa
