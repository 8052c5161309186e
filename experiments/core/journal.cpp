#include "experiments/core/journal.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <system_error>

#include "experiments/core/posix.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

using nlohmann::ordered_json;

Journal::Journal(const std::filesystem::path& path, const ordered_json& header) : path_(path) {
  descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
  if (descriptor_ < 0) fail("opened");
  try {
    if (::flock(descriptor_, LOCK_EX | LOCK_NB) != 0) {
      if (errno == EWOULDBLOCK) throw InputError(path.string() + ": in use by another process");
      fail("locked");
    }
    const std::optional<std::string> text = read_all(descriptor_);
    if (!text) fail("read");

    const std::string header_line = header.dump() + "\n";
    if (!text->starts_with(header_line)) {
      // Only a header that a kill cut short may be overwritten.
      if (!header_line.starts_with(*text))
        throw InputError(fmt::format("{}: not the journal of this study; its first line is {:.200}",
                                     path.string(), text->substr(0, text->find('\n'))));
      if (::ftruncate(descriptor_, 0) != 0) fail("truncated");
      write_line(header_line);
      if (!sync_folder(path)) fail("made durable");
      return;
    }

    std::size_t begin = header_line.size();
    for (std::size_t number = 2; begin < text->size(); ++number) {
      const std::size_t end = text->find('\n', begin);
      if (end == std::string::npos) break;
      ordered_json record = ordered_json::parse(text->begin() + std::ptrdiff_t(begin),
                                                text->begin() + std::ptrdiff_t(end), nullptr, false);
      // After a power failure the last line may have its length but not its bytes.
      if (record.is_discarded() && end + 1 == text->size()) break;
      if (record.is_discarded())
        throw InputError(fmt::format("{}: line {} is no JSON", path.string(), number));
      records_.push_back(std::move(record));
      begin = end + 1;
    }
    size_ = std::int64_t(begin);
    if (begin < text->size() && ::ftruncate(descriptor_, size_) != 0) fail("truncated");
  } catch (...) {
    ::close(descriptor_);
    throw;
  }
}

Journal::~Journal() {
  ::close(descriptor_);
}

void Journal::append(const ordered_json& record) {
  const std::string line = record.dump() + "\n";
  const std::lock_guard lock(mutex_);
  write_line(line);
}

void Journal::write_line(const std::string& line) {
  if (write_all(descriptor_, line) && sync(descriptor_)) {
    size_ += std::int64_t(line.size());
    return;
  }
  // Half a line must not be glued to the next one.
  const int reason = errno;
  const bool restored = ::ftruncate(descriptor_, size_) == 0;
  errno = reason;
  fail(restored ? "written" : "written, nor restored");
}

void Journal::fail(const char* action) const {
  throw InputError(
      fmt::format("{}: cannot be {}: {}", path_.string(), action, std::generic_category().message(errno)));
}

}  // namespace gridstep
