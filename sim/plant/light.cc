#include "sim/plant/light.h"

#include <cmath>

#include "render/blackbody.h"
#include "sim/base/random.h"
#include "sim/plant/opacity.h"
#include "sim/scenario/sun_date.h"
#include "sim/scenario/sun_path.h"

namespace dockyard {
namespace {

/// A frame at p whose z axis points at the sun and whose x axis is level.
Pose3 FacingSun(const Eigen::Vector3d& p, const Eigen::Vector3d& to_sun) {
  Pose3 X;
  X.R.col(2) = to_sun;
  const Eigen::Vector3d level = Eigen::Vector3d::UnitZ().cross(to_sun);
  X.R.col(0) = level.norm() > 1e-6 ? level.normalized() : Eigen::Vector3d::UnitY();
  X.R.col(1) = to_sun.cross(X.R.col(0));
  X.p = p;
  return X;
}

void AddBox(RenderMesh& mesh, const Pose3& X_OB, const Eigen::Vector3d& half) {
  static constexpr int kFaces[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                                       {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
  const auto base = static_cast<std::uint32_t>(mesh.vertices.size());
  for (int corner = 0; corner < 8; ++corner) {
    const Eigen::Vector3d p((corner & 1) ? half.x() : -half.x(),
                            (corner & 2) ? half.y() : -half.y(),
                            (corner & 4) ? half.z() : -half.z());
    mesh.vertices.push_back((X_OB * p).cast<float>());
  }
  for (const auto& f : kFaces) {
    mesh.triangles.push_back({base + f[0], base + f[1], base + f[2]});
    mesh.triangles.push_back({base + f[0], base + f[2], base + f[3]});
  }
}

SceneObject Object(RenderMesh mesh, const Pose3& X_WO, double albedo) {
  return {std::make_shared<const RenderMesh>(std::move(mesh)), X_WO,
          Eigen::Vector3d::Constant(albedo)};
}

/// Of a lit room: from lamps and walls on all sides.
Lighting Room() {
  Lighting lit;
  lit.sun_and_sky.sun_irradiance = 0.0;
  lit.sun_and_sky.sky_irradiance = 1.8;  // as much as even light has in all; the camera exposes
  return lit;
}

/// Broken shade: leaves of a sparse crown, strewn over a disc across the sun's direction.
RenderMesh Leaves(RandomStream& random) {
  // assumed: crown 2.4 m across, leaf clusters of 4-12 cm, a third of the light held back
  constexpr int kLeaves = 260;
  constexpr double kCrownRadius = 1.2, kCrownDepth = 0.5;
  RenderMesh mesh;
  for (int i = 0; i < kLeaves; ++i) {
    const double radius = kCrownRadius * std::sqrt(random.Uniform());
    const double angle = random.Uniform(0.0, 2.0 * kPi);
    const double size = random.Uniform(0.02, 0.06);
    Pose3 X;
    // One after the other: compilers differ in which factor they draw first.
    const double tilt = random.Uniform(-0.8, 0.8);
    const double turn = random.Uniform(0.0, 2.0 * kPi);
    X.R = RotZ(turn) * RotX(tilt);
    X.p = Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle),
                          random.Uniform(-kCrownDepth, kCrownDepth));
    AddBox(mesh, X, {size, 0.7 * size, 0.002});
  }
  return mesh;
}

/// Direction to the sun in the level dock frame: the dock's, turned upright. Azimuth counts from
/// its x axis, where the target faces. The sun is where the file puts it, else where the draw for
/// this kind of light puts it.
Eigen::Vector3d Wanted(const SunModel& sun, double azimuth_rad, double elevation_rad) {
  return DirectionOf(std::isnan(sun.azimuth_rad) ? azimuth_rad : sun.azimuth_rad,
                     std::isnan(sun.elevation_rad) ? elevation_rad : sun.elevation_rad);
}

Lighting Even(RandomStream& random, const SunModel& sun) {
  Lighting lit;
  const double azimuth = Radians(random.Uniform(-50.0, 50.0));
  const double elevation = Radians(random.Uniform(45.0, 60.0));
  lit.sun_and_sky.to_sun_W = Wanted(sun, azimuth, elevation);
  // assumed: thin cloud, direct to diffuse about 1 : 1 (range 0.5-2)
  lit.sun_and_sky.sun_irradiance = 1.0;
  lit.sun_and_sky.sky_irradiance = 0.8;
  return lit;
}

Lighting Speckled(RandomStream& random, const Eigen::Vector3d& p_LB, const SunModel& sun) {
  Lighting lit;
  const double side = random.Uniform() < 0.5 ? -1.0 : 1.0;
  const double azimuth = side * Radians(random.Uniform(25.0, 45.0));
  const double elevation = Radians(random.Uniform(48.0, 58.0));
  const Eigen::Vector3d to_sun = Wanted(sun, azimuth, elevation);
  lit.sun_and_sky.to_sun_W = to_sun;
  // assumed: clear desert sky, direct to diffuse 3 : 1 under a crown that scatters (range 2-5)
  lit.sun_and_sky.sun_irradiance = 1.2;
  lit.sun_and_sky.sky_irradiance = 0.45;
  // The crown hangs 4.5 m up the sun's direction from the board: leaf shadows blur over 4 cm.
  const double distance = 4.5;
  lit.occluders.push_back(
      Object(Leaves(random), FacingSun(p_LB + distance * to_sun, to_sun), 0.12));
  lit.leaves = true;
  return lit;
}

/// The dock's ground in the level dock frame.
struct Ground {
  Eigen::Vector3d normal{0, 0, 1};
  double HeightAt(const Eigen::Vector3d& p) const {
    return -(normal.x() * p.x() + normal.y() * p.y()) / normal.z();
  }
};

Lighting HardShadow(RandomStream& random, const Eigen::Vector3d& p_LB, const Ground& ground,
                    const SunModel& sun) {
  Lighting lit;
  const double side = random.Uniform() < 0.5 ? -1.0 : 1.0;
  const double azimuth = side * Radians(random.Uniform(45.0, 65.0));
  const double elevation = Radians(random.Uniform(30.0, 45.0));
  const Eigen::Vector3d to_sun = Wanted(sun, azimuth, elevation);
  lit.sun_and_sky.to_sun_W = to_sun;
  // assumed: clear desert sky, direct to diffuse on a surface facing the sun 6 : 1 (range 4-9)
  lit.sun_and_sky.sun_irradiance = 1.3;
  lit.sun_and_sky.sky_irradiance = 0.22;
  // A mast with an equipment panel stands sunward of the station. The panel's slanting edge runs
  // across the board's front; where it crosses is drawn for each run.
  const double distance = random.Uniform(1.6, 2.4);
  const Pose3 X_DP = FacingSun(p_LB + distance * to_sun, to_sun);
  const double slant = random.Uniform(-0.5, 0.5);
  const double edge = random.Uniform(-0.22, 0.22);
  RenderMesh mesh;
  constexpr double kHalfWidth = 0.7;  // of the panel [m]; assumed, range 0.4-1
  Pose3 X_PB;
  X_PB.R = RotZ(slant);
  X_PB.p = X_PB.R * Eigen::Vector3d(side * (kHalfWidth + edge), 0.25, 0.0);
  AddBox(mesh, X_PB, {kHalfWidth, 0.75, 0.01});
  lit.occluders.push_back(Object(std::move(mesh), X_DP, 0.35));
  // Its mast, from the panel's middle to the ground.
  const Eigen::Vector3d p_top = X_DP * X_PB.p;
  RenderMesh mast;
  const double foot_m = ground.HeightAt(p_top), half_m = 0.5 * (p_top.z() - foot_m);
  AddBox(mast, Pose3::Translation(0.0, 0.0, half_m), {0.025, 0.025, half_m});
  lit.occluders.push_back(
      Object(std::move(mast), Pose3::Translation(p_top.x(), p_top.y(), foot_m), 0.3));
  return lit;
}

/// What the file asks of the light whatever its kind. The sun's direction is in a level frame.
void FollowFile(const SunModel& sun, SunAndSky& light) {
  if (sun.temperature_k > 0.0) light.sun_rgb = BlackbodyRgb(sun.temperature_k);
  if (sun.sky_temperature_k > 0.0) light.sky_rgb = BlackbodyRgb(sun.sky_temperature_k);
  light.stray = {
      .veil = sun.stray.veil, .core_rad = sun.stray.core_rad, .ghosts = sun.stray.ghosts};
  light.opacity = sun.opacity;
  if (std::isnan(sun.opacity)) return;
  const AirLight air = LightThroughAir(sun.opacity, std::asin(light.to_sun_W.z()));
  light.sun_irradiance = kOutsideIrradiance * air.sun;
  light.sky_irradiance = kOutsideIrradiance * air.sky;
}

/// The frame D turned upright about its origin, heading kept.
Pose3 TurnedUpright(const Pose3& X_WD) {
  return {RotZ(std::atan2(X_WD.R(1, 0), X_WD.R(0, 0))), X_WD.p};
}

}  // namespace

void AddSurroundings(const Lighting& lighting, std::vector<SceneObject>& objects) {
  for (const SceneryObject& thing : lighting.scenery) objects.push_back(thing.object);
  objects.insert(objects.end(), lighting.occluders.begin(), lighting.occluders.end());
}

Lighting MakeLighting(Light light, const Pose3& X_WD, const Eigen::Vector3d& p_DB, const Seed& seed,
                      const SunModel& asked) {
  const SunModel sun = PlacedByDate(asked);
  RandomStream random(StreamKey(seed, "light"));
  // On level ground D stands upright as it is, to the bit.
  const bool level = X_WD.R(2, 0) == 0.0 && X_WD.R(2, 1) == 0.0;
  const Pose3 X_WL = level ? X_WD : TurnedUpright(X_WD);
  const Eigen::Matrix3d R_LD =
      level ? Eigen::Matrix3d(Eigen::Matrix3d::Identity()) : X_WL.R.transpose() * X_WD.R;
  const Eigen::Vector3d p_LB = R_LD * p_DB;
  const Ground ground{R_LD.col(2)};
  Lighting lit;
  switch (light) {
    case Light::kEven:
      lit = Even(random, sun);
      break;
    case Light::kSpeckled:
      lit = Speckled(random, p_LB, sun);
      break;
    case Light::kHardShadow:
      lit = HardShadow(random, p_LB, ground, sun);
      break;
    case Light::kRoom:
      lit = Room();
      break;
  }
  FollowFile(sun, lit.sun_and_sky);
  // Made in the level dock frame, placed in the world.
  if (sun.moving) lit.to_pole_W = X_WL.R * NorthPole(sun, lit.sun_and_sky.to_sun_W);
  lit.sun_and_sky.to_sun_W = X_WL.R * lit.sun_and_sky.to_sun_W;
  for (SceneObject& occluder : lit.occluders) occluder.X_WO = X_WL * occluder.X_WO;
  return lit;
}

}  // namespace dockyard
