#include "sim/plant/nominal_parts.h"

#include <string>
#include <variant>

namespace dockyard {
namespace {

/// In the order of Lens.
constexpr const char* kModels[] = {"kannala_brandt", "brown", "cahvore", "rational",
                                   "double_sphere",  "eucm",  "omni",    "fov"};
static_assert(std::size(kModels) == std::variant_size_v<Lens>);

template <class L, class Visit>
void VisitLens(L& lens, const Visit& visit) {
  // Focal lengths and centre, which every lens but CAHV* has.
  if constexpr (requires { lens.fx; }) {
    visit("fx", lens.fx);
    visit("fy", lens.fy);
    visit("cx", lens.cx);
    visit("cy", lens.cy);
  }
  if constexpr (Of<L, Cahvore>) {
    visit("C", lens.C);
    visit("A", lens.A);
    visit("H", lens.H);
    visit("V", lens.V);
    visit("O", lens.O);
    visit("R", lens.R);
    visit("E", lens.E);
    visit("linearity", lens.linearity);
  }
  if constexpr (requires { lens.xi; }) visit("xi", lens.xi);
  if constexpr (requires { lens.alpha; }) visit("alpha", lens.alpha);
  if constexpr (requires { lens.beta; }) visit("beta", lens.beta);
  if constexpr (requires { lens.k; }) visit("k", lens.k);
  if constexpr (requires { lens.k2; }) {
    visit("k1", lens.k1);
    visit("k2", lens.k2);
  }
  if constexpr (requires { lens.p2; }) {
    visit("p1", lens.p1);
    visit("p2", lens.p2);
  }
  if constexpr (requires { lens.k3; }) visit("k3", lens.k3);
  if constexpr (requires { lens.w_rad; }) visit("w_rad", lens.w_rad);
}

/// The lens of that model, to be read into.
template <std::size_t... I>
Lens NewLens(std::size_t model, std::index_sequence<I...>) {
  Lens lens;
  ((model == I ? static_cast<void>(lens.emplace<I>()) : static_cast<void>(0)), ...);
  return lens;
}

}  // namespace

Json ToJson(const Camera& camera) {
  Json json{{"width", camera.width}, {"height", camera.height}};
  json["model"] = kModels[camera.lens.index()];
  std::visit([&](const auto& lens) { VisitLens(lens, JsonWriter(json)); }, camera.lens);
  return json;
}

void FromJson(const Json& json, Camera& camera) {
  const JsonReader in(json);
  in("width", camera.width);
  in("height", camera.height);
  std::size_t model = 0;
  in.Word("model", "lens model", model, kModels);
  camera.lens = NewLens(model, std::make_index_sequence<std::variant_size_v<Lens>>());
  std::visit([&](auto& lens) { VisitLens(lens, in); }, camera.lens);
}

}  // namespace dockyard
