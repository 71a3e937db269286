#include "sim/rigid/plate_contacts.h"

#include <algorithm>
#include <limits>

namespace dockyard {
namespace {

// Whether a face of `of` has all of `other` outside.
bool HasFaceBetween(const ConvexBody& of, const ConvexBody& other) {
  return std::any_of(of.faces.begin(), of.faces.end(), [&](const HalfSpace& face) {
    return std::all_of(other.vertices.begin(), other.vertices.end(),
                       [&](const auto& p) { return face.normal.dot(p) > face.offset_m; });
  });
}

bool AreApart(const ConvexBody& stone, const ConvexBody& plate) {
  const double reach_m = stone.radius_m + plate.radius_m;
  return (stone.centre - plate.centre).squaredNorm() > reach_m * reach_m ||
         HasFaceBetween(plate, stone) || HasFaceBetween(stone, plate);
}

// A corner of the stone in the plate; the face by which it leaves.
const HalfSpace* WayOut(const std::vector<const HalfSpace*>& towards, const ConvexBody& plate,
                        const Eigen::Vector3d& corner, double& depth_m) {
  if (DistanceTo(plate, corner).distance_m >= 0.0) return nullptr;
  const HalfSpace* way = nullptr;
  depth_m = std::numeric_limits<double>::infinity();
  for (const HalfSpace* face : towards) {
    const double here_m = face->offset_m - face->normal.dot(corner);
    if (here_m >= depth_m) continue;
    depth_m = here_m;
    way = face;
  }
  return way;
}

}  // namespace

void AddPlateContacts(const ConvexBody& stone, const ConvexBody& plate,
                      std::vector<BodyContact>& contacts) {
  if (AreApart(stone, plate)) return;
  int feature = 0;
  for (const auto& edge : plate.edges) {
    AddEdgeContacts(stone, plate.vertices[edge[0]], plate.vertices[edge[1]], feature, contacts);
    feature += 2;
  }
  std::vector<const HalfSpace*> towards;
  for (const HalfSpace& face : plate.faces) {
    if (face.normal.dot(stone.centre) > face.offset_m) towards.push_back(&face);
  }
  for (const Eigen::Vector3d& corner : stone.vertices) {
    double depth_m = 0.0;
    if (const HalfSpace* out = WayOut(towards, plate, corner, depth_m)) {
      contacts.push_back({feature, corner, -out->normal, depth_m, 1.0});
    }
    ++feature;
  }
}

}  // namespace dockyard
