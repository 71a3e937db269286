#include "sim/jobs/pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <map>
#include <stdexcept>
#include <thread>

#include "support/fake_runs.h"

namespace dockyard {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace fs = std::filesystem;

void Sleep(int milliseconds) {
  std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
}

/// Writes to the file for ever.
std::string StayAlive(const fs::path& file) {
  for (;;) {
    WriteText(file, "x");
    Sleep(5);
  }
}

void WaitFor(const fs::path& file) {
  for (int i = 0; i < 4000 && !fs::exists(file); ++i) Sleep(5);
  ASSERT_TRUE(fs::exists(file));
}

/// Whether somebody still writes it.
bool IsAlive(const fs::path& file) {
  Sleep(100);
  fs::remove(file);
  Sleep(200);
  return fs::exists(file);
}

using Work = std::function<std::string(std::int64_t job)>;

/// A pool with jobs 0 .. count - 1, and what came of them.
class Jobs {
 public:
  Jobs(std::int64_t count, const Work& work) : count_(count) {
    calls.work = [work](std::int64_t job, const fs::path&) { return work(job); };
    calls.next = [this](int) -> std::optional<Job> {
      if (next_ == count_) return std::nullopt;
      const std::int64_t job = next_++;
      return Job{job, folder.path() / ("job_" + std::to_string(job))};
    };
    calls.prepare = [this](const Job& job, int) { ++attempts[job.number]; };
    calls.take = [this](const Job& job, int, const JobEnd& end) {
      EXPECT_EQ(ends.count(job.number), 0u);
      ends[job.number] = end;
      order.push_back(job.number);
    };
  }

  int Run() {
    SignalQueue signals;
    return RunPool(options, signals, calls);
  }

  TemporaryFolder folder;
  PoolOptions options;
  PoolCalls calls;
  std::map<std::int64_t, JobEnd> ends;
  std::map<std::int64_t, int> attempts;
  std::vector<std::int64_t> order;

 private:
  std::int64_t count_, next_ = 0;
};

std::map<std::int64_t, std::string> AnswersOf(int workers) {
  Jobs jobs(7, [](std::int64_t job) {
    Sleep(job % 2 == 0 ? 40 : 1);
    return "answer " + std::to_string(job);
  });
  jobs.options.workers = workers;
  EXPECT_EQ(jobs.Run(), 0);
  std::map<std::int64_t, std::string> answers;
  for (const auto& [job, end] : jobs.ends) answers[job] = end.answer;
  return answers;
}

TEST(Pool, GivesEveryAnswerOnceWhateverTheOrderInWhichTheyCome) {
  const auto alone = AnswersOf(1);
  ASSERT_EQ(alone.size(), 7u);
  EXPECT_EQ(alone.at(4), "answer 4");
  EXPECT_EQ(AnswersOf(3), alone);
  EXPECT_EQ(AnswersOf(20), alone);
}

TEST(Pool, GivesAnswersInTheOrderInWhichTheyCome) {
  const TemporaryFolder folder;
  Jobs jobs(3, [&](std::int64_t job) {
    while (job == 0 && !fs::exists(folder.path() / "go")) Sleep(5);
    return std::string("done");
  });
  jobs.options.workers = 2;
  const auto take = jobs.calls.take;
  jobs.calls.take = [&](const Job& job, int place, const JobEnd& end) {
    take(job, place, end);
    if (jobs.order.size() == 2) WriteText(folder.path() / "go", "");
  };
  jobs.Run();
  EXPECT_THAT(jobs.order, ElementsAre(1, 2, 0));
}

TEST(Pool, TakesAnAnswerOfAnyLength) {
  Jobs jobs(2, [](std::int64_t job) { return std::string(job == 0 ? 3000000 : 0, 'x'); });
  jobs.Run();
  EXPECT_EQ(jobs.ends.at(0).answer, std::string(3000000, 'x'));
  EXPECT_EQ(jobs.ends.at(1).answer, "");
}

TEST(Pool, NeverRunsMoreThanItsWorkersAndEachGoesOnFromJobToJob) {
  Jobs jobs(8, [](std::int64_t) {
    Sleep(20);
    return std::to_string(::getpid());
  });
  int most = 0;
  jobs.options.workers = 3;
  jobs.options.waiting = [&](int running) { most = std::max(most, running); };
  jobs.Run();
  EXPECT_EQ(most, 3);
  std::map<std::string, int> jobs_of_process;
  for (const auto& [job, end] : jobs.ends) ++jobs_of_process[end.answer];
  EXPECT_EQ(jobs_of_process.size(), 3u);
}

TEST(Pool, KillsAJobThatHangsAndKeepsTheOthers) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  Jobs jobs(4, [&](std::int64_t job) { return job == 1 ? StayAlive(alive) : std::string("good"); });
  jobs.options.workers = 2;
  jobs.options.limits.wall_s = 1.0;
  jobs.options.retries = 0;
  jobs.Run();
  ASSERT_EQ(jobs.ends.size(), 4u);
  EXPECT_EQ(jobs.ends.at(1).how_it_died, "killed: it took more than 1 s of wall time");
  EXPECT_EQ(jobs.ends.at(1).loss, Loss::kStopped);
  EXPECT_NEAR(jobs.ends.at(1).wall_time_s, 1.0, 0.5);
  for (const std::int64_t job : {0, 2, 3}) EXPECT_EQ(jobs.ends.at(job).answer, "good");
  EXPECT_FALSE(IsAlive(alive));
}

// AddressSanitizer's own memory counts too and has no sensible bound.
#if !defined(__SANITIZE_ADDRESS__) && !(defined(__clang__) && __has_feature(address_sanitizer))
TEST(Pool, StopsAJobThatTakesTooMuchMemory) {
  Jobs jobs(2, [&](std::int64_t job) {
    if (job == 1) return std::string("good");
    std::string much(300u << 20, 'x');
    return much.substr(0, 10);
  });
  jobs.options.limits.memory_mib = 128;
  jobs.Run();
  EXPECT_EQ(jobs.ends.at(0).how_it_died, "out of memory: it took more than 128 MiB");
  EXPECT_EQ(jobs.ends.at(0).loss, Loss::kStopped);
  EXPECT_EQ(jobs.ends.at(1).answer, "good");
}
#endif

TEST(Pool, TellsHowAJobWasLost) {
  Jobs jobs(3, [](std::int64_t job) -> std::string {
    if (job == 0) ::_exit(9);
    ::signal(SIGSEGV, SIG_DFL);
    ::raise(job == 1 ? SIGKILL : SIGSEGV);
    return "";
  });
  jobs.Run();
  EXPECT_EQ(jobs.ends.at(0).how_it_died, "ended with exit code 9 before its result");
  EXPECT_EQ(jobs.ends.at(0).loss, Loss::kCrashed);
  EXPECT_THAT(jobs.ends.at(1).how_it_died, HasSubstr("killed by signal 9"));
  EXPECT_EQ(jobs.ends.at(1).loss, Loss::kStopped);  // nobody kills himself: the system's doing
  EXPECT_THAT(jobs.ends.at(2).how_it_died, HasSubstr("killed by signal 11"));
  EXPECT_EQ(jobs.ends.at(2).loss, Loss::kCrashed);
}

TEST(Pool, TriesALostJobAgainAsOftenAsItMay) {
  for (const int retries : {0, 1, 3}) {
    Jobs jobs(2, [](std::int64_t job) -> std::string {
      if (job == 0) ::_exit(9);
      return "good";
    });
    jobs.options.retries = retries;
    jobs.Run();
    EXPECT_EQ(jobs.attempts.at(0), retries + 1);
    EXPECT_EQ(jobs.attempts.at(1), 1);
    EXPECT_EQ(jobs.ends.at(1).answer, "good");
  }
}

TEST(Pool, AJobWhoseWorkerWasKilledOnceHasItsAnswer) {
  const TemporaryFolder folder;
  Jobs jobs(3, [&](std::int64_t job) -> std::string {
    const fs::path once = folder.path() / "once";
    if (job == 1 && !fs::exists(once)) {
      WriteText(once, "");
      ::kill(::getpid(), SIGKILL);
    }
    return "good";
  });
  jobs.Run();
  for (const std::int64_t job : {0, 1, 2}) EXPECT_EQ(jobs.ends.at(job).answer, "good");
  EXPECT_EQ(jobs.attempts.at(1), 2);
}

TEST(Pool, LosesNoJobByASignalThatASystemSendsToAll) {
  Jobs jobs(3, [](std::int64_t job) {
    for (const int signal : {SIGTERM, SIGINT, SIGHUP}) ::raise(signal);
    return "good " + std::to_string(job);
  });
  jobs.options.retries = 0;
  EXPECT_EQ(jobs.Run(), 0);
  for (const std::int64_t job : {0, 1, 2}) {
    EXPECT_EQ(jobs.ends.at(job).answer, "good " + std::to_string(job));
  }
}

TEST(Pool, AsksAgainForJobsThatComeOfOthers) {
  Jobs jobs(2, [](std::int64_t) { return std::string("good"); });
  std::vector<std::int64_t> further;
  const auto next = jobs.calls.next;
  jobs.calls.next = [&](int place) -> std::optional<Job> {
    if (further.empty()) return next(place);
    const std::int64_t job = further.back();
    further.pop_back();
    return Job{job, jobs.folder.path() / "further"};
  };
  const auto take = jobs.calls.take;
  jobs.calls.take = [&](const Job& job, int place, const JobEnd& end) {
    take(job, place, end);
    if (job.number == 1) further = {7};
  };
  EXPECT_EQ(jobs.Run(), 0);
  EXPECT_THAT(jobs.order, ElementsAre(0, 1, 7));
}

TEST(Pool, EndsAtASignalAndTakesItsWorkersWithIt) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  Jobs jobs(9, [&](std::int64_t job) { return job == 0 ? std::string("good") : StayAlive(alive); });
  jobs.options.waiting = [&](int) {
    if (jobs.ends.size() == 1 && fs::exists(alive)) ::raise(SIGTERM);
  };
  EXPECT_EQ(jobs.Run(), SIGTERM);
  EXPECT_EQ(jobs.ends.size(), 1u);
  EXPECT_FALSE(IsAlive(alive));
}

TEST(Pool, LeavesNoWorkerBehindAnException) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  Jobs jobs(2, [&](std::int64_t job) {
    if (job == 1) return StayAlive(alive);
    while (!fs::exists(alive)) Sleep(5);
    return std::string("good");
  });
  jobs.options.workers = 2;
  jobs.calls.take = [](const Job&, int, const JobEnd&) { throw std::runtime_error("disk full"); };
  EXPECT_THROW(jobs.Run(), std::runtime_error);
  EXPECT_FALSE(IsAlive(alive));
}

TEST(Pool, ItsWorkersDieWithTheirParent) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  const pid_t parent = ::fork();
  if (parent == 0) {
    Jobs(1, [&](std::int64_t) { return StayAlive(alive); }).Run();
    ::_exit(0);
  }
  WaitFor(alive);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_FALSE(IsAlive(alive));
}

TEST(Pool, GivesItsJobsTheTimeInWhichItStoodStillItself) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive", done = folder.path() / "done";
  const pid_t parent = ::fork();
  if (parent == 0) {
    Jobs jobs(1, [&](std::int64_t) {
      WriteText(alive, "x");
      Sleep(2000);
      return std::string("good");
    });
    jobs.options.limits.wall_s = 3.0;
    jobs.options.retries = 0;
    jobs.Run();
    WriteText(done, jobs.ends.at(0).how_it_died);
    ::_exit(0);
  }
  WaitFor(alive);
  ::kill(parent, SIGSTOP);
  Sleep(3500);
  ::kill(parent, SIGCONT);
  ::waitpid(parent, nullptr, 0);
  EXPECT_EQ(Slurp(done), "");
}

TEST(SignalQueue, LetsNoFurtherSignalCutTheEndShort) {
  const auto end = [] {
    {
      SignalQueue signals;
      for (int i = 0; i < 2; ++i) {
        std::raise(SIGTERM);
        if (signals.Take() != SIGTERM) ::_exit(1);
      }
      std::raise(SIGTERM);
      std::raise(SIGINT);
    }
    ::_exit(7);
  };
  EXPECT_EXIT(end(), testing::ExitedWithCode(7), "");
}

}  // namespace
}  // namespace dockyard
