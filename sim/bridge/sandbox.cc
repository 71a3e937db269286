#include "sim/bridge/sandbox.h"

#include <array>
#include <cstdlib>
#include <optional>
#include <system_error>

#include "sim/bridge/call_filter.h"

namespace dockyard {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPath = "/usr/local/bin:/usr/bin:/bin";

/// Where the programs and libraries of the system are (Filesystem Hierarchy Standard, 3.0).
constexpr std::array kSystemFolders{"/bin", "/sbin", "/lib", "/lib32", "/lib64", "/libx32"};
/// By which programs find each other and their libraries.
constexpr std::array kSystemFiles{"/etc/alternatives", "/etc/ld.so.cache", "/etc/ld.so.conf",
                                  "/etc/ld.so.conf.d"};
/// A program's folder must not hold any of these.
constexpr std::array kNotOfAProgram{"/tmp", "/etc", "/var", "/run", "/proc", "/sys",
                                    "/dev", "/usr", "/opt", "/srv", "/mnt"};

void Add(std::vector<std::string>& words, const std::vector<std::string>& more) {
  words.insert(words.end(), more.begin(), more.end());
}

/// The path without links; as it is where that fails.
fs::path Real(const fs::path& path) {
  std::error_code error;
  fs::path real = fs::weakly_canonical(path, error);
  return error ? path : real;
}

/// Whether the first is the second or holds it.
bool Holds(const fs::path& outer, const fs::path& inner) {
  const fs::path relative = inner.lexically_relative(outer);
  return !relative.empty() && *relative.begin() != "..";
}

void AddSystem(std::vector<std::string>& words) {
  Add(words, {"--ro-bind", "/usr", "/usr"});
  for (const char* folder : kSystemFolders) {
    std::error_code error;
    if (fs::is_symlink(folder, error)) {
      Add(words, {"--symlink", fs::read_symlink(folder, error).string(), folder});
    } else {
      Add(words, {"--ro-bind-try", folder, folder});
    }
  }
  for (const char* file : kSystemFiles) Add(words, {"--ro-bind-try", file, file});
}

std::string Bytes(std::int64_t mib) { return std::to_string(mib << 20); }

void AddScratch(std::vector<std::string>& words) {
  Add(words, {"--proc", "/proc", "--dev", "/dev"});
  for (const char* folder : {"/dev/shm", "/tmp"}) {
    Add(words, {"--size", Bytes(kSandboxScratchMib), "--tmpfs", folder});
  }
}

/// Inside, as the number of processes must be limited in the sandbox's own name space of users.
std::vector<std::string> LimitWords() {
  const auto both = [](const char* option, const std::string& value) {
    return std::string("--") + option + "=" + value + ":" + value;
  };
  return {"prlimit",
          both("as", Bytes(kSandboxAddressMib)),
          both("cpu", std::to_string(kSandboxCpu_s)),
          both("fsize", Bytes(kSandboxFileMib)),
          both("nofile", std::to_string(kSandboxOpenFiles)),
          both("nproc", std::to_string(kSandboxThreads)),
          both("core", "0"),
          both("msgqueue", "0"),
          both("memlock", "0"),
          "--"};
}

void RequireOwnFolder(const fs::path& folder, const fs::path& hidden) {
  const auto refuse = [&](const std::string& what) {
    throw SandboxError("--sandbox: the program's folder " + folder.string() + " " + what +
                       "; give the program a folder of its own (controller.folder)");
  };
  for (const char* other : kNotOfAProgram) {
    if (Holds(folder, other)) refuse("holds " + std::string(other));
  }
  const char* of_user = std::getenv(kUserFolder);
  if (of_user != nullptr && *of_user != '\0' && Holds(folder, Real(of_user))) {
    refuse("holds all files of the user");
  }
  if (!hidden.empty() && folder == hidden) refuse("is the results folder");
}

}  // namespace

ProgramStart InSandbox(const std::vector<std::string>& words, const fs::path& folder,
                       const fs::path& hidden_folder) {
  const fs::path own = Real(folder.empty() ? "." : folder);
  const fs::path hidden = hidden_folder.empty() ? hidden_folder : Real(hidden_folder);
  RequireOwnFolder(own, hidden);
  ProgramStart start;
  start.limits = {.threads = kSandboxThreads, .memory_mib = kSandboxMemoryMib};
  start.filter = CallFilter();
  start.folder = "/";
  std::vector<std::string>& all = start.words;
  all = {"bwrap",
         "--unshare-user",
         "--unshare-ipc",
         "--unshare-pid",
         "--unshare-net",
         "--unshare-uts",
         "--unshare-cgroup",
         "--disable-userns",
         "--die-with-parent",
         "--new-session",
         "--cap-drop",
         "ALL",
         "--uid",
         "65534",
         "--gid",
         "65534",
         "--hostname",
         "sandbox",
         "--clearenv"};
  const char* language = std::getenv("LANG");
  Add(all, {"--setenv", "PATH", kPath, "--setenv", kUserFolder, "/tmp", "--setenv", "LANG",
            language == nullptr ? "C.UTF-8" : language, "--setenv", "DOCKYARD_CONTROLLER", "1"});
  AddSystem(all);
  AddScratch(all);
  Add(all, {"--ro-bind", own.string(), own.string()});
  if (!hidden.empty() && (Holds(own, hidden) || Holds("/usr", hidden))) {
    Add(all, {"--size", "4096", "--tmpfs", hidden.string(), "--remount-ro", hidden.string()});
  }
  // The system's settings in /proc/sys belong to root: one that runs this could change them.
  for (const char* mount : {"/proc", "/dev", "/"}) Add(all, {"--remount-ro", mount});
  Add(all, {"--chdir", own.string()});
  if (!start.filter.empty()) Add(all, {"--seccomp", "3"});
  all.push_back("--");
  Add(all, LimitWords());
  Add(all, words);
  return start;
}

void RequireSandbox() {
  static std::optional<std::string> fault;  // once: the trial takes a process
  if (!fault) {
    constexpr double kTrial_s = 60.0;  // assumed, 10-120; it takes 0.02 s on a free computer
    Process trial(InSandbox({"true"}, "/usr/bin", {}));
    const std::string how = trial.End(kTrial_s);
    const std::string messages = trial.Messages();
    fault = how == "exit code 0" ? "" : messages.empty() ? how : messages;
    while (!fault->empty() && fault->back() == '\n') fault->pop_back();
  }
  if (fault->empty()) return;
  throw SandboxError(
      "--sandbox: no sandbox can be made here (" + *fault +
      "); it needs bubblewrap 0.8 or later (Debian: apt-get install bubblewrap) and a kernel that "
      "lets this user make name spaces (sysctl kernel.unprivileged_userns_clone, "
      "kernel.apparmor_restrict_unprivileged_userns, user.max_user_namespaces)");
}

}  // namespace dockyard
