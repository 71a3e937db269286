// The board's fiducials beside AprilTag 3 of the same printed size (10 cm, a tag's black edge) at
// the same places, in the same synthetic views: rates, centre errors, time. One thread each.
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "controller/vision/fiducials.h"
#include "controller/vision/pose_refine.h"
#include "models/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

constexpr double kTagSize = 0.10;  // black edge [m]
constexpr int kModules = 10;       // of a tag's picture, white ring included; eight are the edge

/// Where a mark is in the picture and how large it is.
struct Truth {
  Eigen::Vector2d centre;    // picture of its middle, which a tag's corners give
  Eigen::Vector2d centroid;  // of a disc's picture, which a rim gives
  double disc_px = 0.0;
};

/// By mark: how far off it was found [px]; negative when it was not.
using Finds = std::vector<double>;

struct Tally {
  int marks = 0, found = 0;
  double seconds = 0.0;
  int images = 0;
  double rate() const { return marks > 0 ? 100.0 * found / marks : 0.0; }
  void Add(const Finds& finds, double took) {
    for (const double off : finds) found += off >= 0.0;
    marks += static_cast<int>(finds.size());
    seconds += took;
    ++images;
  }
};

/// Centre errors over the marks that the fiducials' detector and AprilTag both found.
struct Shared {
  int marks = 0;
  double discs_px2 = 0.0, tags_px2 = 0.0;
};

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Albedo of a plate with a tag about each fiducial's place, tag i of the family at place i.
class TagPrint {
 public:
  TagPrint(apriltag_family_t* family, const FiducialBoard& board) : board_(board) {
    for (int i = 0; i < static_cast<int>(board.fiducials.size()); ++i) {
      image_u8_t* image = apriltag_to_image(family, i);
      std::vector<bool> white;
      for (int y = 0; y < kModules; ++y) {
        for (int x = 0; x < kModules; ++x) white.push_back(image->buf[y * image->stride + x] > 127);
      }
      white_.push_back(white);
      std::free(image->buf);  // the library keeps its own way to do this to itself
      std::free(image);
    }
  }
  double operator()(const Eigen::Vector2d& p_B) const {
    constexpr double kModule = kTagSize / 8.0;
    for (std::size_t i = 0; i < white_.size(); ++i) {
      const Eigen::Vector2d from = p_B - board_.fiducials[i].p_BF;
      const int x = static_cast<int>(std::floor(from.x() / kModule + 0.5 * kModules));
      const int y = static_cast<int>(std::floor(from.y() / kModule + 0.5 * kModules));
      if (x < 0 || y < 0 || x >= kModules || y >= kModules) continue;
      return white_[i][static_cast<std::size_t>(y * kModules + x)] ? 0.85 : 0.05;
    }
    return 0.85;
  }

 private:
  const FiducialBoard& board_;
  std::vector<std::vector<bool>> white_;
};

class TagDetector {
 public:
  /// @param decimate  1: full resolution, its longest range; 2: the library's default, faster
  explicit TagDetector(float decimate)
      : family_(tag36h11_create()), detector_(apriltag_detector_create()) {
    apriltag_detector_add_family(detector_, family_);
    detector_->nthreads = 1;
    detector_->quad_decimate = decimate;
  }
  ~TagDetector() {
    apriltag_detector_destroy(detector_);
    tag36h11_destroy(family_);
  }
  TagDetector(const TagDetector&) = delete;
  TagDetector& operator=(const TagDetector&) = delete;

  apriltag_family_t* family() const { return family_; }

  Finds Look(const GrayImage& image, const std::vector<Truth>& truths, Tally* tally) {
    std::vector<std::uint8_t> pixels = image.pixels;
    image_u8_t view{
        .width = image.width, .height = image.height, .stride = image.width, .buf = pixels.data()};
    const double begin = CpuSeconds();
    zarray_t* found = apriltag_detector_detect(detector_, &view);
    const double took = CpuSeconds() - begin;
    Finds finds;
    for (std::size_t id = 0; id < truths.size(); ++id) {
      double nearest = 1e9;
      for (int i = 0; i < zarray_size(found); ++i) {
        apriltag_detection_t* tag = nullptr;
        zarray_get(found, i, &tag);
        if (tag->id != static_cast<int>(id)) continue;
        // AprilTag counts from the corner of the first pixel.
        const Eigen::Vector2d centre(tag->c[0] - 0.5, tag->c[1] - 0.5);
        nearest = std::min(nearest, (centre - truths[id].centre).norm());
      }
      finds.push_back(nearest < 0.25 * truths[id].disc_px ? nearest : -1.0);
    }
    apriltag_detections_destroy(found);
    tally->Add(finds, took);
    return finds;
  }

 private:
  apriltag_family_t* family_;
  apriltag_detector_t* detector_;
};

Finds LookForDiscs(const GrayImage& image, const FiducialBoard& board,
                   const std::vector<Truth>& truths, Tally* tally) {
  const double begin = CpuSeconds();
  const std::vector<DetectedFiducial> found = DetectFiducials(image, board);
  const double took = CpuSeconds() - begin;
  Finds finds;
  for (const Truth& truth : truths) {
    double nearest = 1e9;
    for (const DetectedFiducial& fiducial : found) {
      nearest = std::min(nearest, (fiducial.rim.centre_px - truth.centroid).norm());
    }
    finds.push_back(nearest < 0.25 * truth.disc_px ? nearest : -1.0);
  }
  tally->Add(finds, took);
  return finds;
}

std::vector<Truth> Truths(const SyntheticScene& scene, const StereoRig& rig) {
  std::vector<Truth> truths;
  const Pose3 X_CB = Inverse(scene.X_DR * rig.X_RL) * scene.X_DB;
  for (const Fiducial& fiducial : scene.board.fiducials) {
    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(fiducial.p_BF.x(), fiducial.p_BF.y(), 0.0);
    truths.push_back({*rig.left.Project(p_C),
                      *ProjectDisc(rig.left, X_CB, fiducial, scene.board.disc_diameter_m),
                      kTagSize * rig.left.focal_px().x() / p_C.norm()});
  }
  return truths;
}

enum Detector { kDiscs, kTags, kQuickTags };
constexpr const char* kNames[3] = {"fiducials", "AprilTag 36h11", "  decimate 2"};

class Comparison {
 public:
  void Look(SyntheticScene scene, const StereoRig& rig, std::array<Tally, 3>* tallies,
            Shared* shared) {
    const std::vector<Truth> truths = Truths(scene, rig);
    const GrayImage discs = SyntheticView(scene, rig.left, rig.X_RL);
    const Finds ours = LookForDiscs(discs, scene.board, truths, &(*tallies)[kDiscs]);
    scene.print = TagPrint(full_.family(), scene.board);
    const GrayImage tags = SyntheticView(scene, rig.left, rig.X_RL);
    const Finds theirs = full_.Look(tags, truths, &(*tallies)[kTags]);
    quick_.Look(tags, truths, &(*tallies)[kQuickTags]);
    for (std::size_t i = 0; i < truths.size(); ++i) {
      if (ours[i] < 0.0 || theirs[i] < 0.0) continue;
      ++shared->marks;
      shared->discs_px2 += ours[i] * ours[i];
      shared->tags_px2 += theirs[i] * theirs[i];
    }
  }

 private:
  TagDetector full_{1.0f}, quick_{2.0f};
};

/// Largest range up to which the rate stays at or above the share, linear between the samples.
double RangeAt(const std::vector<double>& ranges, const std::vector<Tally>& tallies,
               double percent) {
  double range = 0.0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (tallies[i].rate() >= percent) {
      range = ranges[i];
      continue;
    }
    if (i == 0) return 0.0;
    const double above = tallies[i - 1].rate(), below = tallies[i].rate();
    return ranges[i - 1] + (ranges[i] - ranges[i - 1]) * (above - percent) / (above - below);
  }
  return range;
}

SyntheticScene SceneAt(double range_m, double angle_rad, bool shadow, std::uint64_t key) {
  RandomStream random(StreamKey(key, "tags"));
  SyntheticScene scene;
  scene.seed = key + 1;
  // The nose turned a little: marks lie at other fractions of a pixel in each view.
  scene.X_DR = RoverAt({range_m, angle_rad, angle_rad + Radians(random.Uniform(-8.0, 8.0))},
                       Radians(random.Uniform(-4.0, 4.0)));
  if (shadow) {
    scene.shadow = SyntheticScene::ShadowEdge{
        .through_B = {random.Uniform(-0.3, 0.3), random.Uniform(-0.15, 0.15)},
        .normal_rad = random.Uniform(0.0, 2.0 * kPi),
        .shade = random.Uniform(0.15, 0.35)};
  }
  return scene;
}

void Compare(int views) {
  const StereoRig rig = TestRig(1024, 768);
  const std::vector<double> ranges{1.5, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14};
  Comparison comparison;
  std::vector<Shared> shared(ranges.size());
  std::array<Tally, 3> all;
  std::printf("%d marks in each cell; 1024 x 768 px, 90 deg, marks of 10 cm\n", 8 * views);
  for (const bool shadow : {false, true}) {
    for (const double angle_deg : {0.0, 30.0, 45.0}) {
      std::vector<std::array<Tally, 3>> cells(ranges.size());
      for (std::size_t r = 0; r < ranges.size(); ++r) {
        for (int i = 0; i < views; ++i) {
          comparison.Look(SceneAt(ranges[r], Radians(angle_deg), shadow,
                                  static_cast<std::uint64_t>(100 * r) + i),
                          rig, &cells[r], &shared[r]);
        }
      }
      std::printf("%s, seen at %.0f deg\n  range [m]      ", shadow ? "hard shadow" : "even light",
                  angle_deg);
      for (const double range : ranges) std::printf("%6.1f", range);
      std::array<double, 3> to95, to50;
      for (std::size_t d = 0; d < 3; ++d) {
        std::vector<Tally> row;
        std::printf("\n  %-14s", kNames[d]);
        for (const auto& cell : cells) {
          row.push_back(cell[d]);
          std::printf("%5.0f%%", cell[d].rate());
          all[d].seconds += cell[d].seconds;
          all[d].images += cell[d].images;
        }
        to95[d] = RangeAt(ranges, row, 95.0);
        to50[d] = RangeAt(ranges, row, 50.0);
        std::printf("   95 %% to %4.1f m, 50 %% to %4.1f m", to95[d], to50[d]);
      }
      std::printf("\n  fiducials over AprilTag: %.1f times the range at 50 %%, ",
                  to50[kDiscs] / to50[kTags]);
      if (to95[kTags] > 0.0) {
        std::printf("%.1f at 95 %%\n", to95[kDiscs] / to95[kTags]);
      } else {
        std::printf("AprilTag never at 95 %%\n");
      }
    }
  }
  std::printf("centre error, rms, of marks that both found [px]\n  range [m]      ");
  for (const double range : ranges) std::printf("%6.1f", range);
  for (const bool tags : {false, true}) {
    std::printf("\n  %-14s", tags ? "AprilTag 36h11" : "fiducials");
    for (const Shared& at : shared) {
      if (at.marks == 0) {
        std::printf("     -");
      } else {
        std::printf("%6.3f", std::sqrt((tags ? at.tags_px2 : at.discs_px2) / at.marks));
      }
    }
  }
  std::printf("\n");
  for (std::size_t d = 0; d < 3; ++d) {
    std::printf("%s: %.1f ms of CPU an image\n", kNames[d],
                1e3 * all[d].seconds / std::max(all[d].images, 1));
  }
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) {
  const int views = argc > 1 ? std::atoi(argv[1]) : 3;
  if (views < 1 || views > 100) {
    std::fprintf(stderr, "tag_compare [views for each range, 1 to 100]\n");
    return 2;
  }
  dockyard::Compare(views);
  return 0;
}
