#include "models/read/load_model_yaml.h"

#include <gmock/gmock.h>

#include "models/read/yaml_path.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::StartsWith;

TEST(ModelYaml, HasItsBasesKeysWithItsOwnOnTop) {
  const ScratchFolder folder;
  folder.Write("parts/base.yaml", "a: 1\nin: {b: 2, c: 3}\n");
  folder.Write("middle.yaml", "base: parts/base.yaml\nin: {c: 4}\n");
  const YamlNode tree = LoadModelYaml(folder.Write("top.yaml", "base: middle.yaml\na: 5\n"));
  EXPECT_EQ(FlowText(tree), "{\"a\": 5, \"in\": {\"b\": 2, \"c\": 4}}");
}

TEST(ModelYaml, TellsTheFileAndLineInWhichAKeyStands) {
  const ScratchFolder folder;
  folder.Write("base.yaml", "\n\na: 1\n");
  const YamlNode tree = LoadModelYaml(folder.Write("top.yaml", "base: base.yaml\nb: 2\n"));
  EXPECT_THAT(tree.Find("a")->place.Text(), HasSubstr("base.yaml:3:4"));
  EXPECT_THAT(tree.Find("b")->place.Text(), HasSubstr("top.yaml:2:4"));
}

TEST(ModelYaml, RefusesABaseThatIsNotThere) {
  const ScratchFolder folder;
  const std::string file = folder.Write("top.yaml", "a: 1\nbase: none.yaml\n");
  EXPECT_THAT(MessageOf([&] { LoadModelYaml(file); }, folder),
              HasSubstr("top.yaml:2:7: base: expected a file, found none at"));
}

TEST(ModelYaml, RefusesBasesThatLeadBackToTheFile) {
  const ScratchFolder folder;
  folder.Write("other.yaml", "base: top.yaml\n");
  const std::string file = folder.Write("top.yaml", "base: other.yaml\n");
  EXPECT_THAT(MessageOf([&] { LoadModelYaml(file); }, folder),
              HasSubstr("base: expected at most 5 files on top of each other, found more"));
}

}  // namespace
}  // namespace dockyard
