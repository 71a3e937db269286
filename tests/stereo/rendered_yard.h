// Level yards with rocks as the renderer shows them, and what is there in truth: rays through the
// plane and the rocks' hulls in closed form. Nothing of the truth comes of the renderer.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "controller/geometry/image.h"
#include "controller/stereo/match.h"
#include "render/stereo_renderer.h"
#include "sim/rigid/rocks.h"

namespace dockyard {

struct YardSettings {
  std::uint64_t seed = 1;
  double sun_elevation_rad = 40.0 * kPi / 180.0;
  double sun_azimuth_rad = 2.2;  // from the way ahead, counter-clockwise; assumed
  RockField field;
};

/// The world's z is up, the ground z = 0, the rover stands at the origin and faces along x.
struct RenderedYard {
  std::vector<double> heights_m;
  Scene scene;  // points to the heights
  std::vector<Rock> rocks;
};
RenderedYard MakeYard(const YardSettings& settings);

/// Rocky 7's body pair: 103 deg, baseline 0.1 m, 0.3 m up, 45 deg down (Nesnas et al. 2000).
StereoRig BodyCameras(int width = 640, int height = 480);

/// The default sensor with a blur of 0.6 px at 640 px.
StereoImages PictureOf(StereoRenderer& renderer, const RenderedYard& yard, const StereoRig& rig,
                       std::uint64_t noise_key, const Pose3& X_WR = {});

/// What a ray meets first.
struct Met3 {
  double way = 0.0;  // in lengths of `along`
  int rock = -1;     // -1: the ground
};
std::optional<Met3> MeetsYard(const std::vector<Rock>& rocks, const Eigen::Vector3d& from,
                              const Eigen::Vector3d& along);

/// By pixel of the rectified left image.
struct YardTruth {
  struct Pixel {
    float disparity_px = 0.0F;  // 0: nothing is met, or the camera does not see there
    int rock = -1;
    bool both = false;  // the right camera sees the same place
  };
  int width = 0, height = 0;
  std::vector<Pixel> pixels;
};
YardTruth TruthOf(const RenderedYard& yard, const StereoRig& rig, const Rectifier& rectifier);

/// Into the folder that the environment's DOCKYARD_IMAGES names, if it names one.
void KeepPicture(const std::string& name, const GrayImage& image);
/// From low (black) to high (white); NaN black.
GrayImage Shades(int width, int height, const std::vector<float>& values, double low, double high);

}  // namespace dockyard
