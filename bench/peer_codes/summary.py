# SPDX-License-Identifier: Apache-2.0
"""Numbers out of what codes say, and words out of numbers."""
from statistics import median

# name: (at least or at most, value); the ratios are pulvis over peer.
TARGETS = {
    "hertz/liggghts": (">=", 5.0), "hertz/lammps": (">=", 4.0), "sjkr/liggghts": (">=", 5.0),
    "jkr/lammps": (">=", 5.0), "falling/liggghts": (">=", 5.0),
    "speed of two threads over one": (">=", 1.9),
    "time per particle-step at 10^6 over 10^4": ("<=", 1.5),
    "bytes per particle": ("<=", 600.0),
    "GiB at most for 10^7 particles": ("<=", 8.0),
}


def read_look(line):
    """"peers: bed NAME VALUE NAME VALUE..." as a dictionary."""
    words = line.split()
    if words[:2] != ["peers:", "bed"] or len(words) % 2:
        raise RuntimeError(f'not what peer_bed says of a bed: "{line}"')
    return dict(zip(words[2::2], map(float, words[3::2])))


def growth(bench):
    """Time per particle-step on the largest bed that `pulvis bench --json` timed over that on the smallest."""
    rows = bench["rows"]
    if len({row["parcels"] for row in rows}) < 2:
        raise RuntimeError("pulvis bench did not time two sizes")
    return max(rows, key=lambda row: row["parcels"])["time_over_smallest_bed"]


def ratios(slower, faster):
    """Of each round by itself, as noise comes and goes: median, lowest, highest."""
    if not slower or len(slower) != len(faster):
        raise ValueError("ratios need the same rounds of both")
    each = [a / b for a, b in zip(slower, faster)]
    return median(each), min(each), max(each)


def row(name, particle_steps, ours, theirs, peer_name, bytes_per_particle, peer_bytes):
    """A row of the result; `ours` and `theirs` are seconds for so many particle-steps, round by round."""
    ratio, lowest, highest = ratios(theirs, ours)
    return {"name": name, "pulvis": particle_steps / median(ours), "peer": particle_steps / median(theirs),
            "peer_name": peer_name, "ratio": ratio, "ratio_lowest": lowest, "ratio_highest": highest,
            "rounds": len(ours), "bytes_per_particle": round(bytes_per_particle),
            "peer_bytes_per_particle": round(peer_bytes)}


def figure(name, value):
    return {"name": name, "value": value, "target": TARGETS[name][1]}


def meets(name, value):
    """Whether the target is kept; None: not measured."""
    sense, target = TARGETS[name]
    return None if value is None else value >= target if sense == ">=" else value <= target


def verdict(name, value):
    sense, target = TARGETS[name]
    return f"{sense} {target:g}: " + {True: "met", False: "MISSED", None: "not measured"}[meets(name, value)]


def show_row(r):
    return (f"{r['name']:<18} {r['pulvis'] / 1e6:>9.2f} {r['peer'] / 1e6:>9.2f} {r['ratio']:>7.2f} "
            f"{r['ratio_lowest']:>6.2f} to {r['ratio_highest']:<6.2f} {r['bytes_per_particle']:>7} "
            f"{r['peer_bytes_per_particle']:>7}  {verdict(r['name'], r['ratio'])}")


ROW_HEADER = (f"{'':<18} {'pulvis':>9} {'peer':>9} {'ratio':>7} {'lowest to highest':>16} {'bytes per particle':>15}\n"
              f"{'':<18} {'M/s':>9} {'M/s':>9} {'':>7} {'':>16} {'pulvis':>7} {'peer':>7}")


def show_figure(f):
    value = "-" if f["value"] is None else f"{f['value']:.4g}"
    return f"{f['name']:<42} {value:>8}  {verdict(f['name'], f['value'])}"
