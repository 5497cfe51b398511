# SPDX-License-Identifier: Apache-2.0
"""Readers of what strangers write, fed with anything by libFuzzer under ASan and UBSan."""
import os
import re
import shutil
import subprocess
import tempfile

from .common import PASSIVE, ROOT, Result, row

TARGETS = ("units", "case_file", "stl", "bed", "checkpoint", "report")
CORPUS = os.path.join(ROOT, "tests", "fuzz", "corpus")
MINUTES = float(os.environ.get("PULVIS_FUZZ_MINUTES", "10"))  # a target


def fuzz_one(folder, target, seconds):
    """Returns what it found (empty: nothing) and how many inputs it tried."""
    found = tempfile.mkdtemp(prefix=f"pulvis-fuzz-{target}-")
    corpus = os.path.join(found, "corpus")
    os.mkdir(corpus)
    command = [os.path.join(folder, "tests", "fuzz", f"fuzz_{target}"), corpus, os.path.join(CORPUS, target),
               f"-max_total_time={seconds:.0f}", "-timeout=10", "-rss_limit_mb=2048", "-print_final_stats=1",
               f"-artifact_prefix={found}/"]
    run = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False,
                         env={**os.environ, **PASSIVE, "ASAN_OPTIONS": "allocator_may_return_null=1"})
    tried = re.search(r"stat::number_of_executed_units:\s*(\d+)", run.stderr)
    artifacts = [name for name in os.listdir(found) if name != "corpus"]
    if run.returncode == 0 and not artifacts:
        shutil.rmtree(found)
        return "", int(tried.group(1)) if tried else 0
    return f"{target}: {', '.join(artifacts)} in {found}: {run.stderr[-600:]}", int(tried.group(1)) if tried else 0


@row("fuzz", "fuzzing of case files, units, STL, beds, checkpoints and run folders, ten minutes a target: no finding")
def fuzz(build, quick):
    if quick:  # the corpus alone, by the programs of the usual build
        replayed = [subprocess.run([os.path.join(build, "tests", "fuzz", f"fuzz_{target}"), os.path.join(CORPUS, target)],
                                   capture_output=True, text=True, errors="replace", check=False) for target in TARGETS]
        faults = [f"{t}: exit {r.returncode}: {r.stderr[-400:]}" for t, r in zip(TARGETS, replayed) if r.returncode != 0]
        return Result(not faults, "; ".join(faults) or f"the corpus of {len(TARGETS)} targets passes", faults=faults)
    log = os.path.join(ROOT, "build", "fuzz.log")
    os.makedirs(os.path.dirname(log), exist_ok=True)
    with open(log, "w", encoding="utf-8") as said:
        for command in (["cmake", "--preset", "fuzz"], ["cmake", "--build", "--preset", "fuzz"]):
            if subprocess.run(command, cwd=ROOT, stdout=said, stderr=said, check=False).returncode != 0:
                raise RuntimeError(f"{' '.join(command)} failed; see {log}")
    faults, tries = [], {}
    for target in TARGETS:
        found, tries[target] = fuzz_one(os.path.join(ROOT, "build", "fuzz"), target, 60 * MINUTES)
        if found:
            faults.append(found)
    says = f"{MINUTES:g} minutes a target: " + ", ".join(f"{t} {n} inputs" for t, n in tries.items())
    return Result(not faults, says + ("; " + "; ".join(faults) if faults else "; no finding"), tries=tries, faults=faults)
