#include "render/scene_painter.h"

#include <algorithm>
#include <cmath>

#include "render/board_plate.h"
#include "render/ground_sectors.h"
#include "render/shaders.h"

namespace dockyard {
namespace {

constexpr double kFar_m = 400.0;

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

Ball BoardBall(const BoardView& view) {
  return {view.X_WB.p, 0.5 * std::hypot(view.board.width_m, view.board.height_m)};
}

Ball InterestBall(const Scene& scene, const Pose3& X_WR) {
  if (scene.interest) return {scene.interest->p_W, scene.interest->radius_m};
  return scene.boards.empty() ? Ball{X_WR.p, 0.5} : BoardBall(scene.boards.front());
}

}  // namespace

ScenePainter::ScenePainter(const GlFunctions& gl)
    : gl_(gl),
      shadow_map_(gl),
      object_(gl, SurfaceVertexShader(), ObjectFragmentShader(kFewObjects)),
      ground_(gl, PlainVertexShader(), GroundFragmentShader()),
      board_(gl, PlainVertexShader(), BoardFragmentShader()),
      thin_(gl, SurfaceVertexShader(), ThinFragmentShader()),
      ground_mesh_(gl),
      tether_mesh_(gl),
      empty_mesh_(gl) {
  empty_mesh_.Upload(SurfaceMesh{});
}

void ScenePainter::Prepare(const Scene& scene, const Pose3& X_WR, const Detail& detail) {
  scene_ = &scene;
  X_WP_ = {Eigen::Matrix3d::Identity(), X_WR.p};
  UploadObjects(scene);
  for (std::size_t i = 0; i < scene.boards.size(); ++i) {
    if (i == board_meshes_.size()) board_meshes_.push_back(std::make_unique<GlMesh>(gl_));
    board_meshes_[i]->Upload(BoardPlate(scene.boards[i]));
  }
  with_ground_ = detail.ground && HasGround(scene.ground);
  if (with_ground_) UploadGround(scene, X_WR, detail.fan);
  fit_ = FitShadow(Casters(scene), InterestBall(scene, X_WR), X_WR, scene.light.to_sun_W,
                   detail.shadow);
  if (!detail.shadows) return shadow_.TakeNone(fit_);
  empty_mesh_.Bind();
  shadow_map_.Render(
      fit_, scene.light.sun_angular_diameter_rad,
      [&](GlProgram& program, const Eigen::Matrix4d& clip_from_U, const ShadowWindow& window) {
        DrawCasters(program, clip_from_U, window);
      },
      shadow_);
  if (!scene.boards.empty()) {
    const Pose3 X_UB = Inverse(fit_.X_WU) * scene.boards.front().X_WB;
    shadow_.TakePlane(X_UB.p, X_UB.R.col(2));
  }
}

std::vector<Ball> ScenePainter::Casters(const Scene& scene) const {
  std::vector<Ball> casters;
  for (const SceneObject& object : scene.objects) {
    const Ball& ball = cache_.at(object.mesh.get()).ball;
    casters.push_back({object.X_WO * ball.center, ball.radius});
  }
  for (const BoardView& board : scene.boards) casters.push_back(BoardBall(board));
  for (const TetherView* body : ThinBodies(scene)) {
    for (const Eigen::Vector3d& p : body->points_W) {
      casters.push_back({p, 0.5 * body->diameter_m});
    }
  }
  return casters;
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
  for (std::size_t i = 0; i < scene_->boards.size(); ++i) {
    place(scene_->boards[i].X_WB);
    board_meshes_[i]->Draw();
  }
  // Thinner than a texel, a tether would flicker along its length.
  const double least = 0.6 * window.texel_m();
  place(X_WP_);
  for (const TetherView* body : ThinBodies(*scene_)) {
    if (body->points_W.empty()) continue;
    tether_mesh_.Upload(TetherTube(*body, [&](const Eigen::Vector3d&) { return least; }));
    tether_mesh_.Draw();
  }
}

void ScenePainter::Pose(GlProgram& program, const Frustum& frustum, const Pose3& X_WO) const {
  program.Set("u_clip_from_object",
              Eigen::Matrix4d(frustum.clip_from_C * ToMatrix(frustum.X_CW * X_WO)));
  program.Set("u_light_from_object", ToMatrix(Inverse(fit_.X_WU) * X_WO));
}

void ScenePainter::PaintInto(std::unique_ptr<GlViewTarget>& target, const Pose3& X_WC,
                             FlatView& view) {
  if (!target || target->width() < view.width || target->height() < view.height) {
    const int w = std::max(view.width, target ? target->width() : 0);
    const int h = std::max(view.height, target ? target->height() : 0);
    target = std::make_unique<GlViewTarget>(gl_, w, h);
  }
  Paint(*target, X_WC, view);
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
  PaintBoards(frustum);
  if (with_ground_) PaintGround(frustum);
  view.seen.resize(static_cast<std::size_t>(view.width) * view.height);
  target.Read(view.width, view.height, view.seen.data());
  const std::vector<const TetherView*> bodies = ThinBodies(*scene_);
  view.layers.resize(bodies.size());
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    PaintTether(frustum, target, *bodies[i], view.layers[i]);
  }
}

void ScenePainter::PaintObjects(const Frustum& frustum) {
  const bool few = BitsFor(scene_->objects.size()) == kFewObjects;
  if (!few && !many_objects_) {
    many_objects_.emplace(gl_, SurfaceVertexShader(), ObjectFragmentShader(kManyObjects));
  }
  GlProgram& program = few ? object_ : *many_objects_;
  program.Use();
  int index = -1;
  for (const SceneObject& object : scene_->objects) {
    ++index;
    if (!object.seen) continue;
    const Cached& cached = cache_.at(object.mesh.get());
    const Eigen::Vector3d p_C = frustum.X_CW * (object.X_WO * cached.ball.center);
    if (!MayShow(frustum.rect, p_C, cached.ball.radius)) continue;
    Pose(program, frustum, object.X_WO);
    program.Set("u_object", index);
    cached.buffers->Draw();
  }
}

void ScenePainter::PaintBoards(const Frustum& frustum) {
  if (scene_->boards.empty()) return;
  board_.Use();
  // A plate that is drawn in the board's plane must not shine through.
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(-1.0f, -8.0f);
  for (std::size_t i = 0; i < scene_->boards.size(); ++i) {
    Pose(board_, frustum, scene_->boards[i].X_WB);
    board_.Set("u_board", static_cast<int>(i));
    board_meshes_[i]->Draw();
  }
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void ScenePainter::PaintGround(const Frustum& frustum) {
  ground_.Use();
  Pose(ground_, frustum, X_WF_);
  if (fan_.count < kGroundSectors) return ground_mesh_.Draw();
  const SectorRange range = VisibleSectors(Inverse(X_WF_) * frustum.X_WC, frustum.rect);
  const int per_sector = ground_mesh_.count() / kGroundSectors;
  const auto draw = [&](int from, int to) {
    ground_mesh_.Draw(per_sector * from, per_sector * (to - from));
  };
  const int end = range.first + range.count;
  draw(range.first, std::min(end, kGroundSectors));
  if (end > kGroundSectors) draw(0, end - kGroundSectors);
}

}  // namespace dockyard
