#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/vision/board/locate.h"
#include "models/read/config_error.h"
#include "sim/app/commands.h"
#include "sim/app/detect_report.h"
#include "sim/app/detect_tags.h"
#include "sim/app/exit_codes.h"
#include "sim/app/image_files.h"
#include "sim/app/number_option.h"
#include "sim/app/terminal.h"
#include "sim/app/vision_files.h"
#include "sim/base/count_text.h"
#include "sim/base/files.h"
#include "sim/images/png.h"
#include "sim/spectator/canvas.h"

namespace dockyard {
namespace {

struct DetectArguments {
  std::string left, right, folder, board, draw;
  RigOptions rig;
  std::string camera;  // of an image alone; empty: left, or the robot's first
  double roll_deg = 0.0, pitch_deg = 0.0;
  PipelineOptions pipeline;
  bool json = false;
};

constexpr const char* kDetectHelp =
    R"(Find the fiducial board in images with the controller's perception.

Examples:
  dockyard view {scenario} --out out/view
  dockyard detect out/view/left.png out/view/right.png --robot {robot} \
    --board {target}
  dockyard detect out/view/left.png --robot {robot} \
    --board {target} --json
  dockyard detect out/view/right.png --camera right --robot {robot} \
    --board {target} --draw out/view/seen.png
  dockyard detect --folder out/view --robot {robot} \
    --board {target}

One image is taken for the left camera's unless --camera says right. A robot's file that names its
cameras (docs/reference/custom.md) has one of them for each image: that of --camera, else the first;
LEFT RIGHT are of those named left and right. --board is a station's file, a dock's or a board's own
(docs/reference/models.md): discs with bars, plain ones, or square tags. Prints each fiducial
(pixel, id, detected or predicted) and the board's pose in the rover body: metres, unit quaternion
w x y z, covariance of p_x p_y p_z [m] and of a small turn about the rover's x y z [rad]. For a
board of tags an id is the tag's number in the file, from 0; of a pair the camera that finds more
tags gives the pose. Exit code 4: no board accepted; the reason is printed. The noise is raised to
what the residuals show, up to 1 px rms, and the covariance with it: flatness_m in the board's file
states a bow, calibration_error_px in the rig's the cameras' error.
--folder searches every image of a folder by itself and counts the accepted boards. Exit code 0, or
3 when some file is no image (it is named, the others are done).)";

/// What the images are searched for, and by which rules.
struct Searched {
  const std::vector<System>& systems;
  NamedBoard board;
  ErrorAllowance errors;
  std::optional<PlacedCamera> camera{};  // of a robot that has them by name; it saw each image
};

/// For images of this size; 0: as in the file.
StereoRig RigFor(const DetectArguments& arguments, const Searched& searched, int width,
                 int height) {
  if (!searched.camera) return RigOf(arguments.rig, searched.systems, width, height);
  const Camera& nominal = searched.camera->camera;
  const Camera camera = width > 0 ? Resized(nominal, width, height) : nominal;
  return {camera, camera, searched.camera->X_FC, searched.camera->X_FC};
}

SightingReport LocatePair(const StereoImages& images, const DetectArguments& arguments,
                          const Searched& searched) {
  const GrayImage& any = images.left.pixels.empty() ? images.right : images.left;
  const StereoRig rig = RigFor(arguments, searched, any.width, any.height);
  const FiducialBoard& board = searched.board.board;
  if (!board.tags.empty()) return LocateTagsIn(images, rig, board, searched.errors);
  LocateHints hints;
  hints.up_R =
      (RotY(Radians(arguments.pitch_deg)) * RotX(Radians(arguments.roll_deg))).transpose() *
      Eigen::Vector3d::UnitZ();
  return LocateBoard(images, rig, board, hints, arguments.pipeline.settings(), searched.errors)
      .report;
}

/// What one camera saw.
StereoImages Alone(GrayImage image, bool right) {
  return right ? StereoImages{.left = {}, .right = std::move(image)}
               : StereoImages{.left = std::move(image), .right = {}};
}

void WarnIfCut(const std::string& file, std::vector<std::string>* warnings) {
  if (file.empty() || !IsCutJpeg(file)) return;
  Warn(file + ": expected a whole JPEG, found one without its end; the missing part is grey",
       warnings);
}

/// The board was not found: checks whether the images are exchanged, or else upside down.
void TryExchanges(const StereoImages& images, const DetectArguments& arguments,
                  const Searched& searched, DetectAnswer* answer,
                  std::vector<std::string>* warnings) {
  if (!images.left.pixels.empty() && !images.right.pixels.empty()) {
    const SightingReport exchanged =
        LocatePair({.left = images.right, .right = images.left}, arguments, searched);
    if (exchanged.accepted && exchanged.method == "stereo") {
      answer->detail = "with left and right exchanged the images show the board";
      return;
    }
  }
  // A board that may be rolled by half a turn would have been found.
  const Upright& upright = searched.board.board.upright;
  const bool any_roll =
      upright.against != Upright::Against::kPlumb && upright.within_rad >= Radians(180.0) - 1e-9;
  const bool tags = !searched.board.board.tags.empty();  // found at any roll
  if (any_roll || tags || !answer->report.marks.empty()) return;
  for (const bool right : {false, true}) {
    const GrayImage& image = right ? images.right : images.left;
    if (image.pixels.empty()) continue;
    if (!LocatePair(Alone(UpsideDown(image), right), arguments, searched).accepted) continue;
    Warn("turned by 180 deg the " + std::string(right ? "right" : "left") +
             " image shows the board: is it upside down?",
         warnings);
  }
}

GrayImage LoadFor(const DetectArguments& arguments, const std::string& file) {
  // Its blur is as wide as a part of the image, so the time grows with pixels times width: 8 s of
  // processor time for 12 megapixels, a minute for 40.
  constexpr std::size_t kMostForTsai2013 = 12'000'000;
  GrayImage image = LoadGray(file);
  if (arguments.pipeline.settings().pipeline == VisionPipeline::kTsai2013 &&
      image.pixels.size() > kMostForTsai2013) {
    throw ConfigError(file +
                      ": expected at most 12 million pixels for --pipeline tsai2013, found " +
                      std::to_string(image.width) + " x " + std::to_string(image.height));
  }
  return image;
}

int DetectInFolder(const DetectArguments& arguments, const Searched& searched,
                   std::vector<std::string>* all_warnings) {
  RigFor(arguments, searched, 0, 0);  // a bad rig is not the fault of an image
  const BoardMarks board_marks = MarksOf(searched.board.board);
  const bool right = arguments.camera == "right";
  int images = 0, failed = 0, accepted = 0;
  Json list = Json::array();
  for (const std::string& file : ImageFilesIn(arguments.folder)) {
    SightingReport report;
    std::vector<std::string> warnings;
    try {
      report = LocatePair(Alone(LoadFor(arguments, file), right), arguments, searched);
      WarnIfCut(file, &warnings);
    } catch (const ConfigError& error) {  // no image, or not of the cameras' shape
      ++failed;
      PrintNote(error.what());
      list.push_back({{"file", file}, {"error", error.what()}, {"warnings", warnings}});
      continue;
    }
    all_warnings->insert(all_warnings->end(), warnings.begin(), warnings.end());
    ++images;
    accepted += report.accepted;
    list.push_back({{"file", file},
                    {"detected", report.DetectedBy(0) + report.DetectedBy(1)},
                    {"board_discs_detected", NamedDiscs(report)},
                    {"warnings", warnings},
                    {"accepted", report.accepted},
                    {"reason", report.accepted ? Json() : Json(report.reason)}});
    if (arguments.json) continue;
    std::printf("%s: %s, %s\n", file.c_str(), DiscsText(report, board_marks).c_str(),
                report.accepted ? "board accepted" : report.reason.c_str());
  }
  if (arguments.json) {
    const Json json{{"images", images},
                    {"not_looked_at", failed},
                    {"boards_accepted", accepted},
                    {"files", list},
                    {"warnings", *all_warnings}};
    std::printf("%s\n", json.dump(2).c_str());
  } else {
    std::printf("%s, %s accepted", CountText(images, "image").c_str(),
                CountText(accepted, "board").c_str());
    if (failed > 0) std::printf("; %d not usable", failed);
    std::printf("\n");
  }
  return failed > 0 ? kExitBadInput : kExitDone;
}

StereoImages LoadImages(const DetectArguments& arguments) {
  if (arguments.right.empty()) {
    return Alone(LoadFor(arguments, arguments.left), arguments.camera == "right");
  }
  StereoImages images{.left = LoadFor(arguments, arguments.left),
                      .right = LoadFor(arguments, arguments.right)};
  if (images.right.width != images.left.width || images.right.height != images.left.height) {
    throw ConfigError(arguments.right + ": expected the size of " + arguments.left + ", " +
                      std::to_string(images.left.width) + " x " +
                      std::to_string(images.left.height) + ", found " +
                      std::to_string(images.right.width) + " x " +
                      std::to_string(images.right.height));
  }
  return images;
}

void RequireSound(const DetectArguments& arguments) {
  if (arguments.left.empty() == arguments.folder.empty()) {
    throw UsageError("give either LEFT [RIGHT] or --folder DIR");
  }
  if (!arguments.folder.empty() && !arguments.draw.empty()) {
    throw UsageError("--draw draws LEFT [RIGHT]; leave it out with --folder");
  }
  if (!arguments.right.empty() && !arguments.camera.empty() && arguments.camera != "left") {
    throw UsageError("--camera is of one image alone; leave it out with LEFT RIGHT");
  }
  arguments.pipeline.RequireSound();
}

/// The camera of each image, where the robot has cameras by name and the images are no pair. Throws
/// UsageError, ConfigError.
std::optional<PlacedCamera> CameraOf(const DetectArguments& arguments,
                                     const std::vector<System>& systems) {
  const auto cameras = NamedCamerasOf(arguments.rig, systems);
  if (!cameras) {
    const std::string& name = arguments.camera;
    if (name.empty() || name == "left" || name == "right") return std::nullopt;
    throw UsageError("--camera: expected left or right, as the cameras are a pair, found '" + name +
                     "'");
  }
  if (!arguments.right.empty()) return std::nullopt;
  return CameraNamed(arguments.camera, *cameras, arguments.rig.robot);
}

/// The images beside each other with what was found in them. Throws IoError.
void Draw(const StereoImages& images, const SightingReport& report, const std::string& file) {
  RgbImage left = AsColour(images.left), right = AsColour(images.right);
  DrawMarks(left, report, 0);
  DrawMarks(right, report, 1);
  WriteWhole(file, EncodePng(SideBySide(left, right)));
}

int Detect(const DetectArguments& arguments, Invocation& call) {
  RequireSound(arguments);
  const NamedBoard named = BoardOf(arguments.board, call.systems);
  const Searched searched{.systems = call.systems,
                          .board = named,
                          .errors = {.raise_noise = true,
                                     .flatness_m = named.flatness_m,
                                     .calibration_px = CalibrationErrorOf(arguments.rig)},
                          .camera = CameraOf(arguments, call.systems)};
  if (arguments.pipeline.settings().pipeline == VisionPipeline::kTsai2013 &&
      !HasTwoOfEachRotation(named.board)) {
    throw ConfigError(arguments.board +
                      ": expected two bars of each rotation, as --pipeline tsai2013 needs them, "
                      "found others");
  }
  if (!arguments.folder.empty()) return DetectInFolder(arguments, searched, &call.warnings);
  const StereoImages images = LoadImages(arguments);
  DetectAnswer answer{.report = {},
                      .detail = {},
                      .pipeline = arguments.pipeline.name,
                      .board_marks = MarksOf(named.board)};
  if (searched.camera) answer.cameras = {searched.camera->name, searched.camera->name};
  WarnIfCut(arguments.left, &call.warnings);
  WarnIfCut(arguments.right, &call.warnings);
  answer.report = LocatePair(images, arguments, searched);
  if (!answer.report.accepted) TryExchanges(images, arguments, searched, &answer, &call.warnings);
  if (!arguments.draw.empty()) Draw(images, answer.report, arguments.draw);
  if (arguments.json) {
    std::printf("%s\n", DetectJson(answer, call.warnings).dump(2).c_str());
  } else {
    PrintDetectText(answer);
  }
  return answer.report.accepted ? kExitDone : kExitNoSuccess;
}

/// The options of systems with a perception of their own.
std::string OptionsOfSystems(const std::vector<System>& systems) {
  std::string text;
  for (const System& system : systems) {
    if (!system.detect.run) continue;
    text += "\nWith a robot or a --scenario of the system " + system.name +
            " instead: " + system.detect.help + "\n";
    for (const CommandOption& option : system.detect.options) {
      text += "  " + option.name +
              std::string(option.name.size() < 14 ? 14 - option.name.size() : 0, ' ') + "  " +
              option.meaning + "\n";
    }
  }
  return text;
}

}  // namespace

void AddDetectCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<DetectArguments>();
  CLI::App* command = app.add_subcommand("detect", kDetectHelp);
  command->footer(OptionsOfSystems(call.systems));
  command->add_option("LEFT", arguments->left,
                      "image of the left camera, or of the one that --camera names");
  command->add_option("RIGHT", arguments->right, "image of the right camera");
  command->add_option("--folder", arguments->folder, "every image of a folder instead, one by one");
  command->add_option("--camera", arguments->camera,
                      "of one image, or of a folder's: left (default) or right of a pair, or its "
                      "name in the robot's file");
  AddRigOptions(*command, arguments->rig);
  command->add_option("--board", arguments->board, "a station's file, or a board's")->required();
  command->add_option("--roll-deg", arguments->roll_deg, "attitude of the rover body")
      ->check(NumberWithin(-60.0, 60.0));
  command->add_option("--pitch-deg", arguments->pitch_deg, "the same, nose-down positive")
      ->check(NumberWithin(-60.0, 60.0));
  command->add_option("--draw", arguments->draw, "PNG of the images with the detections marked");
  command->add_flag("--json", arguments->json, "JSON on standard output");
  AddPipelineOptions(*command, arguments->pipeline);
  command->callback([arguments, &call] { call.exit_code = Detect(*arguments, call); });
}

}  // namespace dockyard
