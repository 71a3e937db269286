// Mappings of a contact and of a joint's stop in a file -> ContactMaterial, JointStop.
#pragma once

#include "models/parts/contact_material.h"
#include "models/parts/joint_stop.h"
#include "models/read/keys.h"

namespace dockyard {

/// Stiffness and damping alone, where friction is another file's.
void VisitYield(Keys& keys, ContactMaterial& material, Presence needed = Presence::kRequired);

/// needed: kRequired, or kDefault where the material's values so far hold for what is left out.
/// rolling_resistance_m may always be left out.
void VisitContact(Keys& keys, ContactMaterial& material, Presence needed = Presence::kRequired);

/// Of a hinge. needed: as of VisitContact.
void VisitStop(Keys& keys, JointStop& stop, Presence needed = Presence::kRequired);
/// Of a slide.
void VisitSlideStop(Keys& keys, JointStop& stop, Presence needed = Presence::kRequired);

}  // namespace dockyard
