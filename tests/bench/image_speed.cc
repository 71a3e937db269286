#include "bench/image_speed.h"

#include <GL/osmesa.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <cstring>
#include <ctime>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace dockyard::axel {
namespace {

constexpr int kGridSide = 150;  // ours draws 600; MuJoCo would spend all its time on it

std::string Xml(int width, int height) {
  const std::string size =
      "offwidth='" + std::to_string(width) + "' offheight='" + std::to_string(height) + "'";
  const std::string grid = std::to_string(kGridSide);
  return R"(<mujoco>
  <visual><global )" +
         size + R"( fovy='67'/><quality shadowsize='2048'/></visual>
  <asset>
    <hfield name='yard' nrow=')" +
         grid + "' ncol='" + grid + R"(' size='6 6 0.05 0.1'/>
    <texture name='soil' type='2d' builtin='checker' width='1024' height='1024' mark='random'
             random='0.3' rgb1='.45 .36 .28' rgb2='.4 .33 .25' markrgb='.3 .25 .2'/>
    <material name='soil' texture='soil' texrepeat='8 8' texuniform='true'/>
  </asset>
  <worldbody>
    <light directional='true' castshadow='true' pos='3 2 5' dir='-.5 -.3 -.8'/>
    <geom type='hfield' hfield='yard' material='soil'/>
    <geom type='box' size='.4 .5 .48' pos='-.41 0 .62' rgba='.6 .6 .6 1'/>
    <geom type='box' size='.005 .45 .25' pos='0 0 .85' rgba='.85 .85 .85 1'/>
    <geom type='cylinder' size='.05 .004' pos='.005 .3 .9' euler='0 90 0' rgba='.05 .05 .05 1'/>
    <geom type='cylinder' size='.05 .004' pos='.005 -.3 .9' euler='0 90 0' rgba='.05 .05 .05 1'/>
    <geom type='cylinder' size='.05 .004' pos='.005 .3 .7' euler='0 90 0' rgba='.05 .05 .05 1'/>
    <geom type='cylinder' size='.05 .004' pos='.005 -.3 .7' euler='0 90 0' rgba='.05 .05 .05 1'/>
    <geom type='cylinder' size='.17 .03' pos='.02 0 .42' euler='0 90 0' rgba='.5 .5 .5 1'/>
    <geom type='capsule' size='.025 .45' pos='3.5 0 .2' euler='0 90 0' rgba='.5 .5 .5 1'/>
    <geom type='cylinder' size='.15 .07' pos='4 .5 .15' euler='90 0 0' rgba='.35 .35 .35 1'/>
    <geom type='cylinder' size='.15 .07' pos='4 -.5 .15' euler='90 0 0' rgba='.35 .35 .35 1'/>
    <camera name='left' pos='4 -.175 .4' xyaxes='0 1 0 0 0 1'/>
    <camera name='right' pos='4 .175 .4' xyaxes='0 1 0 0 0 1'/>
  </worldbody>
</mujoco>)";
}

struct Freed {
  void operator()(mjModel* m) const { mj_deleteModel(m); }
  void operator()(mjData* d) const { mj_deleteData(d); }
};

std::unique_ptr<mjModel, Freed> Load(const std::string& xml) {
  constexpr const char* kName = "yard.xml";
  auto vfs = std::make_unique<mjVFS>();
  mj_defaultVFS(vfs.get());
  mj_makeEmptyFileVFS(vfs.get(), kName, static_cast<int>(xml.size()));
  // The file has a size; it needs no null. NOLINTNEXTLINE(bugprone-not-null-terminated-result)
  std::memcpy(vfs->filedata[mj_findFileVFS(vfs.get(), kName)], xml.data(), xml.size());
  std::array<char, 500> error{};
  mjModel* model = mj_loadXML(kName, vfs.get(), error.data(), static_cast<int>(error.size()));
  mj_deleteVFS(vfs.get());
  if (!model) throw std::runtime_error(std::string("MuJoCo: ") + error.data());
  for (int i = 0; i < kGridSide * kGridSide; ++i) {
    const int column = i % kGridSide, row = i / kGridSide;
    const double x = column, y = row;
    model->hfield_data[i] = static_cast<float>(0.5 + 0.25 * std::sin(0.3 * x) * std::cos(0.23 * y));
  }
  return std::unique_ptr<mjModel, Freed>(model);
}

double CpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

}  // namespace

double MujocoPairSeconds(int width, int height) {
  const OSMesaContext gl = OSMesaCreateContextExt(GL_RGBA, 24, 8, 0, nullptr);
  if (!gl) throw std::runtime_error("OSMesa gives no context");
  std::vector<unsigned char> surface(static_cast<std::size_t>(width) * height * 4);
  OSMesaMakeCurrent(gl, surface.data(), GL_UNSIGNED_BYTE, width, height);
  const auto model = Load(Xml(width, height));
  const std::unique_ptr<mjData, Freed> data(mj_makeData(model.get()));
  mj_forward(model.get(), data.get());
  mjvScene scene;
  mjv_defaultScene(&scene);
  mjv_makeScene(model.get(), &scene, 100);
  mjrContext context;
  mjr_defaultContext(&context);
  mjr_makeContext(model.get(), &context, mjFONTSCALE_100);
  mjr_setBuffer(mjFB_OFFSCREEN, &context);
  mjvOption option;
  mjv_defaultOption(&option);
  std::vector<unsigned char> rgb(static_cast<std::size_t>(width) * height * 3);
  const auto pair = [&] {
    for (int side = 0; side < 2; ++side) {
      mjvCamera camera;
      mjv_defaultCamera(&camera);
      camera.type = mjCAMERA_FIXED;
      camera.fixedcamid = side;
      mjv_updateScene(model.get(), data.get(), &option, nullptr, &camera, mjCAT_ALL, &scene);
      const mjrRect view{0, 0, width, height};
      mjr_render(view, &scene, &context);
      mjr_readPixels(rgb.data(), nullptr, view, &context);
    }
  };
  pair();  // shaders and lists are made once
  constexpr int kRounds = 4;
  const double start = CpuSeconds();
  for (int i = 0; i < kRounds; ++i) pair();
  const double seconds = (CpuSeconds() - start) / kRounds;
  mjr_freeContext(&context);
  mjv_freeScene(&scene);
  OSMesaDestroyContext(gl);
  return seconds;
}

}  // namespace dockyard::axel
