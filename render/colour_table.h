// The colours of materials in a scene's lights, for one camera: made once, so that shading adds and
// multiplies three numbers a light and never sees a spectrum.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "render/spectrum.h"

namespace dockyard {

/// What shines and what it shines on. How strongly it shines is the Scene's.
struct SceneSpectra {
  Spectrum sun = DaylightLight(5500.0);  // also another light from far away: one bright window
  Spectrum sky = DaylightLight(6500.0);  // also the even light of a room
  std::vector<Spectrum> lamps{};         // by Lamp::kind
  std::vector<Spectrum> materials{};     // reflectances, by SceneObject::material
  int ground = 0;                        // the material that light bounces off
};

/// The camera's red, green and blue of one material per irradiance in each light; see ColourOf.
struct MaterialColour {
  Eigen::Vector3d sun, sky, sun_off_ground, sky_off_ground;
  std::vector<Eigen::Vector3d> lamps;
};

struct ColourTable {
  std::vector<MaterialColour> materials;
  MaterialColour white;  // of reflectance 1: what is seen of the sky itself
};

/// The ground is one of the materials.
ColourTable MakeColourTable(const SceneSpectra& spectra, const CameraResponse& camera);

}  // namespace dockyard
