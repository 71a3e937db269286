#include "render/gauss_blur.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <vector>

#include "controller/base/two_widths.h"

namespace dockyard {
namespace {

std::vector<float> GaussianKernel(double sigma) {
  const int radius = std::max(1, static_cast<int>(std::ceil(4.0 * sigma)));
  std::vector<double> weights(2 * radius + 1);
  double sum = 0.0;
  for (int i = -radius; i <= radius; ++i) {
    // The Gaussian's share of each pixel, so that narrow blurs keep their width.
    const double root2 = std::sqrt(2.0) * sigma;
    sum += weights[i + radius] = std::erf((i + 0.5) / root2) - std::erf((i - 0.5) / root2);
  }
  std::vector<float> kernel;
  for (const double w : weights) kernel.push_back(static_cast<float>(w / sum));
  return kernel;
}

// out[x] = sum of kernel[k] * rows[k][x], as many x at once as registers hold.
DOCKYARD_TWO_WIDTHS
void Weigh(const std::vector<const float*>& rows, const std::vector<float>& kernel, int count,
           float* __restrict out) {
  constexpr int kAtOnce = 16;
  const auto block = [&](int x, auto width) {
    float sum[kAtOnce] = {};
    for (std::size_t k = 0; k < kernel.size(); ++k) {
      const float weight = kernel[k];
      const float* from = rows[k] + x;
      for (int i = 0; i < width; ++i) sum[i] += weight * from[i];
    }
    std::copy(sum, sum + width, out + x);
  };
  int x = 0;
  for (; x + kAtOnce <= count; x += kAtOnce) block(x, std::integral_constant<int, kAtOnce>());
  for (; x < count; ++x) block(x, std::integral_constant<int, 1>());
}

}  // namespace

void Blur(double sigma, RadianceImage& image) {
  if (sigma == 0.0) return;
  const std::vector<float> kernel = GaussianKernel(sigma);
  const int radius = static_cast<int>(kernel.size() / 2), w = image.width, h = image.height;
  std::vector<float> padded(w + 2 * radius), out(image.values.size());
  std::vector<const float*> rows(kernel.size());
  for (std::size_t k = 0; k < kernel.size(); ++k) rows[k] = padded.data() + k;
  for (int y = 0; y < h; ++y) {  // along the rows, in place
    float* row = &image.values[static_cast<std::size_t>(y) * w];
    std::fill(padded.begin(), padded.begin() + radius, row[0]);
    std::copy(row, row + w, padded.begin() + radius);
    std::fill(padded.end() - radius, padded.end(), row[w - 1]);
    Weigh(rows, kernel, w, row);
  }
  for (int y = 0; y < h; ++y) {  // down the columns
    for (int k = -radius; k <= radius; ++k) {
      rows[k + radius] = &image.values[static_cast<std::size_t>(std::clamp(y + k, 0, h - 1)) * w];
    }
    Weigh(rows, kernel, w, &out[static_cast<std::size_t>(y) * w]);
  }
  image.values = std::move(out);
}

}  // namespace dockyard
