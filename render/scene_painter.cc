#include "render/scene_painter.h"

#include <algorithm>
#include <cmath>

#include "render/board_plate.h"
#include "render/ground_sectors.h"
#include "render/shaders.h"

namespace dockyard {
namespace {

constexpr double kNear_m = 0.02, kFar_m = 400.0;
constexpr int kReliefUnit = 2, kSoilUnit = 3, kLumpsUnit = 4;
// A shaded facet's normal and its plane differ by the sagitta of its curve.
constexpr double kCurvedBias_m = 0.003, kFlatBias_m = 0.001;

// Panchromatic grey of a linear colour (luminance weights of ITU-R BT.601).
double Grey(const Eigen::Vector3d& rgb) { return rgb.dot(Eigen::Vector3d(0.299, 0.587, 0.114)); }

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
struct ScenePainter::Eye {
  Pose3 X_WC, X_CW;
  TanRect rect;
  int width = 0, height = 0;
  Eigen::Matrix4d clip_from_C;
};

ScenePainter::ScenePainter(const GlFunctions& gl)
    : gl_(gl),
      shadow_map_(gl),
      surface_(gl, SurfaceVertexShader(), SurfaceFragmentShader()),
      open_ground_(gl, SurfaceVertexShader(), GroundFragmentShader(false)),
      shaded_ground_(gl, SurfaceVertexShader(), GroundFragmentShader(true)),
      board_(gl, SurfaceVertexShader(), BoardFragmentShader()),
      sky_(gl, SkyVertexShader(), SkyFragmentShader()),
      open_mesh_(gl),
      shaded_mesh_(gl),
      board_mesh_(gl),
      tether_mesh_(gl),
      relief_(gl),
      soil_(gl),
      lumps_(gl),
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
      fit_, [&](GlProgram& program, const Eigen::Matrix4d& clip_from_U,
                const ShadowWindow& window) { DrawCasters(program, clip_from_U, window); });
  if (HasGround(scene.ground)) UploadFan(scene);
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
  // Thinner than a texel the tether would come and go along its length.
  const double least = 0.6 * window.texel_m();
  tether_mesh_.Upload(TetherTube([&](const Eigen::Vector3d&) { return least; }));
  place(X_WP_);
  tether_mesh_.Draw();
}

void ScenePainter::BeginProgram(GlProgram& program, double bias_m) {
  const SunAndSky& light = scene_->light;
  program.Use();
  shadow_map_.Apply(fit_, program);
  program.Set("u_sun_radius", 0.5 * light.sun_angular_diameter_rad);
  program.Set("u_bias", bias_m);
  program.Set("u_effort", Eigen::Vector2d(effort_.searches, effort_.taps));
  const Eigen::Vector3d up_U = fit_.X_WU.R.row(2).transpose();
  const double on_level = light.sun_irradiance * std::max(up_U.z(), 0.0) + light.sky_irradiance;
  program.Set("u_light", Eigen::Vector3d(light.sun_irradiance, light.sky_irradiance,
                                         light.ground_bounce_albedo * on_level));
  program.Set("u_up", up_U);
}

void ScenePainter::Pose(GlProgram& program, const Eye& eye, const Pose3& X_WO) const {
  program.Set("u_clip_from_object", Eigen::Matrix4d(eye.clip_from_C * ToMatrix(eye.X_CW * X_WO)));
  program.Set("u_light_from_object", ToMatrix(Inverse(fit_.X_WU) * X_WO));
}

void ScenePainter::Paint(const Pose3& X_WC, const TanRect& rect, int width, int height,
                         ShadowEffort effort) {
  effort_ = effort;
  const Eye eye{.X_WC = X_WC,
                .X_CW = Inverse(X_WC),
                .rect = rect,
                .width = width,
                .height = height,
                .clip_from_C = ClipFromCamera(rect)};
  gl_.Viewport(0, 0, width, height);
  gl_.Enable(GL_DEPTH_TEST);
  gl_.DepthFunc(GL_LEQUAL);
  gl_.DepthMask(GL_TRUE);
  gl_.Disable(GL_BLEND);
  gl_.FrontFace(GL_CW);  // the picture is upside down to GL
  gl_.VertexAttrib1f(2, 1.0f);
  gl_.ClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  gl_.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  PaintObjects(eye);
  if (HasBoard(*scene_)) PaintBoard(eye);
  if (HasGround(scene_->ground)) PaintGround(eye);
  PaintSky(eye);
  PaintTether(eye);
}

void ScenePainter::PaintObjects(const Eye& eye) {
  BeginProgram(surface_, kCurvedBias_m);
  for (const SceneObject& object : scene_->objects) {
    const Cached& cached = cache_.at(object.mesh.get());
    const Eigen::Vector3d p_C = eye.X_CW * (object.X_WO * cached.ball.center);
    if (!MayShow(eye.rect, p_C, cached.ball.radius)) continue;
    Pose(surface_, eye, object.X_WO);
    surface_.Set("u_albedo", Grey(object.albedo));
    cached.buffers->Draw();
  }
}

void ScenePainter::PaintBoard(const Eye& eye) {
  const BoardView& view = scene_->board;
  BeginProgram(board_, kFlatBias_m);
  Pose(board_, eye, view.X_WB);
  const int count = static_cast<int>(view.board.fiducials.size());
  Eigen::Matrix<float, 4, Eigen::Dynamic> fiducials(4, count);
  for (int i = 0; i < count; ++i) {
    const Fiducial& f = view.board.fiducials[i];
    // Counter-clockwise for the beholder is towards -y, for y points down.
    fiducials.col(i) =
        Eigen::Vector4d(f.p_BF.x(), f.p_BF.y(), std::cos(f.rotation), -std::sin(f.rotation))
            .cast<float>();
  }
  board_.Set("u_fiducials", fiducials);
  board_.Set("u_fiducial_count", count);
  board_.Set("u_sizes",
             Eigen::Vector3d(0.5 * view.board.disc_diameter_m, 0.5 * view.board.bar_length_m,
                             0.5 * view.board.bar_width_m));
  board_.Set("u_albedos", Eigen::Vector2d(view.white_albedo, view.black_albedo));
  // A plate that is drawn in the board's plane must not shine through.
  gl_.Enable(GL_POLYGON_OFFSET_FILL);
  gl_.PolygonOffset(-1.0f, -8.0f);
  board_mesh_.Draw();
  gl_.Disable(GL_POLYGON_OFFSET_FILL);
}

void ScenePainter::PaintGround(const Eye& eye) {
  relief_.Bind(kReliefUnit);
  soil_.Bind(kSoilUnit);
  lumps_.Bind(kLumpsUnit);
  PaintPart(eye, open_ground_, parts_.open, open_mesh_);
  PaintPart(eye, shaded_ground_, parts_.shaded, shaded_mesh_);
}

void ScenePainter::PaintPart(const Eye& eye, GlProgram& program, const FanPart& part,
                             const GlMesh& mesh) {
  const GroundView& ground = scene_->ground;
  BeginProgram(program, kFlatBias_m);
  Pose(program, eye, X_WF_);
  program.Set("u_relief", kReliefUnit);
  program.Set("u_soil", kSoilUnit);
  program.Set("u_lumps", kLumpsUnit);
  program.Set("u_pole", Eigen::Vector2d(fan_.pole_x_m, fan_.pole_y_m));
  const Eigen::Vector2d scale(1.0 / (ground.cell_m * ground.nx), 1.0 / (ground.cell_m * ground.ny));
  const Eigen::Vector2d first(ground.x0_m - 0.5 * ground.cell_m, ground.y0_m - 0.5 * ground.cell_m);
  program.Set("u_grid_scale", scale);
  program.Set("u_grid_shift", Eigen::Vector2d(-first.cwiseProduct(scale)));
  program.Set("u_albedo", Grey(ground.albedo));
  const SectorRange range = VisibleSectors(Inverse(X_WF_) * eye.X_WC, eye.rect);
  const auto draw = [&](int from, int to) {
    mesh.Draw(part.start[from], part.start[to] - part.start[from]);
  };
  const int end = range.first + range.count;
  draw(range.first, std::min(end, kGroundSectors));
  if (end > kGroundSectors) draw(0, end - kGroundSectors);
}

void ScenePainter::PaintSky(const Eye& eye) {
  BeginProgram(sky_, 0.0);
  const TanRect& r = eye.rect;
  sky_.Set("u_rect", Eigen::Vector4d(r.left, r.top, r.right - r.left, r.bottom - r.top));
  sky_.Set("u_up_C", Eigen::Vector3d(eye.X_CW.R.col(2)));
  sky_.Set("u_sun_C", Eigen::Vector3d(eye.X_CW.R * scene_->light.to_sun_W));
  empty_mesh_.Bind();
  gl_.DrawArrays(GL_TRIANGLES, 0, 3);
}

void ScenePainter::PaintTether(const Eye& eye) {
  const Pose3 X_CP = eye.X_CW * X_WP_;
  const double pixel = (eye.rect.right - eye.rect.left) / eye.width;
  const SurfaceMesh tube = TetherTube(
      [&](const Eigen::Vector3d& p_P) { return 0.6 * pixel * std::max((X_CP * p_P).z(), 0.0); });
  BeginProgram(surface_, kCurvedBias_m);
  Pose(surface_, eye, X_WP_);
  surface_.Set("u_albedo", Grey(scene_->tether.albedo));
  tether_mesh_.Upload(tube);
  gl_.Enable(GL_CULL_FACE);  // or the far side would count as cover too
  gl_.Enable(GL_BLEND);
  gl_.BlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  tether_mesh_.Draw();
  gl_.Disable(GL_BLEND);
  gl_.Disable(GL_CULL_FACE);
}

}  // namespace dockyard
