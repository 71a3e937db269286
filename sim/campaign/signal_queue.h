// Waiting for children, with the signals that end a program held until they are asked for.
#pragma once

#include <csignal>
#include <vector>

#include "sim/campaign/child.h"

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

/// Sleeps until a child or a signal has something to say, a child's time is over, or a second has
/// passed.
void WaitForChildren(const std::vector<const Child*>& children, const SignalQueue& signals);

}  // namespace dockyard
