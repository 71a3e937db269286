// What Tsai et al. (2013) leave open, within the nominal parameters.
#pragma once

#include "controller/axel/nominal/tsai2013_options.h"
#include "controller/io/vision_settings.h"
#include "sim/base/json.h"

namespace dockyard::axel {

Json Tsai2013ToJson(const Tsai2013Vision& vision, const Tsai2013Options& options);
/// From the nominal parameters' member `tsai2013`; logs from before it existed keep the defaults.
/// Throws ConfigError, or Json::exception where a number is missing.
void ReadTsai2013(const Json& nominal, Tsai2013Vision* vision, Tsai2013Options* options);

}  // namespace dockyard::axel
