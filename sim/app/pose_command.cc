#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "controller/vision/points/point_pose.h"
#include "models/read/yaml_reader.h"
#include "sim/app/commands.h"
#include "sim/app/exit_codes.h"
#include "sim/app/pixel_rays.h"
#include "sim/app/point_doubts.h"
#include "sim/app/point_files.h"
#include "sim/app/point_report.h"
#include "sim/app/terminal.h"
#include "sim/app/vision_files.h"
#include "sim/base/count_text.h"

namespace dockyard {
namespace {

struct PoseArguments {
  std::string points, sequence;
  RigOptions rig;
  std::optional<int> width{}, height{};
  std::optional<double> survey_m{};
  PipelineOptions pipeline;
  bool json = false, csv = false;
};

constexpr const char* kPoseHelp =
    R"(Pose of a body from pixels of its known points, one camera or two.

Examples:
  dockyard pose examples/points.csv --robot {robot}
  dockyard pose examples/points.csv --robot {robot} --pipeline tsai2013 --json
  dockyard pose --sequence examples/frames.csv --rig {cameras} --csv

POINTS has the columns camera,u_px,v_px,x_m,y_m,z_m: camera is left or right, pixel (0, 0) the
middle of the first pixel, x y z a point of the body. The points may lie in a plane or not; up to
half may be wrong: they are left out. Optional columns; an empty cell counts as a missing column:
  survey_error_m   1 sigma of the point's place on the body, one axis; else that of --survey-error-m
  disc_diameter_m  the pixel is the middle of a disc of this size, square to the body's z
  frame            any text; --sequence needs it: rows with the same text are of the same time
Further columns are ignored. A row whose pixel is empty or NaN was not detected: it is left out and
counted. A pixel more than 2 px outside the image is an error. The survey's error is shared by all
pixels of a point; it enters what counts as wrong, the weights and the covariance, and the default
holds for the whole file. Pipeline tsai2013 knows neither it nor discs, and leaves no point out.
Chi-square above 5 times its freedom is a warning, or a refusal when a usual mistake explains it:
cameras exchanged, axes left-handed, an image of another size.

Prints the body's pose in the rover body (metres, unit quaternion w x y z, covariance), the rover's
in the body, chi-square, the fitted turn of the cameras, and which points were left out. With
--sequence: one line, JSON object or CSV row for each frame, in order of their first rows. Exit code
0: a pose (of a sequence: of one frame at least); 4: no pose, the reason is printed; 3: a bad file;
2: usage.)";

void RequireSound(const PoseArguments& arguments) {
  arguments.pipeline.RequireSound();
  if (arguments.points.empty() == arguments.sequence.empty()) {
    throw UsageError("give either POINTS or --sequence FILE");
  }
  if (arguments.width.has_value() != arguments.height.has_value()) {
    throw UsageError("--width and --height go together");
  }
  const bool tsai = arguments.pipeline.settings().pipeline == VisionPipeline::kTsai2013;
  if (tsai && arguments.survey_m) {
    throw UsageError("--survey-error-m does not go with --pipeline tsai2013");
  }
  if (arguments.json && arguments.csv) throw UsageError("--json and --csv are two forms: give one");
}

/// What the whole file shows, on stderr.
struct Totals {
  std::size_t frames = 0, poses = 0, doubtful = 0;
  int not_detected = 0;
  std::map<std::string, std::size_t> mistakes = {};  // what would make refused frames agree
};

void Note(const Totals& totals) {
  if (totals.doubtful > 0) {
    PrintNote("warning: " + std::to_string(totals.doubtful) + " of " +
              CountText(totals.frames, "frame has", "frames have") + " a chi-square above " +
              NumberText(kBeyondReason) +
              " times its freedom: check the images' size, the calibration and the points");
  }
  for (const auto& [mistake, count] : totals.mistakes) {
    PrintNote("warning: " + std::to_string(count) + " of " + CountText(totals.frames, "frame") +
              (count == 1 ? " has" : " have") + " no pose: " + mistake);
  }
  std::string text = CountText(totals.frames, "frame") + ", " + CountText(totals.poses, "pose");
  if (totals.not_detected > 0) {
    text += "; " + CountText(totals.not_detected, "row") + " without a pixel left out";
  }
  PrintNote(text);
}

int Pose(const PoseArguments& arguments, const std::vector<System>& systems) {
  RequireSound(arguments);
  const bool sequence = !arguments.sequence.empty();
  const StereoRig rig =
      RigOf(arguments.rig, systems, arguments.width.value_or(0), arguments.height.value_or(0));
  const std::string& file = sequence ? arguments.sequence : arguments.points;
  const std::vector<PointFrame> frames = LoadPointFrames(file, sequence, &rig);
  RequirePixelRays(frames, rig, file);
  PointOptions options;
  options.survey_m = arguments.survey_m.value_or(DefaultSurveyError(frames));
  options.sigma_px = std::hypot(options.sigma_px, CalibrationErrorOf(arguments.rig));
  if (arguments.csv) std::printf("%s\n", PoseTableHeader().c_str());
  Totals totals{.frames = frames.size()};
  for (const PointFrame& frame : frames) {
    FrameAnswer answer = AnswerFor(frame, rig, arguments.pipeline.settings(), options);
    totals.poses += static_cast<bool>(answer.pose);
    totals.doubtful += !answer.warnings.empty();
    totals.not_detected += frame.not_detected;
    if (!answer.agree_when.empty()) ++totals.mistakes[answer.agree_when];
    if (!sequence) {
      if (frame.not_detected > 0) {
        answer.warnings.push_back(CountText(frame.not_detected, "row") +
                                  " without a pixel left out");
      }
      for (const std::string& warning : answer.warnings) PrintNote("warning: " + warning);
      // The table's row has the reason alone.
      if (arguments.csv && !answer.pose) PrintNote(FrameText(frame, answer, false));
    }
    const std::string text = arguments.json  ? FrameJson(frame, answer).dump(sequence ? -1 : 2)
                             : arguments.csv ? PoseTableRow(frame, answer)
                                             : FrameText(frame, answer, !sequence);
    std::printf("%s\n", text.c_str());
  }
  if (sequence) Note(totals);
  return totals.poses > 0 ? kExitDone : kExitNoSuccess;
}

}  // namespace

void AddPoseCommand(CLI::App& app, Invocation& call) {
  auto arguments = std::make_shared<PoseArguments>();
  CLI::App* command = app.add_subcommand("pose", kPoseHelp);
  command->add_option("POINTS", arguments->points, "a CSV file of one frame");
  command->add_option("--sequence", arguments->sequence, "a CSV file of many frames");
  AddRigOptions(*command, arguments->rig);
  command
      ->add_option("--survey-error-m", arguments->survey_m,
                   "1 sigma of a point's place on the body; default 0.001 of the longest side of "
                   "the box about all points of the file")
      ->check(CLI::Range(0.0, 10.0));
  command
      ->add_option(
          "--width", arguments->width,
          "of the images [px]; default: what the rig's file says, 1024 when it says nothing")
      ->check(CLI::Range(64, 16384));
  command->add_option("--height", arguments->height, "of the images [px], with --width; else 768")
      ->check(CLI::Range(64, 16384));
  command->add_flag("--json", arguments->json, "JSON; of a sequence one object a line");
  command->add_flag("--csv", arguments->csv, "a table, one row a frame");
  AddPipelineOptions(*command, arguments->pipeline);
  command->callback([arguments, &call] { call.exit_code = Pose(*arguments, call.systems); });
}

}  // namespace dockyard
