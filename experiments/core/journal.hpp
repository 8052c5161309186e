#pragma once

#include <cstdint>
#include <filesystem>
#include <mutex>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

namespace gridstep {

/// What a long study has finished, so that it can be killed at any moment and resumed: a header line that
/// says which study, then a JSON line for each finished part. A line is on the disk before append() returns.
class Journal {
 public:
  /// Opens the journal of the study that `header` describes, or starts it. A last line that a kill left
  /// incomplete is cut off. The header must hold only what decides the results: resuming demands an equal
  /// one.
  /// @throws InputError if the file is the journal of another study or no journal, has a bad line before the
  /// last, is in use by another process, or cannot be opened or written.
  Journal(const std::filesystem::path& path, const nlohmann::ordered_json& header);
  ~Journal();
  Journal(const Journal&) = delete;
  Journal& operator=(const Journal&) = delete;

  /// The lines after the header that were there when the journal was opened.
  const std::vector<nlohmann::ordered_json>& records() const { return records_; }

  /// May be called from several threads. @throws InputError after which the journal is as it was before the
  /// call.
  void append(const nlohmann::ordered_json& record);

 private:
  void write_line(const std::string& line);
  [[noreturn]] void fail(const char* action) const;

  std::filesystem::path path_;
  std::vector<nlohmann::ordered_json> records_;
  std::mutex mutex_;
  int descriptor_ = -1;
  std::int64_t size_ = 0;  ///< of the complete lines, in bytes
};

}  // namespace gridstep
