// What the camera knows the pyramid by: its bi-cone and its blue strips, as meshes in P.
#pragma once

#include "models/raposa/pyramid_model.h"
#include "render/scene.h"

namespace dockyard::raposa {

RenderMesh GuideMesh(const GuideModel& guide);
/// The rod from the bi-cone to the faces.
RenderMesh RodMesh(const PyramidModel& pyramid);
/// The paint round the edges of the faces' base.
RenderMesh StripsMesh(const MarksModel& marks);
/// The faces within the paint.
RenderMesh FacesMesh(const MarksModel& marks);

}  // namespace dockyard::raposa
