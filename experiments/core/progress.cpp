#include "experiments/core/progress.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "experiments/core/text.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

/// A dumb terminal (an editor's window, a log) cannot return to the start of the line.
bool is_terminal(std::FILE* stream) {
  const char* kind = std::getenv("TERM");
  return ::isatty(::fileno(stream)) == 1 && !(kind && std::string_view(kind) == "dumb");
}

/// Asked at every drawing, because windows are resized.
std::size_t terminal_width(std::FILE* stream) {
  winsize size{};
  const bool known = ::ioctl(::fileno(stream), TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  return known ? size.ws_col : 80;
}

}  // namespace

Progress::Progress(double total, std::FILE* stream)
    : stream_(stream), terminal_(is_terminal(stream)), total_(total), start_(Clock::now()), last_(start_) {
  expects(total > 0 && std::isfinite(total), "a positive, finite amount of work");
}

Progress::~Progress() {
  if (!terminal_ || drawn_width_ == 0) return;
  draw(std::chrono::duration<double>(Clock::now() - start_).count(), last_what_);
  std::fputc('\n', stream_);
  std::fflush(stream_);
}

void Progress::advance(double work, std::string_view what) {
  const std::lock_guard lock(mutex_);
  done_ = std::min(done_ + work, total_);
  last_what_ = what;
  const Clock::time_point now = Clock::now();
  const double elapsed = std::chrono::duration<double>(now - start_).count();
  const double since_last = std::chrono::duration<double>(now - last_).count();
  if (terminal_) {
    if (drawn_width_ > 0 && since_last < 0.1) return;
    draw(elapsed, what);
  } else {
    const double share = done_ / total_;
    // Shares are sums of rounded parts: ten tenths must give ten lines.
    if (share - last_share_ < 0.1 - 1e-9 && since_last < 10) return;
    fmt::print(stream_, "{}\n", status(elapsed, what, 0));
    std::fflush(stream_);
    last_share_ = share;
  }
  last_ = now;
}

std::string Progress::status(double elapsed, std::string_view what, std::size_t bar_width) const {
  const double share = done_ / total_;
  std::string text;
  if (bar_width > 0) {
    const std::size_t full = std::size_t(share * double(bar_width));
    text = fmt::format("[{:#>{}}{:.>{}}] ", "", full, "", bar_width - full);
  }
  text += fmt::format("{:3}% ", int(std::floor(100 * share + 1e-9)));
  text += format_seconds(elapsed);
  if (done_ > 0 && done_ < total_)
    text += ", " + format_seconds(elapsed * (total_ - done_) / done_) + " left";
  return fmt::format("{}: {}", text, what);
}

void Progress::draw(double elapsed, std::string_view what) {
  // A line that fills the last column would wrap on some terminals.
  const std::size_t width = terminal_width(stream_) - 1;
  const std::string text = status(elapsed, what, width >= 60 ? 20 : 0);
  const std::string_view shown = cut_to_width(text, width);
  const std::size_t shown_width = display_width(shown);
  const std::size_t stale = std::min(drawn_width_, width) - std::min({drawn_width_, width, shown_width});
  fmt::print(stream_, "\r{}{:{}}", shown, "", stale);
  std::fflush(stream_);
  drawn_width_ = shown_width;
}

}  // namespace gridstep
