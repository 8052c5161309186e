#pragma once

#include <cstdint>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace gridstep {

/// The JSON in a file. @throws InputError in one line: the file and the system's reason, or the line and
/// column of what is malformed, or the key an object has twice (JSON leaves open which one counts), or that
/// it is nested too deep.
nlohmann::json load_json(const std::filesystem::path& file);
/// The same of a text from `source`.
nlohmann::json parse_json(const std::string& text, const std::string& source);

/// Reads one JSON object strictly: a getter says which key and type it wants, finish() refuses keys nobody
/// asked for, so a misspelt optional key is never ignored. Every failure is an InputError that names the
/// place:
///   study.json: sweeps[0].radius: unknown key 'kk' (known: alpha, k)
/// The JSON must outlive the reader.
class JsonReader {
 public:
  /// `source` is the file or whatever else the text came from. @throws InputError if `value` is no object.
  JsonReader(const nlohmann::json& value, std::string source);

  bool has(const std::string& key);

  double number(const std::string& key);
  double number(const std::string& key, double otherwise);
  int integer(const std::string& key);
  int integer(const std::string& key, int otherwise);
  std::uint64_t seed(const std::string& key, std::uint64_t otherwise);
  bool boolean(const std::string& key, bool otherwise);
  std::string text(const std::string& key);
  std::string text(const std::string& key, std::string otherwise);
  std::vector<double> numbers(const std::string& key);
  std::vector<std::string> texts(const std::string& key);
  JsonReader object(const std::string& key);
  std::vector<JsonReader> objects(const std::string& key);
  /// The bare value, for what another parser reads.
  const nlohmann::json& value(const std::string& key);

  /// @throws InputError naming the first key that no getter asked for, and the ones that were.
  void finish() const;

  /// @throws InputError "place: message".
  [[noreturn]] void fail(std::string_view message) const;
  /// @throws InputError "place: key = value must be requirement"; the key is there.
  [[noreturn]] void fail(const std::string& key, std::string_view requirement) const;

 private:
  JsonReader(const nlohmann::json& value, std::string source, std::string location);
  const nlohmann::json* find(const std::string& key);
  [[noreturn]] void refuse(const std::string& name, const nlohmann::json& found,
                           std::string_view requirement) const;

  const nlohmann::json* value_;
  std::string source_;
  std::string location_;  ///< such as sweeps[0].radius; empty at the top
  std::set<std::string> known_;
};

}  // namespace gridstep
