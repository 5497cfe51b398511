# SPDX-License-Identifier: Apache-2.0
"""Runs that are killed again and again, and go on."""
import filecmp
import json
import os
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

from .common import PASSIVE, ROOT, Result, row

# The shoe of cases/die-filling: soft, fast and short, but with enough parcels that two threads share them.
SHOE = os.path.join(ROOT, "cases", "die-filling", "shoe.toml")
SETTINGS = {
    "powders.molybdenum.coarse_graining": "70",
    "powders.molybdenum.simulated_modulus": "2 MPa",
    "materials.molybdenum.surface_energy": "1e-8 J/m^2",
    "materials.steel.surface_energy": "1e-8 J/m^2",
    "sources.hopper.velocity": '["0 m/s", "0 m/s", "-1 m/s"]',
    "sources.hopper.mass_rate": "170 g/s",
    "phases.settle.at_least": "1 ms",
    "phases.settle.time_limit": "2 ms",
    "motions.pass.distance": "8 mm",
    "motions.pass.speed": "0.5 m/s",
    "motions.pass.acceleration": "100 m/s^2",
    "motions.pass.passes": "1",
    "motions.pass.pause": "0 s",
    "phases.measure.at_least": "1 ms",
    "phases.measure.time_limit": "2 ms",
    "output.interval": "2 ms",
    "output.log_interval": "0.5 ms",
    "output.picture": "false",
    "output.report": "false",  # it says how long the run took
    "output.checkpoint_interval": "0.5 s",
}
QUICK_SETTINGS = {**SETTINGS, "powders.molybdenum.coarse_graining": "150", "output.checkpoint_interval": "0.2 s"}
NO_CHECKPOINT = 2  # the exit code of --resume where there is none
SAME_BYTES = ("log.csv", "wall-forces.csv", "parcels.pvd", "walls.pvd", "porosity.pvd", "frames", "wall-pressure",
              "measures.csv", "measures")


def start(build, settings, out, threads, *options):
    command = [os.path.join(build, "pulvis"), "run", SHOE, "--out", out, "--threads", str(threads), *options]
    for key, value in settings.items():
        command += ["--set", f"{key}={value}"]
    environment = {**os.environ, **PASSIVE}
    with open(out + ".said", "ab") as said:
        return subprocess.Popen(command, stdout=said, stderr=said, env=environment)


def result_of(out):
    with open(os.path.join(out, "result.json"), encoding="utf-8") as file:
        return json.load(file)


def faults_of(out, straight):
    """How a run that was killed and resumed differs from the straight one."""
    faults = []
    if result_of(out)["state_hash"] != result_of(straight)["state_hash"]:
        faults.append("another hash")
    for name in SAME_BYTES:
        one, other = os.path.join(straight, name), os.path.join(out, name)
        if os.path.isdir(one):
            names = sorted(os.listdir(one))
            if not os.path.isdir(other) or sorted(os.listdir(other)) != names:
                faults.append(f"other files in {name}")
            elif filecmp.cmpfiles(one, other, names, shallow=False)[0] != names:
                faults.append(f"other bytes in {name}")
        elif not os.path.exists(other) or not filecmp.cmp(one, other, shallow=False):
            faults.append(f"other bytes in {name}")
    return faults


def killed_run(build, settings, out, longest, most_kills, dice):
    """Kills and resumes until the run is complete; returns (kills, of them before the first checkpoint)."""
    kills, starts, option = 0, 0, []
    while True:
        process = start(build, settings, out, dice.randint(1, 4), *option)
        if kills < most_kills:
            try:
                process.wait(dice.uniform(0.0, longest))
            except subprocess.TimeoutExpired:
                process.send_signal(signal.SIGKILL)
                kills += 1
        status = process.wait()
        if status == 0:
            return kills, starts
        if status == NO_CHECKPOINT:  # killed before there was anything to go on from
            starts += 1
            option = ["--force"]
        elif status == -signal.SIGKILL:
            option = ["--resume"]
        else:
            raise RuntimeError(f"the run ended with status {status}; see {out}.said")


@row("kill", "kill -9 at 100 random moments of a filling case with a moving shoe, resumed each time with 1 to 4 threads: "
             "the hash and the bytes of all series of the straight run")
def kill(build, quick):
    wanted, settings = (5, QUICK_SETTINGS) if quick else (100, SETTINGS)
    dice = random.Random(20261122)
    folder = tempfile.mkdtemp(prefix="pulvis-kill-")
    straight = os.path.join(folder, "straight")
    began = time.monotonic()
    if start(build, settings, straight, 2).wait() != 0:
        raise RuntimeError(f"the straight run failed; see {straight}.said")
    length = time.monotonic() - began
    kills, early, runs, faults = 0, 0, 0, []
    while kills < wanted:
        runs += 1
        out = os.path.join(folder, f"run-{runs}")
        added, before = killed_run(build, settings, out, 0.25 * length, wanted - kills, dice)
        kills, early = kills + added, early + before
        faults += [f"run {runs}: {fault}" for fault in faults_of(out, straight)]
        print(f"  run {runs}: {added} kills, {kills} of {wanted}; resumed {result_of(out)['resumes']} times",
              file=sys.stderr, flush=True)
        if not faults:
            shutil.rmtree(out)
    if not faults:
        shutil.rmtree(folder)
    says = f"{kills} kills ({early} before there was a checkpoint) in {runs} runs; the straight one took {length:.0f} s; "
    says += "; ".join(faults) + f"; see {folder}" if faults else "all ended with its hash and its bytes"
    return Result(not faults, says, kills=kills, before_checkpoint=early, runs=runs, faults=faults,
                  straight_seconds=round(length, 1))
