// Keys of a contact's material.
#include <gtest/gtest.h>

#include "models/read/config_error.h"
#include "models/read/load_contact.h"
#include "models/read/yaml_tree.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

ContactMaterial Read(const std::string& text, Presence needed = Presence::kRequired) {
  const ScratchFolder folder;
  ContactMaterial material{1.0, 2.0, 0.3, 0.0};
  ReadKeys(LoadYaml(folder.Write("contact.yaml", text)), "",
           [&](Keys& keys) { VisitContact(keys, material, needed); });
  return material;
}

TEST(ContactMaterial, ComesFromItsKeys) {
  const ContactMaterial material = Read(
      "stiffness_n_per_m: 2e4\ndamping_ns_per_m: 40\nfriction: 0.6\nrolling_resistance_m: 1e-3\n");
  EXPECT_EQ(material.stiffness_n_per_m, 2e4);
  EXPECT_EQ(material.damping_ns_per_m, 40.0);
  EXPECT_EQ(material.friction, 0.6);
  EXPECT_EQ(material.rolling_resistance_m, 1e-3);
}

TEST(ContactMaterial, KeepsItsDefaultsWhereKeysMayBeMissing) {
  const ContactMaterial material = Read("friction: 0.6\n", Presence::kDefault);
  EXPECT_EQ(material.stiffness_n_per_m, 1.0);
  EXPECT_EQ(material.friction, 0.6);
}

TEST(ContactMaterial, RefusesASpringWithoutStiffness) {
  EXPECT_THROW(Read("stiffness_n_per_m: 0\ndamping_ns_per_m: 40\nfriction: 0.6\n"), ConfigError);
  EXPECT_THROW(Read("damping_ns_per_m: 40\nfriction: 0.6\n"), ConfigError);
}

}  // namespace
}  // namespace dockyard
