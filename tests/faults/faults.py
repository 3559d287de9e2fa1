#!/usr/bin/env python3
"""Kills, interrupts, fills, closes, starves, damages and races every verb of verbs.py.

    faults.py PROGRAM [--trials N] [--seed N] [--kind KIND]... [--verb VERB]...

Each trial has a folder of its own and is told by its seed. What is promised is in
docs/reliability.md. Prints what was tried, and every promise that was broken; status 1 if any was.
"""

import argparse
import collections
import os
import random
import resource
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from verbs import HERE, VERBS, plain, plain_file, prepare

OLD = b"what was here before\n"
PATIENCE = 60  # seconds, for what must end by itself


class Broken(Exception):
    """A promise was broken: lost, torn, silent or slow."""


def limits(file_size=None, memory=None):
    def apply():
        if file_size is not None:
            resource.setrlimit(resource.RLIMIT_FSIZE, (file_size, file_size))
        if memory is not None:
            resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
        resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    return apply


class Trials:
    def __init__(self, program, workshop):
        self.program = program
        self.workshop = workshop
        self.known = {}  # by verb: what it writes when nothing happens to it

    def start(self, arguments, folder, **options):
        options.setdefault("stdin", subprocess.DEVNULL)
        return subprocess.Popen([self.program, *arguments], cwd=folder, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE, **options)

    def run(self, arguments, folder, **options):
        process = self.start(arguments, folder, **options)
        out, err = process.communicate(timeout=PATIENCE)
        return process.returncode, out, err

    def folder(self, verb):
        folder = Path(tempfile.mkdtemp(dir=self.workshop))
        prepare(folder)
        for arguments in verb.needs:
            status, _, err = self.run(arguments, folder)
            if status != 0:
                raise RuntimeError(f"{arguments}: {err.decode()}")
        for name in verb.outputs:
            if "/" not in name:
                (folder / name).write_bytes(OLD)
        return folder

    def reference(self, verb):
        if verb.name not in self.known:
            folder = self.folder(verb)
            before = time.monotonic()
            status, out, err = self.run(verb.arguments, folder)
            if status != 0:
                raise RuntimeError(f"{verb.name}: status {status}: {err.decode()}")
            files = {name: plain_file(folder / name)
                     for name in verb.outputs + (verb.journal if not verb.outputs else ())}
            names = {path.name for path in folder.iterdir()}
            self.known[verb.name] = (plain(out), files, time.monotonic() - before, names)
            shutil.rmtree(folder)
        return self.known[verb.name]

    def require_whole(self, verb, folder):
        """Each output is the old file or the new one, and nothing else was left in the folder."""
        _, files, _, names = self.reference(verb)
        for name in verb.outputs:
            path = folder / name
            if not path.exists():
                if "/" not in name:
                    raise Broken(f"lost: {name} is gone")
                continue
            data = path.read_bytes()
            if data != OLD and plain_file(path) != files[name]:
                raise Broken(f"torn: {name} has {len(data)} bytes that are neither old nor new")
        left = {path.name for path in folder.iterdir()} - names - set(verb.journal)
        if left:
            raise Broken(f"left over: {sorted(left)}")

    def require_new(self, verb, folder):
        """The same command again ends as if nothing had happened."""
        out_known, files, _, _ = self.reference(verb)
        status, out, err = self.run(verb.arguments, folder)
        if status != 0:
            raise Broken(f"lost: the same command again ends with {status}: {err.decode()[:300]}")
        for name, data in files.items():
            if plain_file(folder / name) != data:
                raise Broken(f"lost: {name} is not the same after going on")
        if plain(out) != out_known and not verb.resumes:
            raise Broken("lost: standard output is not the same when run again")

    # ---- the faults -------------------------------------------------------------------------

    def kill(self, verb, folder, chance):
        _, _, seconds, _ = self.reference(verb)
        for _ in range(chance.choice((1, 1, 2)) if verb.resumes else 1):
            process = self.start(verb.arguments, folder)
            time.sleep(chance.uniform(0, 1.1 * seconds))
            process.kill()
            process.communicate(timeout=PATIENCE)
            self.require_whole(verb, folder)
        self.require_new(verb, folder)

    def interrupt(self, verb, folder, chance):
        known, _, seconds, _ = self.reference(verb)
        process = self.start(verb.arguments, folder)
        time.sleep(chance.uniform(0.02, 0.02 + 1.1 * seconds))
        process.send_signal(chance.choice((signal.SIGINT, signal.SIGTERM)))
        before = time.monotonic()
        out, err = process.communicate(timeout=PATIENCE)
        took = time.monotonic() - before
        if took > 1:
            raise Broken(f"slow: ended {took:.2f} s after the signal")
        if process.returncode not in (0, 1, -signal.SIGINT, -signal.SIGTERM):
            raise Broken(f"silent: status {process.returncode}: {err.decode()[:300]}")
        if process.returncode == 1 and b"interrupted" not in err + out:
            raise Broken(f"silent: nothing is said of the interruption: {err.decode()[:300]}")
        if verb.prefix and not known.startswith(plain(out)):
            raise Broken("lost: the answers are no unbroken prefix")
        if verb.resumes or verb.prefix:
            self.require_whole(verb, folder)
        if verb.resumes:
            self.require_new(verb, folder)

    def fill(self, verb, folder, chance):
        _, files, _, _ = self.reference(verb)
        if not files:
            with open("/dev/full", "wb") as full:
                process = subprocess.run([self.program, *verb.arguments], cwd=folder, stdout=full,
                                         stderr=subprocess.PIPE, timeout=PATIENCE, check=False)
            if process.returncode != 3:
                raise Broken(f"silent: status {process.returncode} with a full standard output")
            return
        size = chance.choice((0, 1, 100, 1000, 4000))
        status, _, err = self.run(verb.arguments, folder, preexec_fn=limits(file_size=size))
        largest = max(len(data) for data in files.values())
        if status == 0 and largest <= 4 * size + 100:
            return  # it fits
        if status != 3 or b"cannot write" not in err:
            raise Broken(f"silent: status {status} with room for {size} bytes: {err.decode()[:300]}")
        self.require_whole(verb, folder)
        self.require_new(verb, folder)

    def close(self, verb, folder, chance):
        known, files, _, _ = self.reference(verb)
        closed = chance.choice(((0,), (2,), (0, 2), (1,), (0, 1, 2)))
        redirections = {0: "<&-", 1: ">&-", 2: "2>&-"}
        command = " ".join(redirections[n] for n in closed)
        process = subprocess.run(
            ["/bin/sh", "-c", f'exec "$@" {command}', "sh", self.program, *verb.arguments],
            cwd=folder, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
            timeout=PATIENCE, check=False)
        if 1 in closed and known:
            if process.returncode != 3:
                raise Broken(f"silent: status {process.returncode} with standard output closed")
        elif process.returncode != 0:
            raise Broken(f"status {process.returncode} with {closed} closed")
        elif plain(process.stdout) != (b"" if 1 in closed else known):
            raise Broken(f"lost: another output with {closed} closed")
        for name, data in files.items():
            if plain_file(folder / name) != data and process.returncode == 0:
                raise Broken(f"torn: {name} with {closed} closed")

    def starve(self, verb, folder, chance):
        known, _, _, _ = self.reference(verb)
        memory = chance.randrange(60, 400) << 20
        status, out, err = self.run(verb.arguments, folder, preexec_fn=limits(memory=memory))
        if status == 127 and b"shared librar" in err:
            return  # ended by the system's loader, before its first line
        if status == 0:
            if plain(out) != known:
                raise Broken("silent: another answer with little memory")
        elif status != 3 or b"memory" not in err:
            raise Broken(f"status {status} with {memory >> 20} MB: {err.decode()[-300:]}")
        self.require_whole(verb, folder)

    def damage(self, verb, folder, chance):
        known, files, _, _ = self.reference(verb)
        path = folder / chance.choice(verb.reads)
        data = bytearray(path.read_bytes())
        kind = chance.choice(("digit", "bit", "cut", "cut at line", "drop line", "add"))
        lines = bytes(data).splitlines(keepends=True)
        if kind == "digit":
            at = chance.choice([i for i, c in enumerate(data) if 48 <= c < 58])
            data[at] = chance.choice([c for c in range(48, 58) if c != data[at]])
        elif kind == "bit":
            data[chance.randrange(len(data))] ^= 1 << chance.randrange(8)
        elif kind == "cut":
            del data[chance.randrange(len(data)):]
        elif kind == "cut at line":
            data = bytearray(b"".join(lines[:chance.randrange(len(lines))]))
        elif kind == "drop line":
            del lines[chance.randrange(len(lines))]
            data = bytearray(b"".join(lines))
        else:
            data += chance.randbytes(chance.randrange(1, 40))
        path.write_bytes(bytes(data))
        status, out, err = self.run(verb.arguments, folder)
        if status == 0:
            if plain(out) != known and not verb.resumes:
                raise Broken(f"silent: {kind} in {path.name}, and status 0 with another answer")
            for name, good in files.items():
                if plain_file(folder / name) != good:
                    raise Broken(f"silent: {kind} in {path.name}, and status 0 with another {name}")
        elif status != 2 or path.name not in err.decode("utf-8", "replace"):
            raise Broken(f"{kind} in {path.name}: status {status}: {err.decode()[:300]}")

    def race(self, verb, folder, chance):
        known, files, _, _ = self.reference(verb)
        processes = [self.start(verb.arguments, folder) for _ in range(chance.randrange(2, 6))]
        done = 0
        for process in processes:
            out, err = process.communicate(timeout=PATIENCE)
            if process.returncode == 0:
                done += 1
                if plain(out) != known and not verb.resumes:
                    raise Broken("another answer in a race")
            elif process.returncode != 2 or b"in use by" not in err:
                raise Broken(f"status {process.returncode} in a race: {err.decode()[:300]}")
        if done == 0:
            raise Broken("nobody won the race")
        for name, good in files.items():
            if plain_file(folder / name) != good:
                raise Broken(f"torn: {name} after a race")
        self.require_whole(verb, folder)

    def mesher(self, verb, folder, chance):
        """A mesher that lies: verbs.py has one that uses it."""
        environment = dict(os.environ, TRIPUS_TETGEN=str(HERE / "fake_mesher.py"),
                           FAKE_MESHER_SEED=str(chance.randrange(1 << 30)),
                           FAKE_MESHER_FOR=self.program)
        # Without its mesher a surface can take long.
        status, _, err = self.run((*verb.arguments, "--time-limit", "15"), folder, env=environment)
        text = (folder / "out.vtk").read_text(errors="replace")
        if "inf" in text.lower() or "nan" in text.lower():
            raise Broken("silent: a point that is not finite in the mesh")
        if status not in (0, 2, 3):
            raise Broken(f"status {status} with a damaged mesher: {err.decode()[:300]}")
        if status != 0 and (folder / "out.vtk").read_bytes() != OLD:
            raise Broken("torn: a mesh was written all the same")


#: Every kind of fault, and which verbs it is tried on.
APPLIES = {
    "kill": lambda verb: True,
    "interrupt": lambda verb: True,
    "fill": lambda verb: True,
    "close": lambda verb: True,
    "starve": lambda verb: True,
    "damage": lambda verb: verb.reads,
    "race": lambda verb: verb.outputs or verb.journal,
    "mesher": lambda verb: verb.name == "mesh",
}
KINDS = tuple(APPLIES)


def main():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--trials", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--kind", action="append", choices=KINDS)
    parser.add_argument("--verb", action="append")
    options = parser.parse_args()
    verbs = [verb for verb in VERBS if not options.verb or verb.name in options.verb]
    kinds = [kind for kind in options.kind or KINDS if any(map(APPLIES[kind], verbs))]
    count, broken = collections.Counter(), []
    with tempfile.TemporaryDirectory(prefix="tripus-faults-") as workshop:
        trials = Trials(os.path.abspath(options.program), Path(workshop))
        seed = options.seed
        ended = []
        signal.signal(signal.SIGINT, lambda *_: ended.append(True))
        while sum(count.values()) < options.trials and not ended:
            chance = random.Random(seed)
            kind = kinds[seed % len(kinds)]
            verb = chance.choice([verb for verb in verbs if APPLIES[kind](verb)])
            trials.reference(verb)
            folder = trials.folder(verb)
            try:
                count[kind] += 1
                getattr(trials, kind)(verb, folder, chance)
            except (Broken, subprocess.TimeoutExpired) as problem:
                broken.append(f"{kind} {verb.name}, seed {seed}: {problem}")
                print(broken[-1], flush=True)
            shutil.rmtree(folder, ignore_errors=True)
            seed += 1
    for kind in kinds:
        print(f"{kind:<10} {count[kind]:6} trials")
    print(f"seeds {options.seed} to {seed - 1}: {sum(count.values())} trials, {len(broken)} broken")
    return 1 if broken else 0


if __name__ == "__main__":
    sys.exit(main())
