# SPDX-License-Identifier: Apache-2.0
"""Sanitizers over the suite, and valgrind over some of it."""
import os
import subprocess

from .common import PASSIVE, ROOT, Result, cmake_build, row

# The C library's own allocator checks cannot live beside those; and read_back.py loads a Python of its own.
NOT_UNDER_SANITIZERS = "reliability.(io|full-disk)"
LEAKS = os.path.join(os.path.dirname(os.path.abspath(__file__)), "leaks-of-libraries.txt")
THREADED = "engine.(StateHash|ClosedSystem|Near|Rain|Insertion|Wall)|reliability.ClosedSystem"


def suite(folder, log, environment, *options):
    """Runs tests and returns how many failed, as ctest says it, or an empty text."""
    with open(log, "w", encoding="utf-8") as said:
        run = subprocess.run(["ctest", "--output-on-failure", "-j2", "--timeout", "1800", *options], cwd=folder,
                             stdout=said, stderr=said, env={**os.environ, **PASSIVE, **environment}, check=False)
    with open(log, encoding="utf-8", errors="replace") as said:
        summary = [line.strip() for line in said if "tests passed" in line or "tests failed" in line]
    return run.returncode == 0, (summary[-1] if summary else "no test ran") + f" (see {os.path.relpath(log, ROOT)})"


@row("sanitizers", "ASan and UBSan over the whole suite: no finding")
def sanitizers(build, quick):
    if quick:
        return Result(None, "the quick form has none; needs a build of its own")
    # The preset has clang, since GCC takes several times as long for such a build.
    folder = cmake_build("asan", ["all"], ["--preset", "asan"])
    met, says = suite(folder, folder + "-tests.log", {"UBSAN_OPTIONS": "halt_on_error=1:print_stacktrace=1",
                                                     "LSAN_OPTIONS": f"suppressions={LEAKS}:print_suppressions=0"},
                      "-E", NOT_UNDER_SANITIZERS)
    return Result(met, says)


@row("threads", "ThreadSanitizer over the threaded part of the suite: no finding")
def threads(build, quick):
    if quick:
        return Result(None, "the quick form has none; needs a build of its own")
    # clang with LLVM's OpenMP, whose archer tells TSan of its barriers; GCC's would show races that are none.
    folder = cmake_build("tsan", ["engine_tests", "conservation_tests"], [
        "-DCMAKE_CXX_COMPILER=clang++", "-DCMAKE_BUILD_TYPE=RelWithDebInfo", "-DPULVIS_SANITIZE=thread"])
    environment = {"TSAN_OPTIONS": "ignore_noninstrumented_modules=1:halt_on_error=1", "OMP_NUM_THREADS": "4"}
    met, says = suite(folder, folder + "-tests.log", environment, "-R", THREADED)
    return Result(met, says)


@row("valgrind", "valgrind on a smoke set: no error and no leak")
def valgrind(build, quick):
    if quick:
        return Result(None, "the quick form has none; valgrind takes minutes")
    case = os.path.join(ROOT, "tests", "reliability", "disk.toml")
    program = os.path.join(build, "pulvis")
    out = os.path.join(build, "valgrind-run")
    faults = []
    for arguments in (["check", case], ["run", case, "--out", out, "--force", "--threads", "1"], ["report", out],
                      ["explain", "contact"]):
        command = ["valgrind", "--quiet", "--error-exitcode=99", "--leak-check=full",
                   "--errors-for-leak-kinds=definite", program, *arguments]
        run = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False,
                             env={**os.environ, **PASSIVE, "PULVIS_INSTRUCTION_SET": "baseline"})
        if run.returncode != 0:
            faults.append(f"{arguments[0]}: exit {run.returncode}: {run.stderr[-800:]}")
    return Result(not faults, "; ".join(faults) or "check, run, report and explain: no error, nothing lost", faults=faults)
