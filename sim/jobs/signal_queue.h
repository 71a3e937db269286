// The signals that end a program, held until the program asks for them.
#pragma once

#include <csignal>

namespace dockyard {

/// While it lives, SIGINT, SIGTERM and SIGHUP wait here instead of ending the program.
class SignalQueue {
 public:
  SignalQueue();
  ~SignalQueue();
  SignalQueue(const SignalQueue&) = delete;
  SignalQueue& operator=(const SignalQueue&) = delete;

  int descriptor() const { return descriptor_; }
  /// The number of the signal that came, or 0.
  int Take();

 private:
  sigset_t before_{};
  int descriptor_ = -1;
};

}  // namespace dockyard
