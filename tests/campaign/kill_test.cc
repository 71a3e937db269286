// A campaign under random disturbances: whatever kills, stops or starves its processes, the same
// command again comes to the bytes of an undisturbed one.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mount.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <thread>

#include "models/read/config_error.h"
#include "sim/base/random.h"
#include "sim/campaign/campaign.h"
#include "support/fake_campaign.h"
#include "support/fake_runs.h"
#include "support/run_campaign.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

constexpr int kRuns = 10;

void Sleep(double milliseconds) {
  std::this_thread::sleep_for(std::chrono::duration<double, std::milli>(milliseconds));
}

RunRecord ShortRun(const CampaignRun& run, const RunLogging&) {
  Sleep(2.0 + 3.0 * (run.run % 4));
  return FakeRecord(run);
}

/// Some logs are written at once, some by a second simulation, some never.
Campaign CampaignToKill() {
  Campaign campaign = FakeCampaign(kRuns);
  campaign.keep = {.failures_per_cause = -1, .every_nth_success = 3};
  return campaign;
}

CampaignOptions OptionsFor(const fs::path& dir, int jobs, const Shard& shard) {
  CampaignOptions options;
  options.out_dir = dir;
  options.jobs = jobs;
  options.shard = shard;
  options.systems = FakeSystems();
  options.columns = FakeColumns();
  options.identity.campaign_yaml = CampaignYaml(CampaignToKill());
  return options;
}

/// The campaign in a process of its own. A file may grow to `largest_file` bytes; 0: any size.
pid_t StartCampaign(const fs::path& dir, int jobs, const Shard& shard, rlim_t largest_file) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  const int nowhere = ::open("/dev/null", O_WRONLY);
  ::dup2(nowhere, STDERR_FILENO);
  if (largest_file > 0) {
    ::signal(SIGXFSZ, SIG_IGN);  // then the write fails
    const rlimit limit{largest_file, largest_file};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  try {
    RunShard(CampaignToKill(), ShortRun, OptionsFor(dir, jobs, shard));
  } catch (const std::exception&) {
    ::_exit(50);
  }
  ::_exit(0);
}

/// The process's workers.
std::vector<pid_t> WorkersOf(pid_t process) {
  const std::string id = std::to_string(process);
  std::ifstream list("/proc/" + id + "/task/" + id + "/children");
  std::vector<pid_t> workers;
  for (pid_t worker = 0; list >> worker;) workers.push_back(worker);
  return workers;
}

class Schedule {
 public:
  explicit Schedule(std::uint64_t seed) : random_(StreamKey(seed, "kill")) {}

  int Pick(int count) { return static_cast<int>(random_.Uniform(0.0, 1.0) * count); }

  /// Disturbs the process, which ends by itself sooner or later.
  void Disturb(pid_t process) {
    const int times = 1 + Pick(4);
    for (int i = 0; i < times; ++i) {
      Sleep(random_.Uniform(0.0, 15.0));
      const std::vector<pid_t> workers = WorkersOf(process);
      const pid_t worker =
          workers.empty()
              ? 0
              : workers[static_cast<std::size_t>(Pick(static_cast<int>(workers.size())))];
      switch (Pick(6)) {
        case 0:
          ::kill(process, SIGKILL);
          break;
        case 1:
          ::kill(process, Pick(2) == 0 ? SIGINT : SIGTERM);
          break;
        case 2:
          ::kill(process, SIGSTOP);
          Sleep(random_.Uniform(1.0, 20.0));
          ::kill(process, SIGCONT);
          break;
        case 3:
          if (worker > 0) ::kill(worker, SIGSTOP);
          Sleep(random_.Uniform(1.0, 20.0));
          if (worker > 0) ::kill(worker, SIGCONT);
          break;
        default:
          if (worker > 0) ::kill(worker, SIGKILL);
      }
    }
    ::waitpid(process, nullptr, 0);
  }

  /// Starts and disturbs the campaign several times, whole or in shards.
  void Run(const fs::path& dir, bool limit_files) {
    const int starts = 1 + Pick(4);
    for (int i = 0; i < starts; ++i) {
      const int shards = 1 + Pick(3);
      std::vector<pid_t> processes;
      for (int number = 1; number <= shards; ++number) {
        // The rows of all runs take about 2 500 bytes, a run's figure 3 000.
        const auto most = static_cast<rlim_t>(limit_files && Pick(2) == 0 ? 600 + Pick(4000) : 0);
        processes.push_back(StartCampaign(dir, 1 + Pick(3), {number, shards}, most));
      }
      for (const pid_t process : processes) Disturb(process);
    }
  }

 private:
  RandomStream random_;
};

CampaignEnd Finish(const fs::path& dir) {
  CampaignOptions options = OptionsFor(dir, 2, Shard{});
  options.retry_lost = true;
  return RunCampaign(CampaignToKill(), ShortRun, options);
}

void ExpectSame(const fs::path& disturbed, const fs::path& straight, std::uint64_t seed) {
  for (const char* file : {"results.csv", "results.sqlite", "summary.txt", "campaign.yaml"}) {
    EXPECT_EQ(Slurp(disturbed / file), Slurp(straight / file)) << file << " of schedule " << seed;
  }
  for (int run = 1; run <= kRuns; ++run) {
    const fs::path log = fs::path(RunFolder("", run)) / "outcome.json";
    ASSERT_EQ(fs::exists(disturbed / log), fs::exists(straight / log)) << log << " of " << seed;
    if (!fs::exists(straight / log)) continue;
    EXPECT_EQ(Slurp(disturbed / log), Slurp(straight / log)) << log << " of schedule " << seed;
  }
  EXPECT_FALSE(fs::exists(disturbed / "work")) << seed;
  for (const auto& entry : fs::directory_iterator(disturbed)) {
    EXPECT_NE(entry.path().extension(), ".tmp") << entry.path();
  }
}

int Schedules() {
  const char* asked = std::getenv("DOCKYARD_KILL_SCHEDULES");
  return asked == nullptr ? 20 : std::atoi(asked);
}

TEST(KilledCampaign, GoesOnToTheBytesOfAnUndisturbedOne) {
  const TemporaryFolder folder;
  const fs::path straight = folder.path() / "straight";
  ASSERT_TRUE(Finish(straight).complete());
  for (int seed = 1; seed <= Schedules(); ++seed) {
    const fs::path disturbed = folder.path() / std::to_string(seed);
    Schedule(static_cast<std::uint64_t>(seed)).Run(disturbed, /*limit_files=*/true);
    ASSERT_TRUE(Finish(disturbed).complete()) << seed;
    ExpectSame(disturbed, straight, static_cast<std::uint64_t>(seed));
    fs::remove_all(disturbed);
  }
}

/// A small file system of its own, where the system lets us.
class SmallDisk {
 public:
  explicit SmallDisk(const fs::path& path) : path_(path) {
    fs::create_directories(path);
    mounted_ = ::mount("none", path.c_str(), "tmpfs", 0, "size=64k") == 0;
  }
  ~SmallDisk() {
    if (mounted_) ::umount2(path_.c_str(), MNT_DETACH);
  }
  bool mounted() const { return mounted_; }
  void Enlarge() const { ::mount("none", path_.c_str(), "tmpfs", MS_REMOUNT, "size=64m"); }

 private:
  fs::path path_;
  bool mounted_ = false;
};

// Where no disk can be mounted, files that may not grow stand for it, as in the test above.
TEST(KilledCampaign, GoesOnAfterAFullDisk) {
  const TemporaryFolder folder;
  const fs::path straight = folder.path() / "straight";
  ASSERT_TRUE(Finish(straight).complete());
  for (int seed = 1; seed <= (Schedules() + 3) / 4; ++seed) {
    const SmallDisk disk(folder.path() / std::to_string(seed));
    std::printf("schedule %d: %s\n", seed,
                disk.mounted() ? "a full tmpfs" : "files of limited size");
    std::fflush(stdout);
    const fs::path dir = folder.path() / std::to_string(seed) / "out";
    Schedule(static_cast<std::uint64_t>(1000 + seed)).Run(dir, !disk.mounted());
    if (disk.mounted()) disk.Enlarge();
    ASSERT_TRUE(Finish(dir).complete()) << seed;
    ExpectSame(dir, straight, static_cast<std::uint64_t>(seed));
  }
}

}  // namespace
}  // namespace dockyard
