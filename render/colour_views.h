// Draws the views of colour cameras: what is kept of each camera, and its memory.
#pragma once

#include <memory>
#include <vector>

#include "render/colour_view.h"
#include "render/compose.h"
#include "render/scene_painter.h"
#include "render/sun_in_lens.h"

namespace dockyard {

class ColourViews {
 public:
  /// The context must be current at each call and at the end. The texture is that of the scene's
  /// ground.
  ColourRadiance Render(ScenePainter& painter, const GroundTexture& texture, const Scene& scene,
                        const ColourTable& colours, const ColourView& view,
                        const std::vector<Pose3>& X_WC);

 private:
  // What does not change from image to image.
  struct Lens {
    ColourView view;
    int x0 = 0, y0 = 0;            // of the part that is lit
    PixelGrid grid{};              // of that part
    std::vector<PixelSpan> spans;  // of its rows
    std::vector<float> shares;     // of the light, behind hole and falloff
    TanRect rect{};                // of all spans, in the tan plane of the views
  };
  static Lens MakeLens(const ColourView& view);
  const Lens& LensOf(const ColourView& view);
  // Adds the stray light of the lens, of which the hole shades the sun.
  void AddStray(ScenePainter& painter, const Scene& scene, const ColourTable& colours,
                const Lens& lens, const Pose3& X_WC, std::array<RadianceImage, 3>& part);

  std::vector<Lens> lenses_;
  std::unique_ptr<GlViewTarget> wide_target_, close_target_;
  FlatView wide_, close_;
  SunSight sun_sight_;
};

}  // namespace dockyard
