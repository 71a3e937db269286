#include "sim/bridge/call_filter.h"

#include <linux/audit.h>
#include <linux/filter.h>
#include <linux/seccomp.h>
#include <sys/syscall.h>

#include <cerrno>
#include <cstddef>
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
constexpr int kRefused[] = {SYS_memfd_create,
                            SYS_memfd_secret,
                            SYS_shmget,
                            SYS_shmat,
                            SYS_semget,
                            SYS_msgget,
                            SYS_mq_open,
                            SYS_add_key,
                            SYS_request_key,
                            SYS_keyctl,
                            SYS_bpf,
                            SYS_userfaultfd,
                            SYS_ptrace,
                            SYS_perf_event_open,
                            SYS_io_uring_setup,
                            SYS_process_vm_readv,
                            SYS_process_vm_writev,
                            SYS_pidfd_getfd};
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
  filter.push_back(end(SECCOMP_RET_ALLOW));
  return {reinterpret_cast<const char*>(filter.data()), filter.size() * sizeof filter[0]};
#else
  return {};
#endif
}

}  // namespace dockyard
