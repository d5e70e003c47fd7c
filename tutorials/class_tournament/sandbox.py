"""What a submitted program may use: limits of the process, and a filter of its system calls.

Linux runs a small program (seccomp-bpf) before each system call of the process. Ours knows a list
of allowed calls; every other one fails with EPERM, which Python raises as PermissionError. The
filter cannot be removed, not even by root. It is a list of what is allowed, not of what is
forbidden: a call that a new kernel brings is refused.

Calls that ask for numbers of processes answer 0: from such numbers a program could tell how many
matches were played before its own. Linux itself exempts two calls on x86-64 from all filters, 335
and 336 (``uretprobe`` and ``uprobe``). They only go on with a probe that a debugger has set, and
fail or end the process where there is none.
"""

from __future__ import annotations

import ctypes
import errno
import os
import platform
import struct
import sys
from pathlib import Path

MIB = 2**20


def set_limits(seconds: int, memory: int, files: int | None) -> None:
    """Limit processor time, in seconds, and memory, in MiB, of this process for good.

    `files` are open already: it can then open no other one, write to no regular one, and start no
    process. With None only time and memory are limited.
    """
    import resource

    hard = {"RLIMIT_AS": _address_space() + memory * MIB, "RLIMIT_CORE": 0}
    if files is not None:
        hard |= {
            "RLIMIT_FSIZE": 0,  # of regular files; connections and /dev/null have no size
            "RLIMIT_MEMLOCK": 0,
            "RLIMIT_NOFILE": files,
            "RLIMIT_NPROC": 0,  # not for root, which the filter of system calls stops
        }
    for name, value in hard.items():
        # macOS lacks some of them, and refuses a limit of the address space.
        if hasattr(resource, name) and not (name == "RLIMIT_AS" and sys.platform == "darwin"):
            resource.setrlimit(getattr(resource, name), (value, value))
    # The first signal can be caught, the second one, a second later, cannot.
    resource.setrlimit(resource.RLIMIT_CPU, (seconds, seconds + 1))


def _address_space() -> int:
    """Return the bytes of address space that this process uses already."""
    import resource

    status = Path("/proc/self/statm")
    return int(status.read_text().split()[0]) * resource.getpagesize() if status.exists() else 0


ALLOWED = {
    # What is open already: the connection to the parent, and /dev/null.
    "read": (0, 63),
    "write": (1, 64),
    "close": (3, 57),
    "lseek": (8, 62),
    # Memory, within the limit of the process.
    "mmap": (9, 222),
    "munmap": (11, 215),
    "mremap": (25, 216),
    "mprotect": (10, 226),
    "madvise": (28, 233),
    "brk": (12, 214),
    # Locks of the interpreter, and signals that the process itself causes.
    "futex": (202, 98),
    "rt_sigaction": (13, 134),
    "rt_sigprocmask": (14, 135),
    "rt_sigreturn": (15, 139),
    "sigaltstack": (131, 132),
    "restart_syscall": (219, 128),
    # Time, and how much of it the process has used.
    "sched_yield": (24, 124),
    "clock_nanosleep": (230, 115),
    "pselect6": (270, 72),  # a pause in Python 3.10
    "getrusage": (98, 165),
    "times": (100, 153),
    "clock_gettime": (228, 113),
    "clock_getres": (229, 114),
    "gettimeofday": (96, 169),
    "getrandom": (318, 278),
    "exit": (60, 93),
    "exit_group": (231, 94),
}
"""Allowed system calls: their numbers on x86-64 and on aarch64 (``asm/unistd_64.h`` and
``asm-generic/unistd.h`` of Linux)."""
ANSWERED_BY_0 = {"getpid": (39, 172), "gettid": (186, 178)}
"""Calls that return 0, as above."""

MACHINES = {"x86_64": (0, 0xC000003E), "aarch64": (1, 0xC00000B7)}
"""Column in `ALLOWED`, and the number that the kernel gives to the architecture."""

# Instructions and return values of linux/filter.h and linux/seccomp.h.
_LOAD, _JUMP_IF_EQUAL, _RETURN = 0x20, 0x15, 0x06
_NUMBER_AT, _MACHINE_AT = 0, 4  # offsets in struct seccomp_data
_KILL_PROCESS, _FAIL, _ALLOW = 0x80000000, 0x00050000, 0x7FFF0000
_PR_SET_NO_NEW_PRIVS, _PR_SET_SECCOMP, _PR_SET_PDEATHSIG = 38, 22, 1
_SECCOMP_MODE_FILTER = 2


def filter_system_calls() -> None:
    """Allow this process, which has one thread, the calls in `ALLOWED` only, from now on.

    OSError if the system has no such filters, or forbids them.
    """
    if sys.platform != "linux" or platform.machine() not in MACHINES:
        machine = f"{platform.system()} on {platform.machine()}"
        raise OSError(errno.ENOSYS, f"expected Linux on {' or '.join(MACHINES)}, got {machine}")
    program = ctypes.create_string_buffer(_filter(*MACHINES[platform.machine()]))
    # struct sock_fprog: the number of instructions of 8 bytes, and their address.
    count, address = (len(program) - 1) // 8, ctypes.addressof(program)
    header = ctypes.create_string_buffer(struct.pack("@HP", count, address))
    # Without new privileges, a process that is not root may install filters.
    _control(_PR_SET_NO_NEW_PRIVS, 1)
    try:
        _control(_PR_SET_SECCOMP, _SECCOMP_MODE_FILTER, ctypes.addressof(header))
    except PermissionError as error:
        # Told apart from the PermissionError that a filter causes.
        raise OSError(errno.ENOSYS, "the system forbids filters of system calls") from error


def end_with_parent(signal: int) -> None:
    """Ask for a signal when the process that made this one ends, where the system can do that."""
    if sys.platform == "linux":
        _control(_PR_SET_PDEATHSIG, signal)


def _control(option: int, *arguments: int) -> None:
    """Call prctl; OSError if it fails."""
    words = [*arguments, 0, 0, 0, 0][:4]
    library = ctypes.CDLL(None, use_errno=True)
    if library.prctl(ctypes.c_int(option), *map(ctypes.c_ulong, words)):
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))


def _filter(column: int, machine: int) -> bytes:
    """Return the filter: instructions of code, jump if true, jump if false, and a number."""
    answers = {row[column]: _ALLOW for row in ALLOWED.values()}
    answers |= {row[column]: _FAIL | 0 for row in ANSWERED_BY_0.values()}
    instructions = [
        (_LOAD, 0, 0, _MACHINE_AT),
        # Calls of another architecture, such as 32 bits, have other numbers.
        (_JUMP_IF_EQUAL, 1, 0, machine),
        (_RETURN, 0, 0, _KILL_PROCESS),
        (_LOAD, 0, 0, _NUMBER_AT),
    ]
    for call, answer in answers.items():
        # A jump counts instructions that are left out.
        instructions += [(_JUMP_IF_EQUAL, 0, 1, call), (_RETURN, 0, 0, answer)]
    instructions.append((_RETURN, 0, 0, _FAIL | errno.EPERM))
    return b"".join(struct.pack("=HBBI", *each) for each in instructions)
