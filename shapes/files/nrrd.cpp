#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "shapes/files/formats.hpp"

namespace gridstep {

namespace {

/// The format's names of a type; each of them that is an integer may also be called name_t.
const std::map<std::string, VoxelType, std::less<>>& types() {
  using enum VoxelType;
  static const std::map<std::string, VoxelType, std::less<>> names{{"uchar", uint8},
                                                                   {"unsigned char", uint8},
                                                                   {"uint8", uint8},
                                                                   {"uint8_t", uint8},
                                                                   {"signed char", int8},
                                                                   {"int8", int8},
                                                                   {"int8_t", int8},
                                                                   {"ushort", uint16},
                                                                   {"unsigned short", uint16},
                                                                   {"unsigned short int", uint16},
                                                                   {"uint16", uint16},
                                                                   {"uint16_t", uint16},
                                                                   {"short", int16},
                                                                   {"short int", int16},
                                                                   {"signed short", int16},
                                                                   {"signed short int", int16},
                                                                   {"int16", int16},
                                                                   {"int16_t", int16},
                                                                   {"uint", uint32},
                                                                   {"unsigned int", uint32},
                                                                   {"uint32", uint32},
                                                                   {"uint32_t", uint32},
                                                                   {"int", int32},
                                                                   {"signed int", int32},
                                                                   {"int32", int32},
                                                                   {"int32_t", int32},
                                                                   {"ulonglong", uint64},
                                                                   {"unsigned long long", uint64},
                                                                   {"unsigned long long int", uint64},
                                                                   {"uint64", uint64},
                                                                   {"uint64_t", uint64},
                                                                   {"longlong", int64},
                                                                   {"long long", int64},
                                                                   {"long long int", int64},
                                                                   {"signed long long", int64},
                                                                   {"signed long long int", int64},
                                                                   {"int64", int64},
                                                                   {"int64_t", int64},
                                                                   {"float", float32},
                                                                   {"double", float64}};
  return names;
}

/// Fields that say nothing of where the values are, or how far apart.
const std::set<std::string, std::less<>> kIgnored{
    "content",     "number",          "min",         "max",          "old min",
    "old max",     "oldmin",          "oldmax",      "sample units", "sampleunits",
    "thicknesses", "axis mins",       "axismins",    "axis maxs",    "axismaxs",
    "centers",     "centerings",      "labels",      "units",        "kinds",
    "space",       "space dimension", "space units", "space origin", "measurement frame"};

std::string lower(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (c >= 'A' && c <= 'Z') c = char(c - 'A' + 'a');
  return result;
}

class Header {
 public:
  explicit Header(ByteReader& file) : file_(file) {
    const auto magic = file.line();
    if (!magic || magic->size() != 8 || !magic->starts_with("NRRD000") || magic->back() < '1' ||
        magic->back() > '5')
      file.fail("not a NRRD file (NRRD0001 to NRRD0005)");
    for (auto line = file.line();; line = file.line()) {
      if (!line) file.fail("truncated: ends within its header");
      if (line->empty()) return;
      if (!line->starts_with('#')) add(*line);
    }
  }

  std::optional<std::string_view> text(const std::string& field) const {
    const auto found = fields_.find(field);
    return found == fields_.end() ? std::nullopt : std::optional<std::string_view>(found->second);
  }
  std::string_view needed(const std::string& field) const {
    const auto value = text(field);
    if (!value) file_.fail(fmt::format("its header has no '{}'", field));
    return *value;
  }
  [[noreturn]] void refuse(const std::string& field, std::string_view requirement) const {
    file_.fail(fmt::format("{} = {}: {}", field, shown(needed(field)), requirement));
  }

 private:
  void add(std::string_view line) {
    const std::size_t colon = line.find(':');
    if (colon == std::string_view::npos)
      file_.fail(fmt::format("header line '{}' is no 'field: value'", shown(line)));
    if (line.substr(colon).starts_with(":=")) return;  // a key of the user's own
    static const std::set<std::string, std::less<>> used{
        "type",     "dimension",        "sizes",     "encoding", "endian",
        "spacings", "space directions", "line skip", "byte skip"};
    std::string field = lower(trimmed(line.substr(0, colon)));
    if (field == "lineskip") field = "line skip";
    if (field == "byteskip") field = "byte skip";
    if (field == "data file" || field == "datafile")
      file_.fail("its data are in another file, which is not supported");
    if (kIgnored.contains(field)) return;
    if (!used.contains(field)) file_.fail(fmt::format("unknown field '{}'", shown(field)));
    if (!fields_.emplace(field, trimmed(line.substr(colon + 1))).second)
      file_.fail(fmt::format("'{}' is given twice", field));
  }

  ByteReader& file_;
  std::map<std::string, std::string> fields_;
};

/// "(a,b,c) (d,e,f) (g,h,i)": the lengths of orthogonal vectors; or three numbers.
std::array<double, 3> lengths(const Header& header) {
  std::string text(header.needed("space directions"));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return std::string_view("(),").find(c) < 3; }, ' ');
  RealPoint<3> directions[3];
  std::string_view rest = text;
  for (RealPoint<3>& direction : directions)
    for (int k = 0; k < 3; ++k) {
      const auto number = number_in<double>(next_word(rest));
      if (!number) header.refuse("space directions", "must be three vectors (x,y,z)");
      direction[k] = *number;
    }
  if (!next_word(rest).empty()) header.refuse("space directions", "must be three vectors (x,y,z)");
  std::array<double, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    result[i] = directions[i].norm();
    const RealPoint<3>& next = directions[(i + 1) % 3];
    if (std::abs(directions[i].dot(next)) > 1e-4 * result[i] * next.norm())
      header.refuse("space directions", "must be orthogonal");
  }
  return result;
}

std::array<double, 3> spacings(const Header& header) {
  std::array<double, 3> result;
  std::string_view rest = header.needed("spacings");
  for (double& spacing : result) {
    const auto number = number_in<double>(lower(next_word(rest)));
    if (!number) header.refuse("spacings", "must be three numbers");
    spacing = *number;
  }
  if (!next_word(rest).empty()) header.refuse("spacings", "must be three numbers");
  return result;
}

std::endian order(const Header& header, VoxelType type) {
  const auto endian = header.text("endian");
  if (!endian && bytes_of(type) > 1) header.needed("endian");
  const std::string name = lower(endian.value_or("little"));
  if (name != "little" && name != "big") header.refuse("endian", "must be little or big");
  return name == "big" ? std::endian::big : std::endian::little;
}

}  // namespace

GreyVolume read_nrrd(ByteReader& file) {
  const Header header(file);
  if (header.needed("dimension") != "3") header.refuse("dimension", "must be 3");
  const auto type = types().find(lower(header.needed("type")));
  if (type == types().end()) header.refuse("type", "must be an integer type, float or double");
  GreyVolume volume = volume_of_size(file, sides_in(file, "sizes", header.needed("sizes")), type->second);
  for (const char* skip : {"line skip", "byte skip"})
    if (header.text(skip).value_or("0") != "0") header.refuse(skip, "must be 0");
  if (header.text("spacings"))
    volume.spacing = isotropic_spacing(file, "spacings", spacings(header));
  else if (header.text("space directions"))
    volume.spacing = isotropic_spacing(file, "space directions of length", lengths(header));

  const std::string encoding = lower(header.needed("encoding"));
  if (encoding == "raw")
    read_raw_voxels(file, volume, order(header, volume.type));
  else if (encoding == "gzip" || encoding == "gz")
    read_deflated_voxels(file, volume, order(header, volume.type));
  else
    header.refuse("encoding", "must be raw or gzip");
  return volume;
}

void write_nrrd(const GreyVolume& volume, const Sink& sink) {
  constexpr const char* names[] = {"uint8", "int8",   "uint16", "int16", "uint32",
                                   "int32", "uint64", "int64",  "float", "double"};
  const double s = volume.spacing;
  sink(
      fmt::format("NRRD0004\ntype: {}\ndimension: 3\nsizes: {} {} {}\nspacings: {} {} {}\nencoding: raw\n"
                  "endian: {}\n\n",
                  names[std::size_t(volume.type)], volume.extent[0], volume.extent[1], volume.extent[2], s, s,
                  s, std::endian::native == std::endian::little ? "little" : "big"));
  sink(volume.bytes);
}

}  // namespace gridstep
