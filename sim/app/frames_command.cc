#include <cstdio>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "sim/app/all_images.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/kept_campaign.h"
#include "sim/app/kept_run.h"
#include "sim/app/terminal.h"
#include "sim/base/count_text.h"
#include "sim/base/files.h"
#include "sim/images/png.h"
#include "sim/spectator/canvas.h"
#include "sim/spectator/looks.h"

namespace dockyard {
namespace {

struct FramesArguments {
  std::string dir, out_dir;
  std::optional<int> run;  // none: the folder of a single run
  bool plain = false, json = false;
};

constexpr const char* kFramesHelp =
    R"(Write the images of a run's log as PNG files, with marks of what was found.

Examples:
  dockyard frames results/{campaign_name} 17 --out out/frames
  dockyard frames out/typical --out out/frames --plain

A ring with a number is a fiducial that was measured, or a mark of a controller's program; one with
a cross is where the controller expected a fiducial without measuring it. frames.json tells time,
camera and verdict of each file.
--plain leaves the images as the controller got them. Where the log keeps some of the images alone
(log_image_gap_s) the run is simulated again for the others.)";

bool IsPng(const std::string& bytes) { return bytes.starts_with("\x89PNG"); }

/// Writes one image; returns its entry in frames.json, null if there is no image.
Json WriteLook(const LoggedRun& log, const Look& look, std::size_t index, std::size_t camera,
               bool plain, const std::filesystem::path& out_dir) {
  std::optional<RgbImage> picture = PictureOf(look, camera);
  if (!picture) return nullptr;
  char number[24];
  std::snprintf(number, sizeof number, "%03zu", index + 1);
  const std::string& name = log.cameras[camera].name;
  const std::string file = "look_" + std::string(number) + "_" + name + ".png";
  const std::string& logged = look.images[camera]->bytes;
  if (plain && IsPng(logged)) {
    WriteWhole(out_dir / file, logged);
  } else {
    if (!plain && look.sighting != nullptr) {
      DrawMarks(*picture, look.sighting->report, static_cast<int>(camera));
    }
    WriteWhole(out_dir / file, EncodePng(*picture));
  }
  return {{"file", file},
          {"time_s", look.time_s},
          {"camera", name},
          {"accepted", look.sighting != nullptr && look.sighting->report.accepted},
          {"verdict", WordOf(look)}};
}

int Frames(const FramesArguments& arguments, const Invocation& call) {
  const KeptRun kept = FindKeptRun(arguments.dir, arguments.run, "frames", call);
  if (!kept.log_dir.HasFile(kRunLogFile)) {
    PrintError("there is no log in " + kept.log_dir.path().string() +
               "; `keep` in the campaign's file says which runs keep theirs");
    return kExitIncomplete;
  }
  const LoggedRun log =
      WithAllImages(ReadLoggedRun(kept.log_dir), kept.run, kept.columns.labels, call);
  const std::vector<Look> looks = LooksOf(log);
  MakeFolder(arguments.out_dir);
  Json files = Json::array();
  for (std::size_t index = 0; index < looks.size(); ++index) {
    for (std::size_t camera = 0; camera < log.cameras.size(); ++camera) {
      Json entry = WriteLook(log, looks[index], index, camera, arguments.plain, arguments.out_dir);
      if (!entry.is_null()) files.push_back(std::move(entry));
    }
  }
  WriteWhole(std::filesystem::path(arguments.out_dir) / "frames.json", files.dump(1) + "\n");
  if (files.empty()) {
    PrintError("the log in " + kept.log_dir.path().string() + " has no images");
    return kExitIncomplete;
  }
  PrintNote(CountText(files.size(), "image") + " and frames.json in " + arguments.out_dir);
  if (arguments.json) {
    const Json answer{
        {"folder", arguments.out_dir}, {"images", files}, {"warnings", call.warnings}};
    std::printf("%s\n", answer.dump(1).c_str());
  }
  return kExitDone;
}

}  // namespace

void AddFramesCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<FramesArguments>();
  CLI::App* command = app.add_subcommand("frames", kFramesHelp);
  command->add_option("DIR", arguments->dir, "results folder of a campaign or of one run")
      ->required()
      ->type_name("DIR");
  command->add_option("RUN", arguments->run, "number of the run in a campaign");
  command->add_option("--out", arguments->out_dir, "folder for the images")
      ->required()
      ->type_name("DIR");
  command->add_flag("--plain", arguments->plain, "without marks");
  command->add_flag("--json", arguments->json, "print what was written as JSON");
  AddSecretOption(*command, call);
  command->callback([arguments, &call] { call.exit_code = Frames(*arguments, call); });
}

}  // namespace dockyard
