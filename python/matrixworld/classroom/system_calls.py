"""The system calls of a process, reduced for good to those that computing in memory needs.

Linux runs a small program (seccomp-bpf) before each system call of the process. Ours knows a list
of allowed calls; every other one fails with EPERM, which Python raises as PermissionError. The
filter cannot be removed, not even by root. It is a list of what is allowed, not of what is
forbidden: a call that a new kernel brings is refused.
"""

from __future__ import annotations

import ctypes
import errno
import os
import platform
import struct
import sys

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
    # Questions about the process itself and the time.
    "sched_yield": (24, 124),
    "getpid": (39, 172),
    "gettid": (186, 178),
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

MACHINES = {"x86_64": (0, 0xC000003E), "aarch64": (1, 0xC00000B7)}
"""Column in `ALLOWED`, and the number that the kernel gives to the architecture."""

# Instructions and return values of linux/filter.h and linux/seccomp.h.
_LOAD, _JUMP_IF_EQUAL, _RETURN = 0x20, 0x15, 0x06
_NUMBER_AT, _MACHINE_AT = 0, 4  # offsets in struct seccomp_data
_KILL_PROCESS, _FAIL, _ALLOW = 0x80000000, 0x00050000, 0x7FFF0000
_PR_SET_NO_NEW_PRIVS, _PR_SET_SECCOMP, _PR_SET_PDEATHSIG = 38, 22, 1
_SECCOMP_MODE_FILTER = 2


def restrict() -> None:
    """Allow this process, which has one thread, the calls in `ALLOWED` only, from now on.

    Raises
    ------
    OSError
        If the system has no such filters, or forbids them.
    """
    if sys.platform != "linux" or platform.machine() not in MACHINES:
        machine = f"{platform.system()} on {platform.machine()}"
        raise OSError(errno.ENOSYS, f"expected Linux on {' or '.join(MACHINES)}, got {machine}")
    program = ctypes.create_string_buffer(_program(*MACHINES[platform.machine()]))
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
    """Call prctl, and raise OSError if it fails."""
    words = [*arguments, 0, 0, 0, 0][:4]
    library = ctypes.CDLL(None, use_errno=True)
    if library.prctl(ctypes.c_int(option), *map(ctypes.c_ulong, words)):
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))


def _program(column: int, machine: int) -> bytes:
    """Return the filter: instructions of code, jump if true, jump if false, and a number."""
    numbers = [row[column] for row in ALLOWED.values()]
    return b"".join(
        struct.pack("=HBBI", *instruction)
        for instruction in (
            (_LOAD, 0, 0, _MACHINE_AT),
            # Calls of another architecture, such as 32 bits, have other numbers.
            (_JUMP_IF_EQUAL, 1, 0, machine),
            (_RETURN, 0, 0, _KILL_PROCESS),
            (_LOAD, 0, 0, _NUMBER_AT),
            # A jump counts instructions that are left out: from each test to the last one.
            *((_JUMP_IF_EQUAL, len(numbers) - at, 0, call) for at, call in enumerate(numbers)),
            (_RETURN, 0, 0, _FAIL | errno.EPERM),
            (_RETURN, 0, 0, _ALLOW),
        )
    )
