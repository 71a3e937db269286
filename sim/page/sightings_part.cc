#include "sim/page/sightings_part.h"

#include <algorithm>
#include <cmath>

#include "sim/page/pictures.h"

namespace dockyard {
namespace {

/// Digits that nobody sees would fill the header.
double Rounded(double value, double step) { return std::round(value / step) * step; }
constexpr double kPixelStep = 0.01, kPoseStep = 1e-5;

Json MarksOf(int camera, const SightingReport& report) {
  Json marks = Json::array();
  const auto add = [&](const std::vector<SightingReport::Mark>& list, int measured) {
    for (const auto& mark : list) {
      if (mark.camera != camera) continue;
      marks.push_back(Json::array(
          {Rounded(mark.u_px, kPixelStep), Rounded(mark.v_px, kPixelStep), mark.id, measured}));
    }
  };
  add(report.marks, 1);
  add(report.predicted, 0);
  return marks;
}

/// A camera that took no image and has no mark is left out where another one took an image.
/// @param packed  images by camera; empty where there is none
Json CamerasJson(const LoggedRun& run, const SightingReport& report, const std::string* packed,
                 Payload& payload) {
  Json cameras = Json::array();
  const bool any = std::any_of(packed, packed + run.cameras.size(),
                               [](const std::string& each) { return !each.empty(); });
  for (std::size_t index = 0; index < run.cameras.size(); ++index) {
    const LoggedCamera& camera = run.cameras[index];
    Json json{{"name", camera.name},
              {"width", camera.width},
              {"height", camera.height},
              {"picture", nullptr},
              {"marks", MarksOf(static_cast<int>(index), report)}};
    if (any && packed[index].empty() && json["marks"].empty()) continue;
    if (!packed[index].empty()) json["picture"] = payload.Add(packed[index]);
    cameras.push_back(json);
  }
  return cameras;
}

}  // namespace

Json PlanarJson(const Pose2& X) {
  return Json::array(
      {Rounded(X.x, kPoseStep), Rounded(X.y, kPoseStep), Rounded(X.heading, kPoseStep)});
}

Json SightingsPart(const LoggedRun& run, bool pictures, Payload& payload) {
  std::vector<const LoggedImage*> images;  // by sighting, by camera
  for (const SightingSample& sighting : run.sightings) {
    for (const LoggedCamera& camera : run.cameras) {
      images.push_back(pictures ? run.ImageAt(camera.name, sighting.time_s) : nullptr);
    }
  }
  const std::vector<std::string> small = SmallPictures(images);
  Json sightings = Json::array();
  const std::string* next = small.data();
  for (const SightingSample& sighting : run.sightings) {
    const SightingReport& report = sighting.report;
    sightings.push_back(
        {{"sample", run.SampleAt(sighting.time_s)},
         {"accepted", report.accepted},
         {"reason", report.reason},
         {"method", report.method},
         {"pose", PlanarJson(sighting.X_DR)},
         {"measured", report.accepted ? PlanarJson(sighting.X_DR_measured) : Json()},
         {"reprojection_px", Rounded(report.reprojection_px, 1e-3)},
         {"cameras", CamerasJson(run, report, next, payload)}});
    next += run.cameras.size();
  }
  return sightings;
}

}  // namespace dockyard
