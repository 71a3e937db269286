#include "render/blackbody.h"

#include "controller/base/check.h"
#include "render/shading.h"

namespace dockyard {

Eigen::Vector2d BlackbodyChromaticity(double t) {
  DOCKYARD_CHECK(t >= 1667.0 && t <= 25000.0);
  const double u = 1e3 / t;
  const double x = t < 4000.0 ? ((-0.2661239 * u - 0.2343589) * u + 0.8776956) * u + 0.179910
                              : ((-3.0258469 * u + 2.1070379) * u + 0.2226347) * u + 0.240390;
  double y = ((3.0817580 * x - 5.87338670) * x + 3.75112997) * x - 0.37001483;
  if (t < 2222.0) {
    y = ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683;
  } else if (t < 4000.0) {
    y = ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
  }
  return {x, y};
}

Eigen::Vector3d BlackbodyRgb(double temperature_k) {
  const Eigen::Vector2d xy = BlackbodyChromaticity(temperature_k);
  const Eigen::Vector3d XYZ(xy.x() / xy.y(), 1.0, (1.0 - xy.x() - xy.y()) / xy.y());
  Eigen::Matrix3d rgb_from_XYZ;  // IEC 61966-2-1
  rgb_from_XYZ << 3.2406, -1.5372, -0.4986, -0.9689, 1.8758, 0.0415, 0.0557, -0.2040, 1.0570;
  const Eigen::Vector3d rgb = (rgb_from_XYZ * XYZ).cwiseMax(0.0);
  return rgb / Luminance(rgb);
}

}  // namespace dockyard
