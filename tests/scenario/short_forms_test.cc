// Shorter spellings of a scenario's file against the long ones.
#include "sim/scenario/short_forms.h"

#include <gtest/gtest.h>

namespace dockyard {
namespace {

const std::vector<KnownSystem>& Systems() {
  static const std::vector<KnownSystem> systems = [] {
    KnownSystem any;
    any.name = "any";
    any.model_roots = {{"robot", "robot"}, {"dock", "any.dock"}};
    any.root_keys = {"dock", "judge"};
    KnownSystem other;
    other.name = "other";
    return std::vector<KnownSystem>{any, other};
  }();
  return systems;
}

std::string Long(const std::string& text) {
  return FlowText(WithoutShortForms(ParseYaml(text, "s.yaml"), Systems()));
}

std::string Plain(const std::string& text) { return FlowText(ParseYaml(text, "s.yaml")); }

TEST(ShortForms, NameAModelByItsTwoFiles) {
  EXPECT_EQ(Long("{system: any, robot: {urdf: r.urdf, file: r.yaml}}"),
            Plain("{system: any, robot: r.yaml, changes: {robot: {urdf: r.urdf}}}"));
  EXPECT_EQ(Long("{system: any, dock: {file: d.yaml}}"),
            Plain("{system: any, any: {dock: d.yaml}}"));
}

TEST(ShortForms, KeepChangesThatAreThere) {
  EXPECT_EQ(Long("{system: any, robot: {urdf: r.urdf, file: r.yaml}, "
                 "changes: {robot: {mass_kg: 3}}}"),
            Plain("{system: any, robot: r.yaml, changes: {robot: {mass_kg: 3, urdf: r.urdf}}}"));
}

TEST(ShortForms, PutASystemsKeysUnderItsNameKeyByKey) {
  EXPECT_EQ(Long("{system: any, any: {judge: {hold_s: 1}}, judge: {force_n: 2}}"),
            Plain("{system: any, any: {judge: {hold_s: 1, force_n: 2}}}"));
}

TEST(ShortForms, LeaveOtherSystemsAndOtherShapesAlone) {
  for (const char* text : {"{system: other, dock: d.yaml}", "{system: none, judge: {a: 1}}",
                           "{system: any, robot: {urdf: r.urdf}}", "{name: x}"}) {
    EXPECT_EQ(Long(text), Plain(text));
  }
}

}  // namespace
}  // namespace dockyard
