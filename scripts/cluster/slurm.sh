#!/usr/bin/env bash
# A census as an array job of Slurm that ends in the merge.
set -euo pipefail

usage() {
  cat <<'USAGE'
usage: scripts/cluster/slurm.sh LIST SHARDS [--into FOLDER] [--tasks N] [-- SBATCH-OPTIONS ...]

Submits an array job that makes the shards of the census of LIST, one INPUT a line, in FOLDER
(default: LIST.census), and a job that merges them into FOLDER/census.sqlite and census.tsv once
they have ended. What was killed is made by the same command again: shards that are there are not
made twice, and shards that were begun go on. Prints the numbers of both jobs.
  --tasks N   array tasks, each of which makes several shards (default: as many as shards, but at
              most 1000, which is what Slurm allows by default)
  --          everything behind it goes to sbatch: -- --partition=long --time=24:00:00
The folder must be one that all nodes share. TRIPUS names the program (default: the one that was
built here). See docs/census.md.
USAGE
}

# shellcheck source=scripts/cluster/common.sh
source "$(dirname "${BASH_SOURCE[0]}")/common.sh"
read_arguments "$@"
command -v sbatch > /dev/null || die "there is no Slurm here: sbatch is not found"
prepare
: "${tasks:=$((shards < 1000 ? shards : 1000))}"
[[ "$tasks" =~ ^[1-9][0-9]*$ ]] || die "--tasks $tasks is no number of tasks"
((tasks <= shards)) || tasks="$shards"

# An array task makes the shards task, task + tasks, ... One that fails does not keep the others.
cat > "$into/shards.sbatch" <<JOB
#!/usr/bin/env bash
status=0
for ((k = SLURM_ARRAY_TASK_ID; k <= $shards; k += $tasks)); do
  $(printf '%q' "$program") census --from $(printf '%q' "$list") --shard "\$k/$shards" \\
    -o $(printf '%q' "$into")/"\$k.tcs" --threads "\${SLURM_CPUS_PER_TASK:-1}" || status=\$?
done
exit "\$status"
JOB
cat > "$into/merge.sbatch" <<JOB
#!/usr/bin/env bash
cd $(printf '%q' "$into")
exec $(printf '%q' "$program") census --merge ./*.tcs -o census.sqlite --tsv census.tsv
JOB

job="$(sbatch --parsable --job-name=tripus-census --array="1-$tasks" --requeue \
  --output="$into/log-%a.txt" --open-mode=append "${engine_options[@]}" "$into/shards.sbatch")"
merge="$(sbatch --parsable --job-name=tripus-merge --dependency="afterany:${job%%;*}" \
  --output="$into/merge.txt" "${engine_options[@]}" "$into/merge.sbatch")"
echo "${job%%;*} ${merge%%;*}"
