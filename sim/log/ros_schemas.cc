#include "sim/log/ros_schemas.h"

#include <algorithm>
#include <map>
#include <sstream>

#include "controller/base/check.h"

namespace dockyard {
namespace {

const std::map<std::string, std::string>& Definitions() {
  static const std::map<std::string, std::string> definitions{
      {"builtin_interfaces/Time", "int32 sec\nuint32 nanosec\n"},
      {"builtin_interfaces/Duration", "int32 sec\nuint32 nanosec\n"},
      {"std_msgs/Header", "builtin_interfaces/Time stamp\nstring frame_id\n"},
      {"std_msgs/ColorRGBA", "float32 r\nfloat32 g\nfloat32 b\nfloat32 a\n"},
      {"geometry_msgs/Vector3", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Point", "float64 x\nfloat64 y\nfloat64 z\n"},
      {"geometry_msgs/Quaternion", "float64 x\nfloat64 y\nfloat64 z\nfloat64 w\n"},
      {"geometry_msgs/Pose",
       "geometry_msgs/Point position\ngeometry_msgs/Quaternion orientation\n"},
      {"geometry_msgs/PoseStamped", "std_msgs/Header header\ngeometry_msgs/Pose pose\n"},
      {"geometry_msgs/PoseWithCovariance", "geometry_msgs/Pose pose\nfloat64[36] covariance\n"},
      {"geometry_msgs/PoseWithCovarianceStamped",
       "std_msgs/Header header\ngeometry_msgs/PoseWithCovariance pose\n"},
      {"geometry_msgs/Transform",
       "geometry_msgs/Vector3 translation\ngeometry_msgs/Quaternion rotation\n"},
      {"geometry_msgs/TransformStamped",
       "std_msgs/Header header\nstring child_frame_id\ngeometry_msgs/Transform transform\n"},
      {"tf2_msgs/TFMessage", "geometry_msgs/TransformStamped[] transforms\n"},
      {"nav_msgs/Path", "std_msgs/Header header\ngeometry_msgs/PoseStamped[] poses\n"},
      {"sensor_msgs/Imu",
       "std_msgs/Header header\ngeometry_msgs/Quaternion orientation\n"
       "float64[9] orientation_covariance\ngeometry_msgs/Vector3 angular_velocity\n"
       "float64[9] angular_velocity_covariance\ngeometry_msgs/Vector3 linear_acceleration\n"
       "float64[9] linear_acceleration_covariance\n"},
      {"sensor_msgs/JointState",
       "std_msgs/Header header\nstring[] name\nfloat64[] position\nfloat64[] velocity\n"
       "float64[] effort\n"},
      {"sensor_msgs/CompressedImage", "std_msgs/Header header\nstring format\nuint8[] data\n"},
      {"sensor_msgs/RegionOfInterest",
       "uint32 x_offset\nuint32 y_offset\nuint32 height\nuint32 width\nbool do_rectify\n"},
      {"sensor_msgs/CameraInfo",
       "std_msgs/Header header\nuint32 height\nuint32 width\nstring distortion_model\n"
       "float64[] d\nfloat64[9] k\nfloat64[9] r\nfloat64[12] p\nuint32 binning_x\n"
       "uint32 binning_y\nsensor_msgs/RegionOfInterest roi\n"},
      {"visualization_msgs/UVCoordinate", "float32 u\nfloat32 v\n"},
      {"visualization_msgs/MeshFile", "string filename\nuint8[] data\n"},
      {"visualization_msgs/Marker",
       "std_msgs/Header header\nstring ns\nint32 id\nint32 type\nint32 action\n"
       "geometry_msgs/Pose pose\ngeometry_msgs/Vector3 scale\nstd_msgs/ColorRGBA color\n"
       "builtin_interfaces/Duration lifetime\nbool frame_locked\ngeometry_msgs/Point[] points\n"
       "std_msgs/ColorRGBA[] colors\nstring texture_resource\n"
       "sensor_msgs/CompressedImage texture\nvisualization_msgs/UVCoordinate[] uv_coordinates\n"
       "string text\nstring mesh_resource\nvisualization_msgs/MeshFile mesh_file\n"
       "bool mesh_use_embedded_materials\n"},
      {"visualization_msgs/MarkerArray", "visualization_msgs/Marker[] markers\n"},
      {"rcl_interfaces/Log",
       "builtin_interfaces/Time stamp\nuint8 level\nstring name\nstring msg\nstring file\n"
       "string function\nuint32 line\n"},
      // One control period of the controller, every bit of it: docs/reference/run_log.md.
      {"dockyard_msgs/Frame", "builtin_interfaces/Time stamp\nuint8[] data\n"},
      {"dockyard_msgs/MotorCommand",
       "uint8 FREE=0\nuint8 BRAKE=1\nuint8 VELOCITY=2\nuint8 POSITION=3\nuint8 mode\n"
       "float64 target\nfloat64 speed_limit\nfloat64 acceleration\nfloat64 current_limit\n"},
      {"dockyard_msgs/Commands",
       "uint8 UNDER_WAY=0\nuint8 DOCKED=1\nuint8 GIVEN_UP=2\nbuiltin_interfaces/Time stamp\n"
       "dockyard_msgs/MotorCommand[] motors\nint32[] take_images\nuint8[] switches\n"
       "uint8 verdict\n"},
      {"dockyard_msgs/Scalars",
       "builtin_interfaces/Time stamp\nstring[] names\nfloat64[] values\n"},
      {"dockyard_msgs/Mark", "int32 id\nint32 camera\nfloat64 u_px\nfloat64 v_px\n"},
      {"dockyard_msgs/Sighting",
       "builtin_interfaces/Time stamp\nbool accepted\nstring reason\nstring method\n"
       "int32[] detected\ndockyard_msgs/Mark[] marks\ndockyard_msgs/Mark[] predicted\n"
       "float64 reprojection_px\ngeometry_msgs/Pose target_in_robot\n"
       "float64[36] covariance\nfloat64[3] robot_in_dock_true\n"
       "float64[3] robot_in_dock_measured\n"},
      {"dockyard_msgs/Ground",
       "std_msgs/Header header\nfloat64 x0\nfloat64 y0\nfloat64 cell\nuint32 nx\nuint32 ny\n"
       "float64 step\nuint32[] cells\nint16[] heights\n"}};
  return definitions;
}

const std::string& DefinitionOf(const std::string& type) {
  const auto found = Definitions().find(type);
  DOCKYARD_CHECK(found != Definitions().end());
  return found->second;
}

/// Adds the types that the type's fields have, and theirs.
void AddParts(const std::string& type, std::vector<std::string>& types) {
  std::istringstream lines(DefinitionOf(type));
  for (std::string line; std::getline(lines, line);) {
    const std::string part = line.substr(0, line.find_first_of(" ["));
    const bool message = part.find('/') != std::string::npos;
    if (!message || std::find(types.begin(), types.end(), part) != types.end()) continue;
    types.push_back(part);
    AddParts(part, types);
  }
}

}  // namespace

std::string RosSchema(const std::string& type) {
  std::vector<std::string> parts;
  AddParts(type, parts);
  std::string text = DefinitionOf(type);
  for (const std::string& part : parts) {
    text += std::string(80, '=') + "\nMSG: " + part + "\n" + DefinitionOf(part);
  }
  return text;
}

std::string RosSchemaName(const std::string& type) {
  const std::size_t slash = type.find('/');
  return type.substr(0, slash) + "/msg/" + type.substr(slash + 1);
}

}  // namespace dockyard
