#include "sim/soil/rut.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace dockyard {
namespace {

// How far beside the wheel the displaced soil comes to rest, in cells from the rim's edge, and how
// it is shared: a berm about as wide as the rut's wall is high. Assumed, range 1-5 cells, any
// shares that sum to a half.
constexpr std::array<double, 3> kBermCells{1.5, 2.5, 3.5};
constexpr std::array<double, 3> kBermShares{0.25, 0.15, 0.10};  // of each of two sides
// Cells beside the rim, and before and behind the contact, in which slopes may slump: berms lie
// within four of the rim.
constexpr int kSlumpBeside = 6, kSlumpBehind = 3;
// A slope's excess over the friction angle halves in this time: that of a fall through a few
// millimetres. Assumed, range 0.01-0.1 s.
constexpr double kSlumpTime_s = 0.025;
// Share of a slope's excess that slides in one pass at most; simultaneous flow over four edges is
// stable below 1/8.
constexpr double kLargestShare = 0.1;
// Ties, half a cell aside or pressed to the rim's surface, are decided alike on both sides of the
// wheel.
constexpr double kEdgeTolerance_m = 1e-6;

/// Grid samples [x_begin, x_end) x [y_begin, y_end).
struct Window {
  int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;

  int width() const { return x_end - x_begin; }
  int height() const { return y_end - y_begin; }
};

/// The samples around the contact and this many cells more, beside the rim and on the wheel's way.
Window WindowAround(const HeightGrid& grid, const RimPlace& rim, int beside, int behind) {
  const Eigen::Vector3d& a = rim.axis_G;
  const double across = 0.5 * rim.width_m + beside * grid.cell_m;
  const double along = rim.reach_m + behind * grid.cell_m;
  const double extent_x = std::fabs(a.x()) * across + std::fabs(a.y()) * along;
  const double extent_y = std::fabs(a.y()) * across + std::fabs(a.x()) * along;
  const auto range = [&](double low, double high, int samples, int& begin, int& end) {
    const double last = samples;
    begin = static_cast<int>(std::clamp(std::floor(low / grid.cell_m), 0.0, last));
    end = static_cast<int>(std::clamp(std::ceil(high / grid.cell_m) + 1, 0.0, last));
  };
  const double x = rim.p_G.x() - grid.x0_m, y = rim.p_G.y() - grid.y0_m;
  Window window;
  range(x - extent_x, x + extent_x, grid.nx, window.x_begin, window.x_end);
  range(y - extent_y, y + extent_y, grid.ny, window.y_begin, window.y_end);
  return window;
}

/// Whether soil as high as this reaches into the rim, by its place from the rim's centre.
class InsideRim {
 public:
  explicit InsideRim(const RimPlace& rim)
      : a_(rim.axis_G),
        half_m_(0.5 * rim.width_m + kEdgeTolerance_m),
        square_m2_((rim.radius_m + kEdgeTolerance_m) * (rim.radius_m + kEdgeTolerance_m)) {}

  template <typename Real>
  auto operator()(Real dx_m, double dy_m, Real dz_m) const {
    const Real along = dx_m * a_.x() + dz_m * a_.z() + dy_m * a_.y();
    const Real apart = dx_m * dx_m + dz_m * dz_m + (dy_m * dy_m - square_m2_);
    return (Abs(along) <= half_m_) & (apart < along * along);
  }

 private:
  Eigen::Vector3d a_;
  double half_m_, square_m2_;
};

/// The samples whose soil reaches into the rim.
void FindInside(const HeightGrid& grid, const RimPlace& rim, std::vector<GridSample>& inside) {
  inside.clear();
  const Window window = WindowAround(grid, rim, 1, 1);
  const InsideRim is_inside(rim);
  const double x_m = grid.x0_m - rim.p_G.x(), y_m = grid.y0_m - rim.p_G.y(), z_m = rim.p_G.z();
  for (int iy = window.y_begin; iy < window.y_end; ++iy) {
    const double dy_m = y_m + iy * grid.cell_m;
    const double* heights = grid.heights_m.data() + static_cast<std::ptrdiff_t>(iy) * grid.nx;
    ForFours(window.width(), [&]<typename Real>(int i) {
      const int ix = window.x_begin + i;
      const Real dx_m = x_m + grid.cell_m * From<Real>(ix);
      unsigned bits = Bits(is_inside(dx_m, dy_m, Load<Real>(heights + ix) - z_m));
      for (int k = ix; bits != 0; ++k, bits >>= 1) {
        if ((bits & 1) != 0) inside.push_back({k, iy});
      }
    });
  }
}

/// The rim's lower surface above or below points of the ground plan.
template <typename Real>
struct RimAbove {
  Real z_m = 0.0;
  Real axial_m = 0.0;  // its place along the axle
  decltype(Real(0.0) < 0.0) over;

  RimAbove(const RimPlace& rim, Real x_m, Real y_m) {
    const Eigen::Vector3d& a = rim.axis_G;
    const Real dx = x_m - rim.p_G.x(), dy = y_m - rim.p_G.y();
    const Real u0 = dx * a.x() + dy * a.y();
    // |d|^2 - (d.a)^2 = R^2 for d = (dx, dy, dz), lower root.
    const double q = 1.0 - a.z() * a.z(), per_q = 1.0 / q;
    const Real root =
        u0 * u0 * (a.z() * a.z()) - q * (dx * dx + dy * dy - u0 * u0 - rim.radius_m * rim.radius_m);
    const Real dz = (u0 * a.z() - Sqrt(Max(root, Real(0.0)))) * per_q;
    z_m = dz + rim.p_G.z();
    axial_m = u0 + dz * a.z();
    over = (root > 0.0) & (Abs(axial_m) <= 0.5 * rim.width_m + kEdgeTolerance_m);
  }
};

/// Where soil from under the wheel comes to rest.
class Berms {
 public:
  Berms(const HeightGrid& grid, const RimPlace& rim)
      : per_cell_(1.0 / grid.cell_m),
        a_x_(rim.axis_G.x()),
        a_y_(rim.axis_G.y()),
        half_cells_(0.5 * rim.width_m * per_cell_) {}

  /// Moves soil taken from a sample, at this place along the axle, to the berms on both sides.
  void Heap(GridSample from, double axial_m, double height_m, HeightGrid& grid) const {
    const double axial_cells = axial_m * per_cell_;
    for (std::size_t i = 0; i < kBermCells.size(); ++i) {
      const double out = half_cells_ + kBermCells[i];
      for (const double aside : {out - axial_cells, -out - axial_cells}) {
        Add(from.ix + aside * a_x_, from.iy + aside * a_y_, kBermShares[i] * height_m, grid);
      }
    }
  }

 private:
  /// Adds soil at a place in cells, shared by the four samples around it.
  static void Add(double x, double y, double height_m, HeightGrid& grid) {
    const GridCell at = CellAtCells(grid, x, y);
    double* low = grid.heights_m.data() + static_cast<std::ptrdiff_t>(at.iy) * grid.nx + at.ix;
    double* high = low + grid.nx;
    const double above = at.v * height_m, below = height_m - above;
    low[0] += (1.0 - at.u) * below;
    low[1] += at.u * below;
    high[0] += (1.0 - at.u) * above;
    high[1] += at.u * above;
  }

  double per_cell_, a_x_, a_y_, half_cells_;
};

/// Soil slides down between neighbours that differ by more than the slope allows, all at once, so
/// that the order of the samples does not matter.
class Slump {
 public:
  Slump(HeightGrid& grid, const Window& area, double steepest_m, double share, RutScratch& scratch)
      : steepest_m_(steepest_m), share_(share), flows_(scratch.flows) {
    const int width = area.width(), height = area.height();
    double* heights =
        grid.heights_m.data() + static_cast<std::ptrdiff_t>(area.y_begin) * grid.nx + area.x_begin;
    flows_.clear();
    for (int iy = 0; iy < height; ++iy) {
      double* row = heights + static_cast<std::ptrdiff_t>(iy) * grid.nx;
      under_ = scratch.under_wheel.data() + static_cast<std::ptrdiff_t>(iy) * width;
      FindFlows(row, width - 1, 1, 1);
      if (iy + 1 < height) FindFlows(row, width, grid.nx, width);
    }
    for (const SoilFlow& flow : flows_) {
      *flow.from -= flow.moved_m;
      *flow.to += flow.moved_m;
    }
  }

 private:
  /// The flows between samples of one row and their neighbours: `far` samples on in the grid and
  /// `far_under` in what is under the wheel.
  void FindFlows(double* row, int count, int far, int far_under) {
    ForFours(count, [&]<typename Real>(int i) {
      const Real step = Load<Real>(row + i) - Load<Real>(row + i + far);
      unsigned bits = Bits(Abs(step) > steepest_m_);
      for (int k = i; bits != 0; ++k, bits >>= 1) {
        if ((bits & 1) == 0 || (under_[k] | under_[k + far_under]) != 0) continue;
        const double here = row[k] - row[k + far];
        const double moved = std::copysign(share_ * (std::fabs(here) - steepest_m_), here);
        flows_.push_back({row + k, row + k + far, moved});
      }
    });
  }

  double steepest_m_, share_;
  const unsigned char* under_ = nullptr;
  std::vector<SoilFlow>& flows_;
};

}  // namespace

double PressRut(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double excavated_m,
                RutScratch& scratch) {
  FindInside(grid, rim, scratch.inside);
  const Berms berms(grid, rim);
  const double per_elastic = 1.0 / laws.elastic_pa_per_m;
  double taken = 0.0;
  const std::vector<GridSample>& inside = scratch.inside;
  ForFours(static_cast<int>(inside.size()), [&]<typename Real>(int first) {
    const auto gather = [&](const auto& of) {
      return Gather<Real>([&](int k) { return of(inside[first + k]); });
    };
    const auto sample_of = [&](const std::vector<double>& field) {
      return gather(
          [&](GridSample at) { return field[static_cast<std::size_t>(at.iy) * grid.nx + at.ix]; });
    };
    const RimAbove<Real> above(rim,
                               grid.x0_m + grid.cell_m * gather([](GridSample s) { return s.ix; }),
                               grid.y0_m + grid.cell_m * gather([](GridSample s) { return s.iy; }));
    // A heap above the soil as it was carries nothing: the wheel ploughs through it.
    const Real sinkage = sample_of(grid.undisturbed_m) - above.z_m;
    const Real yield = YieldPressure<Real>(laws, sinkage - excavated_m);
    const Real sunk = sample_of(grid.heights_m) - above.z_m - yield * per_elastic;
    unsigned bits = Bits(above.over & (sunk > 0.0));
    for (int k = 0; bits != 0; ++k, bits >>= 1) {
      if ((bits & 1) == 0) continue;
      const GridSample at = inside[first + k];
      const double height_m = Place(sunk, k);
      grid.heights_m[static_cast<std::size_t>(at.iy) * grid.nx + at.ix] -= height_m;
      taken += height_m;
      berms.Heap(at, Place(above.axial_m, k), height_m, grid);
    }
  });
  if (taken > 0.0) ++grid.revision;
  return taken * grid.cell_m * grid.cell_m;
}

void SlumpBeside(HeightGrid& grid, const RimPlace& rim, const SoilLaws& laws, double dt_s,
                 RutScratch& scratch) {
  const Window area = WindowAround(grid, rim, kSlumpBeside, kSlumpBehind);
  const int width = area.width(), height = area.height();
  if (width <= 0 || height <= 0) return;
  scratch.under_wheel.assign(static_cast<std::size_t>(width) * height, 0);
  for (const GridSample& at : scratch.inside) {
    const int ix = at.ix - area.x_begin, iy = at.iy - area.y_begin;
    scratch.under_wheel[static_cast<std::size_t>(iy) * width + ix] = 1;
  }
  // A flow takes twice its share off the step between two samples.
  const double share = std::min(kLargestShare, 0.5 * (1.0 - std::exp2(-dt_s / kSlumpTime_s)));
  Slump(grid, area, laws.tan_phi * grid.cell_m, share, scratch);
  ++grid.revision;
}

}  // namespace dockyard
