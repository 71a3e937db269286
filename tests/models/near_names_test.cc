// What a wrong name was meant to be, and where a refusal of another kind leads.
#include <gmock/gmock.h>

#include <fstream>

#include "models/read/load_soil.h"
#include "models/read/near_names.h"
#include "models/read/other_kind.h"
#include "models/read/text_file.h"
#include "support/bad_files.h"

namespace dockyard {
namespace {

using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

class NearFiles : public testing::Test {
 protected:
  NearFiles() {
    fs::create_directories(folder_.path() / "models" / "axel");
    for (const char* name : {"axel_typical.yaml", "mars_yard_40.yaml", "models/axel/axel.urdf"}) {
      std::ofstream(folder_.path() / name) << "x: 1\n";
    }
  }
  std::string Near(const std::string& name) const {
    const std::string near = NearFile(folder_.path() / name);
    return near.empty() ? "" : fs::path(near).lexically_relative(folder_.path()).string();
  }
  ScratchFolder folder_;
};

TEST(NearestName, IsOneThatASlipOfThePenAway) {
  EXPECT_EQ(NearestName("lenght_m", {"width_m", "length_m"}), "length_m");
  EXPECT_EQ(NearestName("rm", {"r_m", "alpha_deg"}), "r_m");
  EXPECT_EQ(NearestName("colour", {"radius_m", "width_m"}), "");
  EXPECT_EQ(NearestName("SINKAGE_MM", {"slip", "sinkage_mm"}), "sinkage_mm");
  EXPECT_EQ(NearestName("X_m", {"u_m", "x_m"}), "x_m");
  EXPECT_EQ(NearestName(std::string(5000, 'x'), {"radius_m"}), "");
}

TEST(DidYouMean, NamesTheNearestOrTheOnlyOneThatBeginsSo) {
  EXPECT_EQ(DidYouMean("runn", {"run", "replay"}), ", did you mean 'run'?");
  EXPECT_EQ(DidYouMean("camp", {"campaign", "camera"}), ", did you mean 'campaign'?");
  EXPECT_EQ(DidYouMean("rep", {"replay", "report"}), "");  // two begin so
  EXPECT_EQ(DidYouMean("xyz", {"run", "replay"}), "");
}

TEST_F(NearFiles, AreFoundForASlipInAnyPartOfThePath) {
  EXPECT_EQ(Near("axel_typcal.yaml"), "axel_typical.yaml");
  EXPECT_EQ(Near("axel_typical.yml"), "axel_typical.yaml");
  EXPECT_EQ(Near("axel_typical"), "axel_typical.yaml");
  EXPECT_EQ(Near("model/axel/axel.urdf"), "models/axel/axel.urdf");
  EXPECT_EQ(Near("modles/axle/axel.urdf"), "models/axel/axel.urdf");
}

TEST_F(NearFiles, AreNotFoundForANameUnlikeAnyOrForOneThatIsThere) {
  EXPECT_EQ(Near("station.yaml"), "");
  EXPECT_EQ(Near("nowhere/station.yaml"), "");
  EXPECT_EQ(Near("axel_typical.yaml"), "");
}

TEST_F(NearFiles, AreNamedWhereAFileIsMissing) {
  const std::string message =
      MessageOf([&] { ReadText(folder_.path() / "axel_typcal.yaml"); }, folder_);
  EXPECT_THAT(message, HasSubstr("axel_typcal.yaml: no such file, did you mean '"));
  EXPECT_THAT(message, EndsWith("axel_typical.yaml'?"));
}

TEST(OtherKind, IsNamedWhereAKeyOrALinkIsOfNoSuchThing) {
  for (const char* message : {"dock.yaml:1:1: missing key 'cone'",
                              "dock.yaml:4:3: board.family: unknown key, known are: a",
                              "amr.urdf:3: expected the root link to be 'body'",
                              "s.yaml:2:9: system: expected one of axel, raposa, found 'amr'"}) {
    const std::string hinted = WithOtherKind(message, "robot");
    EXPECT_THAT(hinted, HasSubstr("docs/contributing.md")) << message;
    EXPECT_EQ(WithOtherKind(hinted, "robot"), hinted);
  }
}

TEST(OtherKind, IsNamedForARobotsFileInPlaceOfAGround) {
  try {
    LoadSoil(SourceFile("models/axel/axel.yaml"));
    FAIL() << "read as a ground";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a ground of another kind needs a system of its own"));
  }
}

TEST(OtherKind, IsNotNamedForSlipsAndWrongNumbers) {
  for (const char* message :
       {"a.yaml:4:3: board.fidcials: unknown key, did you mean 'fiducials'?",
        "a.yaml:16:9: cameras.sensor.exposure.stops: unknown key, known are: rule",
        "a.yaml:4:3: mass_kg: expected a number > 0, found 'ten'",
        "a.yaml:9:5: motors.wheel: missing key 'resistance_ohm'"}) {
    EXPECT_EQ(WithOtherKind(message, "robot"), message);
  }
}

}  // namespace
}  // namespace dockyard
