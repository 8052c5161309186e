#include "experiments/core/json_reader.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>

#include "experiments/core/posix.hpp"
#include "shapes/base/contracts.hpp"

namespace gridstep {

namespace {

using nlohmann::json;

constexpr int kMaxDepth = 100;  // messages show values, by recursion

/// "[json.exception.parse_error.101] parse error at line 2, column 3: what" without the name of the
/// exception.
std::string reason(const json::exception& error) {
  std::string text = error.what();
  text.erase(0, text.find("] ") + 2);
  const std::string_view prefix = "parse error at ";
  if (text.starts_with(prefix)) text.erase(0, prefix.size());
  return text;
}

std::string shown(const json& value) {
  std::string text = value.dump(-1, ' ', false, json::error_handler_t::replace);
  const std::size_t longest = 60;
  if (text.size() > longest) text = text.substr(0, longest - 3) + "...";
  return text;
}

bool is_integral(const json& value) {
  return value.is_number_integer() ||
         (value.is_number_float() && std::trunc(value.get<double>()) == value.get<double>());
}

bool is_int(const json& value) {
  return is_integral(value) && value.get<double>() >= std::numeric_limits<int>::min() &&
         value.get<double>() <= std::numeric_limits<int>::max();
}

}  // namespace

json load_json(const std::filesystem::path& file) {
  const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
  const std::optional<std::string> text = descriptor < 0 ? std::nullopt : read_all(descriptor);
  const int reason_unread = errno;
  if (descriptor >= 0) ::close(descriptor);
  if (!text)
    throw InputError(
        fmt::format("{}: cannot be read: {}", file.string(), std::generic_category().message(reason_unread)));

  return parse_json(*text, file.string());
}

json parse_json(const std::string& text, const std::string& source) {
  std::vector<std::set<std::string>> keys_of_open_objects;
  const auto check = [&](int depth, json::parse_event_t event, json& parsed) {
    if (depth > kMaxDepth) throw InputError(fmt::format("{}: nested deeper than {}", source, kMaxDepth));
    if (event == json::parse_event_t::object_start) keys_of_open_objects.emplace_back();
    if (event == json::parse_event_t::object_end) keys_of_open_objects.pop_back();
    if (event == json::parse_event_t::key &&
        !keys_of_open_objects.back().insert(parsed.get<std::string>()).second)
      throw InputError(
          fmt::format("{}: key '{}' is given twice in one object", source, parsed.get<std::string>()));
    return true;
  };
  try {
    return json::parse(text, check);
  } catch (const json::exception& error) {
    throw InputError(fmt::format("{}: {}", source, reason(error)));
  }
}

JsonReader::JsonReader(const json& value, std::string source) : JsonReader(value, std::move(source), "") {}

JsonReader::JsonReader(const json& value, std::string source, std::string location)
    : value_(&value), source_(std::move(source)), location_(std::move(location)) {
  if (!value.is_object()) fail(fmt::format("{} must be an object", shown(value)));
}

const json* JsonReader::find(const std::string& key) {
  known_.insert(key);
  const auto found = value_->find(key);
  return found == value_->end() ? nullptr : &*found;
}

const json& JsonReader::value(const std::string& key) {
  if (const json* found = find(key)) return *found;
  fail(fmt::format("key '{}' is missing", key));
}

bool JsonReader::has(const std::string& key) {
  return find(key) != nullptr;
}

double JsonReader::number(const std::string& key) {
  const json& found = value(key);
  if (!found.is_number()) fail(key, "a number");
  return found.get<double>();
}

double JsonReader::number(const std::string& key, double otherwise) {
  return has(key) ? number(key) : otherwise;
}

int JsonReader::integer(const std::string& key) {
  const json& found = value(key);
  if (!is_int(found)) fail(key, "an integer");
  return found.get<int>();
}

int JsonReader::integer(const std::string& key, int otherwise) {
  return has(key) ? integer(key) : otherwise;
}

std::uint64_t JsonReader::seed(const std::string& key, std::uint64_t otherwise) {
  if (!has(key)) return otherwise;
  // Numbers set in a program are signed ones even where they are not negative.
  const json& found = value(key);
  if (!found.is_number_unsigned() && !(found.is_number_integer() && found.get<std::int64_t>() >= 0))
    fail(key, "an integer from 0 to 2^64 - 1");
  return found.get<std::uint64_t>();
}

bool JsonReader::boolean(const std::string& key, bool otherwise) {
  if (!has(key)) return otherwise;
  if (!value(key).is_boolean()) fail(key, "true or false");
  return value(key).get<bool>();
}

std::string JsonReader::text(const std::string& key) {
  const json& found = value(key);
  if (!found.is_string()) fail(key, "a text");
  return found.get<std::string>();
}

std::string JsonReader::text(const std::string& key, std::string otherwise) {
  return has(key) ? text(key) : std::move(otherwise);
}

std::vector<double> JsonReader::numbers(const std::string& key) {
  const json& found = value(key);
  if (!found.is_array()) fail(key, "a list of numbers");
  std::vector<double> result;
  for (const json& item : found) {
    if (!item.is_number()) refuse(fmt::format("{}[{}]", key, result.size()), item, "a number");
    result.push_back(item.get<double>());
  }
  return result;
}

std::vector<std::string> JsonReader::texts(const std::string& key) {
  const json& found = value(key);
  if (!found.is_array()) fail(key, "a list of texts");
  std::vector<std::string> result;
  for (const json& item : found) {
    if (!item.is_string()) refuse(fmt::format("{}[{}]", key, result.size()), item, "a text");
    result.push_back(item.get<std::string>());
  }
  return result;
}

JsonReader JsonReader::object(const std::string& key) {
  return {value(key), source_, location_.empty() ? key : location_ + "." + key};
}

std::vector<JsonReader> JsonReader::objects(const std::string& key) {
  const json& found = value(key);
  if (!found.is_array()) fail(key, "a list of objects");
  std::vector<JsonReader> result;
  const std::string prefix = location_.empty() ? key : location_ + "." + key;
  for (const json& item : found)
    result.push_back(JsonReader(item, source_, fmt::format("{}[{}]", prefix, result.size())));
  return result;
}

void JsonReader::finish() const {
  for (const auto& [key, ignored] : value_->items())
    if (!known_.contains(key))
      fail(fmt::format("unknown key '{}' (known: {})", key, fmt::join(known_, ", ")));
}

void JsonReader::fail(std::string_view message) const {
  throw InputError(location_.empty() ? fmt::format("{}: {}", source_, message)
                                     : fmt::format("{}: {}: {}", source_, location_, message));
}

void JsonReader::fail(const std::string& key, std::string_view requirement) const {
  refuse(key, value_->at(key), requirement);
}

void JsonReader::refuse(const std::string& name, const json& found, std::string_view requirement) const {
  fail(fmt::format("{} = {} must be {}", name, shown(found), requirement));
}

}  // namespace gridstep
