#include "sim/app/doctor.h"

#include <gmock/gmock.h>

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "app/program.h"
#include "sim/app/systems.h"
#include "sim/base/files.h"
#include "sim/base/json.h"
#include "sim/run/start_images.h"
#include "sim/scenario/load_scenario.h"
#include "support/bad_files.h"
#include "support/program_path.h"
#include "support/source_tree.h"

namespace dockyard {
namespace {

using ::testing::HasSubstr;

Finding Of(const std::vector<Finding>& findings, const std::string& name) {
  for (const Finding& finding : findings) {
    if (finding.name == name) return finding;
  }
  ADD_FAILURE() << "no finding " << name;
  return {};
}

Finding OfFact(const std::string& name, const std::string& value) {
  return Of(ExamineFacts({{name, value}}), name);
}

const MemoryLimit kEnough{8000.0, "free"};

TEST(Doctor, WarnsOfFactsByWhichRunsDiffer) {
  EXPECT_EQ(OfFact("variants", "pinned").health, Health::kOk);
  EXPECT_EQ(OfFact("variants", "of the processor").health, Health::kWarning);
  EXPECT_EQ(OfFact("mathematics", "0000000000000000").health, Health::kWarning);
  EXPECT_EQ(OfFact("processor", "unknown").health, Health::kWarning);
  EXPECT_EQ(OfFact("processor", "Z80").health, Health::kOk);
  const Finding blind = OfFact("gl_renderer", "none: no GL to draw with");
  EXPECT_EQ(blind.health, Health::kMissing);
  EXPECT_THAT(blind.advice, HasSubstr("libosmesa6"));
}

TEST(Doctor, ComparesASystemsImagesWithThoseOfDebian12) {
  const std::string here = "0123456789abcdef", there = "fedcba9876543210";
  EXPECT_EQ(ExamineImages("toy", here, here).name, "image_toy");
  EXPECT_EQ(ExamineImages("toy", here, here).health, Health::kOk);
  EXPECT_EQ(ExamineImages("toy", here, "").health, Health::kOk);
  EXPECT_EQ(ExamineImages("toy", here, there).health, Health::kWarning);
  EXPECT_EQ(ExamineImages("toy", "none: it crashed", there).health, Health::kMissing);
  const Finding unknown = ExamineImages("toy", kNoScenario, there);
  EXPECT_EQ(unknown.health, Health::kWarning);
  EXPECT_THAT(unknown.advice, HasSubstr("scenario is not found"));
}

TEST(Doctor, SaysHowManyRunsTheMemoryHolds) {
  const auto memory = [](double mib, const std::string& set_by) {
    return Of(ExamineMachine(4, {mib, set_by}, 1e6, "", 1.0), "memory");
  };
  EXPECT_EQ(memory(8000.0, "free").health, Health::kOk);
  EXPECT_EQ(memory(700.0, "cgroup").health, Health::kWarning);
  EXPECT_THAT(memory(700.0, "cgroup").advice, HasSubstr("--jobs 2"));
  EXPECT_EQ(memory(1100.0, "ulimit -v").health, Health::kOk);
  EXPECT_EQ(memory(700.0, "ulimit -v").health, Health::kMissing);
  EXPECT_EQ(memory(100.0, "free").health, Health::kMissing);
}

TEST(Doctor, SaysWhatToDoAboutEachLack) {
  const auto findings = ExamineMachine(1, kEnough, 10.0, "No locks available", 0.0);
  for (const char* name : {"disk", "lock", "/dev/shm"}) {
    EXPECT_EQ(Of(findings, name).health, Health::kWarning) << name;
    EXPECT_FALSE(Of(findings, name).advice.empty()) << name;
  }
  for (const Finding& finding : ExamineMachine(1, kEnough, 1e6, "", 64.0)) {
    EXPECT_EQ(finding.health, Health::kOk) << finding.name;
    EXPECT_TRUE(finding.advice.empty()) << finding.name;
  }
}

TEST(Machine, HasTheLeastLimitOfItsControlGroups) {
  const ScratchFolder folder;
  folder.Write("a/b/memory.max", "max\n");
  EXPECT_TRUE(std::isinf(CgroupLimitMib(folder.path(), "/a/b", "memory.max")));
  folder.Write("a/memory.max", "1048576000\n");
  EXPECT_EQ(CgroupLimitMib(folder.path(), "/a/b", "memory.max"), 1000.0);
  folder.Write("a/b/memory.max", "104857600\n");
  EXPECT_EQ(CgroupLimitMib(folder.path(), "/a/b", "memory.max"), 100.0);
  EXPECT_EQ(CgroupLimitMib(folder.path(), "/a", "memory.max"), 1000.0);
  EXPECT_TRUE(std::isinf(CgroupLimitMib(folder.path(), "/", "memory.max")));
}

TEST(Machine, TriesALockAndLeavesNothing) {
  const ScratchFolder folder;
  EXPECT_EQ(LockFault(folder.path()), "");
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  EXPECT_EQ(LockFault(folder.path() / "none"), "No such file or directory");
  EXPECT_GT(FreeDiskMib(folder.path()), 0.0);
  EXPECT_EQ(FreeDiskMib(folder.path() / "none"), 0.0);
}

/// The answer to `doctor --json` in this folder.
Json AnswerIn(const std::string& folder) {
  const ScratchFolder scratch;
  const std::string out = (scratch.path() / "out").string();
  const std::string call = "cd '" + folder + "' && '" + ProgramPath() + "' doctor --json >" + out;
  EXPECT_EQ(std::system(call.c_str()), 0);
  return Json::parse(ReadWhole(out).value_or("{}"));
}

TEST(DoctorCommand, ListsFactsAndFindingsAndTheImagesOfAllSystems) {
  const Json answer = AnswerIn(SourceDir());
  std::vector<std::string> names;
  for (const Json& finding : answer["findings"]) names.push_back(finding["name"]);
  EXPECT_THAT(names, testing::ElementsAre(
                         "dockyard", "program", "processor", "vectors", "libc", "variants",
                         "mathematics", "opencv", "bullet", "compiler", "gl", "gl_vendor",
                         "gl_renderer", "gl_version", "image_axel", "image_raposa", "image_rocky7",
                         "image_custom", "processors", "memory", "disk", "lock", "/dev/shm"));
  EXPECT_EQ(answer["images"].size(), Systems().size());
  for (const System& system : Systems()) {
    EXPECT_EQ(answer["images"][system.name], system.example_files.start_images) << system.name;
  }
}

TEST(DoctorCommand, HasTheSameFingerprintsWhateverTheProcessorHasAndInAnyFolder) {
  const auto prints = [](const std::string& folder) {
    std::string text;
    const Json answer = AnswerIn(folder);
    for (const Json& finding : answer["findings"]) {
      const std::string name = finding["name"];
      if (name == "mathematics" || name.starts_with(kImages)) {
        text += finding["value"].get<std::string>();
      }
    }
    return text;
  };
  const std::string unmasked = prints(SourceDir());
  EXPECT_EQ(unmasked.size(), 16u * (1 + Systems().size())) << unmasked;
  const std::vector<std::pair<const char*, const char*>> masks{
      {"OPENCV_CPU_DISABLE", "AVX512_SKX,AVX2,FP16,AVX,FMA3"},
      {"LP_NATIVE_VECTOR_WIDTH", "128"},
      {"GLIBC_TUNABLES", "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-AVX"}};
  for (const auto& [name, value] : masks) ::setenv(name, value, 1);
  EXPECT_EQ(prints("/"), unmasked);
  for (const auto& [name, value] : masks) ::unsetenv(name);
}

// That runs differ there, too: scripts/renderers.
TEST(StartImages, DifferUnderAnotherRenderer) {
  const std::vector<System> systems = Systems();
  const System& system = FindSystem(systems, "rocky7");
  ::setenv("GALLIUM_DRIVER", "softpipe", 1);
  const std::string images = StartImages(
      system, LoadScenario(SourceFile(system.example_files.scenario), {}, KnownSystems(systems)));
  ::unsetenv("GALLIUM_DRIVER");
  EXPECT_EQ(images.size(), 16u) << images;
  EXPECT_NE(images, system.example_files.start_images);
}

TEST(DoctorCommand, EndsWithTenWhereNothingCanBeDrawn) {
  ::setenv("MESA_GL_VERSION_OVERRIDE", "2.1", 1);
  const Ended blind = Dockyard("doctor");
  ::unsetenv("MESA_GL_VERSION_OVERRIDE");
  EXPECT_EQ(blind.code, 10);
  EXPECT_THAT(blind.out, HasSubstr("missing  gl_renderer  none: "));
  ::setenv("DOCKYARD_GL", "vulkan", 1);
  EXPECT_EQ(Dockyard("doctor").code, 3);
  ::unsetenv("DOCKYARD_GL");
}

}  // namespace
}  // namespace dockyard
