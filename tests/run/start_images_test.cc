// The fingerprint of the images at the start.
#include "sim/run/start_images.h"

#include <cstdio>

#include "run/scripted_run.h"

namespace dockyard {
namespace {

using Rows = std::vector<std::vector<std::uint8_t>>;  // by camera

/// FNV-1a of each camera's number in eight bytes, least first, and of its pixels.
std::string FingerprintOf(const Rows& rows) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  const auto add = [&](std::uint64_t byte) { hash = (hash ^ byte) * 0x100000001b3u; };
  for (std::size_t camera = 0; camera < rows.size(); ++camera) {
    for (std::size_t byte = 0; byte < 8; ++byte) add(byte == 0 ? camera : 0);
    for (const std::uint8_t pixel : rows[camera]) add(pixel);
  }
  char text[17];
  std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(hash));
  return text;
}

class StartImagesOf : public ScriptedRun {
 protected:
  std::string Of(const Rows& rows) {
    script_.cameras = static_cast<int>(rows.size());
    script_.pixels = [rows](int camera) { return rows.at(static_cast<std::size_t>(camera)); };
    return StartImages(ScriptedSystem(script_, diary_), scenario_);
  }
};

TEST_F(StartImagesOf, AllCamerasAreOneFnv1aFingerprint) {
  for (const Rows& rows : {Rows{{1, 2}}, Rows{{1, 2}, {3, 4, 5}}, Rows{{3, 4, 5}, {1, 2}}}) {
    EXPECT_EQ(Of(rows), FingerprintOf(rows));
  }
}

TEST_F(StartImagesOf, ACameraThatShowsNothingAreNone) {
  EXPECT_EQ(Of({{1, 2}, {9, 9, 9}}), "none: the image of camera 1 shows nothing");
  EXPECT_EQ(Of({{0, 0}, {1, 2}}), "none: the image of camera 0 shows nothing");
}

TEST_F(StartImagesOf, ARobotWithoutCamerasAreAnEmptyText) { EXPECT_EQ(Of({}), ""); }

}  // namespace
}  // namespace dockyard
