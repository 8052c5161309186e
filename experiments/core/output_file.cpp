#include "experiments/core/output_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <system_error>

#include "experiments/core/posix.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace fs = std::filesystem;

OutputFile::OutputFile(const fs::path& path) : path_(path) {
  std::error_code ignored;
  const fs::file_status status = fs::status(path, ignored);
  if (fs::is_directory(status)) {
    errno = EISDIR;
    fail("opened");
  }
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    target_ = path;
    descriptor_ = ::open(path.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) fail("opened");
    return;
  }
  target_ = fs::exists(status) ? fs::canonical(path) : path;

  // Process and counter keep writers apart; a name may still be left from a killed process that had the same
  // number.
  static std::atomic<unsigned> counter = 0;
  do {
    temporary_ = target_.parent_path() /
                 fmt::format(".{}.{}-{}.tmp", target_.filename().string(), ::getpid(), counter++);
    descriptor_ = ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  } while (descriptor_ < 0 && errno == EEXIST);
  if (descriptor_ < 0) {
    temporary_.clear();
    fail("created");
  }
}

OutputFile::~OutputFile() {
  discard();
}

void OutputFile::write(std::string_view text) {
  constexpr std::size_t chunk = std::size_t(1) << 20;
  expects(descriptor_ >= 0, "an open output file");
  buffer_ += text;
  if (buffer_.size() >= chunk) flush();
}

void OutputFile::commit() {
  expects(descriptor_ >= 0, "an open output file");
  flush();
  if (!sync(descriptor_)) fail("written");
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0) fail("written");
  if (temporary_.empty()) return;
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) fail("renamed into place");
  temporary_.clear();
  if (!sync_folder(target_)) fail("made durable");
}

void OutputFile::flush() {
  if (!write_all(descriptor_, buffer_)) fail("written");
  buffer_.clear();
}

void OutputFile::discard() noexcept {
  if (descriptor_ >= 0) ::close(descriptor_);
  descriptor_ = -1;
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
  temporary_.clear();
}

void OutputFile::fail(const char* action) {
  const int reason = errno;
  discard();
  throw InputError(
      fmt::format("{}: cannot be {}: {}", path_.string(), action, std::generic_category().message(reason)));
}

void write_whole(const fs::path& path, std::string_view content) {
  OutputFile file(path);
  file.write(content);
  file.commit();
}

}  // namespace gridstep
