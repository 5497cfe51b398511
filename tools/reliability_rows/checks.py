# SPDX-License-Identifier: Apache-2.0
"""Rows whose work a test program of the suite does, here with more rounds than in ./test, or one run."""
import json
import os
import re
import subprocess
import tempfile

from .common import PASSIVE, ROOT, Result, row, run_test


@row("bits", "10,000 single bit flips and truncations of a checkpoint: all detected, none crashes")
def bits(build, quick):
    rounds = 1000 if quick else 10000
    met, said = run_test(build, "tests/run/run_tests", "CheckpointFile.NoticesFlippedBitsAndCutsAnywhere",
                         {"PULVIS_ROUNDS": str(rounds)})
    return Result(met, f"{rounds} of {rounds} detected" if met else "not all detected:\n" + said[-2000:],
                  rounds=rounds)


@row("mutations", "10,000 single-edit mutations of the example cases: each checks clean, or exits 3 (4 for a file it "
                  "names) naming the line that holds the edit")
def mutations(build, quick):
    rounds = 500 if quick else 10000
    met, said = run_test(build, "tests/reliability/mutation_tests", "SlipsOfThePen.*", {"PULVIS_ROUNDS": str(rounds)})
    line = re.search(r"^\d+ edits: (.*)$", said, re.MULTILINE)
    says = f"{rounds} edits: {line.group(1)}" if line else said[-2000:]
    return Result(met, says if met else says + "\n" + said[:3000], rounds=rounds)


@row("guards", "numbers that are none, runaways, deep overlaps and leaping walls put into a run: found within 64 steps, "
               "with parcel, time, place, law and remedy")
def guards(build, quick):
    met, said = run_test(build, "tests/engine/engine_tests", "Guards.*")
    return Result(met, "all found" if met else said[-3000:])


@row("conservation", "momentum and mass of a closed system: 1e-12 of the sum of all momenta; exact")
def conservation(build, quick):
    environment = {} if quick else {"PULVIS_ROUNDS": "100000"}
    met, said = run_test(build, "tests/reliability/conservation_tests", "ClosedSystem.*", environment)
    kept = re.findall(r"^\w+: momentum kept.*$", said, re.MULTILINE)
    return Result(met, "; ".join(kept) if met else said[-2000:])


@row("energy", "ledger of energy over 1e6 steps of a filling: closed to 1e-3 of the energy put through")
def energy(build, quick):
    if quick:
        return Result(None, "the quick form has none; the suite's tests of the ledger are shorter")
    case = os.path.join(ROOT, "tests", "verification", "energy-filling.toml")
    with tempfile.TemporaryDirectory(prefix="pulvis-energy-") as folder:
        run = subprocess.run([os.path.join(build, "pulvis"), "run", case, "--out", folder, "--force", "--threads", "1"],
                             capture_output=True, text=True, env={**os.environ, **PASSIVE}, check=False)
        if run.returncode != 0:
            return Result(False, f"exit {run.returncode}: {run.stderr[-800:]}")
        with open(os.path.join(folder, "result.json"), encoding="utf-8") as file:
            result = json.load(file)
    share, steps = result["energy"]["closing_share"], result["steps"]
    return Result(abs(share) <= 1e-3 and steps >= 1e6, f"{share:.1e} after {steps:,} steps of {result['particles']} parcels",
                  closing_share=share, steps=steps)
