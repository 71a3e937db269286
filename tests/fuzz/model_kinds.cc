// Models in YAML, cameras in JSON, and URDF.
#include <memory>

#include "fuzz/kind.h"
#include "models/read/urdf.h"
#include "models/read/urdf_weld.h"
#include "sim/app/check_file.h"
#include "sim/app/systems.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

/// Axel's folder with its station's files beside it, so that either may be read there. Its meshes
/// are one triangle each: those that do not change cost time alone.
struct ModelFolder {
  ScratchFolder folder;
  std::vector<System> systems = Systems();
  MeshStore meshes;

  ModelFolder() {
    for (const char* model : {"axel", "soils", "cameras", "boards", "wheels"}) {
      folder.CopyModel(model);
    }
    const std::filesystem::path axel = folder.path() / "models/axel";
    std::filesystem::copy(axel / "station", axel,
                          std::filesystem::copy_options::recursive |
                              std::filesystem::copy_options::overwrite_existing);
    for (const auto& mesh : std::filesystem::directory_iterator(axel / "meshes")) {
      const auto name = std::filesystem::relative(mesh.path(), folder.path()).string();
      folder.Write(name, "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nf 1 2 3\n");
    }
  }
};

std::vector<std::string> Words() {
  return {"nan",  ".inf",  "1e308", "-1",    "0",         "null",    "{",       "}",
          "[",    "]",     "- ",    ": ",    "wheels",    "station", "cone",    "board",
          "left", "right", "model", "k_phi", "fiducials", "cameras", "changes", "in_rover"};
}

FuzzKind ModelKind() {
  const auto models = std::make_shared<ModelFolder>();
  std::vector<std::string> seeds;
  for (const char* name :
       {"axel/axel.yaml", "axel/station/station.yaml", "soils/loose_sand.yaml",
        "wheels/pavlov_grouser.yaml", "boards/five_discs.yaml", "boards/asymmetric_4x11.yaml",
        "cameras/navcam.yaml", "cameras/axel_640.yaml"}) {
    seeds.push_back(Slurp(SourceFile(std::string("models/") + name)));
  }
  return {"model", [seeds] { return seeds; }, Words(),
          [models](const std::string& bytes) {
            const std::string file = models->folder.Write("models/axel/fuzzed.yaml", bytes);
            return ReadOrRefused([&] { CheckFile(file, models->systems); });
          }};
}

FuzzKind CamerasKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  return {"cameras",
          [] { return std::vector{Slurp(SourceFile("tests/models/data/m2020_cameras.json"))}; },
          {"\"C\"", "\"A\"", "\"H\"", "\"V\"", "\"O\"", "\"R\"", "\"E\"", "1e308", "-1", "0"},
          [folder](const std::string& bytes) {
            const std::string file = folder->Write("fuzzed.json", bytes);
            return ReadOrRefused([&] { CheckFile(file, {}); });
          }};
}

constexpr const char* kSmallRos =
    "image_width: 64\nimage_height: 48\ncamera_matrix:\n  rows: 3\n  cols: 3\n"
    "  data: [62., 0., 32., 0., 62., 24., 0., 0., 1.]\ndistortion_model: rational_polynomial\n"
    "distortion_coefficients:\n  rows: 1\n  cols: 8\n  data: [0.5, -2.6, 0, 0, 1.4, 0.4, -2.4, "
    "1.4]\n"
    "projection_matrix: {rows: 3, cols: 4, data: [60, 0, 32, -7, 0, 60, 24, 0, 0, 0, 1, 0]}\n"
    "binning_x: 2\nroi: {x_offset: 4, y_offset: 4, width: 32, height: 32}\n";
constexpr const char* kSmallChain =
    "cam0: {camera_model: ds, intrinsics: [-0.2, 0.6, 30, 30, 32, 24], distortion_model: none,\n"
    "  resolution: [64, 48]}\ncam1:\n  camera_model: omni\n  intrinsics: [1.4, 60, 60, 32, 24]\n"
    "  distortion_model: radtan\n  distortion_coeffs: [-0.1, 0.01, 0, 0]\n  resolution: [64, 48]\n"
    "  T_cn_cnm1: [[1, 0, 0, -0.1], [0, 1, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]\n";
constexpr const char* kSmallStorage =
    "<?xml version=\"1.0\"?>\n<opencv_storage>\n<image_size>64 48</image_size>\n"
    "<M1 type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt>\n"
    "<data>62. 0. 32. 0. 62. 24. 0. 0. 1.</data></M1>\n"
    "<M2><rows>3</rows><cols>3</cols><data>62. 0. 32. 0. 62. 24. 0. 0. 1.</data></M2>\n"
    "<D1><rows>1</rows><cols>4</cols><data>0.1 0 0 0</data></D1>\n<R><_>1 0 0</_><_>0 1 0</_>"
    "<_>0 0 1</_></R><T>-0.1 0 0</T>\n</opencv_storage>\n";

/// Of ROS, Kalibr and OpenCV.
FuzzKind CalibrationKind() {
  const auto folder = std::make_shared<ScratchFolder>();
  return {"calibration",
          [] {
            return std::vector<std::string>{kSmallRos, kSmallChain, kSmallStorage};
          },
          {"nan", "1e308", "-1", "0", "rows", "cols", "data", "eucm", "fov", "pinhole",
           "equidistant", "<_>", "</_>", "<!--", "16384", "!!opencv-matrix", "%YAML:1.0", "---"},
          [folder](const std::string& bytes) {
            const std::string file = folder->Write("fuzzed.yaml", bytes);
            return ReadOrRefused([&] { CheckFile(file, {}); });
          }};
}

constexpr const char* kSmallUrdf = R"(<robot name="a"><link name="b">
<inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial>
<collision><geometry><sphere radius="1"/></geometry></collision></link><link name="c"/>
<joint name="d" type="fixed"><parent link="b"/><child link="c"/><origin xyz="0 0 1" rpy="0 0 1"/>
</joint></robot>)";

/// By itself, and as the rover's, whose links are welded to its known ones.
FuzzKind UrdfKind() {
  const auto models = std::make_shared<ModelFolder>();
  const std::string rover = (models->folder.path() / "models/axel/axel.yaml").string();
  const std::string file = (models->folder.path() / "models/axel/axel.urdf").string();
  return {"urdf",
          [] {
            return std::vector{Slurp(SourceFile("models/axel/axel.urdf")),
                               Slurp(SourceFile("models/axel/station/station.urdf")),
                               std::string(kSmallUrdf)};
          },
          {"<link name=\"",
           "<joint name=\"",
           "type=\"revolute\"",
           "type=\"fixed\"",
           "<origin ",
           "xyz=\"0 0 0\"",
           "rpy=\"0 0 0\"",
           "<inertial>",
           "<mass value=\"",
           "<box size=\"1 1 1\"/>",
           "<mesh filename=\"",
           "<cylinder radius=\"1\" length=\"1\"/>",
           "<limit ",
           "<mimic ",
           "nan",
           "1e308",
           "<!--",
           "-->",
           "<![CDATA[",
           "]]>",
           "&amp;",
           "&#x41;",
           "</robot>"},
          [models, rover, file](const std::string& bytes) {
            models->folder.Write("models/axel/axel.urdf", bytes);
            const bool alone = ReadOrRefused([&] {
              const UrdfModel model = LoadUrdf(file, &models->meshes);
              for (const LinkModel& link : model.links) CarrierOf(model, link.name);
            });
            const bool used = ReadOrRefused([&] { CheckFile(rover, models->systems); });
            return alone || used;
          }};
}

}  // namespace

std::vector<NamedKind> ModelKinds() {
  return {{"model", ModelKind},
          {"cameras", CamerasKind},
          {"calibration", CalibrationKind},
          {"urdf", UrdfKind}};
}

}  // namespace dockyard
