# SPDX-License-Identifier: Apache-2.0
"""Eight small scenes, each with one hash however it is computed."""
import glob
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from .common import PASSIVE, ROOT, Result, cmake_build, row

SCENES = os.path.join(ROOT, "tests", "reliability", "scenes")
GOLDEN = os.path.join(ROOT, "tests", "reliability", "golden-hashes.txt")
NAMES = ("settle", "cohesive-heap", "shaken-die", "moving-wall", "drum", "mesh", "insertion", "memory")
# What glibc chooses by the processor: its mathematical functions differ in the last bit.
PLAIN_LIBRARY = {"GLIBC_TUNABLES": "glibc.cpu.hwcaps=-AVX2,-FMA,-AVX512F,-AVX512VL,-FMA4"}


def golden():
    with open(GOLDEN, encoding="utf-8") as file:
        return dict(line.split() for line in file if line.strip() and not line.startswith("#"))


def hash_of(build, scene, options=(), environment=None):
    """Without output or measures."""
    command = [os.path.join(build, "tests", "reliability", "scene_hash"), os.path.join(SCENES, scene + ".toml"), *options]
    run = subprocess.run(command, capture_output=True, text=True, env={**os.environ, **PASSIVE, **(environment or {})},
                         check=False)
    return run.stdout.split()[0] if run.returncode == 0 else f"exit {run.returncode}: {run.stderr.strip()}"


def start(build, scene, out, threads, *options):
    command = [os.path.join(build, "pulvis"), "run", os.path.join(SCENES, scene + ".toml"), "--out", out, "--threads",
               str(threads), "--set", "output.checkpoint_interval=50 ms", "--set", "output.interval=5 ms", *options]
    return subprocess.Popen(command, env={**os.environ, **PASSIVE}, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)


def hash_of_run(build, scene, kills, dice):
    """With output and measures, and killed that often: each time after a checkpoint and some time."""
    folder = tempfile.mkdtemp(prefix="pulvis-scene-")
    out, option, patience = os.path.join(folder, "out"), [], 0.3
    try:
        while True:
            process = start(build, scene, out, dice.randint(1, 4), *option)
            if kills > 0:
                while process.poll() is None and not glob.glob(os.path.join(out, "checkpoints", "*.pulvis")):
                    time.sleep(0.01)
                try:
                    process.wait(dice.uniform(0.0, patience))
                except subprocess.TimeoutExpired:
                    process.send_signal(signal.SIGKILL)
                    kills -= 1
            status = process.wait()
            if status == 0 and kills > 0:  # too fast to be killed: once more, with less patience
                if patience < 0.01:
                    return "ended before it could be killed"
                patience, option = 0.5 * patience, []
                shutil.rmtree(out)
                continue
            if status == 0:
                with open(os.path.join(out, "result.json"), encoding="utf-8") as file:
                    return json.load(file)["state_hash"]
            if status == 2 and option == ["--resume"]:  # killed before there was a checkpoint
                option = ["--force"]
            elif status == -signal.SIGKILL:
                option = ["--resume"]
            else:
                return f"exit {status}"
    finally:
        shutil.rmtree(folder, ignore_errors=True)


def builds(quick, build):
    """Folders with the program as each compiler makes it."""
    if quick:
        return {"the build": build}
    made = {"the build": build}
    for compiler in ("g++", "clang++"):
        for level in ("-O2", "-O3"):
            name = f"reliability-{compiler}{level}"
            made[f"{compiler} {level}"] = cmake_build(name, ["scene_hash"], [
                f"-DCMAKE_CXX_COMPILER={compiler}", "-DCMAKE_BUILD_TYPE=Release",
                f"-DCMAKE_CXX_FLAGS_RELEASE={level} -DNDEBUG"])
    return made


def ways(quick):
    """Options and environment of each way to compute a scene."""
    if quick:
        yield "three threads, half the skin, saved and loaded, baseline, plain libm", \
            ("--threads", "3", "--skin", "0.5", "--save-every", "997"), \
            {"PULVIS_INSTRUCTION_SET": "baseline", **PLAIN_LIBRARY}
        yield "avx2, twice the skin", ("--skin", "2"), {"PULVIS_INSTRUCTION_SET": "avx2"}
        return
    for threads in range(1, 9):
        yield f"{threads} threads", ("--threads", str(threads)), {}
    for instructions in ("baseline", "avx2", "avx512"):
        yield instructions, (), {"PULVIS_INSTRUCTION_SET": instructions}
    for skin in ("0.5", "2"):
        yield f"skin times {skin}", ("--skin", skin), {}
    for steps in ("97", "1001"):
        yield f"saved and loaded every {steps} steps", ("--save-every", steps, "--threads", "2"), {}
    yield "the C library's plain functions", (), PLAIN_LIBRARY


@row("scenes", "8 scenes: one hash each, with 1 to 8 threads, baseline, AVX2 and AVX-512, -O2 and -O3, g++ and clang++, "
               "other skins, with and without output and measures, saved and loaded, killed and resumed")
def scenes(build, quick):
    wanted, faults, tried = golden(), [], 0
    dice = random.Random(20261127)

    def expect(scene, found, how):
        nonlocal tried
        tried += 1
        if found != wanted.get(scene):
            faults.append(f"{scene}, {how}: {found}")

    for name, folder in builds(quick, build).items():
        for scene in NAMES:
            expect(scene, hash_of(folder, scene), name)
            for how, options, environment in ways(quick):
                expect(scene, hash_of(folder, scene, options, environment), f"{name}, {how}")
    for scene in NAMES:
        kills = 1 if quick else 5
        expect(scene, hash_of_run(build, scene, 0, dice), "with output and measures")
        expect(scene, hash_of_run(build, scene, kills, dice), f"killed {kills} times")
    says = f"{tried} runs of {len(NAMES)} scenes: " + ("; ".join(faults[:12]) if faults else "one hash a scene")
    if len(faults) > 12:
        says += f"; and {len(faults) - 12} more"
    return Result(not faults, says, runs=tried, faults=faults)


def renew_hashes(build, reason):
    """Writes the hashes anew and adds the reason to those before; refuses where a second way gives another hash."""
    lines = []
    for scene in NAMES:
        found = hash_of(build, scene)
        other = hash_of(build, scene, ("--threads", "3", "--skin", "0.5"), {"PULVIS_INSTRUCTION_SET": "baseline"})
        if found != other or len(found) != 32:
            print(f"{scene}: {found}, but {other} with three threads; that is a fault, no reason for a new hash",
                  file=sys.stderr)
            return 1
        lines.append(f"{scene} {found}\n")
    reasons = []
    if os.path.exists(GOLDEN):
        with open(GOLDEN, encoding="utf-8") as file:
            reasons = [line for line in file if line.startswith("#")]
    else:
        reasons = ["# SPDX-License-Identifier: Apache-2.0\n",
                   "# Hashes of the last states of tests/reliability/scenes, and why they are these.\n",
                   "# Renewed by: tools/reliability --renew-hashes REASON\n"]
    reasons.append(f"# {time.strftime('%Y-%m-%d')}: {reason}\n")
    with open(GOLDEN, "w", encoding="utf-8") as file:
        file.writelines(reasons + lines)
    print(f"wrote {os.path.relpath(GOLDEN, ROOT)}")
    return 0
