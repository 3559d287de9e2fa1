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

# shellcheck source=scripts/cluster/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
read_arguments "$@"
: "${shards:=100}"
[[ -z "$tasks" ]] || { usage >&2; exit 2; }
command -v parallel > /dev/null || die "GNU parallel is not installed; on Debian: apt install parallel"
prepare

# A shard that was killed is made once more; one that fails twice is missing, and the merge says so.
seq 1 "$shards" | parallel --will-cite --retries 2 --quote "${engine_options[@]}" \
  "$program" census --from "$list" --shard "{}/$shards" -o "$into/{}.tcs" --threads 1 --quiet ||
  echo "parallel.sh: some shards failed" >&2
cd "$into"
exec "$program" census --merge ./*.tcs -o census.sqlite --tsv census.tsv
