#pragma once

#include <stdexcept>
#include <string>

namespace gridstep {

/// A caller broke a documented precondition: a bug in the calling code.
class ContractViolation : public std::logic_error {
 public:
  using std::logic_error::logic_error;
};

/// Something outside the program is wrong (an option, a file, a parameter); the message names it and its
/// value.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Checked in every build: contracts are per call, never per cell.
inline void expects(bool holds, const char* what) {
  if (!holds) throw ContractViolation(std::string("expected ") + what);
}

}  // namespace gridstep
