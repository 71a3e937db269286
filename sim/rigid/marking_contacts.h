// Points of bodies that leave marks in soil: holes where they press, furrows where they are
// dragged.
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

#include "models/parts/soil_model.h"
#include "sim/rigid/ground_contact.h"
#include "sim/soil/moved_soil.h"
#include "sim/soil/soil_laws.h"

namespace dockyard {

/// Each point bears like a round plate. It sinks by Bekker's law from the soil as it was, and the
/// ground keeps its depth but for the elastic rebound. A heap above the soil as it was carries
/// nothing, as for wheels. Friction is that of ground_contact.h. A point that is dragged along
/// pushes the soil ahead of it too: the wall from its plate up to the soil as it was, or to the
/// floor of a rut or a furrow there, resists as a wheel's side does (docs/reference/soil.md). The
/// displaced soil becomes a heap about it, and slumps where that is too steep.
class MarkingContacts {
 public:
  /// soils: by the ground's numbers.
  explicit MarkingContacts(const std::vector<SoilModel>& soils) : soils_(soils) {}

  /// A point that bears like a plate of this diameter. The material's stiffness gives in series
  /// with the soil's rebound. Returns the point's number.
  std::size_t Add(const GroundMaterial& material, double diameter_m);

  /// Force of the ground on the point at p_G that moves with v_G; advances it by one step and
  /// leaves its mark.
  Eigen::Vector3d Step(HeightGrid& ground, std::size_t point, const Eigen::Vector3d& p_G,
                       const Eigen::Vector3d& v_G, double dt_s);
  /// Slopes about the marks slump. Once in each step, after all points.
  void Slump(HeightGrid& ground, double dt_s);

  std::uint64_t StateHash(std::uint64_t seed) const;

 private:
  struct Laws {
    SinkingPlate plate;
    SoilLaws wall;
  };
  struct Point {
    GroundMaterial material;
    double radius_m = 0.0;
    std::vector<Laws> laws;  // by the ground's numbers
    GroundPoint grip;
    Mobilisation push{};    // of the wall's resistance, along x and y of G
    RoundArea mark;         // where it was last in the soil
    double friction = 0.0;  // tan(phi) there
    bool presses = false;   // in the last step
    bool marks = false;     // it has displaced soil since it came down
    bool slumps = false;    // and that is not at rest yet
  };
  static void Release(Point& point);
  Eigen::Vector3d WallForce(const HeightGrid& ground, const Laws& laws, double sunk_m,
                            const Eigen::Vector3d& slide_G, Point& point) const;

  std::vector<SoilModel> soils_;
  std::vector<Point> points_;
  std::vector<RoundArea> held_;
  double since_slump_s_ = 0.0;
};

}  // namespace dockyard
