#include "render/scene_painter.h"

#include <algorithm>
#include <cmath>

#include "render/board_plate.h"
#include "render/ground_sectors.h"
#include "render/shaders.h"

namespace dockyard {
namespace {

constexpr double kNear_m = 0.02, kFar_m = 400.0;
Eigen::Matrix4d ToMatrix(const Pose3& X) {
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.topLeftCorner<3, 3>() = X.R;
  m.topRightCorner<3, 1>() = X.p;
  return m;
}

// Camera frame to GL's clip space; the view's top goes to GL's row 0.
Eigen::Matrix4d ClipFromCamera(const TanRect& r) {
  Eigen::Matrix4d clip = Eigen::Matrix4d::Zero();
  clip(0, 0) = 2.0 / (r.right - r.left);
  clip(0, 2) = -(r.right + r.left) / (r.right - r.left);
  clip(1, 1) = 2.0 / (r.bottom - r.top);
  clip(1, 2) = -(r.bottom + r.top) / (r.bottom - r.top);
  clip(2, 2) = (kFar_m + kNear_m) / (kFar_m - kNear_m);
  clip(2, 3) = -2.0 * kFar_m * kNear_m / (kFar_m - kNear_m);
  clip(3, 2) = 1.0;
  return clip;
}

bool MayShow(const TanRect& r, const Eigen::Vector3d& center_C, double radius) {
  const auto inside = [&](double a, double b, double c) {
    return Eigen::Vector3d(a, b, c).normalized().dot(center_C) > -radius;
  };
  return center_C.z() > -radius && inside(1, 0, -r.left) && inside(-1, 0, r.right) &&
         inside(0, 1, -r.top) && inside(0, -1, r.bottom);
}

bool HasBoard(const Scene& scene) {
  return scene.board.board.width_m > 0.0 && scene.board.board.height_m > 0.0;
}

Ball BoardBall(const Scene& scene) {
  const FiducialBoard& board = scene.board.board;
  return {scene.board.X_WB.p, 0.5 * std::hypot(board.width_m, board.height_m)};
}

}  // namespace

// One view being painted.
struct ScenePainter::Frustum {
  Pose3 X_WC, X_CW;
  TanRect rect;
  int width = 0, height = 0;
  Eigen::Matrix4d clip_from_C;
};

ScenePainter::ScenePainter(const GlFunctions& gl)
    : gl_(gl),
      shadow_map_(gl),
      object_(gl, SurfaceVertexShader(), ObjectFragmentShader()),
      ground_(gl, PlainVertexShader(), GroundFragmentShader()),
      board_(gl, PlainVertexShader(), BoardFragmentShader()),
      thin_(gl, SurfaceVertexShader(), ThinFragmentShader()),
      ground_mesh_(gl),
      board_mesh_(gl),
      tether_mesh_(gl),
      empty_mesh_(gl) {
  empty_mesh_.Upload(SurfaceMesh{});
}

void ScenePainter::Prepare(const Scene& scene, const Pose3& X_WR) {
  scene_ = &scene;
  X_WP_ = {Eigen::Matrix3d::Identity(), X_WR.p};
  UploadObjects(scene);
  if (HasBoard(scene)) board_mesh_.Upload(BoardPlate(scene.board));
  if (HasGround(scene.ground)) UploadGround(scene, X_WR);
  const Ball board = HasBoard(scene) ? BoardBall(scene) : Ball{X_WR.p, 0.5};
  fit_ = FitShadow(Casters(scene), board, X_WR, scene.light.to_sun_W);
  empty_mesh_.Bind();
  shadow_map_.Render(
      fit_, scene.light.sun_angular_diameter_rad,
      [&](GlProgram& program, const Eigen::Matrix4d& clip_from_U, const ShadowWindow& window) {
        DrawCasters(program, clip_from_U, window);
      },
      shadow_);
  if (HasBoard(scene)) {
    const Pose3 X_UB = Inverse(fit_.X_WU) * scene.board.X_WB;
    shadow_.TakePlane(X_UB.p, X_UB.R.col(2));
  }
}

std::vector<Ball> ScenePainter::Casters(const Scene& scene) const {
  std::vector<Ball> casters;
  for (const SceneObject& object : scene.objects) {
    const Ball& ball = cache_.at(object.mesh.get()).ball;
    casters.push_back({object.X_WO * ball.center, ball.radius});
  }
  if (HasBoard(scene)) casters.push_back(BoardBall(scene));
  for (const Eigen::Vector3d& p : scene.tether.points_W) {
    casters.push_back({p, 0.5 * scene.tether.diameter_m});
  }
  return casters;
}

SurfaceMesh ScenePainter::TetherTube(const std::function<double(const Eigen::Vector3d&)>& drawn) {
  std::vector<Eigen::Vector3d> points_P;
  for (const Eigen::Vector3d& p : scene_->tether.points_W) points_P.push_back(p - X_WP_.p);
  return Tube(points_P, 0.5 * scene_->tether.diameter_m, drawn);
}

void ScenePainter::DrawCasters(GlProgram& program, const Eigen::Matrix4d& clip_from_U,
                               const ShadowWindow& window) {
  const Pose3 X_UW = Inverse(fit_.X_WU);
  const auto place = [&](const Pose3& X_WO) {
    program.Set("u_clip_from_object", Eigen::Matrix4d(clip_from_U * ToMatrix(X_UW * X_WO)));
  };
  for (const SceneObject& object : scene_->objects) {
    const Cached& cached = cache_.at(object.mesh.get());
    const Eigen::Vector3d p_U = X_UW * (object.X_WO * cached.ball.center);
    const Eigen::Vector2d off = (p_U.head<2>() - window.center_m).cwiseAbs();
    if (off.maxCoeff() > window.half_m + cached.ball.radius) continue;
    place(object.X_WO);
    cached.buffers->Draw();
  }
  if (HasBoard(*scene_)) {
    place(scene_->board.X_WB);
    board_mesh_.Draw();
  }
  // Thinner than a texel, the tether would flicker along its length.
  const double least = 0.6 * window.texel_m();
  tether_mesh_.Upload(TetherTube([&](const Eigen::Vector3d&) { return least; }));
  place(X_WP_);
  tether_mesh_.Draw();
}

void ScenePainter::Pose(GlProgram& program, const Frustum& frustum, const Pose3& X_WO) const {
  program.Set("u_clip_from_object",
              Eigen::Matrix4d(frustum.clip_from_C * ToMatrix(frustum.X_CW * X_WO)));
  program.Set("u_light_from_object", ToMatrix(Inverse(fit_.X_WU) * X_WO));
}

void ScenePainter::Paint(const GlViewTarget& target, const Pose3& X_WC, FlatView& view) {
  const Frustum frustum{.X_WC = X_WC,
                        .X_CW = Inverse(X_WC),
                        .rect = view.rect,
                        .width = view.width,
                        .height = view.height,
                        .clip_from_C = ClipFromCamera(view.rect)};
  target.BindSeen();
  gl_.Viewport(0, 0, view.width, view.height);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
  gl_.FrontFace(GL_CW);  // the image is upside down to GL
  gl_.VertexAttrib1f(2, 1.0f);
  constexpr GLuint kSky[4] = {0, 0, 0, 0};
  gl_.ClearBufferuiv(GL_COLOR, 0, kSky);
  gl_.Clear(GL_DEPTH_BUFFER_BIT);
  PaintObjects(frustum);
  if (HasBoard(*scene_)) PaintBoard(frustum);
  if (HasGround(scene_->ground)) PaintGround(frustum);
  view.seen.resize(static_cast<std::size_t>(view.width) * view.height);
  target.Read(view.width, view.height, view.seen.data());
  PaintTether(frustum, target, view);
}

void ScenePainter::PaintObjects(const Frustum& frustum) {
  object_.Use();
  int index = -1;
  for (const SceneObject& object : scene_->objects) {
    ++index;
    const Cached& cached = cache_.at(object.mesh.get());
    const Eigen::Vector3d p_C = frustum.X_CW * (object.X_WO * cached.ball.center);
    if (!MayShow(frustum.rect, p_C, cached.ball.radius)) continue;
    Pose(object_, frustum, object.X_WO);
    object_.Set("u_object", index);
    cached.buffers->Draw();
  }
}

void ScenePainter::PaintBoard(const Frustum& frustum) {
  board_.Use();
  Pose(board_, frustum, scene_->board.X_WB);
  // A plate that is drawn in the board's plane must not shine through.
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(-1.0f, -8.0f);
  board_mesh_.Draw();
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void ScenePainter::PaintGround(const Frustum& frustum) {
  ground_.Use();
  Pose(ground_, frustum, X_WF_);
  const SectorRange range = VisibleSectors(Inverse(X_WF_) * frustum.X_WC, frustum.rect);
  const int per_sector = ground_mesh_.count() / kGroundSectors;
  const auto draw = [&](int from, int to) {
    ground_mesh_.Draw(per_sector * from, per_sector * (to - from));
  };
  const int end = range.first + range.count;
  draw(range.first, std::min(end, kGroundSectors));
  if (end > kGroundSectors) draw(0, end - kGroundSectors);
}

// The pixels that the tether may touch.
bool ScenePainter::FitThin(const Frustum& frustum, FlatView& view) const {
  const Pose3& X_CW = frustum.X_CW;
  const double px = (frustum.rect.right - frustum.rect.left) / frustum.width;
  const double py = (frustum.rect.bottom - frustum.rect.top) / frustum.height;
  Eigen::AlignedBox2d box;
  bool any = false;
  for (const Eigen::Vector3d& p_W : scene_->tether.points_W) {
    const Eigen::Vector3d p_C = X_CW * p_W;
    if (p_C.z() < 2.0 * kNear_m) {  // may come up to the camera: anywhere
      box.extend(Eigen::Vector2d(frustum.rect.left, frustum.rect.top));
      box.extend(Eigen::Vector2d(frustum.rect.right, frustum.rect.bottom));
      continue;
    }
    any = true;
    const Eigen::Vector2d tan = p_C.head<2>() / p_C.z();
    const double reach = scene_->tether.diameter_m / p_C.z() + 2.0 * std::max(px, py);
    box.extend(tan - Eigen::Vector2d::Constant(reach));
    box.extend(tan + Eigen::Vector2d::Constant(reach));
  }
  if (!any) return false;
  const auto pixel = [](double at, double from, double step, int last) {
    return static_cast<int>(std::clamp(std::floor((at - from) / step), 0.0, double(last)));
  };
  view.thin_x = pixel(box.min().x(), frustum.rect.left, px, frustum.width);
  view.thin_y = pixel(box.min().y(), frustum.rect.top, py, frustum.height);
  view.thin_width = pixel(box.max().x() + px, frustum.rect.left, px, frustum.width) - view.thin_x;
  view.thin_height = pixel(box.max().y() + py, frustum.rect.top, py, frustum.height) - view.thin_y;
  return view.thin_width > 0 && view.thin_height > 0;
}

void ScenePainter::PaintTether(const Frustum& frustum, const GlViewTarget& target, FlatView& view) {
  view.thin.clear();
  view.thin_width = view.thin_height = 0;
  if (!FitThin(frustum, view)) return;
  const Pose3 X_CP = frustum.X_CW * X_WP_;
  const double pixel = (frustum.rect.right - frustum.rect.left) / frustum.width;
  tether_mesh_.Upload(TetherTube(
      [&](const Eigen::Vector3d& p_P) { return 0.6 * pixel * std::max((X_CP * p_P).z(), 0.0); }));
  target.BindThin();
  gl_.Enable(GL_SCISSOR_TEST);
  gl_.Scissor(view.thin_x, view.thin_y, view.thin_width, view.thin_height);
  constexpr GLfloat kNone[4] = {0, 0, 0, 0};
  gl_.ClearBufferfv(GL_COLOR, 0, kNone);
  thin_.Use();
  Pose(thin_, frustum, X_WP_);
  thin_.Set("u_up", Eigen::Vector3d(fit_.X_WU.R.row(2).transpose()));
  gl_.Enable(GL_CULL_FACE);  // or the far side would count as cover too
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  tether_mesh_.Draw();
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_CULL_FACE);
  gl_.Disable(GL_SCISSOR_TEST);
  view.thin.resize(static_cast<std::size_t>(view.thin_width) * view.thin_height);
  target.Read(view.thin_x, view.thin_y, view.thin_width, view.thin_height, view.thin.data());
}

}  // namespace dockyard
