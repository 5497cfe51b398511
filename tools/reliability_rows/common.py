# SPDX-License-Identifier: Apache-2.0
"""What the rows of tools/reliability share."""
import os
import re
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
ROWS = {}
PASSIVE = {"OMP_WAIT_POLICY": "passive"}  # threads that wait must not spin: there may be more than processors


class Result:
    """What came of a row: whether the target was met, a sentence, and numbers for --json."""

    def __init__(self, met, says, **numbers):
        self.met, self.says, self.numbers = met, says, numbers


def row(name, target):
    """Adds a row: a function of (build folder, whether quick) that gives a Result."""
    def add(function):
        ROWS[name] = (target, function)
        return function
    return add


def run_test(build, program, name, environment=None):
    """Runs one GoogleTest (or several, by a pattern); gives whether all passed, and what was printed."""
    run = subprocess.run([os.path.join(build, program), f"--gtest_filter={name}"], capture_output=True, text=True,
                         env={**os.environ, **PASSIVE, **(environment or {})}, check=False)
    passed = re.search(r"\[  PASSED  \] [1-9]", run.stdout)
    return run.returncode == 0 and passed is not None, run.stdout + run.stderr


def cmake_build(name, targets, options, environment=None):
    """Configures and builds targets in build/NAME; returns that folder."""
    folder = os.path.join(ROOT, "build", name)
    environment = {**os.environ, **(environment or {})}
    log = folder + ".log"
    os.makedirs(os.path.dirname(folder), exist_ok=True)
    with open(log, "w", encoding="utf-8") as said:
        for command in (["cmake", "-S", ROOT, "-B", folder, "-G", "Ninja", *options],
                        ["cmake", "--build", folder, "--target", *targets]):
            if subprocess.run(command, stdout=said, stderr=said, env=environment, check=False).returncode != 0:
                raise RuntimeError(f"{' '.join(command)} failed; see {log}")
    return folder
