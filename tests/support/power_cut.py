"""Runs on a disk whose power is cut at any write: they go on to equal bytes, or name the damage.

    sudo python tests/support/power_cut.py 7 --tries 200

Needs Linux with FUSE and loop devices. A run plays on a file system, which is on a loop device,
which is on a file of this program: so that it sees each write of the system to the disk, and each
flush, in their order. A cut keeps all writes before the last flush. Of those after it, it keeps any
that the disk may have had in its cache, the last one perhaps in part. The run then goes on.
"""

import argparse
import contextlib
import os
import stat
import struct
import subprocess
import sys
import threading
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np

from killed import SETTINGS, play_run
from matrixworld._util.files import DamagedFileError
from tiny_race import results, straight

SIZE = 24 * 2**20
SECTOR = 512
ROOT, DISK = 1, 2
# Operations of the protocol of FUSE (include/uapi/linux/fuse.h) that a loop device needs.
LOOKUP, FORGET, GETATTR, SETATTR, OPEN, READ, WRITE, STATFS, RELEASE, FSYNC = (
    1, 2, 3, 4, 14, 15, 16, 17, 18, 20,
)  # fmt: skip
FLUSH, INIT, OPENDIR, RELEASEDIR, INTERRUPT, FORGETS = 25, 26, 27, 29, 36, 42
UNKNOWN = 38  # ENOSYS
Event = tuple[int, bytes] | None
"""Offset and content of a write; None: a flush."""


def attributes(node):
    size, mode = (0, stat.S_IFDIR | 0o755) if node == ROOT else (SIZE, stat.S_IFREG | 0o644)
    return struct.pack(
        "<6Q10I", node, size, size // SECTOR, 0, 0, 0, 0, 0, 0, mode, 1, 0, 0, 0, 4096, 0
    )


class Disk:
    """A file ``disk`` in a directory, which writes down what it is asked to write."""

    def __init__(self, place, content):
        self.content, self.events, self.place = bytearray(content), [], place
        self.handle = os.open("/dev/fuse", os.O_RDWR)
        options = f"fd={self.handle},rootmode=40000,user_id=0,group_id=0"
        mount = ["mount", "-i", "-t", "fuse", "-o", options, "disk", str(place)]
        subprocess.run(mount, check=True, pass_fds=[self.handle])
        threading.Thread(target=self.serve, daemon=True).start()

    def serve(self):
        while True:
            try:
                request = os.read(self.handle, 2**20)
            except OSError:  # it is unmounted
                return
            length, operation, number, node = struct.unpack_from("<IIQQ", request)
            if operation in (FORGET, INTERRUPT, FORGETS):
                continue
            answer = self.answer(operation, node, request[40:length])
            error = -UNKNOWN if answer is None else 0
            body = answer or b""
            os.write(self.handle, struct.pack("<IiQ", 16 + len(body), error, number) + body)

    def answer(self, operation, node, given):
        if operation == INIT:
            return struct.pack("<4I2H2I2H8I", 7, 31, 2**17, 0, 16, 12, 2**17, 1, 32, 0, *[0] * 8)
        if operation == LOOKUP:
            return struct.pack("<4Q2I", DISK, 0, 0, 0, 0, 0) + attributes(DISK)
        if operation in (GETATTR, SETATTR):
            return struct.pack("<Q2I", 0, 0, 0) + attributes(node)
        if operation in (OPEN, OPENDIR):
            return struct.pack("<Q2I", 0, 0, 0)
        if operation == READ:
            _, offset, size = struct.unpack_from("<QQI", given)
            return bytes(self.content[offset : offset + size])
        if operation == WRITE:
            _, offset, size = struct.unpack_from("<QQI", given)
            self.content[offset : offset + size] = content = given[40 : 40 + size]
            self.events.append((offset, content))
            return struct.pack("<2I", size, 0)
        if operation == FSYNC:
            self.events.append(None)
            return b""
        if operation == STATFS:
            return struct.pack("<5Q4I24x", 2**20, 2**20, 2**20, 2**10, 2**10, 4096, 255, 4096, 0)
        return b"" if operation in (FLUSH, RELEASE, RELEASEDIR) else None

    def close(self):
        subprocess.run(["umount", str(self.place)], check=True)
        os.close(self.handle)


@contextlib.contextmanager
def mounted(disk, place):
    place.mkdir(exist_ok=True)
    subprocess.run(["mount", "-o", "loop", str(disk), str(place)], check=True)
    try:
        yield place
    finally:
        subprocess.run(["umount", str(place)], check=True)


def in_child(kind, run):
    """Play a run to its end in another process; return 0, or 3 if it named what is damaged."""
    child = os.fork()
    if child == 0:
        try:
            play_run(kind, run)
            os._exit(0)
        except DamagedFileError as error:
            sys.stdout.write(f"{error}\n")
            sys.stdout.flush()
            os._exit(3)
        finally:
            os._exit(1)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1])


def recorded(kind, empty, root):
    """Return the writes and flushes of a run on a new disk."""
    (root / "fuse").mkdir(exist_ok=True)
    disk = Disk(root / "fuse", empty)
    try:
        with mounted(root / "fuse" / "disk", root / "on") as place:
            code = in_child(kind, place / "run")
            events = disk.events[:]  # not those of the end
            assert code == 0
    finally:
        disk.close()
    return events


def cut(content, events, rng):
    """Return what a disk holds after a cut at a random event."""
    at = int(rng.integers(len(events) + 1))
    flushed = max((i for i in range(at) if events[i] is None), default=0)
    kept, disk = rng.choice([0.0, 0.5, 1.0]), bytearray(content)
    for number, event in enumerate(events[:at]):
        if event is None or (number > flushed and rng.random() >= kept):
            continue
        offset, written = event
        if number == at - 1:
            written = written[: SECTOR * int(rng.integers(1 + len(written) // SECTOR))]
        disk[offset : offset + len(written)] = written
    return bytes(disk)


def tries(seed, count, root):
    """Return how many cut runs ended in what way; AssertionError for one that ended in none."""
    rng, ends = np.random.default_rng(seed), dict.fromkeys(("equal bytes", "named damage"), 0)
    image = root / "image"
    image.write_bytes(bytes(SIZE))
    subprocess.run(["mkfs.ext4", "-q", "-F", str(image)], check=True)
    empty, kinds = image.read_bytes(), sorted(SETTINGS)
    for number in range(count):
        if number % 20 == 0:
            kind = kinds[number // 20 % len(kinds)]
            events = recorded(kind, empty, root)
        image.write_bytes(cut(empty, events, rng))
        subprocess.run(["e2fsck", "-fy", str(image)], capture_output=True, check=False)
        with mounted(image, root / "again") as place:
            code = in_child(kind, place / "run")
            equal = code == 0 and results(place / "run") == straight(SETTINGS[kind])
        assert equal or code == 3, f"seed {seed}, try {number} ({kind}): {code}"
        ends["equal bytes" if equal else "named damage"] += 1
    return ends


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__.partition("\n")[0])
    parser.add_argument("seed", type=int)
    parser.add_argument("--tries", type=int, default=200)
    args = parser.parse_args()
    with TemporaryDirectory(prefix="power-") as folder:
        sys.stdout.write(f"{tries(args.seed, args.tries, Path(folder))}\n")
