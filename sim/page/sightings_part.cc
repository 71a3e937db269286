#include "sim/page/sightings_part.h"

#include <optional>

#include "sim/images/png.h"
#include "sim/images/webp.h"

namespace dockyard {
namespace {

constexpr double kPictureQuality = 60.0;
constexpr int kWidestPicture_px = 640;  // wider ones are halved

/// Every second pixel's square of four, averaged.
RgbImage Halved(const RgbImage& image) {
  RgbImage half{image.width / 2, image.height / 2, {}};
  half.pixels.reserve(3 * static_cast<std::size_t>(half.width) * half.height);
  for (int y = 0; y < half.height; ++y) {
    for (int x = 0; x < half.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int dx, int dy) {
          const std::size_t pixel = static_cast<std::size_t>(2 * y + dy) * image.width + 2 * x + dx;
          return static_cast<int>(image.pixels[3 * pixel + c]);
        };
        half.pixels.push_back(
            static_cast<std::uint8_t>((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1) + 2) / 4));
      }
    }
  }
  return half;
}

/// As a small WebP; empty for bytes that are no PNG of ours.
std::string Picture(const std::string& png) {
  std::optional<RgbImage> image = ColourFromPng(png);
  if (!image) return "";
  while (image->width > kWidestPicture_px) image = Halved(*image);
  return EncodeWebp(*image, kPictureQuality);
}

Json MarksOf(int camera, const SightingReport& report) {
  Json marks = Json::array();
  const auto add = [&](const std::vector<SightingReport::Mark>& list, int measured) {
    for (const auto& mark : list) {
      if (mark.camera != camera) continue;
      marks.push_back(Json::array({mark.u_px, mark.v_px, mark.id, measured}));
    }
  };
  add(report.marks, 1);
  add(report.predicted, 0);
  return marks;
}

Json CamerasJson(const LoggedRun& run, const SightingSample& sighting, bool pictures,
                 Payload& payload) {
  Json cameras = Json::array();
  for (std::size_t index = 0; index < run.cameras.size(); ++index) {
    const LoggedCamera& camera = run.cameras[index];
    Json json{{"name", camera.name},
              {"width", camera.width},
              {"height", camera.height},
              {"picture", nullptr},
              {"marks", MarksOf(static_cast<int>(index), sighting.report)}};
    const LoggedImage* image = pictures ? run.ImageAt(camera.name, sighting.time_s) : nullptr;
    const std::string webp = image == nullptr ? "" : Picture(image->png);
    if (!webp.empty()) json["picture"] = payload.Add(webp);
    cameras.push_back(json);
  }
  return cameras;
}

}  // namespace

Json PlanarJson(const Pose2& X) { return Json::array({X.x, X.y, X.heading}); }

Json SightingsPart(const LoggedRun& run, bool pictures, Payload& payload) {
  Json sightings = Json::array();
  for (const SightingSample& sighting : run.sightings) {
    const SightingReport& report = sighting.report;
    sightings.push_back(
        {{"sample", run.SampleAt(sighting.time_s)},
         {"accepted", report.accepted},
         {"reason", report.reason},
         {"method", report.method},
         {"pose", PlanarJson(sighting.X_DR)},
         {"measured", report.accepted ? PlanarJson(sighting.X_DR_measured) : Json()},
         {"reprojection_px", report.reprojection_px},
         {"cameras", CamerasJson(run, sighting, pictures, payload)}});
  }
  return sightings;
}

}  // namespace dockyard
