#include "render/colour_table.h"

#include "controller/base/check.h"

namespace dockyard {

ColourTable MakeColourTable(const SceneSpectra& spectra, const CameraResponse& camera) {
  DOCKYARD_CHECK(spectra.ground >= 0 &&
                 spectra.ground < static_cast<int>(spectra.materials.size()));
  const Spectrum& ground = spectra.materials[static_cast<std::size_t>(spectra.ground)];
  const auto colour = [&](const Spectrum& material) {
    MaterialColour c{.sun = ColourOf(spectra.sun, material, camera),
                     .sky = ColourOf(spectra.sky, material, camera),
                     .sun_off_ground = ColourOff(spectra.sun, ground, material, camera),
                     .sky_off_ground = ColourOff(spectra.sky, ground, material, camera),
                     .lamps = {}};
    for (const Spectrum& lamp : spectra.lamps) c.lamps.push_back(ColourOf(lamp, material, camera));
    return c;
  };
  ColourTable table{.materials = {}, .white = colour(EvenGrey(1.0))};
  for (const Spectrum& material : spectra.materials) table.materials.push_back(colour(material));
  return table;
}

}  // namespace dockyard
