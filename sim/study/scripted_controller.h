// A brain that senses nothing and does what a study's script says: for physics alone.
#pragma once

#include <memory>
#include <vector>

#include "controller/io/controller.h"
#include "controller/io/rover_sheet.h"
#include "models/study.h"

namespace dockyard {

/// Plays the steps one after the other, the arm's motor braked, and gives up at the end. A step
/// with neither reel_m_s nor tension_n has the spool braked; tension_n alone winds at 0.05 m/s.
std::unique_ptr<Controller> MakeScriptedController(const RoverSheet& sheet,
                                                   const std::vector<ScriptStep>& script);

}  // namespace dockyard
