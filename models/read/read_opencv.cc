// Cameras in files of OpenCV's FileStorage, under the names that its samples and users give.
#include <optional>

#include "models/read/calibrations.h"
#include "models/read/camera_pose.h"
#include "models/read/config_error.h"
#include "models/read/opencv_storage.h"

namespace dockyard {
namespace {

using Names = std::vector<std::string>;

const Names kMatrix{"camera_matrix", "Camera_Matrix",    "cameraMatrix", "CameraMatrix", "K", "M",
                    "mtx",           "intrinsic_matrix", "intrinsics",   "camMatrix"};
const Names kCoefficients{"distortion_coefficients",
                          "Distortion_Coefficients",
                          "distCoeffs",
                          "distortionCoefficients",
                          "dist_coeffs",
                          "dist_coeff",
                          "distortion",
                          "dist",
                          "D"};
const Names kTurn{"R", "rotation_matrix", "rotation", "Rot", "stereo_R"};
const Names kShift{"T", "translation_vector", "translation", "Trans", "t", "stereo_T"};

/// The same names of the left (0) or right (1) camera of a pair.
Names OfSide(const Names& names, int side) {
  const char* endings[2][6] = {{"1", "_1", "L", "_left", "Left", "_l"},
                               {"2", "_2", "R", "_right", "Right", "_r"}};
  const char* beginnings[2][2] = {{"left_", "l_"}, {"right_", "r_"}};
  Names all;
  for (const std::string& name : names) {
    for (const char* end : endings[side]) all.push_back(name + end);
    for (const char* begin : beginnings[side]) all.push_back(begin + name);
  }
  return all;
}

std::optional<NumberGrid> OpenCvGrid(const YamlNode& root, const Names& names) {
  std::string key;
  const YamlNode* node = FindFirst(root, names, &key);
  return node && node->kind != YamlNode::Kind::kNull ? std::optional(ReadGrid(*node, key))
                                                     : std::nullopt;
}

void OpenCvSize(const YamlNode& root, Camera& camera) {
  const std::pair<const char*, const char*> pairs[] = {{"image_width", "image_height"},
                                                       {"image_Width", "image_Height"},
                                                       {"imageWidth", "imageHeight"},
                                                       {"img_width", "img_height"},
                                                       {"width", "height"}};
  for (const auto& [width, height] : pairs) {
    const YamlNode *w = root.Find(width), *h = root.Find(height);
    if (!w || !h) continue;
    camera.width = PixelCount(*w, width);
    camera.height = PixelCount(*h, height);
    return;
  }
  std::string key;
  const YamlNode* size = FindFirst(
      root, {"image_size", "imageSize", "img_size", "frame_size", "image_resolution", "size"},
      &key);
  if (!size) {
    throw ConfigError(
        root.place.Text() +
        ": missing keys 'image_width' and 'image_height': OpenCV's programs may leave "
        "them out, write them into the file");
  }
  if (size->kind != YamlNode::Kind::kSequence || size->items.size() != 2) {
    RefuseNode(*size, key, "a list of 2, width and height");
  }
  camera.width = PixelCount(size->items[0], key);
  camera.height = PixelCount(size->items[1], key);
}

bool IsFisheye(const YamlNode& root) {
  const YamlNode* flag = FindFirst(root, {"fisheye_model", "fisheye", "is_fisheye"});
  if (flag) return flag->scalar == "1" || flag->scalar == "true";
  const YamlNode* model = FindFirst(root, {"distortion_model", "camera_model", "model_type"});
  return model && (model->scalar == "fisheye" || model->scalar == "equidistant");
}

Lens OpenCvLens(const YamlNode& root, const FocalNumbers& focal, const NumberGrid* d,
                const std::optional<NumberGrid>& xi) {
  if (!xi) return IsFisheye(root) ? FisheyeOf(focal, d) : PinholeOf(focal, d);
  xi->RequireCount(1);
  if (!(xi->values[0] >= 0.0 && xi->values[0] <= 100.0)) xi->Refuse(0, "a number from 0 to 100");
  return OmniOf(focal, xi->values[0], d);
}

Camera OpenCvCamera(const YamlNode& root, const NumberGrid& K, const Names& coefficients,
                    const Names& xi) {
  Camera camera;
  OpenCvSize(root, camera);
  const std::optional<NumberGrid> d = OpenCvGrid(root, coefficients);
  camera.lens = OpenCvLens(root, ReadFocalMatrix(K), d ? &*d : nullptr, OpenCvGrid(root, xi));
  return camera;
}

/// The right camera in the left one, from x_right = R x_left + T.
Pose3 OpenCvRight(const YamlNode& root) {
  const std::optional<NumberGrid> R = OpenCvGrid(root, kTurn), T = OpenCvGrid(root, kShift);
  if (!R || !T) {
    throw ConfigError(
        root.place.Text() + ": missing key '" + (R ? "T" : "R") +
        "' of the pair, from the left camera to the right one; stereo_calib writes it "
        "to extrinsics.yml: give both files, LEFT,RIGHT");
  }
  R->RequireShape(3, 3);
  T->RequireCount(3);
  return Inverse(Pose3{NearestRotation(R->matrix<3, 3>(), R->Place()),
                       Eigen::Vector3d(T->values[0], T->values[1], T->values[2])});
}

}  // namespace

bool HasOpenCvCamera(const YamlNode& root) {
  const auto matrix = [&](const Names& names) {
    const YamlNode* node = FindFirst(root, names);
    return node && node->kind != YamlNode::Kind::kScalar && node->kind != YamlNode::Kind::kNull;
  };
  return matrix(kMatrix) || (matrix(OfSide(kMatrix, 0)) && matrix(OfSide(kMatrix, 1)));
}

YamlNode MergedOpenCvFiles(const YamlNode& one, const YamlNode& other) {
  YamlNode merged = HasOpenCvCamera(one) ? one : other;
  const YamlNode& more = HasOpenCvCamera(one) ? other : one;
  for (std::size_t i = 0; i < more.keys.size(); ++i) {
    if (merged.Find(more.keys[i].name)) continue;
    merged.keys.push_back(more.keys[i]);
    merged.items.push_back(more.items[i]);
  }
  return merged;
}

std::vector<PlacedCamera> ReadOpenCvCameras(const YamlNode& root) {
  const std::optional<NumberGrid> left = OpenCvGrid(root, OfSide(kMatrix, 0)),
                                  right = OpenCvGrid(root, OfSide(kMatrix, 1));
  if (!left || !right) {
    const std::optional<NumberGrid> K = OpenCvGrid(root, kMatrix);
    if (!K) throw ConfigError(root.place.Text() + ": missing key 'camera_matrix'");
    return {{.name = "",
             .camera = OpenCvCamera(root, *K, kCoefficients, {"xi"}),
             .X_FC = {},
             .X_PC = {}}};
  }
  return {{.name = "left",
           .camera = OpenCvCamera(root, *left, OfSide(kCoefficients, 0), OfSide({"xi"}, 0)),
           .X_FC = {},
           .X_PC = {}},
          {.name = "right",
           .camera = OpenCvCamera(root, *right, OfSide(kCoefficients, 1), OfSide({"xi"}, 1)),
           .X_FC = OpenCvRight(root),
           .X_PC = {}}};
}

}  // namespace dockyard
