"""Censuses by Slurm, GNU parallel and dask, each with one shard killed: the same bytes in the end.

    clusters.py PROGRAM slurm | parallel | dask

Exit status 77 where the engine is not installed. Slurm's daemons are started here, for two nodes
that have names only, which takes root.
"""

import os
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
import time
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
LIST = ROOT / "data" / "triangulations-4.txt"
SHARDS = 12
SKIPPED = 77
PATIENCE = 240
#: The one that sees Debian's packages.
DEBIAN_PYTHON = Path("/usr/bin/python3")


def skip(why):
    print("skipped:", why)
    sys.exit(SKIPPED)


def short_list(folder):
    lines = [line for line in LIST.read_text().splitlines() if not line.startswith("#")]
    path = folder / "list"
    path.write_text("\n".join(lines[::4]) + "\n")
    return path


def expected(program, folder):
    table = folder / "whole.tsv"
    subprocess.run([program, "census", "--from", folder / "list", "--tsv", table, "--quiet"], check=True)
    return table.read_bytes()


def wait_for(condition, what):
    end = time.monotonic() + PATIENCE
    while not condition():
        if time.monotonic() > end:
            sys.exit(f"waited in vain for {what}")
        time.sleep(0.05)


def process_of_shard(program, folder):
    """A process that is making a shard in the folder, or None."""
    for entry in Path("/proc").iterdir():
        if not entry.name.isdigit():
            continue
        try:
            words = (entry / "cmdline").read_bytes().split(b"\0")
        except OSError:
            continue
        if words[0] == str(program).encode() and any(w.startswith(str(folder).encode()) and
                                                     w.endswith(b".tcs") for w in words):
            return int(entry.name)
    return None


def kill_one(program, folder):
    """Kills one shard in the midst of its work, with kill -9."""
    found = []

    def is_found():
        pid = process_of_shard(program, folder)
        if pid is None or not list(folder.glob("*.journal")):
            return False
        try:
            os.kill(pid, signal.SIGKILL)
        except ProcessLookupError:
            return False
        found.append(pid)
        return True

    wait_for(is_found, "a shard to kill")
    print("killed", found[0])


class Slurm:
    """slurmctld and two slurmd on this machine, with munge; all in one folder."""

    def __init__(self, folder):
        self.folder = folder
        self.daemons = []
        if subprocess.run(["pgrep", "-x", "munged"], capture_output=True).returncode != 0:
            for path in ("/run/munge", "/var/lib/munge", "/var/log/munge"):
                os.makedirs(path, exist_ok=True)
                shutil.chown(path, "munge", "munge")
            self.start("runuser", "-u", "munge", "--", "munged", "--foreground")
            time.sleep(1)
        host = socket.gethostname()
        conf = folder / "slurm.conf"
        conf.write_text(f"""ClusterName=tripus
SlurmctldHost={host}(127.0.0.1)
SlurmUser=root
SlurmdUser=root
AuthType=auth/munge
SlurmctldPort=17010
ProctrackType=proctrack/pgid
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
AccountingStorageType=accounting_storage/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core
ReturnToService=2
SchedulerParameters=sched_interval=2
StateSaveLocation={folder}/state
SlurmdSpoolDir={folder}/spool-%n
SlurmctldPidFile={folder}/slurmctld.pid
SlurmdPidFile={folder}/slurmd-%n.pid
SlurmctldLogFile={folder}/slurmctld.log
SlurmdLogFile={folder}/slurmd-%n.log
NodeName=n1 NodeHostname={host} NodeAddr=127.0.0.1 Port=17011 CPUs=1
NodeName=n2 NodeHostname={host} NodeAddr=127.0.0.1 Port=17012 CPUs=1
PartitionName=all Nodes=ALL Default=YES MaxTime=INFINITE State=UP
""")
        for name in ("state", "spool-n1", "spool-n2"):
            (folder / name).mkdir()
        self.environment = dict(os.environ, SLURM_CONF=str(conf))
        self.start("slurmctld", "-D", "-f", str(conf))
        for node in ("n1", "n2"):
            self.start("slurmd", "-D", "-N", node, "-f", str(conf))
        wait_for(lambda: self.run("sinfo", "-h", "-t", "idle", "-o", "%D").strip() == "2", "two nodes")

    def start(self, *command):
        self.daemons.append(subprocess.Popen(command, stdout=subprocess.DEVNULL,
                                             stderr=subprocess.DEVNULL))

    def run(self, *command):
        return subprocess.run(command, capture_output=True, text=True, env=self.environment,
                              check=False).stdout

    def stop(self):
        for daemon in reversed(self.daemons):
            daemon.terminate()
        for daemon in self.daemons:
            try:
                daemon.wait(10)
            except subprocess.TimeoutExpired:
                daemon.kill()


def by_slurm(program, folder):
    for name in ("slurmctld", "slurmd", "sbatch", "munged"):
        if not shutil.which(name):
            skip(f"{name} is not installed (scripts/setup cluster)")
    if os.geteuid() != 0:
        skip("Slurm's daemons are started as root")
    into = folder / "shards"
    (folder / "slurm").mkdir()
    slurm = Slurm(folder / "slurm")
    try:
        command = [ROOT / "scripts/cluster/slurm.sh", folder / "list", str(SHARDS), "--into", into,
                   "--tasks", "6"]
        environment = dict(slurm.environment, TRIPUS=str(program))

        def submit():
            jobs = subprocess.run(command, env=environment, check=True, capture_output=True,
                                  text=True).stdout.split()
            print("jobs", *jobs)

        submit()
        kill_one(program, into)
        wait_for(lambda: not slurm.run("squeue", "-h").strip(), "the jobs")
        print((into / "merge.txt").read_text().strip())
        assert not (into / "census.tsv").exists(), "a census with a shard missing"
        submit()  # the same command makes what is missing
        wait_for(lambda: not slurm.run("squeue", "-h").strip(), "the jobs")
    finally:
        slurm.stop()
    return (into / "census.tsv").read_bytes()


def by_parallel(program, folder):
    if not shutil.which("parallel"):
        skip("GNU parallel is not installed (scripts/setup cluster)")
    into = folder / "shards"
    run = subprocess.Popen([ROOT / "scripts/cluster/parallel.sh", folder / "list", str(SHARDS),
                            "--into", into, "--", "--jobs", "2"],
                           env=dict(os.environ, TRIPUS=str(program)))
    kill_one(program, into)
    assert run.wait(PATIENCE) == 0
    return (into / "census.tsv").read_bytes()


def by_dask(program, folder):
    try:
        from distributed import Client, LocalCluster
    except ImportError:
        if Path(sys.executable).resolve() != DEBIAN_PYTHON.resolve() and DEBIAN_PYTHON.exists():
            os.execv(DEBIAN_PYTHON, [DEBIAN_PYTHON, *sys.argv])
        skip("dask.distributed is not installed (scripts/setup cluster, or pip install distributed)")
    sys.path.insert(0, str(ROOT / "scripts/cluster"))
    import threading

    from dask_census import run_census
    into = folder / "shards"
    with LocalCluster(n_workers=2, threads_per_worker=1, processes=True,
                      dashboard_address=None) as cluster, Client(cluster) as client:
        killer = threading.Thread(target=kill_one, args=(program, into))
        into.mkdir()
        killer.start()
        table = run_census(client, program, folder / "list", SHARDS, into)
        killer.join()
    return Path(table).read_bytes()


def main():
    program, engine = Path(sys.argv[1]).resolve(), sys.argv[2]
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name).resolve()
        short_list(folder)
        census = {"slurm": by_slurm, "parallel": by_parallel, "dask": by_dask}[engine](program, folder)
        assert census == expected(program, folder), "the census is another one"
    print("the same census, byte for byte")


if __name__ == "__main__":
    main()
