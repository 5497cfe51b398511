# SPDX-License-Identifier: Apache-2.0
"""Whether the codes compute the same thing: rows of what was compared, deviation and limit (None: shown only)."""
from . import contacts as pairs

# Of beds after the same settling from the same places, springs forgotten: relative. Places moved by a nanometre at
# random change the energy by a hundred-thousandth. LIGGGHTS has the same law, but not our correction of dashpots for
# the step, nor the normal in its middle; LAMMPS also has another rolling spring and another lever of spins.
LIMITS = {"liggghts": {"kinetic": 0.02, "height": 0.0001, "contacts": 0.002},
          "lammps": {"kinetic": 0.10, "height": 0.001, "contacts": 0.005}}


def contacts(folder):
    hertz = pairs.NORMAL + pairs.SLIDING
    rows = []
    for code, law, which in (("liggghts", "hertz", hertz + pairs.ROLLING), ("liggghts", "sjkr", pairs.NORMAL),
                             ("lammps", "hertz", hertz), ("lammps", "jkr", hertz)):
        rows += pairs.compare(code, law, which, folder)
    # LAMMPS lets a spin move the contact with the whole radius, and its rolling spring has one stiffness.
    return rows + pairs.compare("lammps", "hertz", pairs.ROLLING, folder, limit=None)


def beds(of, looks, peers):
    """`looks`: what pulvis' settled bed is, by law."""
    rows = []
    for law, codes in peers.items():
        for code in codes:
            theirs = of.look(law, f"{code}-{law}.dump")
            if theirs["parcels"] != looks[law]["parcels"]:
                raise RuntimeError(f"{code} lost spheres: {theirs['parcels']:.0f} of {looks[law]['parcels']:.0f}")
            rows += [(f"{law}, {code}: {what} of the bed, {looks[law][what]:.5g} and {theirs[what]:.5g}",
                      abs(looks[law][what] / theirs[what] - 1.0), limit) for what, limit in LIMITS[code].items()]
    return rows


def show(rows):
    """Prints them; whether all limits are kept."""
    for what, deviation, limit in rows:
        judged = "differs by definition" if limit is None else f"limit {limit:g}"
        print(f"{what:<70} {deviation:>8.1e}  {judged}{'' if kept(deviation, limit) else ': NOT THE SAME'}")
    return all(kept(deviation, limit) for _, deviation, limit in rows)


def kept(deviation, limit):
    return limit is None or deviation <= limit
