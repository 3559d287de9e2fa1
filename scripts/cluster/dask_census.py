#!/usr/bin/env python3
"""A census by the workers of a dask.distributed scheduler, and its merge.

For those who have a scheduler running (`pip install distributed`):

    python3 scripts/cluster/dask_census.py LIST SHARDS --scheduler tcp://host:8786
    python3 scripts/cluster/dask_census.py LIST SHARDS --local 4      processes of this machine

Shards go to FOLDER (default: LIST.census), which all workers must share; a worker that dies costs
the shard that it was making, which another one goes on with. See docs/census.md.
"""

import argparse
import os
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]


def positive(text):
    """A whole number above 0, for argparse."""
    number = int(text)
    if number < 1:
        raise ValueError(text)
    return number


def make_shard(program, list_file, number, count, folder):
    """Makes one shard, in a process of its own; its number. Runs on a worker."""
    command = [program, "census", "--from", list_file, "--shard", f"{number}/{count}",
               "-o", f"{folder}/{number}.tcs", "--threads", "1", "--quiet"]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    if result.returncode != 0:
        raise RuntimeError(f"shard {number}/{count}: {result.stderr.strip()}")
    return number


def run_census(client, program, list_file, shards, folder):
    """Makes all shards by the workers of a `distributed.Client` and merges them. Returns the path
    of the table. Raises RuntimeError for a shard that fails three times."""
    from distributed import as_completed

    folder = Path(folder).resolve()
    folder.mkdir(parents=True, exist_ok=True)
    list_file = str(Path(list_file).resolve())
    futures = [client.submit(make_shard, str(program), list_file, number, shards, str(folder),
                             pure=False, retries=3) for number in range(1, shards + 1)]
    for future in as_completed(futures):
        future.result()
    parts = [str(folder / f"{number}.tcs") for number in range(1, shards + 1)]
    table = folder / "census.tsv"
    subprocess.run([str(program), "census", "--merge", *parts, "-o", str(folder / "census.sqlite"),
                    "--tsv", str(table), "--quiet"], check=True)
    return table


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("list", help="one INPUT a line")
    parser.add_argument("shards", type=positive)
    parser.add_argument("--into", help="folder of the shards (default: LIST.census)")
    where = parser.add_mutually_exclusive_group(required=True)
    where.add_argument("--scheduler", help="address, such as tcp://host:8786")
    where.add_argument("--local", type=positive, metavar="N", help="N processes of this machine")
    arguments = parser.parse_args()
    program = Path(os.environ.get("TRIPUS", ROOT / "build/release/bin/tripus")).resolve()
    if not program.exists():
        parser.error(f"there is no program {program}; build it, or name it in TRIPUS")
    if not os.access(arguments.list, os.R_OK):
        parser.error(f"there is no list {arguments.list}")
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        sys.exit("dask.distributed is not here: scripts/setup cluster (for /usr/bin/python3), or pip install distributed")
    into = arguments.into or arguments.list + ".census"
    try:
        if arguments.scheduler:
            with Client(arguments.scheduler) as client:
                print(run_census(client, program, arguments.list, arguments.shards, into))
        else:
            with LocalCluster(n_workers=arguments.local, threads_per_worker=1, processes=True,
                              dashboard_address=None) as cluster, Client(cluster) as client:
                print(run_census(client, program, arguments.list, arguments.shards, into))
    except (OSError, RuntimeError, ValueError) as error:
        print(f"dask_census.py: {error}", file=sys.stderr)
        return 2
    except subprocess.CalledProcessError as error:  # the program has said why
        return error.returncode if error.returncode > 0 else 3
    return 0


if __name__ == "__main__":
    sys.exit(main())
