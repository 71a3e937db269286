#include "sim/rigid/rocks.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "controller/base/split_mix.h"
#include "sim/base/random.h"

namespace dockyard {
namespace {

// Corners of a rock; assumed, 12-30.
constexpr int kCorners = 18;
// They are at least this far apart on the unit sphere [rad]; assumed, 0.3-0.5.
constexpr double kApart = 0.42;
// Width over length; assumed, 0.6-1.
constexpr double kNarrowest = 0.7;
// Top and bottom are cut flat at this share of the ellipsoid's half height, with three corners or
// more each; assumed, 0.5-0.8.
constexpr double kFlat = 0.6;
constexpr int kFlatCorners = 3;
// Standard deviation of a top's tilt; assumed, 0-15 deg.
constexpr double kTilt_rad = 0.14;

// Places drawn for one rock before the field counts as full.
constexpr int kTries = 2000;

double Steepness(double cover) { return 1.79 + 0.152 / cover; }

bool HasTopAndBottom(const std::vector<Eigen::Vector3d>& directions) {
  const auto Beyond = [&](double side) {
    return std::count_if(directions.begin(), directions.end(),
                         [&](const Eigen::Vector3d& d) { return side * d.z() > kFlat; });
  };
  return Beyond(1.0) >= kFlatCorners && Beyond(-1.0) >= kFlatCorners;
}

std::vector<Eigen::Vector3d> SpreadDirections(RandomStream& random) {
  std::vector<Eigen::Vector3d> directions;
  while (directions.size() < kCorners || !HasTopAndBottom(directions)) {
    if (directions.size() == kCorners) directions.clear();
    const double z = random.Uniform(-1.0, 1.0), angle = random.Uniform(-kPi, kPi);
    const double r = std::sqrt(1.0 - z * z);
    const Eigen::Vector3d d(r * std::cos(angle), r * std::sin(angle), z);
    const bool apart = std::all_of(directions.begin(), directions.end(), [&](const auto& other) {
      return d.dot(other) < std::cos(kApart);
    });
    if (apart) directions.push_back(d);
  }
  return directions;
}

// Diameters whose number per area falls as exp(-q D) / D^2.
double DrawDiameter(const RockField& field, RandomStream& random) {
  const double few = 1.0 / field.largest_m, many = 1.0 / field.least_m;
  const double q = Steepness(field.cover);
  while (true) {
    const double diameter_m = 1.0 / random.Uniform(few, many);
    if (random.Uniform() < std::exp(-q * (diameter_m - field.least_m))) return diameter_m;
  }
}

// The number of a Poisson process on the area, by the gaps between its events.
int DrawCount(double mean, RandomStream& random) {
  int count = 0;
  for (double at = -std::log(1.0 - random.Uniform()); at < mean; ++count) {
    at -= std::log(1.0 - random.Uniform());
  }
  return count;
}

bool Overlaps(const std::vector<Rock>& rocks, const Eigen::Vector2d& p_D, double diameter_m) {
  return std::any_of(rocks.begin(), rocks.end(), [&](const Rock& rock) {
    const double least_m = 0.5 * (rock.size.diameter_m + diameter_m);
    return (rock.p_D - p_D).squaredNorm() < least_m * least_m;
  });
}

ConvexBody AtPlace(const ConvexBody& shape, const Eigen::Vector2d& p_D, double turn_rad) {
  return Pose3{RotZ(turn_rad), Eigen::Vector3d(p_D.x(), p_D.y(), 0.0)} * shape;
}

void AddField(const RockField& field, const GroundArea& area,
              const std::vector<Eigen::Vector2d>& clear_D, std::uint64_t key,
              std::vector<Rock>& rocks) {
  RandomStream random(key);
  const double area_m2 = (area.x_to_m - area.x_from_m) * (area.y_to_m - area.y_from_m);
  const double mean = area_m2 * RocksPerArea(field.cover, field.least_m, field.largest_m);
  if (mean > kMostRocks) throw std::length_error("too many rocks");
  std::vector<RockSize> sizes(static_cast<std::size_t>(DrawCount(mean, random)));
  for (RockSize& size : sizes) {
    size.diameter_m = DrawDiameter(field, random);
    size.height_m = size.diameter_m * random.Uniform(field.flattest, field.steepest);
  }
  std::stable_sort(sizes.begin(), sizes.end(), [](const RockSize& a, const RockSize& b) {
    return a.diameter_m > b.diameter_m;
  });
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    Rock rock{.p_D = {0, 0}, .size = sizes[i], .given = false, .body = {}};
    int tries = 0;
    do {
      if (++tries > kTries) throw std::length_error("the rocks do not fit");
      const double x = random.Uniform(area.x_from_m, area.x_to_m);
      rock.p_D = {x, random.Uniform(area.y_from_m, area.y_to_m)};
    } while (Overlaps(rocks, rock.p_D, rock.size.diameter_m));
    const double tilt_rad = kTilt_rad * random.Normal(), turn_rad = random.Uniform(-kPi, kPi);
    rock.body = AtPlace(RockShape(rock.size, field.buried, tilt_rad, SplitMix(key, i + 1)),
                        rock.p_D, turn_rad);
    rocks.push_back(std::move(rock));
  }
  std::erase_if(rocks, [&](const Rock& rock) {
    return !rock.given && std::any_of(clear_D.begin(), clear_D.end(), [&](const auto& p_D) {
      return (rock.p_D - p_D).norm() < field.clear_m + 0.5 * rock.size.diameter_m;
    });
  });
}

}  // namespace

double RocksPerArea(double cover, double least_m, double largest_m) {
  if (cover <= 0.0 || least_m >= largest_m) return 0.0;
  // A cover of -dF goes by circles of pi/4 D^2: the integral of 4 k q exp(-q D) / (pi D^2), over
  // 1/D by Simpson's rule.
  constexpr int kPieces = 200;
  const double q = Steepness(cover);
  const double from = 1.0 / largest_m, width = (1.0 / least_m - from) / kPieces;
  double sum = 0.0;
  for (int i = 0; i <= kPieces; ++i) {
    const double weight = i == 0 || i == kPieces ? 1.0 : (i % 2 == 1 ? 4.0 : 2.0);
    sum += weight * std::exp(-q / (from + i * width));
  }
  return 4.0 * cover * q / kPi * sum * width / 3.0;
}

ConvexBody RockShape(const RockSize& size, double buried, double tilt_rad, std::uint64_t key) {
  RandomStream random(key);
  const double narrow = random.Uniform(kNarrowest, 1.0);
  std::vector<Eigen::Vector3d> points = SpreadDirections(random);
  const Eigen::Matrix3d tilt = RotY(tilt_rad);
  Eigen::Vector3d low(1e9, 1e9, 1e9), high = -low;
  for (Eigen::Vector3d& p : points) {
    p = tilt * Eigen::Vector3d(p.x(), narrow * p.y(), std::clamp(p.z(), -kFlat, kFlat));
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  const Eigen::Vector3d extent = high - low, middle = 0.5 * (low + high);
  const double across = size.diameter_m / (0.5 * (extent.x() + extent.y()));
  const double upright = size.height_m / (1.0 - buried) / extent.z();
  for (Eigen::Vector3d& p : points) {
    p = Eigen::Vector3d(across * (p.x() - middle.x()), across * (p.y() - middle.y()),
                        size.height_m - upright * (high.z() - p.z()));
  }
  return HullOf(points);
}

std::vector<Rock> PlaceRocks(const RockField& field, const GroundArea& area,
                             const std::vector<Eigen::Vector2d>& clear_D, std::uint64_t key) {
  std::vector<Rock> rocks;
  const std::uint64_t shapes = SplitMix(key, 0);
  for (const GivenRock& given : field.given) {
    const RockSize size{given.diameter_m, given.height_m};
    const Eigen::Vector2d p_D(given.x_m, given.y_m);
    const ConvexBody shape = RockShape(size, field.buried, 0.0, SplitMix(shapes, rocks.size()));
    rocks.push_back({p_D, size, true, AtPlace(shape, p_D, given.turn_rad)});
  }
  if (field.cover > 0.0) AddField(field, area, clear_D, key, rocks);
  return rocks;
}

}  // namespace dockyard
