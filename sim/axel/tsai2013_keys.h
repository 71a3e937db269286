// The keys of a scenario under `axel.tsai2013`: what Tsai et al. (2013) leave open.
#pragma once

#include "controller/axel/nominal/tsai2013_options.h"
#include "controller/io/vision_settings.h"
#include "sim/scenario/keys.h"

namespace dockyard::axel {

/// Names every key. Its range is that which a study may vary it over, or wider.
void VisitTsai2013Keys(Keys& keys, Tsai2013Vision& vision, Tsai2013Options& options);

}  // namespace dockyard::axel
