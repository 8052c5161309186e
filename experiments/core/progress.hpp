#pragma once

#include <chrono>
#include <cstddef>
#include <cstdio>
#include <mutex>
#include <string>
#include <string_view>

namespace gridstep {

/// Tells a person how far a long run is. Where a line can be redrawn (terminal.hpp), one that is, at most ten times a second,
/// and fits the width; elsewhere plain lines, one whenever 10 s or another 10 % have passed. Never any
/// colour.
class Progress {
 public:
  /// `total` is the work to come in any unit that is proportional to time. The stream must outlive the
  /// progress.
  /// @throws ContractViolation unless total is positive and finite.
  Progress(double total, std::FILE* stream);
  /// Ends the line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// `work` more is done, and `what` is the part it was. May be called from several threads; for parts, not
  /// for cells.
  void advance(double work, std::string_view what);

 private:
  using Clock = std::chrono::steady_clock;

  std::string status(double elapsed, std::string_view what, std::size_t bar_width) const;
  void draw(double elapsed, std::string_view what);

  std::mutex mutex_;
  std::FILE* stream_;
  bool terminal_;
  double total_, done_ = 0;
  double last_share_ = 0;  ///< of the work, when the last line was shown
  std::string last_what_;
  std::size_t drawn_width_ = 0;
  Clock::time_point start_, last_;
};

}  // namespace gridstep
