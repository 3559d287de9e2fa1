#!/usr/bin/env python3
"""A tripus-tetgen that lies: asks the real one, and damages its answer.

TRIPUS_TETGEN names it; FAKE_MESHER_SEED chooses the damage, FAKE_MESHER_FOR is the program tripus,
beside which the real mesher is found.
"""

import os
import random
import signal
import socket
import struct
import subprocess
import sys
import time
from pathlib import Path

REQUEST, RESPONSE = 8 * 8, 8 * 4  # meshing/detail/tetgen_protocol.hpp


def receive(link, size):
    data = b""
    while len(data) < size:
        part = link.recv(min(1 << 16, size - len(data)))
        if not part:
            return None
        data += part
    return data


def real_mesher():
    near = Path(os.environ["FAKE_MESHER_FOR"]).resolve().parent
    return next(path for path in (near / "tripus-tetgen", near.parent / "libexec/tripus-tetgen")
                if path.exists())


def ask(request, body):
    ours, theirs = socket.socketpair()
    with subprocess.Popen([str(real_mesher()), str(os.getpid())], stdin=theirs):
        theirs.close()
        ours.sendall(request + body)
        response = receive(ours, RESPONSE)
        mark, status, points, tetrahedra = struct.unpack("<4Q", response)
        mesh = b"" if status else receive(ours, 24 * points + 16 * tetrahedra)
    return [mark, status, points, tetrahedra], bytearray(mesh)


def main():
    chance = random.Random(int(os.environ["FAKE_MESHER_SEED"]))
    link = socket.socket(fileno=os.dup(0))
    how = chance.choice(("honest", "nan", "inf", "far", "unused", "corner", "swap", "count",
                         "cut", "crash", "exit", "babble", "mute"))
    if how == "crash":
        sys.stderr.write("the fake mesher crashes\n")
        sys.stderr.flush()
        os.kill(os.getpid(), signal.SIGSEGV)
    if how == "exit":
        sys.exit("the fake mesher gives up")
    if how == "babble":
        link.sendall(chance.randbytes(4096))
        return
    if how == "mute":
        link.shutdown(socket.SHUT_RDWR)
        link.close()
        os.close(0)
        time.sleep(30)
        return
    request = receive(link, REQUEST)
    fields = struct.unpack("<8Q", request)
    sizes = fields[5:8]
    body = receive(link, 24 * sizes[0] + 12 * sizes[1] + 24 * sizes[2])
    head, mesh = ask(request, body)
    surface, points, tetrahedra = sizes[0], head[2], head[3]
    inner = [i for i in range(surface, points)] or [points - 1]
    place = 24 * chance.choice(inner) + 8 * chance.randrange(3) if points else 0
    if how in ("nan", "inf", "far") and points:
        value = {"nan": float("nan"), "inf": float("inf"), "far": 1e30}[how]
        mesh[place:place + 8] = struct.pack("<d", value)
    elif how == "unused" and points:
        mesh[24 * points:24 * points] = struct.pack("<3d", *[float("nan")] * 3)
        head[2] += 1
    elif how in ("corner", "swap") and tetrahedra:
        at = 24 * points + 4 * chance.randrange(4 * tetrahedra)
        value = 1 << 31 if how == "corner" else chance.randrange(points)
        mesh[at:at + 4] = struct.pack("<I", value)
    elif how == "count":
        head[2 + chance.randrange(2)] = chance.choice((1 << 60, 1 << 33, 0, head[2] + 1))
    elif how == "cut":
        del mesh[chance.randrange(len(mesh) + 1):]
    link.sendall(struct.pack("<4Q", *head) + bytes(mesh))


if __name__ == "__main__":
    main()
