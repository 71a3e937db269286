// What a controller's program reaches in a sandbox, and what without one.
#include <arpa/inet.h>
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <cstring>
#include <fstream>

#include "app/program.h"
#include "sim/base/json.h"
#include "support/fake_runs.h"

namespace dockyard {
namespace {

using testing::HasSubstr;
using testing::Not;
namespace fs = std::filesystem;

constexpr const char* kOpen = "";
constexpr const char* kSandbox = " --sandbox";

/// A folder with the hostile program, and one outside of it.
class SandboxedController : public testing::Test {
 protected:
  SandboxedController() {
    fs::create_directory(program());
    for (const char* file :
         {"tests/bridge/hostile_controller.py", "examples/python/dockyard_client.py"}) {
      fs::copy(SourceFile(file), program());
    }
    WriteText(in("secret"), "a secret");
  }

  std::string in(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string program() const { return in("program"); }

  std::string Words(const std::string& attempt, const std::string& argument) const {
    return "run tests/toy/scenario.yaml --allow-commands --answer-limit 120 --json --set "
           "'controller={command: "
           "[python3, hostile_controller.py, " +
           attempt + ", \"" + argument + "\"], folder: " + program() + "}'";
  }

  /// "it worked: ..." or "it failed: ...", or how the program was ended.
  std::string Try(const std::string& attempt, const std::string& argument,
                  const std::string& more) const {
    const Ended ended = Dockyard(Words(attempt, argument) + more);
    const Json json = Json::parse(ended.out, nullptr, false);
    EXPECT_TRUE(json.is_object()) << ended.err;
    return ended.err + (json.is_object() ? json.value("failure_note", "") : "");
  }

  void ExpectShut(const std::string& attempt, const std::string& argument,
                  const std::string& more = "") const {
    EXPECT_THAT(Try(attempt, argument, kSandbox + more), HasSubstr("it failed")) << attempt;
  }
  void ExpectOpen(const std::string& attempt, const std::string& argument,
                  const std::string& more = "") const {
    EXPECT_THAT(Try(attempt, argument, kOpen + more), HasSubstr("it worked")) << attempt;
  }

  TemporaryFolder folder_;
};

/// A listening socket that is closed with it.
class Listener {
 public:
  Listener(const sockaddr* address, socklen_t size)
      : socket_(::socket(address->sa_family, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    EXPECT_EQ(::bind(socket_, address, size), 0);
    EXPECT_EQ(::listen(socket_, 8), 0);
  }
  ~Listener() { ::close(socket_); }
  int port() const {
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
  }

 private:
  int socket_;
};

/// Whether a process runs with this argument.
bool Runs(const std::string& argument) {
  for (const auto& entry : fs::directory_iterator("/proc")) {
    std::ifstream file(entry.path() / "cmdline");
    const std::string words((std::istreambuf_iterator<char>(file)), {});
    if (words == std::string("sleep") + '\0' + argument + '\0') return true;
  }
  return false;
}

TEST_F(SandboxedController, SeesNoOtherProcess) {
  for (const char* attempt : {"memory", "trace", "kill_parent"}) ExpectShut(attempt, "-");
  ExpectOpen("kill_parent", "-");
  const std::string test = std::to_string(::getpid());
  ExpectShut("kill", test);
  ExpectOpen("kill", test);
}

TEST_F(SandboxedController, ReadsAndWritesNoResults) {
  const std::string out = in("out"), option = " --out " + out;
  for (const char* file : {"/resolved.yaml", "/run.mcap"}) {
    ExpectShut("read", out + file, option);
    ExpectOpen("read", out + file, option);
  }
  ExpectShut("write", out + "/forged", option);
  EXPECT_FALSE(fs::exists(out + "/forged"));
  ExpectOpen("write", out + "/forged", option);
}

TEST_F(SandboxedController, ReadsNoResultsThatLieInItsFolder) {
  const std::string out = program() + "/out", option = " --out " + out;
  ExpectShut("read", out + "/resolved.yaml", option);
  ExpectShut("write", out + "/forged", option);
  EXPECT_THAT(Try("folder", out, kSandbox + option), HasSubstr("it worked: empty"));
  const Ended same = Dockyard(Words("read", "-") + kSandbox + " --out " + program());
  EXPECT_EQ(same.code, 2);
  EXPECT_THAT(same.err, HasSubstr("is the results folder"));
}

TEST_F(SandboxedController, ReachesNoFileOutsideOfItsFolder) {
  ExpectShut("read", in("secret"));
  ExpectOpen("read", in("secret"));
  fs::create_symlink(in("secret"), program() + "/link");
  ExpectShut("read", program() + "/link");
  ExpectOpen("read", program() + "/link");
  const std::string to = program() + "/hard";
  ExpectShut("link", program() + "/dockyard_client.py:" + to);
  ExpectShut("link", in("secret") + ":" + to);
  EXPECT_FALSE(fs::exists(to));
  ExpectOpen("link", in("secret") + ":" + to);
  ExpectShut("write", program() + "/new");
  ExpectShut("read", "/etc/passwd");
  for (const char* folder : {"/root", "/var", "/run", "/sys"}) ExpectShut("folder", folder);
  ExpectShut("write", "/proc/sys/kernel/core_pattern");
  ExpectShut("write", "/new");
}

TEST_F(SandboxedController, SharesNoMemoryByName) {
  const std::string shared = "/dev/shm/dockyard_sandbox_test_" + std::to_string(::getpid());
  EXPECT_THAT(Try("write", shared, kSandbox), HasSubstr("it worked"));  // in its own
  EXPECT_FALSE(fs::exists(shared));
  ExpectOpen("write", shared);
  EXPECT_TRUE(fs::exists(shared));
  fs::remove(shared);
}

TEST_F(SandboxedController, ReachesNoSocket) {
  const std::string name = "dockyard_sandbox_test_" + std::to_string(::getpid());
  sockaddr_un abstract{};
  abstract.sun_family = AF_UNIX;
  std::memcpy(abstract.sun_path + 1, name.data(), name.size());
  const Listener first(reinterpret_cast<const sockaddr*>(&abstract),
                       static_cast<socklen_t>(offsetof(sockaddr_un, sun_path) + 1 + name.size()));
  ExpectShut("abstract", name);
  ExpectOpen("abstract", name);
  sockaddr_in loopback{};
  loopback.sin_family = AF_INET;
  loopback.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  const Listener second(reinterpret_cast<const sockaddr*>(&loopback), sizeof loopback);
  ExpectShut("loopback", std::to_string(second.port()));
  ExpectOpen("loopback", std::to_string(second.port()));
  ExpectShut("names", "-");
}

TEST_F(SandboxedController, FindsNoSignOfOthersOrOfAFormerRun) {
  ExpectShut("signals", "-");
  EXPECT_THAT(Try("signals", "-", kOpen), HasSubstr("flock"));
}

TEST_F(SandboxedController, CannotFillTheComputer) {
  EXPECT_THAT(Try("forks", "400", kSandbox), Not(HasSubstr("it worked")));
  for (const char* folder : {"/tmp", "/dev/shm"}) ExpectShut("disk", folder);
  EXPECT_THAT(Try("hog", "10", kSandbox), Not(HasSubstr("it worked")));
  EXPECT_THAT(Try("hogs", "6", kSandbox), HasSubstr("MiB of main memory"));
  ExpectShut("uncounted", "-");
  ExpectShut("new_user", "-");
}

TEST_F(SandboxedController, LeavesNoProcessInASandboxOrOutside) {
  const std::string mark = "61." + std::to_string(::getpid());
  for (const char* mode : {kOpen, kSandbox}) {
    for (const char* attempt : {"daemon", "children"}) {
      EXPECT_THAT(Try(attempt, mark, mode), HasSubstr("it worked")) << attempt << mode;
      EXPECT_FALSE(Runs(mark)) << attempt << mode;
    }
  }
}

TEST_F(SandboxedController, InheritsNothingInASandboxOrOutside) {
  ::setenv("DOCKYARD_TEST_SECRET", "1", 1);
  const int kept = ::open("/etc/passwd", O_RDONLY);  // a shell would have it, too
  for (const char* mode : {kOpen, kSandbox}) {
    EXPECT_THAT(Try("descriptors", "-", mode), HasSubstr("it worked: \n")) << mode;
    const std::string said = Try("environment", "-", mode);
    EXPECT_THAT(said, HasSubstr("it worked: DOCKYARD_CONTROLLER")) << mode;
    EXPECT_THAT(said, Not(HasSubstr("SECRET"))) << mode;
  }
  ::close(kept);
  ::unsetenv("DOCKYARD_TEST_SECRET");
}

TEST_F(SandboxedController, CannotFloodTheMessages) {
  for (const char* mode : {kOpen, kSandbox}) {
    const std::string out = in("flood") + (mode == kOpen ? "" : "_sandbox");
    EXPECT_THAT(Try("flood", "200", mode + (" --out " + out)), HasSubstr("it worked")) << mode;
    EXPECT_EQ(fs::file_size(out + "/messages.txt"), 64u << 10) << mode;
  }
}

TEST_F(SandboxedController, IsRefusedWhereNoSandboxCanBeMade) {
  const std::string path = std::getenv("PATH");
  ::setenv("PATH", "/nowhere", 1);
  const Ended ended = Dockyard(Words("read", "-") + kSandbox + " --out " + in("out"));
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(ended.code, 2);
  EXPECT_THAT(ended.err, HasSubstr("apt-get install bubblewrap"));
  EXPECT_FALSE(fs::exists(in("out")));
}

TEST_F(SandboxedController, MustHaveAFolderOfItsOwn) {
  for (const char* folder : {"/", "/tmp", "/usr"}) {
    const Ended ended = Dockyard(
        "run tests/toy/scenario.yaml --allow-commands --sandbox --set 'controller={command: "
        "[\"true\"], folder: " +
        std::string(folder) + "}'");
    EXPECT_EQ(ended.code, 2) << folder;
    EXPECT_THAT(ended.err, HasSubstr("a folder of its own")) << folder;
  }
}

TEST_F(SandboxedController, OfACampaignIsConfinedAndReplayedSo) {
  const std::string out = in("results");
  WriteText(in("campaign.yaml"),
            "campaign: c\nseed: 1\nkeep: all\nbase: " + SourceFile("tests/toy/scenario.yaml") +
                "\nscenario: {controller: {command: [python3, hostile_controller.py, read, " + out +
                "/campaign.yaml], files: [dockyard_client.py], folder: program}}\nruns: [{run: 1, "
                "start.r_m: 1}]\n");
  const Ended ended = Dockyard("campaign " + in("campaign.yaml") +
                               " --quiet --allow-commands --sandbox --out " + out);
  EXPECT_EQ(ended.code, 0) << ended.err;
  EXPECT_THAT(Slurp(out + "/runs/001/messages.txt"), HasSubstr("it failed"));
  EXPECT_THAT(ended.out, HasSubstr(" --allow-commands --sandbox"));
  const Ended replay = Dockyard("replay " + out + " 1 --allow-commands --sandbox");
  EXPECT_EQ(replay.code, 0) << replay.out << replay.err;
}

}  // namespace
}  // namespace dockyard
