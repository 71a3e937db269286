// The docking algorithm of Tsai, Nesnas and Zarzhitsky (2013) for a tethered two-wheel rover: take
// an image pair, locate the board, plan arcs, drive with the tether taut, check, back up or mate.
#pragma once

#include <functional>
#include <memory>

#include "controller/axel/nominal/nominal.h"
#include "controller/io/controller.h"
#include "controller/vision/board/locate.h"

namespace dockyard::axel {

using Locator = std::function<LocateOutput(const StereoImages&, const LocateHints&)>;

/// Vision-based, tether-assisted docking. The locator defaults to LocateBoard with the nominal rig
/// and board; tests may give another.
std::unique_ptr<Controller> MakeDockyardController(const Nominal& nominal, Locator locator = {});

/// The controller as published, with the published perception whatever the nominal parameters say.
std::unique_ptr<Controller> MakeTsai2013Controller(const Nominal& nominal, Locator locator = {});

/// The control experiment (Tsai et al., V-C): wheels free, reel in until the tip is seated.
std::unique_ptr<Controller> MakeReelOnlyController(const Nominal& nominal);

}  // namespace dockyard::axel
