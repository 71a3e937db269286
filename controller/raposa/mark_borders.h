// Whether the marks of a fit end where the image's colours end, and have one colour each.
#pragma once

#include "controller/raposa/layers.h"

namespace dockyard::raposa {

/// Marks fill more of a cell that counts as theirs; with the blur this is 2 px beyond their edges.
inline constexpr float kOfMarks = 0.02f;
/// A cell that no layer explains shows another thing: a cell costs at most what it does this many
/// sigmas off. Assumed, 4-8.
inline constexpr float kOtherThing = 5.0f;

/// Share of a cell that all parts of the pyramid fill but its rod.
float MarksIn(const LayerImage& layers, std::size_t cell);

/// Of the cells close round a mark, and outside of all, the share with its colour rather than the
/// ground's or the sky's. A true mark has almost 0; a part of something larger almost 1.
double ShareBeyond(const FitWindow& window, const LayerImage& layers, const LayerColours& colours,
                   Layer mark);

/// Of a mark's cells, the share that shows another thing. weights: of WeightsFor.
double ShareOfOthers(const FitWindow& window, const LayerImage& layers, const LayerColours& colours,
                     const std::vector<float>& weights, Layer mark);

}  // namespace dockyard::raposa
