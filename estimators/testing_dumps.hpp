#pragma once

// Dumps of the reference library, for tests of parity. They are not part of the sources: the tests skip where
// the folder ../shared/reference is not at hand.

#include <filesystem>
#include <fstream>
#include <map>
#include <sstream>
#include <string>
#include <vector>

namespace gridstep {

struct Dump {
  std::map<std::string, std::string> header;  // h, re, nsurfels, ...
  std::map<std::string, std::size_t> column;
  std::vector<std::vector<double>> rows;

  double at(std::size_t row, const std::string& name) const { return rows[row][column.at(name)]; }
};

inline std::filesystem::path dump_path(const std::string& file) {
  return std::filesystem::path(GRIDSTEP_SOURCE_DIR) / "../shared/reference" / file;
}

inline Dump read_dump(const std::filesystem::path& path) {
  Dump dump;
  std::ifstream file(path);
  std::string line, word;
  std::getline(file, line);
  for (std::istringstream words(line); words >> word;)
    if (const auto equals = word.find('='); equals != std::string::npos)
      dump.header[word.substr(0, equals)] = word.substr(equals + 1);
  std::getline(file, line);
  for (std::istringstream names(line); std::getline(names, word, ',');)
    dump.column.emplace(word, dump.column.size());
  while (std::getline(file, line)) {
    dump.rows.emplace_back();
    for (std::istringstream values(line); std::getline(values, word, ',');)
      dump.rows.back().push_back(std::stod(word));
  }
  return dump;
}

}  // namespace gridstep
