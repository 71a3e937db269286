// Rendered stereo pairs of the board in the yard, over a Halton set of poses, with the truth beside
// them: the same world, light, lenses and sensor as in a run.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "controller/vision/board/locate.h"
#include "render/stereo_renderer.h"
#include "sim/axel/axel_view.h"
#include "sim/axel/build_run.h"
#include "sim/axel/fiducial_truth.h"

namespace dockyard::axel {

struct YardOptions {
  Light light = Light::kEven;
  int width = 1024, height = 768;
  double r_min_m = 1.0, r_max_m = 7.0;
  double alpha_rad = Radians(45.0), h_rad = Radians(30.0), pitch_rad = Radians(10.0);
  bool has_board = true;    // without: the yard from random places, no fiducial anywhere
  std::string cache{};      // a folder that keeps the images; empty: none
  std::uint64_t seed = 40;  // of world, light, rig and sensor, with the number of the image pair
};

/// One fiducial in one image.
struct YardMark {
  FiducialPixels truth;
  double shaded = 0.0;  // share of the disc from which the sun's middle is hidden, 0..1
  bool InView() const { return truth.whole && truth.hidden == 0.0; }
  bool CutByShadow() const { return shaded > 0.02 && shaded < 0.98; }
};

struct YardSample {
  int index = 0;
  DockingCoords at;
  double pitch_rad = 0.0;
  StereoImages images;
  StereoRig built_rig;                         // the cameras that took the images
  SensorOptions sensor;                        // the sensor behind them
  Pose3 X_WR;                                  // truth
  Pose3 X_RB;                                  // truth
  Pose3 X_DB;                                  // truth
  std::array<std::vector<YardMark>, 2> marks;  // left, right; by id
  LocateHints hints;                           // up as the IMU would give it
  /// At least five fiducials whole and unhidden in one image.
  bool InView() const;
};

/// Poses, light, rig and noise of image pair i are functions of options and i alone.
class YardViews {
 public:
  explicit YardViews(const YardOptions& options);
  ~YardViews();

  /// With render false the truth only; images stay empty.
  YardSample Take(int i, bool render = true);
  /// The same from a given place.
  YardSample TakeAt(int i, const DockingCoords& at, double pitch_rad, bool render = true);
  const StereoRig& calibration() const { return built_.nominal.rig; }
  const FiducialBoard& board() const { return built_.nominal.board; }
  const Scene& last_scene() const { return scene_; }

 private:
  void Draw(const YardSample& sample, StereoImages* images);

  YardOptions options_;
  Scenario scenario_;
  BuiltRun built_;
  std::unique_ptr<World> world_;
  std::unique_ptr<StereoRenderer> renderer_;
  std::unique_ptr<SceneBuilder> builder_;
  Scene scene_;
};

/// Halton's sequence (Numerische Mathematik 2, 1960), 0..1.
double Halton(int index, int base);

}  // namespace dockyard::axel
