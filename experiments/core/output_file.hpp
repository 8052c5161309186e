#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <string_view>

namespace gridstep {

/// A file that appears whole or not at all: written under a temporary name in the same folder, and renamed by
/// commit() once it is safely on the disk. A file that was there before stays as it was until then; without
/// commit() nothing is left behind. What exists and is no regular file (a device, a pipe) cannot be replaced
/// and is written directly.
class OutputFile {
 public:
  /// @throws InputError naming the path and the system's reason, as do the other functions; after a failure
  /// the temporary is gone and the object is of no further use.
  explicit OutputFile(const std::filesystem::path& path);
  ~OutputFile();
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;

  void write(std::string_view text);
  void commit();

 private:
  void flush();
  void discard() noexcept;
  [[noreturn]] void fail(const char* action);

  std::filesystem::path path_;    ///< as given, for messages
  std::filesystem::path target_;  ///< with symbolic links followed
  std::filesystem::path temporary_;
  std::string buffer_;
  int descriptor_ = -1;
};

/// The same in one call.
void write_whole(const std::filesystem::path& path, std::string_view content);

}  // namespace gridstep
