#include "sim/campaign/signal_queue.h"

#include <poll.h>
#include <sys/signalfd.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>

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
  ::close(descriptor_);
  sigprocmask(SIG_SETMASK, &before_, nullptr);
}

int SignalQueue::Take() {
  signalfd_siginfo info{};
  const ssize_t count = ::read(descriptor_, &info, sizeof info);
  return count == sizeof info ? static_cast<int>(info.ssi_signo) : 0;
}

void WaitForChildren(const std::vector<const Child*>& children, const SignalQueue& signals) {
  std::vector<pollfd> watched{{signals.descriptor(), POLLIN, 0}};
  double patience_s = 1.0;  // the clock of a live progress line
  for (const Child* child : children) {
    watched.push_back({child->descriptor(), POLLIN, 0});
    patience_s = std::min(patience_s, std::max(0.0, child->seconds_left()));
  }
  const int got =
      ::poll(watched.data(), watched.size(), static_cast<int>(std::ceil(1000.0 * patience_s)));
  DOCKYARD_CHECK(got >= 0 || errno == EINTR);
}

}  // namespace dockyard
