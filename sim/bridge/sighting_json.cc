#include "sim/bridge/sighting_json.h"

#include <Eigen/Geometry>
#include <cmath>
#include <limits>

#include "sim/bridge/answer_json.h"

namespace dockyard {
namespace {

// Beyond it a mark is in no image. Assumed, 2e4-1e6: the widest images have some 1e4.
constexpr double kFarthest_px = 1e5;
// An image has room for six digits. Assumed, 999-999 999.
constexpr int kLargestId = 999'999;
// An element of R R^T may be off the identity by this: a program may round its digits. Assumed,
// 1e-6-1e-2.
constexpr double kRotationOff = 1e-3;

const Json& Field(const Json& json, const std::string& of, const char* name) {
  const auto at = json.find(name);
  if (at == json.end()) throw AnswerError(of + " without " + name);
  return *at;
}

int WholeField(const Json& mark, const char* name, int most) {
  const Json& json = Field(mark, "a mark", name);
  const std::string range = "0 to " + std::to_string(most);
  const double value = json.is_number_integer() ? json.get<double>() : -1.0;
  if (!(value >= 0.0 && value <= most)) {
    throw AnswerError(std::string("a mark whose ") + name + " is no whole number from " + range);
  }
  return static_cast<int>(value);
}

double Within(const Json& json, const std::string& what, double most) {
  const double value = NumberOf(json, what);
  if (std::abs(value) > most) throw AnswerError(what + " that is too large");
  return value;
}

SightingReport::Mark MarkOf(const Json& json, int camera_count) {
  if (!json.is_object()) throw AnswerError("a mark that is no object");
  if (camera_count == 0) throw AnswerError("a mark, but the robot has no camera");
  return {.id = WholeField(json, "id", kLargestId),
          .camera = WholeField(json, "camera", camera_count - 1),
          .u_px = Within(Field(json, "a mark", "u_px"), "a mark's u_px", kFarthest_px),
          .v_px = Within(Field(json, "a mark", "v_px"), "a mark's v_px", kFarthest_px)};
}

std::vector<SightingReport::Mark> MarksOf(const Json& json, int camera_count) {
  if (!json.is_array()) throw AnswerError("marks that are no list");
  if (json.size() > kMostMarks) {
    throw AnswerError("more than " + std::to_string(kMostMarks) + " marks");
  }
  std::vector<SightingReport::Mark> marks;
  for (const Json& each : json) marks.push_back(MarkOf(each, camera_count));
  return marks;
}

/// So many numbers in a list.
const Json& ListOf(const Json& json, const char* name, std::size_t count) {
  const Json& list = Field(json, "a pose", name);
  if (list.is_array() && list.size() == count) return list;
  throw AnswerError(std::string("a pose whose ") + name + " is no list of " +
                    std::to_string(count) + " numbers");
}

Pose3 PoseOf(const Json& json) {
  if (!json.is_object()) throw AnswerError("a pose that is no object");
  const Json &R = ListOf(json, "R", 9), &p_m = ListOf(json, "p_m", 3);
  Pose3 X;
  for (int i = 0; i < 9; ++i) {
    X.R(i / 3, i % 3) = Within(R[static_cast<std::size_t>(i)], "a number of a pose's R", 2.0);
  }
  for (int i = 0; i < 3; ++i) {
    X.p(i) = Within(p_m[static_cast<std::size_t>(i)], "a number of a pose's p_m", kFarthestPose_m);
  }
  const Eigen::Matrix3d off = X.R * X.R.transpose() - Eigen::Matrix3d::Identity();
  if (off.cwiseAbs().maxCoeff() > kRotationOff || X.R.determinant() < 0.0) {
    throw AnswerError("a pose whose R is no rotation");
  }
  X.R = Eigen::Quaterniond(X.R).normalized().toRotationMatrix();
  return X;
}

}  // namespace

void TakeSightingParts(const Json& belief, int camera_count, SightingParts& parts) {
  if (const auto marks = belief.find("marks"); marks != belief.end()) {
    parts.marks = MarksOf(*marks, camera_count);
  }
  if (const auto pose = belief.find("pose"); pose != belief.end()) parts.X_RB = PoseOf(*pose);
}

SightingReport ReportOf(const SightingParts& parts, int camera_count) {
  SightingReport report;
  report.accepted = parts.X_RB.has_value();
  report.marks = parts.marks.value_or(std::vector<SightingReport::Mark>{});
  if (!report.accepted) report.reason = report.marks.empty() ? "nothing found" : "no pose";
  report.detected.resize(static_cast<std::size_t>(camera_count));
  for (const SightingReport::Mark& mark : report.marks) {
    ++report.detected[static_cast<std::size_t>(mark.camera)];
  }
  report.reprojection_px = std::numeric_limits<double>::quiet_NaN();
  report.X_RB = parts.X_RB.value_or(Pose3{});
  return report;
}

}  // namespace dockyard
