#include "sim/bridge/call_filter.h"

#include <fcntl.h>
#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/socket.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
#include <iterator>
#include <vector>

namespace dockyard {
namespace {

#if defined(__x86_64__)
constexpr unsigned kProcessor = AUDIT_ARCH_X86_64;
constexpr unsigned kForeignCalls = 0x40000000;  // x32 (asm/unistd.h: __X32_SYSCALL_BIT)
#elif defined(__aarch64__)
constexpr unsigned kProcessor = AUDIT_ARCH_AARCH64;
constexpr unsigned kForeignCalls = 0x40000000;  // none are as high
#endif

#if defined(__x86_64__) || defined(__aarch64__)
constexpr int kCachestat = 451;  // younger than Debian 12's headers; the same on both processors
constexpr unsigned kDontNeed = POSIX_FADV_DONTNEED;
constexpr int kRefused[] = {SYS_memfd_create, SYS_memfd_secret, SYS_shmget, SYS_shmat, SYS_semget,
                            SYS_msgget, SYS_mq_open, SYS_add_key, SYS_request_key, SYS_keyctl,
                            SYS_bpf, SYS_userfaultfd, SYS_ptrace, SYS_perf_event_open,
                            SYS_io_uring_setup, SYS_process_vm_readv, SYS_process_vm_writev,
                            SYS_pidfd_getfd,
                            // What others, or a former run, left in the files' cache.
                            SYS_mincore, kCachestat, SYS_preadv2,
                            // Signals over files that two sandboxes see.
                            SYS_flock, SYS_inotify_init1,
#if defined(__x86_64__)
                            SYS_inotify_init,
#endif
                            SYS_fanotify_init};

/// Calls with one argument whose value decides.
struct Argument {
  int call;
  int place;  // of the argument, from 0
  unsigned value;
};
constexpr Argument kRefusedValues[] = {{SYS_fcntl, 1, F_GETLK},      {SYS_fcntl, 1, F_OFD_GETLK},
                                       {SYS_fcntl, 1, F_SETLEASE},   {SYS_fcntl, 1, F_NOTIFY},
                                       {SYS_fcntl, 1, F_SETPIPE_SZ}, {SYS_fadvise64, 3, kDontNeed}};
/// All other families of sockets are refused.
constexpr unsigned kSocketFamilies[] = {AF_UNIX, AF_INET, AF_INET6, AF_NETLINK};
#endif

}  // namespace

std::string CallFilter() {
#if defined(__x86_64__) || defined(__aarch64__)
  const auto load = [](std::size_t offset) {
    return sock_filter BPF_STMT(BPF_LD | BPF_W | BPF_ABS, static_cast<unsigned>(offset));
  };
  const auto end = [](unsigned what) { return sock_filter BPF_STMT(BPF_RET | BPF_K, what); };
  std::vector<sock_filter> filter;
  // Programs of another word length have other numbers: they end.
  filter.push_back(load(offsetof(seccomp_data, arch)));
  filter.push_back(sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, kProcessor, 1, 0));
  filter.push_back(end(SECCOMP_RET_KILL_PROCESS));
  filter.push_back(load(offsetof(seccomp_data, nr)));
  filter.push_back(sock_filter BPF_JUMP(BPF_JMP | BPF_JGE | BPF_K, kForeignCalls, 0, 1));
  filter.push_back(end(SECCOMP_RET_ERRNO | ENOSYS));
  for (const int call : kRefused) {
    filter.push_back(
        sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, static_cast<unsigned>(call), 0, 1));
    filter.push_back(end(SECCOMP_RET_ERRNO | EPERM));
  }
  const auto argument = [&](int place) {
    // The lower half: the kernel reads an int, and both processors have it first.
    return load(offsetof(seccomp_data, args) + static_cast<std::size_t>(place) * 8);
  };
  const auto is = [](unsigned value, unsigned char skip_else) {
    return sock_filter BPF_JUMP(BPF_JMP | BPF_JEQ | BPF_K, value, 0, skip_else);
  };
  for (const Argument& each : kRefusedValues) {
    filter.push_back(is(static_cast<unsigned>(each.call), 4));
    filter.push_back(argument(each.place));
    filter.push_back(is(each.value, 1));
    filter.push_back(end(SECCOMP_RET_ERRNO | EPERM));
    filter.push_back(load(offsetof(seccomp_data, nr)));
  }
  constexpr auto kToNext = static_cast<unsigned char>(2 + 2 * std::size(kSocketFamilies));
  for (const int call : {SYS_socket, SYS_socketpair}) {
    filter.push_back(is(static_cast<unsigned>(call), kToNext));
    filter.push_back(argument(0));
    for (const unsigned family : kSocketFamilies) {
      filter.push_back(is(family, 1));
      filter.push_back(end(SECCOMP_RET_ALLOW));
    }
    filter.push_back(end(SECCOMP_RET_ERRNO | EPERM));
  }
  filter.push_back(end(SECCOMP_RET_ALLOW));
  return {reinterpret_cast<const char*>(filter.data()), filter.size() * sizeof filter[0]};
#else
  return {};
#endif
}

}  // namespace dockyard
