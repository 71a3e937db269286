// The board's fiducials beside AprilTag 3 of the same printed size (10 cm, a tag's black edge) at
// the same places, in the same synthetic views: rates, centre errors, time. One thread each.
#include <apriltag/apriltag.h>
#include <apriltag/tag36h11.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <vector>

#include "controller/vision/fiducials.h"
#include "models/random.h"
#include "vision/synthetic_view.h"

namespace dockyard {
namespace {

constexpr double kTagSize = 0.10;  // black edge [m]
constexpr int kModules = 10;       // of a tag's picture, white ring included; eight are the edge

/// Where a mark's middle is in the picture and how large it is.
struct Truth {
  Eigen::Vector2d pixel;
  double disc_px = 0.0;
};

struct Tally {
  int marks = 0, found = 0;
  double squares_px2 = 0.0, seconds = 0.0;
  int images = 0;
  double rate() const { return marks > 0 ? 100.0 * found / marks : 0.0; }
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

class Comparison {
 public:
  Comparison() : family_(tag36h11_create()), detector_(apriltag_detector_create()) {
    apriltag_detector_add_family(detector_, family_);
    detector_->nthreads = 1;
    detector_->quad_decimate = 1.0f;  // full resolution: its longest range
  }
  ~Comparison() {
    apriltag_detector_destroy(detector_);
    tag36h11_destroy(family_);
  }
  Comparison(const Comparison&) = delete;
  Comparison& operator=(const Comparison&) = delete;

  void Look(SyntheticScene scene, const StereoRig& rig, Tally* discs, Tally* tags) {
    const std::vector<Truth> truths = Truths(scene, rig);
    Discs(SyntheticView(scene, rig.left, rig.X_RL), scene.board, truths, discs);
    scene.print = TagPrint(family_, scene.board);
    Tags(SyntheticView(scene, rig.left, rig.X_RL), truths, tags);
  }

 private:
  static std::vector<Truth> Truths(const SyntheticScene& scene, const StereoRig& rig) {
    std::vector<Truth> truths;
    const Pose3 X_CB = Inverse(scene.X_DR * rig.X_RL) * scene.X_DB;
    for (const Fiducial& fiducial : scene.board.fiducials) {
      const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(fiducial.p_BF.x(), fiducial.p_BF.y(), 0.0);
      truths.push_back({*rig.left.Project(p_C), kTagSize * rig.left.focal_px().x() / p_C.norm()});
    }
    return truths;
  }
  static void Discs(const GrayImage& image, const FiducialBoard& board,
                    const std::vector<Truth>& truths, Tally* tally) {
    const double begin = CpuSeconds();
    const std::vector<DetectedFiducial> found = DetectFiducials(image, board);
    tally->seconds += CpuSeconds() - begin;
    ++tally->images;
    for (const Truth& truth : truths) {
      ++tally->marks;
      double nearest = 1e9;
      for (const DetectedFiducial& fiducial : found) {
        nearest = std::min(nearest, (fiducial.rim.centre_px - truth.pixel).norm());
      }
      if (nearest > 0.25 * truth.disc_px) continue;
      ++tally->found;
      tally->squares_px2 += nearest * nearest;
    }
  }
  void Tags(const GrayImage& image, const std::vector<Truth>& truths, Tally* tally) {
    std::vector<std::uint8_t> pixels = image.pixels;
    image_u8_t view{
        .width = image.width, .height = image.height, .stride = image.width, .buf = pixels.data()};
    const double begin = CpuSeconds();
    zarray_t* found = apriltag_detector_detect(detector_, &view);
    tally->seconds += CpuSeconds() - begin;
    ++tally->images;
    for (std::size_t id = 0; id < truths.size(); ++id) {
      ++tally->marks;
      double nearest = 1e9;
      for (int i = 0; i < zarray_size(found); ++i) {
        apriltag_detection_t* tag = nullptr;
        zarray_get(found, i, &tag);
        if (tag->id != static_cast<int>(id)) continue;
        // AprilTag counts from the corner of the first pixel.
        const Eigen::Vector2d centre(tag->c[0] - 0.5, tag->c[1] - 0.5);
        nearest = std::min(nearest, (centre - truths[id].pixel).norm());
      }
      if (nearest > 0.25 * truths[id].disc_px) continue;
      ++tally->found;
      tally->squares_px2 += nearest * nearest;
    }
    apriltag_detections_destroy(found);
  }

  apriltag_family_t* family_;
  apriltag_detector_t* detector_;
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

void Compare(int views) {
  const StereoRig rig = TestRig(1024, 768);
  const std::vector<double> ranges{1.5, 2, 3, 4, 5, 6, 7, 8, 9, 10};
  Comparison comparison;
  Tally all_discs, all_tags;
  for (const bool shadow : {false, true}) {
    for (const double angle_deg : {0.0, 30.0, 45.0}) {
      std::vector<Tally> discs(ranges.size()), tags(ranges.size());
      for (std::size_t r = 0; r < ranges.size(); ++r) {
        for (int i = 0; i < views; ++i) {
          RandomStream random(StreamKey(static_cast<std::uint64_t>(100 * r + i), "tags"));
          SyntheticScene scene;
          scene.seed = static_cast<std::uint64_t>(i + 1);
          // The nose turned a little: marks lie at other fractions of a pixel in each view.
          const double alpha = Radians(angle_deg);
          scene.X_DR = RoverAt({ranges[r], alpha, alpha + Radians(random.Uniform(-8.0, 8.0))},
                               Radians(random.Uniform(-4.0, 4.0)));
          if (shadow) {
            scene.shadow = SyntheticScene::ShadowEdge{
                .through_B = {random.Uniform(-0.3, 0.3), random.Uniform(-0.15, 0.15)},
                .normal_rad = random.Uniform(0.0, 2.0 * kPi),
                .shade = random.Uniform(0.15, 0.35)};
          }
          comparison.Look(scene, rig, &discs[r], &tags[r]);
        }
      }
      std::printf("%s, seen at %.0f deg\n  range [m]      ", shadow ? "hard shadow" : "even light",
                  angle_deg);
      for (const double range : ranges) std::printf("%6.1f", range);
      const auto print = [&](const char* name, const std::vector<Tally>& tallies, Tally* all) {
        std::printf("\n  %-14s", name);
        for (const Tally& tally : tallies) {
          std::printf("%5.0f%%", tally.rate());
          all->found += tally.found;
          all->marks += tally.marks;
          all->squares_px2 += tally.squares_px2;
          all->seconds += tally.seconds;
          all->images += tally.images;
        }
        std::printf("   95 %% to %.1f m, 50 %% to %.1f m", RangeAt(ranges, tallies, 95.0),
                    RangeAt(ranges, tallies, 50.0));
      };
      print("fiducials", discs, &all_discs);
      print("AprilTag 36h11", tags, &all_tags);
      std::printf("\n");
    }
  }
  const auto sum = [](const char* name, const Tally& all) {
    std::printf("%s: centre error %.3f px rms, %.1f ms an image\n", name,
                std::sqrt(all.squares_px2 / std::max(all.found, 1)),
                1e3 * all.seconds / std::max(all.images, 1));
  };
  sum("fiducials", all_discs);
  sum("AprilTag 36h11", all_tags);
}

}  // namespace
}  // namespace dockyard

int main(int argc, char** argv) {
  const int views = argc > 1 ? std::atoi(argv[1]) : 3;
  if (views < 1) {
    std::fprintf(stderr, "tag_compare [views for each range, at least 1]\n");
    return 2;
  }
  dockyard::Compare(views);
  return 0;
}
