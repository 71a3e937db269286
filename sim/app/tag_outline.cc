#include "sim/app/tag_outline.h"

#include <algorithm>
#include <cstdlib>
#include <set>
#include <utility>

namespace dockyard {
namespace {

using Corner = std::pair<int, int>;  // column, row
using Edge = std::pair<Corner, Corner>;

/// Sides between black and white, black on the right hand (x right, y down).
std::set<Edge> EdgesOf(const TagCells& cells) {
  std::set<Edge> edges;
  const auto black = [&](int x, int y) {
    return x >= 0 && y >= 0 && x < cells.across && y < cells.across && cells.IsBlack(x, y);
  };
  for (int y = 0; y < cells.across; ++y) {
    for (int x = 0; x < cells.across; ++x) {
      if (!black(x, y)) continue;
      if (!black(x, y - 1)) edges.insert({{x, y}, {x + 1, y}});
      if (!black(x + 1, y)) edges.insert({{x + 1, y}, {x + 1, y + 1}});
      if (!black(x, y + 1)) edges.insert({{x + 1, y + 1}, {x, y + 1}});
      if (!black(x - 1, y)) edges.insert({{x, y + 1}, {x, y}});
    }
  }
  return edges;
}

/// The next side: to the right if there is one, so that squares at a corner stay apart.
Edge Next(const std::set<Edge>& edges, const Edge& edge) {
  const auto [from, at] = edge;
  const int dx = at.first - from.first, dy = at.second - from.second;
  for (const auto& [x, y] : {std::pair(-dy, dx), {dx, dy}, {dy, -dx}}) {
    const Edge next{at, {at.first + x, at.second + y}};
    if (edges.contains(next)) return next;
  }
  return edge;
}

int TwiceArea(const TagOutline& outline) {
  int sum = 0;
  const std::size_t count = outline.corners.size();
  for (std::size_t i = 0; i < count; ++i) {
    const Eigen::Vector2i &a = outline.corners[i], &b = outline.corners[(i + 1) % count];
    sum += a.x() * b.y() - a.y() * b.x();
  }
  return sum;
}

}  // namespace

std::vector<TagOutline> OutlinesOf(const TagCells& cells) {
  std::set<Edge> edges = EdgesOf(cells);
  std::vector<TagOutline> outlines;
  while (!edges.empty()) {
    TagOutline outline{.corners = {}};
    const std::set<Edge> all = edges;
    const Edge first = *edges.begin();
    Edge edge = first;
    do {
      edges.erase(edge);
      const Edge next = Next(all, edge);
      const bool turns =
          next.second.first - next.first.first != edge.second.first - edge.first.first;
      if (turns) outline.corners.emplace_back(next.first.first, next.first.second);
      edge = next;
    } while (edge != first);
    outline.black = TwiceArea(outline) > 0;
    outlines.push_back(std::move(outline));
  }
  // A hole is smaller than the outline about it.
  std::stable_sort(outlines.begin(), outlines.end(), [](const TagOutline& a, const TagOutline& b) {
    return std::abs(TwiceArea(a)) > std::abs(TwiceArea(b));
  });
  return outlines;
}

}  // namespace dockyard
