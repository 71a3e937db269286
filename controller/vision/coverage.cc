#include "controller/vision/coverage.h"

#include <algorithm>
#include <cmath>

#include "controller/geometry/pose.h"

namespace dockyard {
namespace {

/// Weights at -n .. n. A narrow Gaussian has three, with its variance.
std::vector<float> Kernel(double sigma) {
  if (sigma < 0.6) {
    const auto side = static_cast<float>(0.5 * sigma * sigma);
    return {side, 1.0f - 2.0f * side, side};
  }
  const int n = static_cast<int>(std::ceil(3.0 * sigma));
  std::vector<float> weights;
  float sum = 0.0f;
  for (int i = -n; i <= n; ++i) {
    weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
    sum += weights.back();
  }
  for (float& w : weights) w /= sum;
  return weights;
}

}  // namespace

ConvexPolygon HullOf(ConvexPolygon points) {
  if (points.count < 3) return {};
  const auto end = points.corners.begin() + points.count;
  std::sort(points.corners.begin(), end, [](const auto& a, const auto& b) {
    return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
  });
  ConvexPolygon hull;
  const auto last = [&](int back) {
    return hull.corners[static_cast<std::size_t>(hull.count - back)];
  };
  for (int side = 0; side < 2; ++side) {
    const int first = hull.count;
    for (auto p = points.corners.begin(); p != end; ++p) {
      while (hull.count >= first + 2 && Cross(last(1) - last(2), *p - last(1)) <= 0.0) {
        --hull.count;
      }
      hull.Add(*p);
    }
    --hull.count;
    std::reverse(points.corners.begin(), end);
  }
  return hull;
}

void Coverage::Reset(int width, int height) {
  width_ = width;
  height_ = height;
  sums_.assign(static_cast<std::size_t>(width + 2) * static_cast<std::size_t>(height), 0.0f);
}

void Coverage::Add(const ConvexPolygon& polygon) {
  double area = 0.0;
  const auto at = [&](int i) {
    return polygon.corners[static_cast<std::size_t>(i % polygon.count)];
  };
  for (int i = 0; i < polygon.count; ++i) area += Cross(at(i), at(i + 1));
  // An edge that goes down takes what lies right of it away in one sense of turning.
  const double sign = area > 0.0 ? -1.0 : 1.0;
  for (int i = 0; i < polygon.count; ++i) {
    const Eigen::Vector2d a = at(i), b = at(i + 1);
    if (a.y() < b.y()) AddEdge(a.x(), a.y(), b.x(), b.y(), sign);
    if (b.y() < a.y()) AddEdge(b.x(), b.y(), a.x(), a.y(), -sign);
  }
}

void Coverage::AddEdge(double x0, double y0, double x1, double y1, double sign) {
  const double slope = (x1 - x0) / (y1 - y0);
  const double from = std::max(y0, 0.0), to = std::min(y1, static_cast<double>(height_));
  for (int j = static_cast<int>(from); j < height_ && j < to; ++j) {
    const double ya = std::max(from, static_cast<double>(j)), yb = std::min(to, j + 1.0);
    if (yb <= ya) continue;
    AddSpan(&sums_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_ + 2)],
            x0 + slope * (ya - y0), x0 + slope * (yb - y0), sign * (yb - ya));
  }
}

// Right of the edge the cells have dy more; those that it crosses, the share right of it. Written
// as differences from cell to cell.
void Coverage::AddSpan(float* row, double xa, double xb, double dy) {
  const double most = width_;
  const double left = std::clamp(std::min(xa, xb), 0.0, most);
  const double right = std::clamp(std::max(xa, xb), 0.0, most);
  const int first = static_cast<int>(left), last = static_cast<int>(right);
  if (first == last || right - left < 1e-9) {
    const double inside = 0.5 * (left + right) - first;
    row[first] += static_cast<float>(dy * (1.0 - inside));
    row[first + 1] += static_cast<float>(dy * inside);
    return;
  }
  const double per_cell = dy / (right - left);
  double before = 0.0;  // share of the cell before this one
  for (int i = first; i <= last; ++i) {
    // Mean over the cell of the share of the edge that lies left of the point.
    const double a = std::max(left, static_cast<double>(i)), b = std::min(right, i + 1.0);
    const double share = (0.5 * (b - a) * ((a - left) + (b - left)) +
                          std::max(0.0, i + 1.0 - right) * (right - left)) *
                         per_cell;
    row[i] += static_cast<float>(share - before);
    before = share;
  }
  row[last + 1] += static_cast<float>(dy - before);
}

void Coverage::Finish() {
  values_.resize(static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  for (int j = 0; j < height_; ++j) {
    const float* in = &sums_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_ + 2)];
    float* out = &values_[static_cast<std::size_t>(j) * static_cast<std::size_t>(width_)];
    float sum = 0.0f;
    for (int i = 0; i < width_; ++i) {
      sum += in[i];
      out[i] = std::min(std::max(sum, 0.0f), 1.0f);
    }
  }
}

void BlurShares(int width, int height, double sigma_cells, std::vector<float>* values) {
  if (sigma_cells <= 0.0) return;
  const std::vector<float> kernel = Kernel(sigma_cells);
  const int n = static_cast<int>(kernel.size()) / 2;
  const auto w = static_cast<std::size_t>(width);
  std::vector<float> padded(w + 2 * static_cast<std::size_t>(n));
  for (int j = 0; j < height; ++j) {
    float* row = values->data() + static_cast<std::size_t>(j) * w;
    std::fill(padded.begin(), padded.begin() + n, row[0]);
    std::copy(row, row + width, padded.begin() + n);
    std::fill(padded.begin() + n + width, padded.end(), row[width - 1]);
    std::fill(row, row + width, 0.0f);
    for (int k = 0; k <= 2 * n; ++k) {
      const float weight = kernel[static_cast<std::size_t>(k)];
      const float* from = padded.data() + k;
      for (int i = 0; i < width; ++i) row[i] += weight * from[i];
    }
  }
  const std::vector<float> in = *values;
  std::fill(values->begin(), values->end(), 0.0f);
  for (int j = 0; j < height; ++j) {
    float* out = values->data() + static_cast<std::size_t>(j) * w;
    for (int k = -n; k <= n; ++k) {
      const float weight = kernel[static_cast<std::size_t>(k + n)];
      const float* from =
          in.data() + static_cast<std::size_t>(std::clamp(j + k, 0, height - 1)) * w;
      for (int i = 0; i < width; ++i) out[i] += weight * from[i];
    }
  }
}

}  // namespace dockyard
