#include "experiments/core/provenance.hpp"

#include <fmt/core.h>
#include <sys/utsname.h>
#include <tbb/version.h>

#include <Eigen/src/Core/util/Macros.h>
#include <boost/version.hpp>
#include <ctime>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>

#include "experiments/core/build_info.hpp"
#include "experiments/core/norms.hpp"

namespace gridstep {

namespace {

std::string compiler() {
#if defined(__clang__)
  return "clang " __clang_version__;
#elif defined(__GNUC__)
  return "gcc " __VERSION__;
#else
  return "unknown";
#endif
}

/// Linux only; elsewhere, and on processors that do not tell, "unknown".
std::string cpu_model() {
  std::ifstream cpuinfo("/proc/cpuinfo");
  for (std::string line; std::getline(cpuinfo, line);)
    if (line.starts_with("model name") && line.find(": ") != std::string::npos)
      return line.substr(line.find(": ") + 2);
  return "unknown";
}

std::string operating_system() {
  utsname name{};
  if (::uname(&name) != 0) return "unknown";
  return fmt::format("{} {} {}", name.sysname, name.release, name.machine);
}

std::string utc_now() {
  const std::time_t now = std::time(nullptr);
  std::tm parts{};
  ::gmtime_r(&now, &parts);
  char text[sizeof "2000-01-01T00:00:00Z"];
  std::strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &parts);
  return text;
}

}  // namespace

nlohmann::ordered_json provenance() {
  const BuildInfo& build = build_info();
  return {{"program", "gridstep"},
          {"version", build.version},
          {"commit", build.commit},
          {"dirty", build.dirty},
          {"compiler", compiler()},
          {"build_type", build.type},
          {"flags", build.flags},
          {"libraries",
           {{"eigen", fmt::format("{}.{}.{}", EIGEN_WORLD_VERSION, EIGEN_MAJOR_VERSION, EIGEN_MINOR_VERSION)},
            {"boost", fmt::format("{}.{}.{}", BOOST_VERSION / 100000, BOOST_VERSION / 100 % 1000,
                                  BOOST_VERSION % 100)},
            {"fmt", fmt::format("{}.{}.{}", FMT_VERSION / 10000, FMT_VERSION / 100 % 100, FMT_VERSION % 100)},
            {"tbb", TBB_runtime_version()},
            {"nlohmann_json", fmt::format("{}.{}.{}", NLOHMANN_JSON_VERSION_MAJOR,
                                          NLOHMANN_JSON_VERSION_MINOR, NLOHMANN_JSON_VERSION_PATCH)}}},
          {"cpu", cpu_model()},
          {"cores", std::thread::hardware_concurrency()},
          {"os", operating_system()},
          {"norms", norm_definition},
          {"time", utc_now()}};
}

}  // namespace gridstep
