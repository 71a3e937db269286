#include "sim/app/detect_report.h"

#include <cstdio>
#include <set>

#include "sim/app/vision_files.h"
#include "sim/base/count_text.h"

namespace dockyard {
namespace {

Json MarksJson(const DetectAnswer& answer) {
  const SightingReport& report = answer.report;
  Json list = Json::array();
  const auto add = [&](const SightingReport::Mark& mark, const char* state) {
    list.push_back({{"id", mark.id},
                    {"camera", answer.cameras[mark.camera == 1 ? 1 : 0]},
                    {"u_px", mark.u_px},
                    {"v_px", mark.v_px},
                    {"state", state}});
  };
  for (const auto& mark : report.marks) add(mark, "detected");
  for (const auto& mark : report.predicted) add(mark, "predicted");
  return list;
}

/// "stereo", or the name of the camera that gave the pose.
std::string MethodOf(const DetectAnswer& answer) {
  const std::string& method = answer.report.method;
  return method == "left" ? answer.cameras[0] : method == "right" ? answer.cameras[1] : method;
}

}  // namespace

std::size_t NamedDiscs(const SightingReport& report) {
  std::set<int> ids;
  for (const SightingReport::Mark& mark : report.marks) ids.insert(mark.id);
  return ids.size();
}

BoardMarks MarksOf(const FiducialBoard& board) {
  if (!board.tags.empty()) return {.count = board.tags.size(), .noun = "tag"};
  return {.count = board.fiducials.size()};
}

std::string DiscsText(const SightingReport& report, const BoardMarks& board) {
  if (!report.marks.empty()) {
    return std::to_string(NamedDiscs(report)) + " of the board's " + std::to_string(board.count) +
           " " + board.noun + "s";
  }
  return CountText(report.DetectedBy(0) + report.DetectedBy(1), board.noun) + " in the image";
}

Json DetectJson(const DetectAnswer& answer, const std::vector<std::string>& warnings) {
  const SightingReport& report = answer.report;
  Json json;
  json["pipeline"] = answer.pipeline;
  json["accepted"] = report.accepted;
  json["reason"] = report.accepted ? Json() : Json(report.reason);
  json["detail"] = answer.detail.empty() ? Json() : Json(answer.detail);
  json["method"] = MethodOf(answer);
  json["detected_left"] = report.DetectedBy(0);
  json["detected_right"] = report.DetectedBy(1);
  json["board_discs"] = answer.board_marks.count;
  json["board_discs_detected"] = NamedDiscs(report);
  json["board_in_rover"] = report.accepted ? PoseJson(report.X_RB, report.covariance) : Json();
  json["reprojection_px"] = report.marks.empty() ? Json() : Json(report.reprojection_px);
  const Eigen::Vector3d &turn = report.camera_turn_rad, &sigma = report.camera_turn_sigma_rad;
  json["camera_turn_rad"] = {turn.x(), turn.y(), turn.z()};
  json["camera_turn_sigma_rad"] = {sigma.x(), sigma.y(), sigma.z()};
  json["fiducials"] = MarksJson(answer);
  json["warnings"] = warnings;
  return json;
}

void PrintDetectText(const DetectAnswer& answer) {
  const SightingReport& report = answer.report;
  for (const Json& mark : MarksJson(answer)) {
    std::printf("%-5s %d  %9.3f %9.3f px  %s\n", mark["camera"].get<std::string>().c_str(),
                mark["id"].get<int>(), mark["u_px"].get<double>(), mark["v_px"].get<double>(),
                mark["state"].get<std::string>().c_str());
  }
  const std::string discs = DiscsText(report, answer.board_marks);
  if (report.accepted) {
    std::printf("board (%s, %s, %.3f px rms): %s\n", MethodOf(answer).c_str(), discs.c_str(),
                report.reprojection_px, PoseText(report.X_RB, report.covariance).c_str());
    return;
  }
  const std::string detail = answer.detail.empty() ? "" : ": " + answer.detail;
  std::printf("no board: %s%s (%s)\n", report.reason.c_str(), detail.c_str(), discs.c_str());
}

}  // namespace dockyard
