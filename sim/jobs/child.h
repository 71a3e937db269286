// A piece of work in a process of its own: a crash costs only that piece.
#pragma once

#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace dockyard {

/// A forked child that does its work and answers with a text over a pipe. It dies with its parent,
/// ignores Ctrl-C (the parent handles it), leaves no core file, and prints into a file.
class Child {
 public:
  /// The result of the child: its answer, whole if `how_it_died` is empty.
  struct End {
    std::string answer;
    std::string how_it_died;
    double cpu_time_s = 0.0, wall_time_s = 0.0;
  };

  /// @param work            runs in the child; must not throw
  /// @param messages        file for what the child prints
  /// @param close_in_child  descriptors that are the parent's alone
  /// Throws IoError when no process can be had.
  Child(const std::function<std::string()>& work, const std::filesystem::path& messages,
        double time_limit_s, const std::vector<int>& close_in_child);
  /// Kills the child if it still runs.
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  int descriptor() const { return pipe_; }  // readable when there is something to read
  /// Takes the bytes that the child has sent; true at their end.
  bool Read();
  /// Kills the child when its time is over.
  void KillIfLate();
  double seconds_left() const;
  /// Waits for the child and gives its result.
  End Finish();

 private:
  using Clock = std::chrono::steady_clock;

  std::filesystem::path messages_;
  double time_limit_s_;
  Clock::time_point started_;
  pid_t child_ = -1;
  int pipe_ = -1;
  bool late_ = false;
  std::string answer_;
};

}  // namespace dockyard
