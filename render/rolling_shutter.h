// A rolling shutter: the rows of an image are exposed one after another, from top to bottom. No GL.
#pragma once

#include <functional>

#include "render/motion_blur.h"
#include "render/shutter.h"

namespace dockyard {

/// Whether rows differ enough for it, where the image moves by this from the first row's exposure
/// to the last's: by 0.1 px or more, as the fields of interlaced video.
bool RowsDiffer(double motion_px);

/// A pair of views whose exposure's middle is `share` of the readout after that of the middle row.
/// With depths where RowsDiffer.
using PairInReadout = std::function<StereoRadiance(double share)>;

/// Both views of a camera pair that moves while its rows are exposed: row y of h at the share
/// (y + 1/2) / h - 1/2 of the readout. motion_px: how far the image moves in it, at most; `motion`
/// is that of the rig's body meanwhile. Where rows do not differ, one view serves all of them, bit
/// for bit. Else the rows are cut into parts in which the image moves by a pixel at most (16 parts
/// at most). Each has one view, of its middle, whose rows are moved on by their own time
/// (MoveRows).
StereoRadiance OverReadout(double motion_px, const StereoRig& rig, const ExposureMotion& motion,
                           const PairInReadout& view);

/// The same of one camera. `motion` is the camera's own.
using OneInReadout = std::function<RadianceImage(double share)>;
RadianceImage OverReadout(double motion_px, const Camera& camera, const ExposureMotion& motion,
                          const OneInReadout& view);

}  // namespace dockyard
