// What the camera knows the pyramid by: its bi-cone and its blue strips, as meshes in P.
#pragma once

#include "models/raposa/pyramid_model.h"
#include "render/scene.h"

namespace dockyard::raposa {

/// A closed solid turned about z of the frame A from (z, radius), lowest z first.
RenderMesh TurnedMesh(const std::vector<Eigen::Vector2d>& profile_m, const Pose3& X_OA);
RenderMesh GuideMesh(const GuideModel& guide);
/// The rod from the bi-cone to the faces.
RenderMesh RodMesh(const PyramidModel& pyramid);
/// The strips along the edges of the faces' base.
RenderMesh StripsMesh(const MarksModel& marks);
/// The faces within the strips.
RenderMesh FacesMesh(const MarksModel& marks);

}  // namespace dockyard::raposa
