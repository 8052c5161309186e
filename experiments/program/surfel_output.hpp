#pragma once

#include <memory>
#include <string>
#include <vector>

#include "experiments/core/output_file.hpp"
#include "shapes/files/surface_file.hpp"

namespace gridstep {

/// Whether a path that --csv names is that of standard output.
bool is_standard_output(const std::string& path);

/// The files that --csv and --out name, opened before anything is computed: what cannot be written is known at once.
class SurfelOutput {
 public:
  /// @param csv may be empty, or - for standard output
  /// @throws InputError for a path whose extension is that of no format for dimension d, or that cannot be opened.
  SurfelOutput(const std::string& csv, const std::vector<std::string>& paths, int d);

  bool empty() const { return files_.empty(); }
  /// What else there is to print goes here: to standard error where a table goes to standard output.
  std::FILE* summary_stream() const { return to_standard_output_ ? stderr : stdout; }

  /// Writes all files, and commits them only then. The surfels are those of the rows, in order.
  template <int d>
  void write(const SurfelTable& table, std::span<const Surfel<d>> surfels, GridStep h);

 private:
  struct File {
    const SurfaceFormat* format;
    std::string path;
    std::unique_ptr<OutputFile> file;
  };
  std::vector<File> files_;
  bool to_standard_output_ = false;
};

}  // namespace gridstep
