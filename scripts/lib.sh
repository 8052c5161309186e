# shellcheck shell=bash
# Steps that setup, test and reproduce share. Sourced by bash after `set -euo pipefail`; sets `root`.

root=$(CDPATH="" cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd -P)

die() {
  printf '%s: %s\n' "${0##*/}" "$*" >&2
  exit 1
}

# The comment at the head of a script is its --help.
show_help() {
  sed -n '2,/^[^#]/{/^#/!d;s/^# \{0,1\}//;p}' "$0"
}

# CMake's own variable wins, for machines whose cores are shared.
cores() {
  printf '%s\n' "${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
}

# configure_and_build PRESET [arguments of cmake --build]
configure_and_build() {
  local preset=$1
  shift
  "$root/scripts/setup"
  cd -- "$root" || return
  cmake --preset "$preset"
  cmake --build --preset "$preset" --parallel "$(cores)" "$@"
}
