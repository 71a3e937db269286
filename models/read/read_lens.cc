#include "models/read/read_lens.h"

#include "controller/base/number_text.h"

namespace dockyard {
namespace {

const Range kCoefficient = Between(-1e6, 1e6);

template <typename L>
L ReadFocal(const YamlReader& in, const L& lens) {
  return WithFocal(
      lens, {in.Number("fx_px", Positive(1e6)), in.Number("fy_px", Positive(1e6)),
             in.Number("cx_px", Between(-1e6, 1e6)), in.Number("cy_px", Between(-1e6, 1e6))});
}

Lens ReadPinhole(const YamlReader& in) { return ReadFocal(in, BrownPinhole{}); }

Lens ReadBrown(const YamlReader& in) {
  auto lens = ReadFocal(in, BrownPinhole{});
  lens.k1 = in.Number("k1", kCoefficient);
  lens.k2 = in.Number("k2", kCoefficient);
  lens.k3 = in.NumberOr("k3", 0.0, kCoefficient);
  lens.p1 = in.NumberOr("p1", 0.0, kCoefficient);
  lens.p2 = in.NumberOr("p2", 0.0, kCoefficient);
  return lens;
}

Lens ReadKannalaBrandt(const YamlReader& in) {
  auto lens = ReadFocal(in, KannalaBrandt{});
  const YamlNode& list = in.List("k", 4, 4);
  for (std::size_t i = 0; i < 4; ++i) {
    if (!ParseNumber(list.items[i].scalar, lens.k[i])) in.Refuse("k", "a list of 4 numbers");
  }
  return lens;
}

Lens ReadRational(const YamlReader& in) {
  auto lens = ReadFocal(in, RationalPinhole{});
  const char* keys[] = {"k1", "k2", "k3", "k4", "k5", "k6"};
  for (std::size_t i = 0; i < 6; ++i) lens.k[i] = in.Number(keys[i], kCoefficient);
  lens.p1 = in.NumberOr("p1", 0.0, kCoefficient);
  lens.p2 = in.NumberOr("p2", 0.0, kCoefficient);
  return lens;
}

Lens ReadDoubleSphere(const YamlReader& in) {
  auto lens = ReadFocal(in, DoubleSphere{});
  lens.xi = in.Number("xi", kXiOfSpheres);
  lens.alpha = in.Number("alpha", NonNegative(1.0));
  return lens;
}

Lens ReadEucm(const YamlReader& in) {
  auto lens = ReadFocal(in, Eucm{});
  lens.alpha = in.Number("alpha", NonNegative(1.0));
  lens.beta = in.Number("beta", Positive(100.0));
  return lens;
}

Lens ReadOmni(const YamlReader& in) {
  auto lens = ReadFocal(in, Omni{});
  lens.xi = in.Number("xi", NonNegative(100.0));
  lens.k1 = in.NumberOr("k1", 0.0, kCoefficient);
  lens.k2 = in.NumberOr("k2", 0.0, kCoefficient);
  lens.p1 = in.NumberOr("p1", 0.0, kCoefficient);
  lens.p2 = in.NumberOr("p2", 0.0, kCoefficient);
  return lens;
}

Lens ReadFov(const YamlReader& in) {
  auto lens = ReadFocal(in, FovPinhole{});
  lens.w_rad = in.Number("w_rad", kWidthOfFov_rad);
  return lens;
}

struct FocalModel {
  const char* name;
  std::vector<std::string> keys;  // in addition to those of every focal model
  Lens (*read)(const YamlReader& in);
};

const std::vector<FocalModel>& FocalModels() {
  static const std::vector<FocalModel> models{
      {"kannala_brandt", {"k"}, ReadKannalaBrandt},
      {"brown", {"k1", "k2", "k3", "p1", "p2"}, ReadBrown},
      {"pinhole", {}, ReadPinhole},
      {"rational", {"k1", "k2", "k3", "k4", "k5", "k6", "p1", "p2"}, ReadRational},
      {"double_sphere", {"xi", "alpha"}, ReadDoubleSphere},
      {"eucm", {"alpha", "beta"}, ReadEucm},
      {"omni", {"xi", "k1", "k2", "p1", "p2"}, ReadOmni},
      {"fov", {"w_rad"}, ReadFov}};
  return models;
}

const FocalModel* Find(const std::string& name) {
  for (const FocalModel& model : FocalModels()) {
    if (model.name == name) return &model;
  }
  return nullptr;
}

}  // namespace

std::vector<std::string> FocalModelNames() {
  std::vector<std::string> names;
  for (const FocalModel& model : FocalModels()) names.emplace_back(model.name);
  return names;
}

bool IsFocalModel(const std::string& model) { return Find(model) != nullptr; }

std::vector<std::string> FocalModelKeys(const std::string& model) {
  std::vector<std::string> keys{"fx_px", "fy_px", "cx_px", "cy_px"};
  const std::vector<std::string>& more = Find(model)->keys;
  keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

Lens ReadFocalLens(const YamlReader& in, const std::string& model) { return Find(model)->read(in); }

}  // namespace dockyard
