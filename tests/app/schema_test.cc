// The schemas of scenarios and campaigns against an independent validator.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <regex>

#include "app/program.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
namespace fs = std::filesystem;

class Schema : public testing::TestWithParam<std::string> {
 protected:
  Schema() { WriteText(SchemaFile(), Dockyard("schema " + GetParam()).out); }
  fs::path SchemaFile() const { return folder_.path() / "schema.json"; }

  /// What the validator says of the files; empty if all fit.
  std::string Faults(const std::string& files) const {
    const fs::path out = folder_.path() / "faults";
    const std::string command = "python3 '" + SourceFile("tests/app/schema_check.py") + "' '" +
                                SchemaFile().string() + "' " + files + " >'" + out.string() +
                                "' 2>&1";
    const int status = std::system(command.c_str());
    const std::string said = Slurp(out);
    EXPECT_EQ(status == 0, said.empty()) << said;
    return said;
  }
  std::string FaultsOfText(const std::string& text) const {
    const fs::path file = folder_.path() / "changed.yaml";
    WriteText(file, text);
    return Faults("'" + file.string() + "'");
  }
  /// Expects a fault in each file of `good` with one of the parts at its end. One call for all.
  void ExpectRefused(const std::string& good, const std::vector<std::string>& parts) const {
    std::string files;
    const auto name = [&](std::size_t i) {
      return (folder_.path() / ("bad_" + std::to_string(i) + ".yaml")).string();
    };
    for (std::size_t i = 0; i < parts.size(); ++i) {
      WriteText(name(i), good + parts[i]);
      files += " '" + name(i) + "'";
    }
    const std::string faults = Faults(files);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_THAT(faults, HasSubstr(name(i) + ": ")) << parts[i];
    }
  }
  /// Files of scenarios/ that are of the kind, by a key that the kind alone has at the line's head.
  std::vector<std::string> FilesOfKind() const {
    const std::regex head(GetParam() == "scenario" ? "(^|\n)start:" : "(^|\n)campaign:");
    std::vector<std::string> files;
    for (const char* dir : {"scenarios", "scenarios/studies", "examples/python"}) {
      for (const auto& entry : fs::directory_iterator(SourceFile(dir))) {
        if (entry.path().extension() != ".yaml") continue;
        if (std::regex_search(Slurp(entry.path()), head)) files.push_back(entry.path().string());
      }
    }
    return files;
  }

  const TemporaryFolder folder_;
};

TEST_P(Schema, TakesEveryFileOfTheProject) {
  const std::vector<std::string> files = FilesOfKind();
  EXPECT_GE(files.size(), 4u);
  std::string words;
  for (const std::string& file : files) words += " '" + file + "'";
  EXPECT_EQ(Faults(words), "");
}

INSTANTIATE_TEST_SUITE_P(Of, Schema, testing::Values("scenario", "campaign"));

TEST_P(Schema, RefusesWhatTheReaderRefuses) {
  if (GetParam() != "scenario") return;
  const std::string good = Slurp(SourceFile("scenarios/axel_typical.yaml"));
  const std::string added = "\nyard: {cell_m: 0.02}\n";
  ASSERT_EQ(good.find("\nyard:"), std::string::npos);
  EXPECT_EQ(FaultsOfText(good + added), "");
  ExpectRefused(good,
                {"\nyrad: {cell_m: 0.02}\n", "\nyard: {cel_m: 0.02}\n", "\nyard: {cell_m: fine}\n",
                 "\nyard: {cell_m: 0.5}\n", "\nyard: {cell_m: true}\n", "\nyard: [0.02]\n",
                 "\nraposa: {}\n", "\ntime_limit_s: 0\n", "\nsite: {x_m: 2e6}\n",
                 "\ncamera: {width_px: 64.5}\n", "\ncamera: {left: {picture: black}}\n"});
}

TEST_P(Schema, KnowsTheKeysOfEachSystem) {
  if (GetParam() != "scenario") return;
  const std::string good = Slurp(SourceFile("scenarios/raposa_point_9.yaml"));
  ASSERT_EQ(FaultsOfText(good), "");
  EXPECT_NE(FaultsOfText(std::regex_replace(good, std::regex("pyramid:"), "piramid:")), "");
  EXPECT_NE(FaultsOfText(good + "\naxel: {station: x.yaml}\n"), "");
}

TEST_P(Schema, RefusesACampaignThatTheReaderRefuses) {
  if (GetParam() != "campaign") return;
  const std::string good = "campaign: yard\nbase: axel_typical.yaml\n";
  EXPECT_EQ(FaultsOfText(good), "");
  EXPECT_EQ(FaultsOfText(good + "draw: {start.r_m: {uniform: {min: 2, max: 3}}}\nkeep: none\n"),
            "");
  ExpectRefused(
      good,
      {"desing: {runs: 5}\n", "design: {runs: 0}\n", "design: {kind: sobl}\n", "keep: some\n",
       "draw: {start.r_m: {unifrom: {min: 2, max: 3}}}\n",
       "draw: {start.r_m: {uniform: {min: 2}}}\n", "draw: {seed: {uniform: {min: 2, max: 3}}}\n",
       "vary: {start.r_m: 5}\n", "vary: {start.r_m: {from: 1, to: 2}}\n", "scenario: {yrad: {}}\n",
       "limits: {retries: 11}\n", "correlate: [{keys: [a], rank: 0.5}]\n", "seed: -1\n"});
  EXPECT_NE(FaultsOfText("campaign: yard\n"), "");               // no base
  EXPECT_NE(FaultsOfText("campaign: a/b\nbase: x.yaml\n"), "");  // no name of a folder
}

/// A kind of model files, some of them, and a required key of theirs.
struct ModelFiles {
  std::string kind;
  std::vector<std::string> files;
  std::string key;
};

class ModelSchema : public testing::TestWithParam<ModelFiles> {
 protected:
  ModelSchema() {
    WriteText(folder_.path() / "schema.json", Dockyard("schema " + GetParam().kind).out);
  }

  /// What the validator says of the files.
  std::string Faults(const std::vector<std::string>& files) const {
    const std::string out = (folder_.path() / "faults").string();
    std::string command = "python3 '" + SourceFile("tests/app/schema_check.py") + "' '" +
                          (folder_.path() / "schema.json").string() + "'";
    for (const std::string& file : files) command += " '" + file + "'";
    std::system((command + " >'" + out + "' 2>&1").c_str());
    return Slurp(out);
  }

  const TemporaryFolder folder_;
};

TEST_P(ModelSchema, TakesTheFilesOfItsKindAndRefusesATypoAsTheReaderDoes) {
  std::vector<std::string> files;
  for (const std::string& file : GetParam().files) files.push_back(SourceFile(file));
  EXPECT_EQ(Faults(files), "");
  const std::string folder = fs::path(files[0]).parent_path().string() + "/";
  const std::string good =
      std::regex_replace(Slurp(files[0]), std::regex("\nbase: "), "\nbase: " + folder);
  const std::size_t at = ("\n" + good).find("\n" + GetParam().key + ":");
  ASSERT_NE(at, std::string::npos);
  const std::string written = (folder_.path() / "bad.yaml").string();
  WriteText(written, good.substr(0, at) + "x" + good.substr(at));
  EXPECT_NE(Faults({written}), "");
  EXPECT_THAT(Dockyard("check " + written).err, HasSubstr("x" + GetParam().key + ": unknown key"));
}

INSTANTIATE_TEST_SUITE_P(
    Of, ModelSchema,
    testing::Values(
        ModelFiles{
            "soil",
            {"models/soils/compact_gravel.yaml", "models/soils/loose_sand.yaml",
             "models/soils/ding_2011.yaml", "models/soils/fjs_1.yaml", "models/soils/grc_1.yaml",
             "models/soils/grc_3.yaml", "models/soils/lete_sand.yaml",
             "models/soils/pavlov_90.yaml", "models/soils/wong_dry_sand.yaml"},
            "source"},
        ModelFiles{"board",
                   {"models/boards/five_discs.yaml", "models/boards/grid_4x3.yaml",
                    "models/boards/asymmetric_4x11.yaml", "models/boards/charger_tag.yaml",
                    "models/boards/four_tags.yaml"},
                   "name"},
        ModelFiles{"axel.robot",
                   {"models/axel/axel.yaml", "models/axel/axel_coaxial.yaml",
                    "models/axel/axel_former_mating.yaml", "models/axel/axel_field.yaml"},
                   "tether"},
        ModelFiles{"axel.station",
                   {"models/axel/station/station.yaml", "models/axel/station/station_anchored.yaml",
                    "models/axel/station/station_former_mating.yaml"},
                   "feet"},
        ModelFiles{"raposa.robot", {"models/raposa/raposa.yaml"}, "lamps"},
        ModelFiles{"raposa.pyramid", {"models/raposa/pyramid/pyramid.yaml"}, "cable"},
        ModelFiles{"rocky7.robot", {"models/rocky7/rocky7.yaml"}, "imu"}),
    [](const auto& info) { return std::regex_replace(info.param.kind, std::regex("[.]"), "_"); });

TEST(SchemaCommand, DescribesKeysWithUnitsDefaultsAndRanges) {
  const Ended ended = Dockyard("schema scenario");
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("https://json-schema.org/draft/2020-12/schema"));
  const std::string flat = std::regex_replace(ended.out, std::regex("\\s+"), " ");
  EXPECT_THAT(flat,
              HasSubstr("\"length_m\": { \"type\": \"number\", \"minimum\": 4.0, \"maximum\": "
                        "200.0, \"description\": \"of the ground, from 1.5 m behind the "
                        "target [m]\", \"default\":"));
  EXPECT_EQ(Dockyard("schema robot").code, 2);
}

}  // namespace
}  // namespace dockyard
