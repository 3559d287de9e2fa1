# Shared by the scripts of this folder; sourced, not run.
# shellcheck shell=bash

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)"
jobs="${TRIPUS_JOBS:-$(nproc)}"

die() {
  echo "$(basename "$0"): $*" >&2
  exit 2
}

# configure_and_build PRESET [TARGET ...]: quiet unless something is wrong.
configure_and_build() {
  local preset="$1" log folder
  shift
  folder="$root/build/${preset%-tests}"  # release-tests is release with tests
  log="$folder/configure.log"
  mkdir -p "$folder"
  if ! (cd "$root" && cmake --preset "$preset") > "$log" 2>&1; then
    cat "$log" >&2
    return 1
  fi
  local targets=()
  if (($# > 0)); then targets=(--target "$@"); fi
  NINJA_STATUS="[%f/%t] " cmake --build "$folder" --parallel "$jobs" "${targets[@]}"
}
