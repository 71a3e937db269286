#include "sim/log/ground_log.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

#include "sim/log/ros_markers.h"
#include "sim/log/ros_messages.h"
#include "sim/mcap/cdr.h"

namespace dockyard {
namespace {

std::int16_t Steps(double height_m) {
  return static_cast<std::int16_t>(
      std::clamp(std::round(height_m / GroundLog::kStep_m), -32768.0, 32767.0));
}

/// Samples from one corner of a triangle to the next, at least one.
int Stride(double cell_m, double length_m) {
  return std::max(1, static_cast<int>(std::lround(length_m / cell_m)));
}

}  // namespace

bool GroundLog::Update(const StageGround& ground) {
  if (ground.heights_m == nullptr) return false;
  const std::size_t count = static_cast<std::size_t>(ground.nx) * ground.ny;
  if (!heights_.empty() && ground.revision == grid_.revision) return false;
  all_ = heights_.size() != count;
  grid_ = ground;
  grid_.heights_m = nullptr;
  heights_.resize(count);
  heights_m_.resize(count);
  cells_.clear();
  const std::size_t nx = static_cast<std::size_t>(ground.nx);
  for (std::size_t first = 0; first < count; first += nx) {
    const double* row = ground.heights_m + first;
    // Wheels change few rows; the others need no rounding.
    if (!all_ && std::memcmp(row, &heights_m_[first], nx * sizeof(double)) == 0) continue;
    std::memcpy(&heights_m_[first], row, nx * sizeof(double));
    for (std::size_t i = first; i < first + nx; ++i) {
      const std::int16_t height = Steps(ground.heights_m[i]);
      if (!all_ && height == heights_[i]) continue;
      heights_[i] = height;
      if (!all_) cells_.push_back(static_cast<std::uint32_t>(i));
    }
  }
  return all_ || !cells_.empty();
}

std::string GroundLog::Message(Tick tick) const {
  CdrWriter out;
  PutHeader(out, tick, kGroundFrame);
  for (const double value : {grid_.x0_m, grid_.y0_m, grid_.cell_m}) out.Double(value);
  out.U32(static_cast<std::uint32_t>(grid_.nx));
  out.U32(static_cast<std::uint32_t>(grid_.ny));
  out.Double(kStep_m);
  out.Count(cells_.size());
  for (const std::uint32_t cell : cells_) out.U32(cell);
  const std::size_t count = all_ ? heights_.size() : cells_.size();
  out.Count(count);
  for (std::size_t i = 0; i < count; ++i) {
    out.U16(static_cast<std::uint16_t>(heights_[all_ ? i : cells_[i]]));
  }
  return out.Take();
}

Eigen::Vector3d GroundLog::PointW(int ix, int iy) const {
  const std::size_t at = static_cast<std::size_t>(iy) * grid_.nx + ix;
  return grid_.X_WG * Eigen::Vector3d(grid_.x0_m + ix * grid_.cell_m,
                                      grid_.y0_m + iy * grid_.cell_m, heights_[at] * kStep_m);
}

std::string GroundLog::Markers(Tick tick) const {
  const int stride = Stride(grid_.cell_m, 0.1), tile = stride * Stride(stride * grid_.cell_m, 1.0);
  const int across = (grid_.nx + tile - 1) / tile, along = (grid_.ny + tile - 1) / tile;
  std::set<int> changed;
  for (const std::uint32_t cell : cells_) {
    const int ix = static_cast<int>(cell) % grid_.nx, iy = static_cast<int>(cell) / grid_.nx;
    // A sample on the edge is a corner of two squares.
    for (const int x : {std::max(0, ix - 1) / tile, ix / tile}) {
      for (const int y : {std::max(0, iy - 1) / tile, iy / tile}) changed.insert(y * across + x);
    }
  }
  for (int i = 0; all_ && i < across * along; ++i) changed.insert(i);

  CdrWriter out;
  out.Count(changed.size());
  for (const int id : changed) {
    std::vector<Eigen::Vector3d> corners_W;
    const int x0 = id % across * tile, y0 = id / across * tile;
    for (int y = y0; y < std::min(y0 + tile, grid_.ny - 1); y += stride) {
      for (int x = x0; x < std::min(x0 + tile, grid_.nx - 1); x += stride) {
        const int x1 = std::min(x + stride, grid_.nx - 1), y1 = std::min(y + stride, grid_.ny - 1);
        const Eigen::Vector3d a = PointW(x, y), b = PointW(x1, y), c = PointW(x1, y1),
                              d = PointW(x, y1);
        corners_W.insert(corners_W.end(), {a, b, c, a, c, d});
      }
    }
    PutTriangles(out, tick, "ground", id, corners_W, grid_.rgb);
  }
  return out.Take();
}

}  // namespace dockyard
