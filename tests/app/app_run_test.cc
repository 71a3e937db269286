// Whole short runs through the program: the real world, with a short time limit.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <algorithm>
#include <chrono>
#include <fstream>
#include <iterator>
#include <map>
#include <thread>

#include "app/program.h"
#include "sim/app/systems.h"
#include "sim/base/json.h"
#include "sim/campaign/campaign_folder.h"
#include "sim/campaign/merge.h"
#include "sim/campaign/shard_file.h"
#include "sim/images/png.h"
#include "sim/log/result_row.h"
#include "support/edited_log.h"
#include "support/fake_runs.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;
namespace fs = std::filesystem;

RowColumns AxelColumns(const std::vector<std::string>& labels) {
  return Systems().front().Columns(labels);
}

TEST(ProgramRun, ThatHasNoTimeToDockEndsWithFour) {
  const Ended ended = Dockyard("run scenarios/axel_typical.yaml --set time_limit_s=3 --json");
  EXPECT_EQ(ended.code, 4);
  const Json json = Json::parse(ended.out);
  EXPECT_EQ(json["success"], false);
  EXPECT_EQ(json["success_word"], "docked");
  EXPECT_GT(json["cpu_time_s"].get<double>(), 0.0);
  EXPECT_EQ(json.size(), ColumnNames(AxelColumns({})).size() + 4);
  EXPECT_EQ(json["warnings"], Json::array());
  EXPECT_THAT(json["failure_note"].get<std::string>(), Not(testing::IsEmpty()));
}

TEST(ProgramRun, WithTheSameSeedHasTheSameStateHash) {
  const auto hash = [](const std::string& seed) {
    const Ended ended =
        Dockyard("run scenarios/axel_typical.yaml --set time_limit_s=3 --json --seed " + seed);
    return Json::parse(ended.out)["state_hash"].get<std::string>();
  };
  const std::string first = hash("5");
  EXPECT_EQ(first, hash("5"));
  EXPECT_NE(first, hash("6"));
}

// Each mask hides instructions of the processor from one library: OpenCV, Mesa, the C library.
TEST(ProgramRun, HasTheSameStateHashWhateverTheProcessorHas) {
  const auto hash = [] {
    const Ended ended = Dockyard(
        "run scenarios/axel_typical.yaml --set time_limit_s=12 --set camera.width_px=640 "
        "--set camera.height_px=480 --json");
    const Json json = Json::parse(ended.out);
    EXPECT_GT(json["images"].get<int>(), 0);
    return json["state_hash"].get<std::string>();
  };
  const std::string unmasked = hash();
  const std::vector<std::pair<const char*, const char*>> masks{
      {"OPENCV_CPU_DISABLE", "AVX512_SKX,AVX2,FP16,AVX,FMA3"},
      {"LP_NATIVE_VECTOR_WIDTH", "128"},
      {"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-AVX"}};
  for (const auto& [name, value] : masks) {
    ::setenv(name, value, 1);
    EXPECT_EQ(hash(), unmasked) << name;
  }
  EXPECT_EQ(hash(), unmasked) << "all three";
  for (const auto& [name, value] : masks) ::unsetenv(name);
}

TEST(ProgramRun, FeelsAMastOnAFixedJoint) {
  const TemporaryFolder folder;
  const fs::path axel = folder.path() / "axel";
  const fs::path models = SourceFile("models");
  fs::copy(models / "axel", axel, fs::copy_options::recursive);
  const auto hash = [&] {
    const Ended ended =
        Dockyard("run scenarios/axel_typical.yaml --set time_limit_s=1 --set robot=" +
                 (axel / "axel.yaml").string() + " --json");
    EXPECT_EQ(ended.code, 4) << ended.err;
    return Json::parse(ended.out)["state_hash"].get<std::string>();
  };
  const std::string without = hash();
  EXPECT_EQ(hash(), without);
  std::ifstream in(axel / "axel.urdf");
  std::string urdf((std::istreambuf_iterator<char>(in)), {});
  urdf.insert(urdf.rfind("</robot>"),
              "<link name=\"mast\"><inertial><mass value=\"6\"/><inertia ixx=\"0.2\" iyy=\"0.2\" "
              "izz=\"0.1\" ixy=\"0\" ixz=\"0\" iyz=\"0\"/></inertial></link>"
              "<joint name=\"mast_joint\" type=\"fixed\"><parent link=\"body\"/>"
              "<child link=\"mast\"/><origin xyz=\"0 0 0.5\"/></joint>");
  std::ofstream(axel / "axel.urdf") << urdf;
  EXPECT_NE(hash(), without);
}

TEST(ProgramRun, LeavesItsLogAndHistoryInItsFolder) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  for (int again = 0; again < 2; ++again) {
    EXPECT_EQ(Dockyard("run scenarios/axel_typical.yaml --set time_limit_s=2 --out " + out).code,
              4);
  }
  for (const char* file : {"resolved.yaml", "run.mcap", "history.csv", "outcome.json",
                           "sightings.json", "plans.json", "result.csv"}) {
    EXPECT_TRUE(fs::exists(fs::path(out) / file)) << file;
  }
  EXPECT_EQ(Dockyard("report --svg " + out).code, 0);
  for (const char* file : {"path.svg", "history.svg"}) {
    EXPECT_THAT(Slurp(fs::path(out) / file), HasSubstr("timeout after 2 s")) << file;
  }
}

/// Names and bytes of all files of a folder.
std::map<std::string, std::string> FilesIn(const fs::path& dir) {
  std::map<std::string, std::string> files;
  for (const auto& entry : fs::directory_iterator(dir)) {
    files[entry.path().filename().string()] = Slurp(entry.path());
  }
  return files;
}

TEST(ProgramFrames, WritesTheImagesOfALogWithAndWithoutMarks) {
  const TemporaryFolder folder;
  const std::string run = (folder.path() / "run").string();
  const fs::path marked = folder.path() / "marked", plain = folder.path() / "plain";
  Dockyard("run scenarios/axel_typical.yaml --set time_limit_s=6 --out " + run);
  ASSERT_EQ(Dockyard("frames " + run + " --out " + marked.string()).code, 0);
  ASSERT_EQ(Dockyard("frames " + run + " --plain --out " + plain.string()).code, 0);
  const Json list = Json::parse(Slurp(marked / "frames.json"));
  ASSERT_GE(list.size(), 2u);
  EXPECT_EQ(list[0]["file"], "look_001_left.png");
  EXPECT_EQ(list[0]["accepted"], true);
  const auto drawn = DecodePng<RgbImage>(Slurp(marked / "look_001_left.png"));
  const auto seen = DecodePng<GrayImage>(Slurp(plain / "look_001_left.png"));
  ASSERT_TRUE(drawn && seen);
  // The marks are all that differs.
  const RgbImage gray = AsColour(*seen);
  std::size_t differing = 0;
  for (std::size_t i = 0; i < gray.pixels.size(); ++i) {
    differing += gray.pixels[i] != drawn->pixels[i];
  }
  EXPECT_GT(differing, 200u);
  EXPECT_LT(differing, gray.pixels.size() / 20);
  fs::remove(fs::path(run) / "run.mcap");
  EXPECT_EQ(Dockyard("frames " + run + " --out " + marked.string()).code, 10);
}

/// The folders of one run: its log keeps one image a second, and all.
std::pair<std::string, std::string> ThinAndWhole(const TemporaryFolder& folder) {
  const std::string scenario = "run scenarios/raposa_point_9.yaml --set time_limit_s=1.5",
                    thin = (folder.path() / "thin").string(),
                    whole = (folder.path() / "whole").string();
  Dockyard(scenario + " --out " + thin);
  Dockyard(scenario + " --set log_image_gap_s=0 --out " + whole);
  return {thin, whole};
}

// One image a second, the others made again: the replay has all of them, bit for bit.
TEST(ProgramFrames, MakesImagesThatALogDoesNotKeepByARunAnew) {
  const TemporaryFolder folder;
  const auto [thin, whole] = ThinAndWhole(folder);
  EXPECT_LT(3 * fs::file_size(fs::path(thin) / "run.mcap"),
            fs::file_size(fs::path(whole) / "run.mcap"));
  const fs::path made = folder.path() / "made", kept = folder.path() / "kept";
  const Ended frames = Dockyard("frames " + thin + " --plain --out " + made.string());
  EXPECT_THAT(frames.err, HasSubstr("made by simulating the run again"));
  ASSERT_EQ(Dockyard("frames " + whole + " --plain --out " + kept.string()).code, 0);
  EXPECT_EQ(FilesIn(made), FilesIn(kept));
  EXPECT_GE(FilesIn(made).size(), 14u);
  const Ended replay = Dockyard("replay " + thin);
  EXPECT_THAT(replay.out, HasSubstr("controller alone: same commands at all 15 steps"));
  EXPECT_EQ(replay.code, 0);
}

// The page of a log that keeps one image a second is as large as that of a log that keeps all.
TEST(ProgramReport, MakesImagesThatALogDoesNotKeepByARunAnew) {
  const TemporaryFolder folder;
  const auto [thin, whole] = ThinAndWhole(folder);
  const fs::path kept = folder.path() / "kept.html", made = folder.path() / "made.html",
                 all = folder.path() / "all.html";
  ASSERT_EQ(Dockyard("report " + thin + " --out " + kept.string()).code, 0);
  const Ended report = Dockyard("report " + thin + " --all-images --out " + made.string());
  ASSERT_EQ(report.code, 0);
  EXPECT_THAT(report.err, HasSubstr("made by simulating the run again"));
  ASSERT_EQ(Dockyard("report " + whole + " --out " + all.string()).code, 0);
  const auto size = [](const fs::path& file) { return static_cast<double>(fs::file_size(file)); };
  EXPECT_NEAR(size(made), size(all), 1000.0);
  EXPECT_GT(size(made), size(kept) + 20'000.0);
}

// The program prints the pixel that it found: the ring is there.
TEST(ProgramFrames, DrawsTheMarksOfAProgramWhereItFoundThem) {
  const TemporaryFolder folder;
  const fs::path run = folder.path() / "run", images = folder.path() / "images";
  Dockyard("run examples/python/dock_straight.yaml --set time_limit_s=0.3 --allow-commands --out " +
           run.string());
  const std::string said = Slurp(run / "messages.txt"), word = "darkest at (";
  ASSERT_THAT(said, HasSubstr(word));
  const int u = std::stoi(said.substr(said.find(word) + word.size()));
  const Json sightings = Json::parse(Slurp(run / "sightings.json"));
  ASSERT_EQ(sightings.size(), 1u);
  EXPECT_EQ(sightings[0]["accepted"], false);
  EXPECT_EQ(sightings[0]["marks"][0]["u_px"], u);
  const int v = sightings[0]["marks"][0]["v_px"];
  ASSERT_EQ(Dockyard("frames " + run.string() + " --out " + images.string()).code, 0);
  const Json first = Json::parse(Slurp(images / "frames.json"))[0];
  EXPECT_EQ(first["verdict"], "no pose");
  const auto drawn = DecodePng<RgbImage>(Slurp(images / first["file"].get<std::string>()));
  ASSERT_TRUE(drawn);
  const int radius = drawn->width / 128;
  const std::uint8_t* ring =
      &drawn->pixels[3 * static_cast<std::size_t>(v * drawn->width + u + radius)];
  EXPECT_GT(ring[1], ring[0] + 50);  // green, in a grey image
  EXPECT_GT(ring[1], ring[2] + 50);
}

// A log that is gone is made again: the same run gives the same film.
TEST(ProgramReplay, DrawsTheSameFramesFromALogAndWithoutIt) {
  const TemporaryFolder folder;
  const std::string run = (folder.path() / "run").string();
  const fs::path logged = folder.path() / "logged", anew = folder.path() / "anew";
  Dockyard("run scenarios/axel_typical.yaml --set time_limit_s=4.5 --out " + run);
  const std::string film = "replay " + run + " --period 2 --size 320x180 --frames ";
  const Ended ended = Dockyard(film + logged.string());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.out, HasSubstr("ffmpeg -framerate 0.5 -i '" + logged.string()));
  fs::remove(fs::path(run) / "run.mcap");
  ASSERT_EQ(Dockyard(film + anew.string()).code, 0);
  const auto files = FilesIn(logged);
  EXPECT_EQ(files.size(), 4u);  // 0, 2 and 4 s, and the end
  EXPECT_EQ(files, FilesIn(anew));
}

TEST(ProgramView, ShowsTheWorldFromOutsideAsTheRunMadeIt) {
  const TemporaryFolder folder;
  const std::string view = "view scenarios/axel_typical.yaml --outside --size 320x180 ";
  const fs::path start = folder.path() / "start", later = folder.path() / "later";
  ASSERT_EQ(Dockyard(view + "--out " + start.string()).code, 0);
  const Ended ended = Dockyard(view + "--time 8 --out " + later.string());
  ASSERT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(ended.err, HasSubstr("8.0 s"));
  const auto first = DecodePng<RgbImage>(Slurp(start / "outside.png"));
  const auto second = DecodePng<RgbImage>(Slurp(later / "outside.png"));
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->width, 320);
  EXPECT_EQ(first->height, 180);
  EXPECT_NE(first->pixels, second->pixels);
}

/// scenarios/ci_4.yaml with a time limit that makes it short.
std::string ShortCampaign(const fs::path& out, int jobs) {
  return "campaign scenarios/ci_4.yaml --quiet --set scenario.time_limit_s=3 --jobs " +
         std::to_string(jobs) + " --out " + out.string();
}

TEST(ProgramCampaign, ComesOutTheSameOnOneProcessorAndOnTwoAndReplays) {
  const TemporaryFolder folder;
  const fs::path one = folder.path() / "1", two = folder.path() / "2";
  ASSERT_EQ(Dockyard(ShortCampaign(one, 1)).code, 0);
  ASSERT_EQ(Dockyard(ShortCampaign(two, 2)).code, 0);
  EXPECT_EQ(Slurp(one / "results.csv"), Slurp(two / "results.csv"));
  EXPECT_EQ(Slurp(one / "results.sqlite"), Slurp(two / "results.sqlite"));

  const RowColumns columns = AxelColumns(
      {"day", "region", "soil", "light", "start.r_m", "start.alpha_deg", "start.heading_deg"});
  const int run = ReadShards(one, RowCheck::OfNoCampaign(), columns).results.front().run;
  const std::string replay = "replay " + one.string() + " " + std::to_string(run);
  const Ended same = Dockyard(replay);
  EXPECT_EQ(same.code, 0) << same.out;
  EXPECT_THAT(same.out, HasSubstr("same result row, bit for bit"));
  EXPECT_THAT(same.out, HasSubstr("controller alone: same"));
  EXPECT_THAT(same.err, Not(HasSubstr("differs")));
  EXPECT_EQ(Dockyard("replay " + RunFolder(one, run).string()).out, same.out);

  FinishedRuns kept = ReadShards(one, RowCheck::OfNoCampaign(), columns);
  kept.results[0].state_hash ^= 1;
  const fs::path shard = ShardFile(one, Shard{});
  fs::remove(shard);
  ShardWriter(shard, {{"shard", "x"}}, columns)
      .Append({kept.results[0], kept.timings[0], kept.notes[0]});
  const Ended other = Dockyard(replay);
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.out, HasSubstr("state_hash"));

  fs::remove(shard);
  EXPECT_EQ(Dockyard(replay).code, 10);
  EXPECT_EQ(Dockyard("replay " + one.string() + " 999").code, 2);
}

TEST(ProgramCampaign, ReplaysElsewhereWithoutTheModelsThatItWasRunWith) {
  const TemporaryFolder folder;
  const fs::path home = folder.path() / "home", away = folder.path() / "away";
  for (const char* part : {"scenarios", "models"}) {
    fs::create_directories(home / part);
    fs::copy(SourceFile(part), home / part, fs::copy_options::recursive);
  }
  const std::string campaign = (home / "scenarios/ci_4.yaml").string();
  ASSERT_EQ(Dockyard("campaign " + campaign + " --quiet --set scenario.time_limit_s=3 --out " +
                     (home / "out").string())
                .code,
            0);
  for (const auto& entry : fs::recursive_directory_iterator(home / "out")) {
    const std::string extension = entry.path().extension().string();
    if (extension != ".yaml" && extension != ".json" && extension != ".rows") continue;
    EXPECT_EQ(Slurp(entry.path()).find(home.string()), std::string::npos) << entry.path();
  }
  fs::rename(home / "out", away);
  fs::remove_all(home);
  const Ended replay = Dockyard("replay " + away.string() + " 14");
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
  EXPECT_EQ(replay.err, "");
}

TEST(ProgramCampaign, MergesShardsOfSeveralFoldersToTheSameResults) {
  const TemporaryFolder folder;
  const fs::path whole = folder.path() / "whole", all = folder.path() / "all";
  ASSERT_EQ(Dockyard(ShortCampaign(whole, 2)).code, 0);
  for (const char* number : {"1", "2"}) {
    const std::string part = ShortCampaign(folder.path() / number, 1) + " --shard " + number + "/2";
    ASSERT_EQ(Dockyard(part).code, 0);
  }
  EXPECT_EQ(Dockyard("merge " + all.string() + " " + (folder.path() / "1").string()).code, 10);
  EXPECT_EQ(Dockyard("merge " + all.string() + " " + (folder.path() / "2").string()).code, 0);
  EXPECT_EQ(Slurp(all / "results.csv"), Slurp(whole / "results.csv"));
  EXPECT_EQ(Slurp(all / "summary.txt"), Slurp(whole / "summary.txt"));
  EXPECT_EQ(Dockyard("campaign --watch " + all.string()).code, 0);
  EXPECT_EQ(Dockyard("replay " + all.string() + " 14").code, 0);
}

TEST(ProgramRun, ReplaysFromItsOwnFolder) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "run").string();
  const std::string replay = "replay " + out;
  ASSERT_EQ(
      Dockyard("run scenarios/axel_typical.yaml --seed 9 --set time_limit_s=2 --out " + out).code,
      4);
  const Ended same = Dockyard(replay);
  EXPECT_EQ(same.code, 0) << same.out << same.err;
  EXPECT_THAT(same.out, HasSubstr("same result row, bit for bit"));
  EXPECT_THAT(same.out, HasSubstr("controller alone: same"));
  EXPECT_EQ(Dockyard(replay + " 2").code, 2);  // it holds one run

  const fs::path file = fs::path(out) / "run.mcap", aside = folder.path() / "run.mcap";
  fs::rename(file, aside);  // half of the comparison is then left out
  EXPECT_EQ(Dockyard(replay).code, 10);
  fs::rename(aside, file);

  const std::string log = Slurp(file);  // a controller is never made from the log's own numbers
  const auto edit = [&](const std::string& is, const std::string& becomes) {
    WriteText(file, log);
    EditLog(file, [&](McapAttachment& each) {
      if (each.name == "header.json") each.data = Replaced(each.data, is, becomes);
    });
  };
  edit("\"drum_radius_m\":0", "\"drum_radius_m\":1");
  const Ended other = Dockyard(replay);
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.out, HasSubstr("the models' nominal parameters are not the log's"));
  edit("\"system\":\"axel\"", "\"system\":\"alex\"");
  const Ended alien = Dockyard(replay);
  EXPECT_EQ(alien.code, 3);
  EXPECT_THAT(alien.err, HasSubstr("expected one of the system axel, found one of 'alex'"));
  WriteText(file, log.substr(0, log.size() / 2));
  const Ended torn = Dockyard(replay);
  EXPECT_EQ(torn.code, 10);
  EXPECT_THAT(torn.out, HasSubstr("the log is cut short"));
  WriteText(file, log);

  const fs::path result = fs::path(out) / "result.csv";
  std::string text = Slurp(result);
  text.replace(text.size() - 2, 1, text[text.size() - 2] == '0' ? "1" : "0");  // of the state hash
  WriteText(result, text);
  EXPECT_EQ(Dockyard(replay).code, 1);
  fs::remove(result);
  EXPECT_EQ(Dockyard(replay).code, 10);
}

TEST(ProgramCampaign, StoppedByASignalKeepsItsRunsAndGoesOnToTheSameResults) {
  const TemporaryFolder folder;
  const fs::path straight = folder.path() / "straight";
  ASSERT_EQ(Dockyard(ShortCampaign(straight, 2)).code, 0);
  for (const int signal : {SIGINT, SIGTERM}) {
    const fs::path stopped = folder.path() / std::to_string(signal);
    const fs::path results = stopped / "results.csv", shard = ShardFile(stopped, Shard{});
    const pid_t process = StartDockyard(ShortCampaign(stopped, 1));
    const auto rows = [&] {
      const std::string text = fs::exists(shard) ? Slurp(shard) : "";
      return std::count(text.begin(), text.end(), '\n') - 2;
    };
    for (int i = 0; i < 6000 && rows() < 1; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
    }
    ASSERT_GE(rows(), 1);
    ::kill(process, signal);
    EXPECT_EQ(WaitForEnd(process), 128 + signal);
    EXPECT_LT(rows(), 4);
    EXPECT_EQ(Dockyard(ShortCampaign(stopped, 2)).code, 0);
    EXPECT_EQ(Slurp(results), Slurp(straight / "results.csv"));
  }
}

}  // namespace
}  // namespace dockyard
