# SPDX-License-Identifier: Apache-2.0
"""Disks that fail or are full: exit 6, the file named, no partial file under a final name, and the run goes on later."""
import errno
import filecmp
import json
import os
import random
import shutil
import subprocess
import tempfile
import xml.etree.ElementTree

from .common import PASSIVE, ROOT, Result, row

CASE = os.path.join(ROOT, "tests", "reliability", "disk.toml")
FAILED, NO_CHECKPOINT = 6, 2
# The calls, with how they may fail; 0: a write of half the bytes. What may be tried again must not end the run.
FAILURES = [("write", errno.ENOSPC), ("write", errno.EIO), ("write", errno.EDQUOT), ("write", 0),
            ("write", errno.EINTR), ("fsync", errno.EIO), ("fsync", errno.ENOSPC), ("rename", errno.EIO),
            ("rename", errno.ENOSPC), ("open", errno.ENOSPC), ("open", errno.EMFILE), ("close", errno.EIO),
            ("close", errno.ENOSPC), ("ftruncate", errno.EIO), ("mkdir", errno.ENOSPC), ("unlink", errno.EIO)]
HARMLESS = [("write", 0), ("write", errno.EINTR)]
GROWING = ("log.csv", "measures.csv", "wall-forces.csv")  # files that grow line by line


def run(build, out, *options, environment=None):
    command = [os.path.join(build, "pulvis"), "run", CASE, "--out", out, "--threads", "1", *options]
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=300,
                          env={**os.environ, **PASSIVE, **(environment or {})})


def failing(build, out, call, at, how, many):
    return {"LD_PRELOAD": os.path.join(build, "tests", "reliability", "libfailing_calls.so"), "PULVIS_FAIL_UNDER": out,
            "PULVIS_FAIL_CALL": call, "PULVIS_FAIL_AT": str(at), "PULVIS_FAIL_WITH": str(how),
            "PULVIS_FAIL_FOR": str(many)}


def files_in(out):
    for folder, _, names in os.walk(out):
        for name in names:
            yield os.path.join(folder, name)


def partial_files(out, straight):
    """Files that have their final name and are not whole, or not those of the run that nothing disturbed."""
    for path in files_in(out):
        name = os.path.relpath(path, out)
        if name.endswith(".part") or name in GROWING or name == ".pulvis.lock":
            continue
        try:
            if name.endswith(".json"):
                with open(path, encoding="utf-8") as file:
                    json.load(file)
            elif name.endswith(".pvd"):
                xml.etree.ElementTree.parse(path)
            elif name.endswith((".vtp", ".vti")):
                with open(path, "rb") as file:
                    if not file.read().endswith(b"</VTKFile>\n"):
                        yield f"{name} is cut short"
            elif name.startswith("wall-pressure"):
                if not filecmp.cmp(path, os.path.join(straight, name), shallow=False):
                    yield f"{name} is cut short"
            elif os.path.getsize(path) == 0:
                yield f"{name} is empty"
        except (ValueError, xml.etree.ElementTree.ParseError) as error:
            yield f"{name}: {error}"


def differences(out, straight):
    """Files that are not as those of the run that nothing disturbed."""
    for path in files_in(straight):
        name = os.path.relpath(path, straight)
        if name in ("result.json", "run.json") or name.startswith("checkpoints") or name.endswith(".lock"):
            continue
        other = os.path.join(out, name)
        if not os.path.exists(other) or not filecmp.cmp(path, other, shallow=False):
            yield f"another {name}"


def state_hash(out):
    with open(os.path.join(out, "result.json"), encoding="utf-8") as file:
        return json.load(file)["state_hash"]


def goes_on(build, out, straight):
    """What is wrong with a run that goes on in a folder that a failed one left."""
    rest = run(build, out, "--resume")
    if rest.returncode == NO_CHECKPOINT:  # it failed before the first
        rest = run(build, out, "--force")
    if rest.returncode != 0:
        return [f"exit {rest.returncode} when it was to go on: {rest.stderr.strip()[-300:]}"]
    if state_hash(out) != state_hash(straight):
        return ["another hash when it had gone on"]
    return list(differences(out, straight))


def disturbed(build, out, writes, call, environment):
    """A run with failing calls. Only one that goes on cuts files, to where its checkpoint stands: that is broken off first,
    in the last tenth of its writes."""
    if call != "ftruncate":
        return run(build, out, environment=environment)
    run(build, out, environment=failing(build, out, "write", writes - writes // 10, errno.EIO, 1000000))
    return run(build, out, "--resume", environment=environment)


def faults_of(build, out, straight, writes, call, at, how, many):
    """None where there were fewer calls than `at`: checkpoints come by the clock, so that runs differ in their number."""
    count = out + ".count"
    if os.path.exists(count):
        os.remove(count)
    outcome = disturbed(build, out, writes, call,
                        {**failing(build, out, call, at, how, many), "PULVIS_FAIL_COUNT": count})
    if os.path.exists(count):  # else it crashed
        with open(count, encoding="utf-8") as file:
            if int(file.read()) < at:
                return None
    if (call, how) in HARMLESS:
        if outcome.returncode != 0:
            return [f"exit {outcome.returncode}: {outcome.stderr.strip()[-300:]}"]
        return list(differences(out, straight))
    faults = []
    if outcome.returncode != 0:
        if outcome.returncode != FAILED:
            faults.append(f"exit {outcome.returncode}: {outcome.stderr.strip()[-300:]}")
        elif out not in outcome.stderr:
            faults.append(f"names no file: {outcome.stderr.strip()[-300:]}")
    elif call not in ("close", "unlink", "fsync"):  # a folder that cannot be synced, a lock that stays: no harm
        faults.append("was not noticed")
    return faults + list(partial_files(out, straight)) + goes_on(build, out, straight)


def calls_of(build, folder, writes, call):
    """How many of these calls the run makes."""
    count, out = os.path.join(folder, "count"), os.path.join(folder, "counting")
    environment = {**failing(build, out, call, 0, 0, 0), "PULVIS_FAIL_COUNT": count}
    if disturbed(build, out, writes, call, environment).returncode != 0:
        raise RuntimeError("the undisturbed run failed")
    shutil.rmtree(out)
    with open(count, encoding="utf-8") as file:
        return int(file.read())


@row("io", "1,000 runs with a failing open, write, sync, close, rename, truncate, mkdir or unlink: exit 6 and the file "
           "named, nothing partial under a final name, and the last checkpoint loads and leads to the straight run's bytes")
def injected(build, quick):
    wanted = 32 if quick else 1000
    dice = random.Random(20261128)
    folder = os.path.realpath(tempfile.mkdtemp(prefix="pulvis-disk-"))
    straight, out = os.path.join(folder, "straight"), os.path.join(folder, "out")
    plain = run(build, straight)
    if plain.returncode != 0:
        raise RuntimeError(f"the straight run failed: {plain.stderr}")
    calls = {}
    for call, _ in FAILURES:  # writes come first
        if call not in calls:
            calls[call] = calls_of(build, folder, calls.get("write", 0), call)
    if min(calls.values()) == 0:
        raise RuntimeError(f"a call is never made, and so cannot fail: {calls}")
    faults = []
    for number in range(wanted):
        call, how = FAILURES[number % len(FAILURES)]
        many = dice.choice((1, 1, 50 if (call, how) == ("write", errno.EINTR) else 1000000))
        found = None
        while found is None:  # until there are as many calls
            shutil.rmtree(out, ignore_errors=True)
            at = dice.randint(1, calls[call])
            found = faults_of(build, out, straight, calls["write"], call, at, how, many)
        name = os.strerror(how) if how else "half the bytes"
        faults += [f"{call} {at} of {calls[call]} ({name}, for {many}): {fault}" for fault in found]
        shutil.rmtree(out, ignore_errors=True)
    shutil.rmtree(folder)
    says = f"{wanted} runs with failing calls ({', '.join(f'{n} {c}' for c, n in calls.items())} a run): "
    says += "; ".join(faults[:10]) + (f"; and {len(faults) - 10} more" if len(faults) > 10 else "") if faults \
        else "all as they should be"
    return Result(not faults, says, runs=wanted, faults=faults)


@row("full-disk", "a tmpfs that is full in 40 places of a run: exit 6 and the file named, nothing partial under a final "
                  "name, and with more room the run goes on to the straight run's bytes")
def full_disk(build, quick):
    wanted = 4 if quick else 40
    folder = os.path.realpath(tempfile.mkdtemp(prefix="pulvis-full-"))
    straight, disk = os.path.join(folder, "straight"), os.path.join(folder, "disk")
    out = os.path.join(disk, "out")
    os.mkdir(disk)
    try:
        if run(build, straight).returncode != 0:
            raise RuntimeError("the straight run failed")
        need = sum(os.path.getsize(path) + 4096 for path in files_in(straight)) // 1024
        faults, full = [], 0
        for number in range(wanted):
            size = max(16, need * (number + 1) // (wanted + 1)) // 4 * 4
            mount = subprocess.run(["mount", "-t", "tmpfs", "-o", f"size={size}k", "tmpfs", disk], capture_output=True,
                                   text=True, check=False)
            if mount.returncode != 0:
                return Result(None, "nothing can be mounted here: " + mount.stderr.strip(), runs=0)
            try:
                outcome = run(build, out)
                full += outcome.returncode == FAILED
                found = list(partial_files(out, straight))
                if outcome.returncode not in (0, FAILED):
                    found.append(f"exit {outcome.returncode}: {outcome.stderr.strip()[-300:]}")
                elif outcome.returncode == FAILED and disk not in outcome.stderr:
                    found.append(f"names no file: {outcome.stderr.strip()[-300:]}")
                subprocess.run(["mount", "-o", "remount,size=200m", disk], check=True)
                found += goes_on(build, out, straight) if outcome.returncode != 0 else []
                faults += [f"{size} KiB: {fault}" for fault in found]
            finally:
                subprocess.run(["umount", disk], check=True)
    finally:
        shutil.rmtree(folder, ignore_errors=True)
    says = f"{wanted} sizes up to {need} KiB, full in {full} of them: "
    return Result(not faults and full > 0, says + ("; ".join(faults[:10]) if faults else "all as they should be"),
                  runs=wanted, full=full, faults=faults)
