#include "controller/vision/board/layout_namings.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"
#include "controller/vision/board/detected_marks.h"
#include "controller/vision/board/pose_gates.h"
#include "controller/vision/homography.h"
#include "controller/vision/p3p.h"

namespace dockyard {
namespace {

constexpr std::size_t kSeeds = 60;    // detections that are tried as a first disc, best ones first
constexpr std::size_t kNearSeen = 6;  // detections about it, of which two are taken
constexpr std::size_t kNearPrinted =
    14;  // marks about a mark: two rings of a grid, and some missing
// The ellipse's map against the true one over one pitch: perspective at 45 deg and two pitches away
// changes lengths by a third and angles by 20 deg.
constexpr double kLengthTolerance = 1.5, kTurnTolerance = 30.0 * kPi / 180.0;
constexpr double kLeastSine = 0.3;    // of the angle between the two neighbours
constexpr int kRounds = 3;            // of fits by homography
constexpr std::size_t kKept = 40;     // namings
constexpr int kMostTriples = 25000;   // compared in one image; 2 s for a board of 44 not found
constexpr double kLargeShare = 0.75;  // of the marks, in a naming whose discs are not tried again

/// A neighbour of the first disc, and its place relative to it on the board.
struct Beside {
  int index = -1;
  Eigen::Vector2d way_m;
};

std::vector<Beside> Nearest(std::vector<Beside> all, std::size_t count) {
  std::stable_sort(all.begin(), all.end(), [](const Beside& a, const Beside& b) {
    return a.way_m.squaredNorm() < b.way_m.squaredNorm();
  });
  if (all.size() > count) all.resize(count);
  return all;
}

std::vector<Beside> SeenBeside(const DetectedMarks& marks, std::size_t seed) {
  std::vector<Beside> all;
  const SeenMark& from = marks.seen[seed];
  for (std::size_t i = 0; i < marks.seen.size(); ++i) {
    const double ratio = marks.seen[i].radius_px / from.radius_px;
    if (i == seed || ratio > 2.0 || ratio < 0.5 || !from.board_by_T.allFinite()) continue;
    all.push_back({static_cast<int>(i), from.board_by_T * (marks.seen[i].at_T - from.at_T)});
  }
  return Nearest(std::move(all), kNearSeen);
}

std::vector<std::vector<Beside>> PrintedBeside(const FiducialBoard& board) {
  std::vector<std::vector<Beside>> beside;
  for (std::size_t i = 0; i < board.fiducials.size(); ++i) {
    std::vector<Beside> all;
    for (std::size_t k = 0; k < board.fiducials.size(); ++k) {
      if (k == i) continue;
      all.push_back({static_cast<int>(k), board.fiducials[k].p_BF - board.fiducials[i].p_BF});
    }
    beside.push_back(Nearest(std::move(all), kNearPrinted));
  }
  return beside;
}

bool LengthsAgree(const Beside& seen, const Beside& printed) {
  const double ratio = seen.way_m.norm() / printed.way_m.norm();
  return ratio < kLengthTolerance && ratio > 1.0 / kLengthTolerance;
}

bool TurnsAgree(const Beside& seen_a, const Beside& seen_b, const Beside& a, const Beside& b) {
  const auto turn = [](const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    return std::atan2(Cross(from, to), from.dot(to));
  };
  return std::abs(turn(seen_a.way_m, seen_b.way_m) - turn(a.way_m, b.way_m)) < kTurnTolerance;
}

bool OnALine(const Beside& a, const Beside& b) {
  return Cross(a.way_m, b.way_m) < kLeastSine * a.way_m.norm() * b.way_m.norm();
}

const Eigen::Vector2d kUnseen(std::nan(""), std::nan(""));

double RadiusPx(const Camera& camera, const FiducialBoard& board, const Pose3& X_CB,
                const Eigen::Vector3d& p_C) {
  const double slant = std::max(X_CB.R.col(2).dot(p_C.normalized()), 0.05);
  return 0.5 * board.disc_diameter_m * camera.focal_px().x() / p_C.norm() * std::sqrt(slant);
}

Naming NameByPose(const DetectedMarks& marks, const Camera& camera, const FiducialBoard& board,
                  const Pose3& X_CB) {
  std::vector<Eigen::Vector2d> places;
  std::vector<double> radii;
  for (const Fiducial& mark : board.fiducials) {
    const Eigen::Vector3d p_C = X_CB * Eigen::Vector3d(mark.p_BF.x(), mark.p_BF.y(), 0.0);
    radii.push_back(RadiusPx(camera, board, X_CB, p_C));
    places.push_back(p_C.z() > 0.0 ? marks.plane.FromRay(p_C.normalized()) : kUnseen);
  }
  return NameBy(marks, places, radii);
}

/// The naming, with the marks that a homography through it adds.
Naming Grown(const DetectedMarks& marks, const FiducialBoard& board, Naming naming) {
  for (int round = 0; round < kRounds && naming.size() >= 4; ++round) {
    std::vector<PlanePair> pairs;
    for (const MarkMatch& match : naming) {
      pairs.push_back({.board = board.fiducials[static_cast<std::size_t>(match.id)].p_BF,
                       .image = marks.seen[static_cast<std::size_t>(match.detection)].at_T});
    }
    const auto H = FitHomography(pairs);
    if (!H) break;
    std::vector<Eigen::Vector2d> places;
    for (const Fiducial& mark : board.fiducials) {
      places.push_back(Map(*H, mark.p_BF).value_or(kUnseen));
    }
    Naming wider = NameBy(marks, places, std::vector<double>(places.size(), 0.0));
    if (wider.size() <= naming.size()) break;
    naming = std::move(wider);
  }
  return naming;
}

struct Search {
  const DetectedMarks& marks;
  const Camera& camera;
  const FiducialBoard& board;
  const Eigen::Vector3d& up_C;
  std::vector<std::vector<Beside>> printed;
  std::vector<Naming> found;
  int triples = 0;
};

/// Whether a disc at this point of the board would be as large as the one seen.
bool SizeFits(const SeenMark& seen, const Search& search, const Pose3& X_CB,
              const Eigen::Vector3d& p_B) {
  const double ratio = seen.radius_px / RadiusPx(search.camera, search.board, X_CB, X_CB * p_B);
  return ratio < kDiscSizeTolerance && ratio > 1.0 / kDiscSizeTolerance;
}

/// Takes the seed and two neighbours for a mark and two of its neighbours.
void TryTriple(Search& search, std::size_t seed, const Beside& a, const Beside& b, std::size_t mark,
               const Beside& mark_a, const Beside& mark_b) {
  const auto point = [&](std::size_t id) {
    const Eigen::Vector2d& p = search.board.fiducials[id].p_BF;
    return Eigen::Vector3d(p.x(), p.y(), 0.0);
  };
  const auto sight = [&](std::size_t i) { return search.marks.seen[i].sight_C; };
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const auto poses =
      PosesFromThreePoints({point(mark), point(at(mark_a.index)), point(at(mark_b.index))},
                           {sight(seed), sight(at(a.index)), sight(at(b.index))});
  for (const Pose3& X_CB : poses) {
    if (!ShowsItsFace(X_CB) || !IsUpright(X_CB, search.board.upright, Pose3{}, search.up_C) ||
        !SizeFits(search.marks.seen[seed], search, X_CB, point(mark))) {
      continue;
    }
    const Naming naming = Grown(search.marks, search.board,
                                NameByPose(search.marks, search.camera, search.board, X_CB));
    if (static_cast<int>(naming.size()) < MarksNeeded(search.board)) continue;
    if (std::ranges::find(search.found, naming) == search.found.end()) {
      search.found.push_back(naming);
    }
  }
}

void TrySeed(Search& search, std::size_t seed) {
  const std::vector<Beside> seen = SeenBeside(search.marks, seed);
  for (const Beside& a : seen) {
    for (const Beside& b : seen) {
      if (OnALine(a, b)) continue;  // the same beside itself, too; each pair in one order only
      for (std::size_t mark = 0; mark < search.printed.size(); ++mark) {
        for (const Beside& mark_a : search.printed[mark]) {
          if (!LengthsAgree(a, mark_a)) continue;
          for (const Beside& mark_b : search.printed[mark]) {
            if (!LengthsAgree(b, mark_b) || OnALine(mark_a, mark_b) ||
                !TurnsAgree(a, b, mark_a, mark_b)) {
              continue;
            }
            if (++search.triples > kMostTriples) return;
            TryTriple(search, seed, a, b, mark, mark_a, mark_b);
          }
        }
      }
    }
  }
}

}  // namespace

std::vector<std::vector<MarkMatch>> NamingsByLayout(const std::vector<DetectedFiducial>& detections,
                                                    const Camera& camera,
                                                    const FiducialBoard& board,
                                                    const Eigen::Vector3d& up_C) {
  const DetectedMarks marks = MarksOf(detections, camera, board);
  Search search{marks, camera, board, up_C, PrintedBeside(board), {}, 0};
  for (std::size_t seed = 0; seed < std::min(kSeeds, detections.size()); ++seed) {
    // A disc of a large naming would give that naming and its rivals again. A small naming may be
    // false.
    const bool named = std::any_of(search.found.begin(), search.found.end(), [&](const Naming& n) {
      if (n.size() < kLargeShare * static_cast<double>(board.fiducials.size())) return false;
      return std::any_of(n.begin(), n.end(),
                         [&](const MarkMatch& m) { return m.detection == static_cast<int>(seed); });
    });
    if (!named) TrySeed(search, seed);
  }
  std::stable_sort(search.found.begin(), search.found.end(),
                   [](const Naming& a, const Naming& b) { return a.size() > b.size(); });
  if (search.found.size() > kKept) search.found.resize(kKept);
  return search.found;
}

}  // namespace dockyard
