# Shared by slurm.sh and parallel.sh; sourced, not run.
# shellcheck shell=bash

# shellcheck source=scripts/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/../common.sh"

# read_arguments ARGUMENT ...: sets `list`, `shards`, `into` and `tasks`, those that are given, and
# `engine_options` to what is behind --. Calls `usage`.
read_arguments() {
  list="" shards="" into="" tasks="" engine_options=()
  while (($# > 0)); do
    case "$1" in
      --help | -h) usage; exit 0 ;;
      --into | --tasks)
        (($# > 1)) && [[ -n "$2" ]] || die "$1 wants a value"
        printf -v "${1#--}" '%s' "$2"
        shift 2 ;;
      --) engine_options=("${@:2}"); return ;;
      -*) usage >&2; exit 2 ;;
      *)
        if [[ -z "$list" ]]; then list="$1"; elif [[ -z "$shards" ]]; then shards="$1"; else usage >&2; exit 2; fi
        shift ;;
    esac
  done
}

# prepare: checks `list` and `shards`, makes the folder `into`, and sets `program`; all paths are
# absolute then.
prepare() {
  [[ -n "$list" && "$shards" =~ ^[1-9][0-9]*$ ]] || { usage >&2; exit 2; }
  [[ -r "$list" ]] || die "there is no list $list"
  program="$(realpath -m "${TRIPUS:-$root/build/release/bin/tripus}")"
  [[ -x "$program" ]] || die "there is no program $program; build it, or name it in TRIPUS"
  list="$(realpath "$list")"
  mkdir -p "${into:=$list.census}"
  into="$(realpath "$into")"
}
