#pragma once

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

// What readers and writers of files share. Each says whether it succeeded, with the reason in errno.
namespace gridstep {

inline std::optional<std::string> read_all(int descriptor) {
  std::string text, chunk(1 << 16, '\0');
  for (;;) {
    const ssize_t got = ::read(descriptor, chunk.data(), chunk.size());
    if (got == 0) return text;
    if (got < 0 && errno != EINTR) return std::nullopt;
    if (got > 0) text.append(chunk, 0, std::size_t(got));
  }
}

inline bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = ::write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written < 0) return false;
    text.remove_prefix(std::size_t(written));
  }
  return true;
}

/// To the disk. Devices and some file systems have nothing to synchronise, which is no failure.
inline bool sync(int descriptor) {
  return ::fsync(descriptor) == 0 || errno == EINVAL || errno == ENOTSUP || errno == EROFS;
}

/// Makes the name of a file created or renamed durable. A folder one may write but not read cannot be
/// synchronised.
inline bool sync_folder(const std::filesystem::path& file) {
  const std::filesystem::path folder = file.has_parent_path() ? file.parent_path() : ".";
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) return errno == EACCES;
  const bool done = sync(descriptor);
  const int reason = errno;
  ::close(descriptor);
  errno = reason;
  return done;
}

}  // namespace gridstep
