#include "sim/app/film_files.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

#include "controller/base/number_text.h"
#include "models/read/near_names.h"
#include "sim/app/commands.h"
#include "sim/app/passing_folder.h"
#include "sim/base/files.h"
#include "sim/images/png.h"
#include "sim/plant/renderer.h"
#include "sim/spectator/film.h"

namespace dockyard {

namespace {

/// Three numbers apart by commas; none: the text is something else.
std::optional<Eigen::Vector3d> PlaceFrom(const std::string& text) {
  Eigen::Vector3d place(0.0, 0.0, 0.0);
  std::size_t begin = 0;
  for (int i = 0; i < 3; ++i) {
    const std::size_t comma = i < 2 ? text.find(',', begin) : text.size();
    if (comma == std::string::npos) return std::nullopt;
    const auto number = NumberFromText(text.substr(begin, comma - begin));
    if (!number || std::abs(*number) > 1e4) return std::nullopt;
    place(i) = *number;
    begin = comma + 1;
  }
  return place;
}

Aim AimFrom(const std::string& text, const StageShapes& shapes) {
  if (const auto place = PlaceFrom(text)) return {.name = {}, .p_D = place};
  const std::vector<std::string> known = AimNames(shapes);
  if (std::find(known.begin(), known.end(), text) != known.end()) return {text, std::nullopt};
  std::string names;
  for (const std::string& name : known) names += name + ", ";
  const std::string near = NearestName(text, known);
  throw UsageError("--at: expected " + names + "or X,Y,Z in metres, found '" + text + "'" +
                   (near.empty() ? "" : "; nearest is '" + near + "'"));
}

}  // namespace

OutsideOptions OutsideArguments::options(const StageShapes& shapes) const {
  OutsideOptions options;
  char rest = 0;
  const bool two =
      std::sscanf(size.c_str(), "%dx%d%c", &options.width, &options.height, &rest) == 2;
  const auto within = [](int pixels) { return pixels >= 64 && pixels <= 3840; };
  if (!two || !within(options.width) || !within(options.height)) {
    throw UsageError(
        "--size: expected WIDTHxHEIGHT, each 64 to 3840 pixels, as in 960x540; found '" + size +
        "'");
  }
  if (options.width % 2 != 0 || options.height % 2 != 0) {
    throw UsageError("--size: expected even numbers, as films need them, found '" + size + "'");
  }
  if (!at.empty()) options.at = AimFrom(at, shapes);
  if (from_D.empty()) return options;
  options.from_D = Eigen::Vector3d(from_D[0], from_D[1], from_D[2]);
  return options;
}

void AddOutsideOptions(CLI::App& command, OutsideArguments& arguments) {
  command.add_option("--size", arguments.size, "of the pictures [960x540]")
      ->type_name("WIDTHxHEIGHT");
  command
      .add_option("--from", arguments.from_D,
                  "where the spectator stands, from the target: out along its axis, to the left, "
                  "up [m] [where all is in view; with --at near its point, where nothing hides it]")
      ->type_name("X,Y,Z")
      ->delimiter(',')
      ->expected(3);
  command
      .add_option("--at", arguments.at,
                  "the spectator's aim point, shown from near: target, robot, another point of the "
                  "system (tip, gripper ...), or a place as of --from [robot and target]")
      ->type_name("NAME|X,Y,Z");
}

StageShapes ShapesToDraw(const System& system, const Scenario& scenario) {
  if (!system.shapes) {
    throw UsageError("the system " + system.name + " cannot be shown from outside");
  }
  return system.shapes(scenario);
}

int WriteFilm(const LoggedRun& log, const StageShapes& shapes, const OutsideOptions& options,
              double period_s, const std::filesystem::path& out_dir) {
  const std::unique_ptr<StereoRenderer> renderer = MakeRenderer();
  Film film(log, shapes, options, *renderer);
  MakeFolder(out_dir);
  const std::size_t last = log.times_s.size() - 1;
  const double begin_s = log.times_s.front();
  int frames = 0;
  std::size_t drawn = last + 1;  // none
  for (int step = 0; drawn != last; ++step) {
    const std::size_t sample = log.SampleAt(begin_s + period_s * step);
    if (sample == drawn) continue;
    drawn = sample;
    char name[32];
    std::snprintf(name, sizeof name, "frame_%05d.png", ++frames);
    WriteWhole(out_dir / name, EncodePng(film.Frame(sample)));
  }
  return frames;
}

double WriteOutside(const LoggedRun& log, const StageShapes& shapes, const OutsideOptions& options,
                    double time_s, const std::filesystem::path& file) {
  if (log.times_s.empty()) throw DataError("the log has no sample of the world");
  const std::unique_ptr<StereoRenderer> renderer = MakeRenderer();
  const std::size_t sample = log.SampleAt(time_s);
  OutsideView view(log, shapes, options, sample, sample, *renderer);
  WriteWhole(file, EncodePng(view.Image(sample)));
  return log.times_s[sample];
}

LoggedRun LogAnew(const System& system, const CampaignRun& run, RunOptions options) {
  const PassingFolder folder;
  options.log_dir = folder.path();
  Simulate(system, run, options);
  return ReadLoggedRun(folder.path());
}

}  // namespace dockyard
