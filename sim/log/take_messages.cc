#include "sim/log/take_messages.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "sim/log/pose_numbers.h"
#include "sim/log/ros_markers.h"

namespace dockyard {
namespace {

constexpr std::size_t kSmallestMarker = 128, kPointBytes = 24, kMarkBytes = 24;

double TakeTime(CdrReader& in) {
  const std::int32_t s = in.I32();
  return s + 1e-9 * in.U32();
}

Eigen::Vector3d TakeVector(CdrReader& in) {
  Eigen::Vector3d v;
  for (double& x : v) x = in.Double();
  return v;
}

std::vector<SightingReport::Mark> TakeMarks(CdrReader& in) {
  std::vector<SightingReport::Mark> marks(in.Count(kMarkBytes));
  for (SightingReport::Mark& mark : marks) {
    mark.id = in.I32();
    mark.camera = in.I32();
    mark.u_px = in.Double();
    mark.v_px = in.Double();
  }
  return marks;
}

}  // namespace

TakenHeader TakeHeader(CdrReader& in) {
  const double time_s = TakeTime(in);
  return {time_s, in.Text()};
}

Pose3 TakePose(CdrReader& in) {
  Pose3 X;
  X.p = TakeVector(in);
  const double x = in.Double(), y = in.Double(), z = in.Double(), w = in.Double();
  X.R = Eigen::Quaterniond(w, x, y, z).toRotationMatrix();
  return X;
}

SightingSample TakeSighting(CdrReader in, std::uint32_t version) {
  SightingSample sighting{.time_s = TakeTime(in), .X_DR = {}, .report = {}, .X_DR_measured = {}};
  SightingReport& report = sighting.report;
  report.accepted = in.Bool();
  report.reason = in.Text();
  report.method = in.Text();
  report.detected.resize(in.Count(sizeof(std::int32_t)));
  for (int& count : report.detected) count = in.I32();
  report.marks = TakeMarks(in);
  report.predicted = TakeMarks(in);
  report.reprojection_px = in.Double();
  report.X_RB = TakePose(in);
  for (int row = 0; row < 6; ++row) {
    for (int column = 0; column < 6; ++column) report.covariance(row, column) = in.Double();
  }
  const std::size_t given = version < 6 ? 3 : 6;
  for (RobotPose* X : {&sighting.X_DR, &sighting.X_DR_measured}) {
    std::array<double, 6> numbers{};
    std::generate_n(numbers.begin(), given, [&] { return in.Double(); });
    *X = PoseFromNumbers(numbers);
  }
  return sighting;
}

Timed<std::vector<Pose2>> TakePlan(CdrReader in) {
  Timed<std::vector<Pose2>> plan{TakeHeader(in).time_s, {}};
  for (std::uint32_t left = in.Count(kSmallestStamped); left > 0; --left) {
    TakeHeader(in);
    plan.value.push_back(ToGround(TakePose(in)));
  }
  return plan;
}

Timed<LoggedNote> TakeNote(CdrReader in) {
  const double time_s = TakeTime(in);
  in.U8();  // the level
  std::string name = in.Text();
  return {time_s, {std::move(name), in.Text()}};
}

Timed<LoggedImage> TakeImage(CdrReader in) {
  const TakenHeader header = TakeHeader(in);
  in.Text();  // the format
  return {header.time_s, {header.frame, std::string(in.Bytes())}};
}

LoggedCamera TakeCamera(CdrReader in) {
  LoggedCamera camera{.name = TakeHeader(in).frame};
  camera.height = in.U32();
  camera.width = in.U32();
  return camera;
}

Timed<LoggedGround> TakeGround(CdrReader in) {
  Timed<LoggedGround> ground{TakeHeader(in).time_s, {}};
  LoggedGround& g = ground.value;
  for (double* number : {&g.x0_m, &g.y0_m, &g.cell_m}) *number = in.Double();
  g.nx = in.U32();
  g.ny = in.U32();
  g.step_m = in.Double();
  g.cells.resize(in.Count(sizeof(std::uint32_t)));
  for (std::uint32_t& cell : g.cells) cell = in.U32();
  g.heights.resize(in.Count(sizeof(std::int16_t)));
  for (std::int16_t& height : g.heights) height = static_cast<std::int16_t>(in.U16());
  const std::uint64_t all = std::uint64_t{g.nx} * g.ny;
  const bool fits = g.cells.empty() ? g.heights.size() == all
                                    : g.heights.size() == g.cells.size() &&
                                          *std::max_element(g.cells.begin(), g.cells.end()) < all;
  if (!fits) throw DataError("heights of the ground do not fit their grid");
  return ground;
}

std::optional<StageLine> TakeLine(CdrReader in) {
  StageLine line;
  if (in.Count(kSmallestMarker) == 0) return line;
  TakeHeader(in);
  line.name = in.Text();
  in.I32();  // id
  if (in.I32() != kLineStrip) return std::nullopt;
  in.I32();  // action
  TakePose(in);
  line.diameter_m = TakeVector(in).x();
  for (double& part : line.rgb) part = in.Float();
  in.Float();
  in.I32();  // lifetime
  in.U32();
  in.Bool();
  line.points_W.resize(in.Count(kPointBytes));
  for (Eigen::Vector3d& point : line.points_W) point = TakeVector(in);
  return line;
}

void TakeScalars(CdrReader in, Series& series) {
  TakeTime(in);
  std::vector<std::string> names(in.Count(kSmallestText));
  for (std::string& name : names) name = in.Text();
  const std::vector<double> values = in.Doubles();
  if (values.size() != names.size()) throw DataError("scalars without a name");
  for (std::size_t i = 0; i < names.size(); ++i) series[names[i]].push_back(values[i]);
}

}  // namespace dockyard
