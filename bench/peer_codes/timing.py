# SPDX-License-Identifier: Apache-2.0
"""The codes take turns on one core; who waits for his turn waits for input and uses none."""
import contextlib
import json
import os
import subprocess
import tempfile
import time

from . import beds as make
from .places import BUILD, version_of
from .summary import figure, growth, read_look, row

PEERS = {"hertz": ("liggghts", "lammps"), "sjkr": ("liggghts",), "jkr": ("lammps",)}
SKINS = {"bed": (0.0001, 0.00025, 0.0005), "fall": (0.00025, 0.0005, 0.001)}  # m; a radius is 0.00125
STEPS = 150  # a turn
TEN_MILLION = 10_000_000
NEEDED = 9 * 2**30  # bytes free before ten million are tried


def name_of(code):
    return {"liggghts": "LIGGGHTS ", "lammps": "LAMMPS "}[code] + version_of(code)


def seconds_of(session, steps, clock=None):
    """What `steps` steps take of the processor, or of another clock."""
    clock = clock or session.processor_seconds
    began = clock()
    session.go_on(steps)
    session.wait("done")
    return clock() - began


class Skins:
    """Each peer's best of three skins, found once and kept beside the bed."""

    def __init__(self, beds):
        self.beds, self.path = beds, beds.path("skins.json")
        self.known = {}
        if os.path.exists(self.path):
            with open(self.path, encoding="utf-8") as file:
                self.known = json.load(file)

    def best(self, code, law, start, kind):
        """kind: bed or fall."""
        key = f"{code} {law} {kind}"
        if key not in self.known:
            turns = 2 if kind == "bed" else self.beds.size.falling // 300
            self.known[key] = self.find(code, law, start, SKINS[kind], turns, 100)
            with open(self.path, "w", encoding="utf-8") as file:
                json.dump(self.known, file, indent=2)
        took = self.known[key]
        return float(min(took, key=took.get))

    def find(self, code, law, start, skins, turns, steps):
        """Seconds by skin; the skins take turns, so that all see the same stretch."""
        took = {f"{skin:g}": 0.0 for skin in skins}
        with self.beds.peer(code, law, skins[0], start) as session:
            for _ in range(turns):
                for skin in skins:
                    session.send(f"neighbor {skin:g} bin", "run 1 post no", 'print "peers: done"')
                    session.wait("done")
                    took[f"{skin:g}"] += seconds_of(session, steps)
            session.close()
        print(f"peers: {code}, {law}, {start}: seconds by skin {took}", flush=True)
        return took


def on_the_bed(beds, pulvis, rounds):
    """Rows of every law; `pulvis`: its settled sessions by law."""
    skins, rows = Skins(beds), []
    for law, codes in PEERS.items():
        with contextlib.ExitStack() as open_ones:
            peers = {code: open_ones.enter_context(
                beds.peer(code, law, skins.best(code, law, f"{code}-{law}.restart", "bed"), f"{code}-{law}.restart"))
                for code in codes}
            rows += take_turns(beds, law, pulvis[law], peers, rounds)
    return rows


def take_turns(beds, law, ours, peers, rounds):
    sessions = {"pulvis": ours, **peers}
    for session in sessions.values():
        seconds_of(session, STEPS // 2)  # caches warm, lists made
    took = {name: [] for name in sessions}
    for _ in range(rounds):
        for name, session in sessions.items():
            took[name].append(seconds_of(session, STEPS))
    share = {name: (session.memory() - session.empty) / beds.size.count for name, session in sessions.items()}
    return [row(f"{law}/{code}", STEPS * beds.size.count, took["pulvis"], took[code], name_of(code), share["pulvis"],
                share[code]) for code in peers]


def falling(beds, falls):
    """The row of the fall, from insertion on; both codes fall side by side, a tenth at a time."""
    skin = Skins(beds).best("liggghts", "hertz", "fall.data", "fall")
    part = beds.size.falling // 10
    took, share = {"pulvis": [], "liggghts": []}, {}
    for _ in range(falls):
        with beds.pulvis("hertz", "fall.dump") as ours, beds.peer("liggghts", "hertz", skin, "fall.data") as theirs:
            sessions = {"pulvis": ours, "liggghts": theirs}
            whole = dict.fromkeys(sessions, 0.0)
            for _ in range(10):
                for name, session in sessions.items():
                    whole[name] += seconds_of(session, part)
            for name, session in sessions.items():
                took[name].append(whole[name])
                share[name] = (session.memory() - session.empty) / beds.size.count
    return row("falling/liggghts", 10 * part * beds.size.count, took["pulvis"], took["liggghts"], name_of("liggghts"),
               share["pulvis"], share["liggghts"])


def threads(beds, rounds):
    """Speed of two threads over one, by the wall clock: of all figures the one that needs a quiet machine most."""
    name = "speed of two threads over one"
    processors = sorted(os.sched_getaffinity(0))
    if len(processors) < 2:
        return figure(name, None)
    both = f"{processors[0]},{processors[1]}"
    with beds.pulvis("hertz", "bed.dump") as one, beds.pulvis("hertz", "bed.dump", 2, both) as two:
        took = {one: [], two: []}
        for session in took:
            seconds_of(session, 3 * STEPS)
        for _ in range(rounds):
            for session, times in took.items():
                times.append(seconds_of(session, STEPS, time.perf_counter))
    return figure(name, row("", 1, took[two], took[one], "", 0, 0)["ratio"])


def growing(cpu):
    """Time per particle-step of a million against ten thousand of the same bed."""
    with tempfile.TemporaryDirectory(prefix="peers-") as folder:
        rows = os.path.join(folder, "rows.json")
        subprocess.run(["taskset", "-c", str(cpu), os.path.join(BUILD, "pulvis"), "bench", "--sizes", "1e4,1e6", "--laws", "hertz",
                        "--threads", "1", "--json", rows], capture_output=True, text=True, check=True)
        with open(rows, encoding="utf-8") as file:
            return figure("time per particle-step at 10^6 over 10^4", growth(json.load(file)))


def available():
    with open("/proc/meminfo", encoding="utf-8") as file:
        return next(1024 * int(line.split()[1]) for line in file if line.startswith("MemAvailable:"))


def ten_million(beds):
    """The most memory that ten million particles take, a rebuild of the lists from full ones included."""
    name = "GiB at most for 10^7 particles"
    if available() < NEEDED:
        print("peers: less than 9 GiB of memory are free: ten million particles are not tried")
        return figure(name, None)
    tiles = next(n for n in range(1, 1000) if n * n * beds.size.count >= TEN_MILLION)
    with beds.pulvis("hertz", "bed.dump", tiles=tiles) as session:
        rebuilt = rebuilds(session)
        for _ in range(20):
            seconds_of(session, 10)
            if rebuilds(session) > rebuilt:
                break
        else:
            raise RuntimeError("no rebuild of ten million particles in 200 steps: their memory cannot be told")
        at_most = session.memory("VmHWM")
        session.close()
    return figure(name, at_most * TEN_MILLION / (tiles * tiles * beds.size.count) / 2**30)


def rebuilds(session):
    session.send("look")
    return read_look(session.wait("bed"))["rebuilds"]
