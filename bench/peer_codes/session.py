# SPDX-License-Identifier: Apache-2.0
"""A running code that is told what to do line by line, so that codes can take turns."""
import contextlib
import os
import subprocess
import time

# Open MPI, which Debian's LIGGGHTS comes with, otherwise refuses to run as root.
ENVIRONMENT = {"OMPI_ALLOW_RUN_AS_ROOT": "1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM": "1", "OMP_PROC_BIND": "false"}


class Session:
    """A process that reads commands and prints "peers: WORD" when it is done with them."""

    def __init__(self, name, command, folder, cpus, threads=1):
        self.name, self.said = name, []
        self.process = subprocess.Popen(
            ["taskset", "-c", cpus, "stdbuf", "-oL", *command], cwd=folder, text=True, stdin=subprocess.PIPE,
            stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
            env={**os.environ, **ENVIRONMENT, "OMP_NUM_THREADS": str(threads)})

    def send(self, *lines):
        try:
            self.process.stdin.write("".join(line + "\n" for line in lines))
            self.process.stdin.flush()
        except BrokenPipeError:
            self.fail()

    def wait(self, word):
        """The line that begins with "peers: WORD"."""
        for line in self.process.stdout:
            self.said = self.said[-40:] + [line]
            if line.startswith("peers: " + word):
                return line.strip()
        return self.fail()

    def fail(self):
        self.process.wait()
        raise RuntimeError(f"{self.name} ended with status {self.process.returncode}:\n" + "".join(self.said[-12:]))

    def processor_seconds(self):
        """What all threads of the process used of processors; other programs on the machine hardly change it."""
        # The number that clock_getcpuclockid(3) gives for a process.
        return time.clock_gettime((~self.process.pid << 3) | 2)

    def memory(self, field="VmRSS"):
        """Bytes in use; VmHWM: at most so far."""
        with open(f"/proc/{self.process.pid}/status", encoding="utf-8") as status:
            for line in status:
                if line.startswith(field + ":"):
                    return 1024 * int(line.split()[1])
        raise RuntimeError(f"/proc says no {field} of {self.name}")

    def close(self):
        """Lets the process end, so that its files are whole."""
        self.process.stdin.close()
        self.said = self.process.stdout.read().splitlines(keepends=True)
        if self.process.wait() != 0:
            self.fail()

    def __enter__(self):
        return self

    def __exit__(self, *_):
        if self.process.poll() is None:
            self.process.kill()
        self.process.wait()
        self.process.stdout.close()
        with contextlib.suppress(OSError):
            self.process.stdin.close()
