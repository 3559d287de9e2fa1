#!/usr/bin/env bash
# A census by GNU parallel, on this machine or on several, and its merge.
set -euo pipefail

usage() {
  cat <<'USAGE'
usage: scripts/cluster/parallel.sh LIST [SHARDS] [--into FOLDER] [-- PARALLEL-OPTIONS ...]

Makes the shards (default: 100) of the census of LIST, one INPUT a line, in FOLDER (default:
LIST.census), one process a core, and merges them into FOLDER/census.sqlite and census.tsv. The same
command again makes what is missing.
  --   everything behind it goes to parallel: -- --sshloginfile hosts (machines that share the folder
       and the program), -- --jobs 4
TRIPUS names the program (default: the one that was built here). See docs/census.md.
USAGE
}

die() { echo "parallel.sh: $1" >&2; exit 2; }

list="" shards="" into=""
while (($# > 0)); do
  case "$1" in
    --help | -h) usage; exit 0 ;;
    --into) into="${2:?}"; shift 2 ;;
    --) shift; break ;;
    -*) usage >&2; exit 2 ;;
    *)
      if [[ -z "$list" ]]; then list="$1"; elif [[ -z "$shards" ]]; then shards="$1"; else usage >&2; exit 2; fi
      shift ;;
  esac
done
: "${shards:=100}"
[[ -n "$list" && "$shards" =~ ^[1-9][0-9]*$ ]] || { usage >&2; exit 2; }
[[ -r "$list" ]] || die "there is no list $list"
command -v parallel > /dev/null || die "GNU parallel is not installed; on Debian: apt install parallel"

root="$(cd "$(dirname "${BASH_SOURCE[0]}")/../.." && pwd)"
program="$(realpath "${TRIPUS:-$root/build/release/bin/tripus}")"
[[ -x "$program" ]] || die "there is no program $program; build it, or name it in TRIPUS"
list="$(realpath "$list")"
mkdir -p "${into:=$list.census}"
into="$(realpath "$into")"

# A shard that was killed is made once more; one that fails twice is missing, and the merge says so.
seq 1 "$shards" | parallel --will-cite --retries 2 --quote "$@" \
  "$program" census --from "$list" --shard "{}/$shards" -o "$into/{}.tcs" --threads 1 --quiet ||
  echo "parallel.sh: some shards failed" >&2
cd "$into"
exec "$program" census --merge ./*.tcs -o census.sqlite --tsv census.tsv
