#include "sim/jobs/signal_queue.h"

#include <sys/signalfd.h>
#include <unistd.h>

#include <initializer_list>

#include "controller/base/check.h"

namespace dockyard {

SignalQueue::SignalQueue() {
  sigset_t caught;
  sigemptyset(&caught);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) sigaddset(&caught, signal);
  sigprocmask(SIG_BLOCK, &caught, &before_);
  descriptor_ = ::signalfd(-1, &caught, SFD_NONBLOCK | SFD_CLOEXEC);
  DOCKYARD_CHECK(descriptor_ >= 0);
}

SignalQueue::~SignalQueue() {
  // More than one asks for the same end, as when a shell and its batch system both send TERM. The
  // others must not cut it short.
  while (Take() != 0) {
  }
  ::close(descriptor_);
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

int SignalQueue::Take() {
  signalfd_siginfo info{};
  const ssize_t count = ::read(descriptor_, &info, sizeof info);
  return count == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
}

}  // namespace dockyard
