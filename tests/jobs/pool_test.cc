#include "sim/jobs/pool.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
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

/// Gives `count` jobs, all with this work on their index.
std::function<std::optional<Job>()> Jobs(std::size_t count, const fs::path& dir,
                                         const std::function<std::string(std::size_t)>& work) {
  auto next = std::make_shared<std::size_t>(0);
  return [=]() -> std::optional<Job> {
    if (*next == count) return std::nullopt;
    const std::size_t index = (*next)++;
    return Job{index, [=] { return work(index); }, dir / ("job_" + std::to_string(index))};
  };
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

std::map<std::size_t, std::string> AnswersOf(int processes) {
  const TemporaryFolder folder;
  SignalQueue signals;
  std::map<std::size_t, std::string> answers;
  const auto work = [](std::size_t index) {
    Sleep(index % 2 == 0 ? 40 : 1);
    return "answer " + std::to_string(index);
  };
  const int signal =
      RunPool({.processes = processes, .time_limit_s = 60.0}, signals, Jobs(7, folder.path(), work),
              [&](std::size_t index, const Child::End& end) {
                EXPECT_EQ(answers.count(index), 0u);
                answers[index] = end.answer;
              });
  EXPECT_EQ(signal, 0);
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
  SignalQueue signals;
  std::vector<std::size_t> order;
  const auto first_waits = [&](std::size_t index) {
    if (index == 0) {
      while (!fs::exists(folder.path() / "go")) Sleep(5);
    }
    return std::string("done");
  };
  RunPool({.processes = 2, .time_limit_s = 60.0}, signals, Jobs(3, folder.path(), first_waits),
          [&](std::size_t index, const Child::End&) {
            order.push_back(index);
            if (order.size() == 2) WriteText(folder.path() / "go", "");
          });
  EXPECT_THAT(order, ElementsAre(1, 2, 0));
}

TEST(Pool, NeverRunsMoreThanItsProcesses) {
  const TemporaryFolder folder;
  SignalQueue signals;
  int most = 0;
  const auto work = [](std::size_t) {
    Sleep(20);
    return std::string();
  };
  RunPool({.processes = 3,
           .time_limit_s = 60.0,
           .waiting = [&](int running) { most = std::max(most, running); }},
          signals, Jobs(8, folder.path(), work), [](std::size_t, const Child::End&) {});
  EXPECT_EQ(most, 3);
}

TEST(Pool, KillsAChildThatHangsAndKeepsTheOthers) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  SignalQueue signals;
  std::map<std::size_t, Child::End> ends;
  const auto work = [&](std::size_t index) {
    return index == 1 ? StayAlive(alive) : std::string("good");
  };
  RunPool({.processes = 2, .time_limit_s = 1.0}, signals, Jobs(4, folder.path(), work),
          [&](std::size_t index, const Child::End& end) { ends[index] = end; });
  ASSERT_EQ(ends.size(), 4u);
  EXPECT_EQ(ends.at(1).how_it_died, "killed: it took more than 1 s of wall time");
  for (const std::size_t index : {0u, 2u, 3u}) EXPECT_EQ(ends.at(index).answer, "good");
  EXPECT_FALSE(IsAlive(alive));
}

TEST(Pool, TellsHowAChildDied) {
  const TemporaryFolder folder;
  SignalQueue signals;
  std::map<std::size_t, std::string> died;
  const auto work = [](std::size_t index) {
    if (index == 0) ::_exit(9);
    ::raise(SIGKILL);
    return std::string();
  };
  RunPool({.processes = 1, .time_limit_s = 60.0}, signals, Jobs(2, folder.path(), work),
          [&](std::size_t index, const Child::End& end) { died[index] = end.how_it_died; });
  EXPECT_EQ(died.at(0), "ended with exit code 9 before its result");
  EXPECT_THAT(died.at(1), HasSubstr("killed by signal 9"));
}

TEST(Pool, EndsAtASignalAndTakesItsChildrenWithIt) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  SignalQueue signals;
  int taken = 0;
  const auto work = [&](std::size_t index) {
    return index == 0 ? std::string("good") : StayAlive(alive);
  };
  const int signal = RunPool({.processes = 1,
                              .time_limit_s = 60.0,
                              .waiting =
                                  [&](int) {
                                    if (taken == 1) ::raise(SIGTERM);
                                  }},
                             signals, Jobs(9, folder.path(), work),
                             [&](std::size_t, const Child::End&) { ++taken; });
  EXPECT_EQ(signal, SIGTERM);
  EXPECT_EQ(taken, 1);
  EXPECT_FALSE(IsAlive(alive));
}

TEST(Pool, LeavesNoChildBehindAnException) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  SignalQueue signals;
  const auto work = [&](std::size_t index) {
    if (index == 1) return StayAlive(alive);
    while (!fs::exists(alive)) Sleep(5);
    return std::string("good");
  };
  const auto full = [](std::size_t, const Child::End&) { throw std::runtime_error("disk full"); };
  EXPECT_THROW(
      RunPool({.processes = 2, .time_limit_s = 60.0}, signals, Jobs(2, folder.path(), work), full),
      std::runtime_error);
  EXPECT_FALSE(IsAlive(alive));
}

TEST(Pool, ItsChildrenDieWithTheirParent) {
  const TemporaryFolder folder;
  const fs::path alive = folder.path() / "alive";
  const pid_t parent = ::fork();
  if (parent == 0) {
    SignalQueue signals;
    RunPool({.processes = 1, .time_limit_s = 60.0}, signals,
            Jobs(1, folder.path(), [&](std::size_t) { return StayAlive(alive); }),
            [](std::size_t, const Child::End&) {});
    ::_exit(0);
  }
  WaitFor(alive);
  ::kill(parent, SIGKILL);
  ::waitpid(parent, nullptr, 0);
  EXPECT_FALSE(IsAlive(alive));
}

}  // namespace
}  // namespace dockyard
