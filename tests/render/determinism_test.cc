// The same scene gives the same bits, on any back end and with any number of threads.
#include <dlfcn.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "render/scene_samples.h"
#include "support/program_path.h"

namespace dockyard {
namespace {

const StereoRig kRig = SampleRig(320, 240);

// The thread count is read once a process, hence processes of their own.
std::string HashWithThreads(const char* count) {
  const std::string command = std::string("LP_NUM_THREADS=") + count + " '" + ProgramPath() + "'";
  FILE* pipe = popen(command.c_str(), "r");
  if (!pipe) return "";
  std::array<char, 64> line{};
  const char* got = std::fgets(line.data(), line.size(), pipe);
  const int status = pclose(pipe);
  return got && status == 0 ? line.data() : "";
}

TEST(Image, HasTheSameBitsTwice) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  StereoRenderer renderer;
  const StereoImages first = renderer.Render(yard->scene, kRig, yard->X_WR, {.noise_key = 9});
  const StereoImages again = renderer.Render(yard->scene, kRig, yard->X_WR, {.noise_key = 9});
  const StereoImages anew =
      StereoRenderer().Render(yard->scene, kRig, yard->X_WR, {.noise_key = 9});
  EXPECT_EQ(first, again);
  EXPECT_EQ(first, anew);
}

TEST(Image, DoesNotDependOnWhatWasDrawnBefore) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  const auto other = SampleYard(4.0, SunAt(-0.5, 0.4));
  StereoRenderer renderer;
  const StereoImages first = renderer.Render(yard->scene, kRig, yard->X_WR, {});
  renderer.Render(other->scene, SampleRig(640, 480), other->X_WR, {});
  EXPECT_EQ(first, renderer.Render(yard->scene, kRig, yard->X_WR, {}));
}

TEST(Image, HasTheSameBitsWithAnyNumberOfThreads) {
  const std::string alone = HashWithThreads("0");
  ASSERT_FALSE(alone.empty());
  EXPECT_EQ(alone, HashWithThreads("1"));
  EXPECT_EQ(alone, HashWithThreads("2"));
}

TEST(Image, FollowsTheGroundWhenItsHeightsChangeInPlace) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  StereoRenderer renderer;
  const StereoImages before = renderer.Render(yard->scene, kRig, yard->X_WR, {});
  for (double& h : yard->heights_m) h *= 3.0;
  EXPECT_NE(before, renderer.Render(yard->scene, kRig, yard->X_WR, {}));
}

TEST(EglContext, DrawsWhatOsMesaDraws) {
  if (!dlopen("libEGL.so.1", RTLD_NOW))
    FAIL() << "libEGL.so.1 is not installed: scripts/install_packages dev brings it";
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  StereoRenderer osmesa, egl(GlBackend::kEglSurfaceless);
  const StereoImages a = osmesa.Render(yard->scene, kRig, yard->X_WR, {});
  const StereoImages b = egl.Render(yard->scene, kRig, yard->X_WR, {});
  // A graphics processor may round otherwise; one rasteriser gives one image.
  if (osmesa.names().renderer == egl.names().renderer) {
    EXPECT_EQ(a, b);
  }
  int largest = 0;
  for (std::size_t i = 0; i < a.left.pixels.size(); ++i) {
    largest = std::max(largest, std::abs(a.left.pixels[i] - b.left.pixels[i]));
    largest = std::max(largest, std::abs(a.right.pixels[i] - b.right.pixels[i]));
  }
  EXPECT_LE(largest, 1);
}

TEST(Contexts, TakeTurnsOnOneThread) {
  const auto yard = SampleYard(2.0, SunAt(0.5, 0.7));
  StereoRenderer one, two;
  const StereoImages a = one.Render(yard->scene, kRig, yard->X_WR, {});
  const StereoImages b = two.Render(yard->scene, kRig, yard->X_WR, {});
  EXPECT_EQ(a, b);
  EXPECT_EQ(a, one.Render(yard->scene, kRig, yard->X_WR, {}));
}

}  // namespace
}  // namespace dockyard
