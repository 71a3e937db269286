"""A controller that tries one thing that it should not, says on standard error whether it worked, and gives up."""

import ctypes
import fcntl
import os
import socket
import struct
import sys
import time

from dockyard_client import GIVEN_UP, Commands, Motor, serve

MIB = 1 << 20
LIBC = ctypes.CDLL(None, use_errno=True)


def call(result):
    if result < 0:
        raise OSError(ctypes.get_errno(), os.strerror(ctypes.get_errno()))
    return result


def simulators():
    """Processes of the simulator that are visible."""
    found = []
    for name in os.listdir("/proc"):
        try:
            if name.isdigit() and "toy_dockyard" in open(f"/proc/{name}/cmdline").read().split("\0")[0]:
                found.append(int(name))
        except OSError:
            pass
    if not found:
        raise OSError("there is no simulator")
    return found


def memory(_):
    with open(f"/proc/{simulators()[0]}/mem", "rb"):
        return "its memory is open"


def trace(_):
    for process in simulators():
        call(LIBC.ptrace(16, process, None, None))  # PTRACE_ATTACH
        LIBC.ptrace(17, process, None, None)  # PTRACE_DETACH


def kill(process):
    os.kill(int(process), 0)
    os.kill(os.getppid(), 0)


def kill_parent(_):
    for process in simulators():
        os.kill(process, 0)


def read(path):
    with open(path, "rb") as file:
        return f"{len(file.read())} bytes"


def write(path):
    with open(path, "w") as file:
        file.write("from the controller")


def link(paths):
    os.link(*paths.split(":"))


def abstract(name):
    with socket.socket(socket.AF_UNIX) as client:
        client.connect("\0" + name)


def loopback(port):
    socket.create_connection(("127.0.0.1", int(port)), timeout=5).close()


def names(_):
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as client:
        client.connect(("192.0.2.1", 53))  # TEST-NET-1: to be routed is all that it takes


def forks(most):
    for _ in range(int(most)):
        if os.fork() == 0:
            time.sleep(60)
            os._exit(0)
    time.sleep(2)


def disk(folder):
    block = b"x" * MIB
    total_mib = 0
    try:
        for number in range(10):
            with open(f"{folder}/{number}", "wb") as file:
                for _ in range(1024):
                    total_mib += file.write(block) // MIB
    except OSError as error:
        if total_mib < 200:
            raise
        print(error, file=sys.stderr)
    return f"{total_mib} MiB"


def hog(gib):
    kept = []
    for _ in range(int(gib) * 16):
        kept.append(bytearray(b"x") * (64 * MIB))
    time.sleep(1)


def hogs(count):
    """Each below the limit of one process."""
    for _ in range(int(count)):
        if os.fork() == 0:
            kept = bytearray(b"x") * (600 * MIB)
            time.sleep(60)
            os._exit(len(kept) & 1)
    time.sleep(60)


def uncounted(_):
    worked = []
    try:
        worked.append(os.memfd_create("x"))
    except OSError:
        pass
    shared = LIBC.shmget(0, MIB, 0o1600)
    if shared >= 0:
        LIBC.shmctl(shared, 0, None)
        worked.append(shared)
    if not worked:
        raise OSError("none can be had")


def signals(_):
    """What two sandboxes, or two runs one after the other, could tell each other by."""
    worked = []
    shared = os.open("/usr/bin/env", os.O_RDONLY)
    try:
        fcntl.flock(shared, fcntl.LOCK_SH)
        worked.append("flock")
    except OSError:
        pass
    try:
        fcntl.fcntl(shared, 36, struct.pack("hhqqi4x", fcntl.F_WRLCK, 0, 0, 1, 0))  # F_OFD_GETLK
        worked.append("lock query")
    except OSError:
        pass
    for family in (40, 38):  # AF_VSOCK, AF_ALG
        try:
            socket.socket(family, socket.SOCK_STREAM if family == 40 else socket.SOCK_SEQPACKET)
            worked.append(f"family {family}")
        except OSError:
            pass
    if LIBC.inotify_init1(0) >= 0:
        worked.append("inotify")
    if LIBC.posix_fadvise(shared, ctypes.c_long(0), ctypes.c_long(0), 4) == 0:  # POSIX_FADV_DONTNEED
        worked.append("fadvise")
    LIBC.mmap.restype = ctypes.c_void_p
    address = LIBC.mmap(None, ctypes.c_size_t(4096), 1, 2, shared, ctypes.c_long(0))
    if LIBC.mincore(ctypes.c_void_p(address), ctypes.c_size_t(4096), ctypes.create_string_buffer(1)) == 0:
        worked.append("mincore")
    if LIBC.syscall(451, shared, ctypes.c_void_p(0), ctypes.c_void_p(0), 0) >= 0 or ctypes.get_errno() != 1:
        worked.append("cachestat")
    if not worked:
        raise OSError("nothing worked")
    return ", ".join(worked)


def daemon(mark):
    if os.fork() == 0:
        os.setsid()
        if os.fork() == 0:
            for descriptor in range(3):
                os.close(descriptor)
            os.execvp("sleep", ["sleep", mark])
        os._exit(0)
    time.sleep(0.3)


def children(mark):
    for _ in range(5):
        if os.fork() == 0:
            os.execvp("sleep", ["sleep", mark])
    time.sleep(0.3)


def descriptors(_):
    """What others than the standard streams, of which the client has copies, lead to."""
    found = set()
    for name in os.listdir("/proc/self/fd"):
        try:
            found.add(os.readlink(f"/proc/self/fd/{name}"))
        except OSError:
            pass  # it was the folder's own
    return " ".join(sorted(found - {os.readlink(f"/proc/self/fd/{i}") for i in range(3)}))


def environment(_):
    return " ".join(sorted(os.environ))


def flood(mib):
    for _ in range(int(mib)):
        os.write(2, b"x" * MIB)
    os.write(2, b"\n")


def new_user(_):
    call(LIBC.unshare(0x10000000))  # CLONE_NEWUSER


def folder(path):
    return " ".join(os.listdir(path)) or "empty"


class Hostile:
    def __init__(self, hello):
        self.motors = hello["motors"]

    def step(self, frame):
        try:
            text = f"it worked: {globals()[sys.argv[1]](sys.argv[2])}"
        except (OSError, MemoryError) as error:
            text = f"it failed: {error}"
        print(text, file=sys.stderr, flush=True)
        return Commands([Motor()] * self.motors, verdict=GIVEN_UP)


serve(Hostile)
