#include "sim/log/ros_markers.h"

#include "sim/log/ros_messages.h"

namespace dockyard {
namespace {

constexpr std::int32_t kTriangleList = 11;  // of visualization_msgs/Marker

struct MarkerOfPoints {
  std::string name;
  std::int32_t id = 0, type = kLineStrip;
  Eigen::Vector3d scale{1.0, 1.0, 1.0}, rgb{0.0, 0.0, 0.0};
};

/// visualization_msgs/Marker in the world
void PutMarker(CdrWriter& out, Tick tick, const MarkerOfPoints& marker,
               const std::vector<Eigen::Vector3d>& points_W) {
  constexpr std::int32_t kAdd = 0;
  PutHeader(out, tick, kWorldFrame);
  out.Text(marker.name);
  out.I32(marker.id);
  out.I32(marker.type);
  out.I32(kAdd);
  PutPose(out, {});
  PutVector(out, marker.scale);
  for (int i = 0; i < 3; ++i) out.Float(static_cast<float>(marker.rgb(i)));
  out.Float(1.0f);
  out.I32(0);  // for ever
  out.U32(0);
  out.Bool(false);
  out.Count(points_W.size());
  for (const Eigen::Vector3d& point : points_W) PutVector(out, point);
  out.Count(0);  // colours of the points
  out.Text("");  // texture
  PutHeader(out, 0, "");
  out.Text("");
  out.Bytes("");
  out.Count(0);
  for (int i = 0; i < 3; ++i) out.Text("");  // text, mesh, the mesh's file
  out.Bytes("");
  out.Bool(false);
}

}  // namespace

void PutTriangles(CdrWriter& out, Tick tick, const std::string& name, int id,
                  const std::vector<Eigen::Vector3d>& corners_W, const Eigen::Vector3d& rgb) {
  PutMarker(out, tick, {.name = name, .id = id, .type = kTriangleList, .rgb = rgb}, corners_W);
}

std::string SolidsMessage(Tick tick, const StageSolids& solids) {
  CdrWriter out;
  out.Count(1);
  PutTriangles(out, tick, solids.name, 0, *solids.corners_W, solids.rgb);
  return out.Take();
}

std::string LinesMessage(Tick tick, const std::vector<StageLine>& lines) {
  CdrWriter out;
  out.Count(lines.size());
  std::int32_t id = 0;
  for (const StageLine& line : lines) {
    PutMarker(
        out, tick,
        {.name = line.name, .id = id++, .scale = {line.diameter_m, 0.0, 0.0}, .rgb = line.rgb},
        line.points_W);
  }
  return out.Take();
}

}  // namespace dockyard
