// A controller that ignores its sensors and plays a script, to run the physics alone.
#pragma once

#include <memory>
#include <vector>

#include "controller/axel/nominal/nominal.h"
#include "controller/axel/nominal/script.h"
#include "controller/io/controller.h"

namespace dockyard::axel {

/// Plays the steps one after the other, the arm's motor braked, and gives up at the end. A step
/// with neither reel_m_s nor tension_n has the spool braked; tension_n alone reels at 0.05 m/s.
std::unique_ptr<Controller> MakeScriptedController(const Nominal& nominal,
                                                   const std::vector<ScriptStep>& script);

}  // namespace dockyard::axel
