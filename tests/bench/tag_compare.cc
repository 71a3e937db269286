// The board's fiducials beside AprilTag 3 of the same printed size (10 cm, a tag's black edge) at
// the same places of the board, in the same yard, light, cameras and sensor, drawn by the same
// renderer: rates over range, angle and light, centre errors, time. One thread each.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <functional>
#include <string>
#include <vector>

#include "bench/tags.h"
#include "controller/vision/board/fiducials.h"
#include "perception/yard_views.h"
#include "sim/base/files.h"
#include "sim/base/random.h"
#include "sim/images/png.h"
#include "sim/log/frame_codec.h"

namespace dockyard::axel {
namespace {

/// Place and size of a mark in the image.
struct Truth {
  Eigen::Vector2d centre;    // image of its middle, which a tag's corners give
  Eigen::Vector2d centroid;  // of a disc's image, which a rim gives
  double size_px = 0.0;
};
/// By id; none where the tag with its white ring is not whole and unhidden.
using Truths = std::vector<std::optional<Truth>>;

/// By id: how far off it was found [px]; negative when it was not.
using Finds = std::vector<double>;

struct Tally {
  int marks = 0, found = 0;    // marks in view
  int boards = 0, placed = 0;  // image pairs; of these with the board's pose
  double seconds = 0.0;
  int images = 0;
  void Add(const Finds& finds, const Truths& truths) {
    for (std::size_t i = 0; i < truths.size(); ++i) {
      marks += truths[i].has_value();
      found += truths[i] && finds[i] >= 0.0;
    }
  }
};

double Percent(int part, int whole) { return whole > 0 ? 100.0 * part / whole : 0.0; }

/// Centre errors over the marks that the fiducials' detector and AprilTag both found.
struct Shared {
  int marks = 0;
  double discs_px2 = 0.0, tags_px2 = 0.0;
};

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

/// Finds by the nearest of the candidates; more than a quarter of the mark off is another object.
Finds Match(const Truths& truths,
            const std::function<double(std::size_t id, const Truth&)>& nearest) {
  Finds finds;
  for (std::size_t id = 0; id < truths.size(); ++id) {
    const double off = truths[id] ? nearest(id, *truths[id]) : 1e9;
    finds.push_back(truths[id] && off < 0.25 * truths[id]->size_px ? off : -1.0);
  }
  return finds;
}

Finds LookForDiscs(const GrayImage& image, const FiducialBoard& board, const Truths& truths,
                   Tally* tally) {
  const double begin = CpuSeconds();
  const std::vector<DetectedFiducial> found = DetectFiducials(image, board);
  tally->seconds += CpuSeconds() - begin;
  ++tally->images;
  const Finds finds = Match(truths, [&](std::size_t, const Truth& truth) {
    double nearest = 1e9;
    for (const DetectedFiducial& fiducial : found) {
      nearest = std::min(nearest, (fiducial.rim.centre_px - truth.centroid).norm());
    }
    return nearest;
  });
  tally->Add(finds, truths);
  return finds;
}

Finds LookForTags(const GrayImage& image, TagDetector& detector, const Truths& truths,
                  Tally* tally) {
  const double begin = CpuSeconds();
  const std::vector<SeenTag> found = detector.Detect(image);
  tally->seconds += CpuSeconds() - begin;
  ++tally->images;
  const Finds finds = Match(truths, [&](std::size_t id, const Truth& truth) {
    double nearest = 1e9;
    for (const SeenTag& tag : found) {
      if (tag.id != static_cast<int>(id)) continue;
      nearest = std::min(nearest, (tag.centre_px - truth.centre).norm());
    }
    return nearest;
  });
  tally->Add(finds, truths);
  return finds;
}

/// For one camera; of marks in view, by a disc round the tag's white corners.
Truths TruthsOf(const YardViews& views, const YardSample& sample, bool right) {
  Scene scene = views.last_scene();
  scene.boards[0].board.disc_diameter_m = kTagImage_m * std::sqrt(2.0);
  const Camera& camera = right ? sample.built_rig.right : sample.built_rig.left;
  const Pose3 X_WC = sample.X_WR * (right ? sample.built_rig.X_RQ : sample.built_rig.X_RL);
  Truths truths;
  const std::vector<FiducialPixels> around = TrueFiducials(scene, camera, X_WC);
  for (std::size_t id = 0; id < around.size(); ++id) {
    const std::optional<Eigen::Vector2d>& centroid = sample.marks[right ? 1 : 0][id].truth.centroid;
    truths.emplace_back();
    if (!around[id].whole || around[id].hidden > 0.0 || !centroid) continue;
    const double range_m = (Inverse(X_WC) * scene.boards[0].X_WB.p).norm();
    truths.back() = {*around[id].centre, *centroid, kTagSize_m * camera.focal_px().x() / range_m};
  }
  return truths;
}

enum Detector { kDiscs, kTags, kQuickTags };
constexpr std::array<const char*, 3> kNames{"fiducials", "AprilTag 36h11", "  decimate 2"};
constexpr std::array<const char*, 3> kBoardNames{"board's pose", "one tag or more", "  decimate 2"};

class Comparison {
 public:
  /// folder: keeps each view's left image with tags; empty: none.
  explicit Comparison(std::string folder) : folder_(std::move(folder)) {
    if (!folder_.empty()) MakeFolder(folder_);
  }

  void Detect(YardViews& views, const YardSample& sample, const std::string& name,
              std::array<Tally, 3>* tallies, Shared* shared) {
    const StereoImages tags =
        ExposeStereo(RenderPrinted(renderer_, views.last_scene(), sample.built_rig, sample.X_WR,
                                   full_.Images(views.board())),
                     sample.built_rig, sample.sensor);
    if (!folder_.empty()) WriteWhole(folder_ + "/" + name + ".png", EncodePng(tags.left));
    std::array<int, 2> seen{};
    for (const bool right : {false, true}) {
      const Truths truths = TruthsOf(views, sample, right);
      const GrayImage& with_tags = right ? tags.right : tags.left;
      const Finds ours = LookForDiscs(right ? sample.images.right : sample.images.left,
                                      views.board(), truths, &(*tallies)[kDiscs]);
      const Finds theirs = LookForTags(with_tags, full_, truths, &(*tallies)[kTags]);
      const Finds quick = LookForTags(with_tags, quick_, truths, &(*tallies)[kQuickTags]);
      const auto found = [](double off) { return off >= 0.0; };
      seen[0] += static_cast<int>(std::count_if(theirs.begin(), theirs.end(), found));
      seen[1] += static_cast<int>(std::count_if(quick.begin(), quick.end(), found));
      for (std::size_t i = 0; i < truths.size(); ++i) {
        if (ours[i] < 0.0 || theirs[i] < 0.0) continue;
        ++shared->marks;
        shared->discs_px2 += ours[i] * ours[i];
        shared->tags_px2 += theirs[i] * theirs[i];
      }
    }
    const double begin = CpuSeconds();
    const bool placed = LocateBoard(sample.images, views.calibration(), views.board(), sample.hints)
                            .report.accepted;
    locate_s_ += CpuSeconds() - begin;
    ++located_;
    (*tallies)[kDiscs].placed += placed;
    (*tallies)[kTags].placed += seen[0] > 0;
    (*tallies)[kQuickTags].placed += seen[1] > 0;
    for (Tally& tally : *tallies) ++tally.boards;
  }
  double locate_ms() const { return 1e3 * locate_s_ / std::max(located_, 1); }

 private:
  std::string folder_;
  StereoRenderer renderer_;
  TagDetector full_{1.0f}, quick_{2.0f};
  double locate_s_ = 0.0;
  int located_ = 0;
};

/// Largest range up to which the rate stays at or above the share, linear between the samples.
double RangeAt(const std::vector<double>& ranges, const std::vector<double>& rates,
               double percent) {
  double range = 0.0;
  for (std::size_t i = 0; i < ranges.size(); ++i) {
    if (rates[i] >= percent) {
      range = ranges[i];
      continue;
    }
    if (i == 0) return 0.0;
    const double above = rates[i - 1], below = rates[i];
    return ranges[i - 1] + (ranges[i] - ranges[i - 1]) * (above - percent) / (above - below);
  }
  return range;
}

/// Prints the rates; gives the range at 95 % and at 50 %.
std::array<double, 2> PrintRow(const char* name, const std::vector<double>& ranges,
                               const std::vector<double>& rates) {
  std::printf("\n  %-20s", name);
  for (const double rate : rates) std::printf("%5.0f%%", rate);
  const std::array<double, 2> to{RangeAt(ranges, rates, 95.0), RangeAt(ranges, rates, 50.0)};
  std::printf("   95 %% to %4.1f m, 50 %% to %4.1f m", to[0], to[1]);
  return to;
}

void PrintRanges(const std::vector<double>& ranges) {
  std::printf("  %-20s", "range [m]");
  for (const double range : ranges) std::printf("%6.1f", range);
}

using Cells = std::vector<std::array<Tally, 3>>;  // by range

void PrintTable(const std::vector<double>& ranges, const Cells& cells) {
  PrintRanges(ranges);
  std::array<std::array<double, 2>, 3> to;
  for (const bool boards : {false, true}) {
    for (std::size_t d = 0; d < 3; ++d) {
      std::vector<double> rates;
      for (const auto& cell : cells) {
        const Tally& t = cell[d];
        rates.push_back(boards ? Percent(t.placed, t.boards) : Percent(t.found, t.marks));
      }
      const char* name = boards ? kBoardNames[d] : kNames[d];
      const auto here = PrintRow(name, ranges, rates);
      if (!boards) to[d] = here;
    }
  }
  std::printf("\n  fiducials over AprilTag:");
  for (const int at : {1, 0}) {
    const char* share = at == 0 ? "95 %" : "50 %";
    if (to[kTags][at] > 0.0) {
      std::printf(" %.1f times the range at %s;", to[kDiscs][at] / to[kTags][at], share);
    } else {
      std::printf(" AprilTag never at %s;", share);
    }
  }
  std::printf("\n");
}

void Compare(int views, const std::string& folder) {
  const std::vector<double> ranges{1.5, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 14};
  Comparison comparison(folder);
  std::vector<Shared> shared(ranges.size());
  std::array<Tally, 3> all;
  std::printf(
      "%d pairs in each cell, 8 marks in each image; 1024 x 768 px, 90 deg, marks of 10 cm\n",
      views);
  for (const Light light : {Light::kEven, Light::kSpeckled, Light::kHardShadow}) {
    YardViews yard({.light = light, .seed = 43});
    for (const double angle_deg : {0.0, 30.0, 45.0}) {
      Cells cells(ranges.size());
      for (std::size_t r = 0; r < ranges.size(); ++r) {
        for (int i = 0; i < views; ++i) {
          const int key = static_cast<int>(100 * r) + i;
          RandomStream random(StreamKey(static_cast<std::uint64_t>(key), "tags"));
          // The nose turned a little: marks lie at other fractions of a pixel in each view.
          const double alpha = Radians(i % 2 == 0 ? angle_deg : -angle_deg);
          const double h = alpha + Radians(random.Uniform(-8.0, 8.0));
          const YardSample sample =
              yard.TakeAt(key, {ranges[r], alpha, h}, Radians(random.Uniform(-4.0, 4.0)));
          char name[80];
          std::snprintf(name, sizeof name, "%s_%.0fdeg_%.1fm_%d", LightName(light), angle_deg,
                        ranges[r], i);
          comparison.Detect(yard, sample, name, &cells[r], &shared[r]);
        }
        for (std::size_t d = 0; d < 3; ++d) {
          all[d].seconds += cells[r][d].seconds;
          all[d].images += cells[r][d].images;
        }
      }
      std::printf("%s, seen at %.0f deg\n", LightName(light), angle_deg);
      PrintTable(ranges, cells);
      std::fflush(stdout);
    }
  }
  std::printf("centre error, rms, of marks that both found [px]\n");
  PrintRanges(ranges);
  for (const bool tags : {false, true}) {
    std::printf("\n  %-20s", tags ? "AprilTag 36h11" : "fiducials");
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
  std::printf("both images of a pair to the board's pose: %.1f ms of CPU\n",
              comparison.locate_ms());
}

}  // namespace
}  // namespace dockyard::axel

int main(int argc, char** argv) {
  const int views = argc > 1 ? std::atoi(argv[1]) : 4;
  if (views < 1 || views > 100) {
    std::fprintf(stderr, "tag_compare [views for each range, 1 to 100] [folder for the images]\n");
    return 2;
  }
  dockyard::axel::Compare(views, argc > 2 ? argv[2] : "");
  return 0;
}
