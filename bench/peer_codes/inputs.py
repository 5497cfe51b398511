# SPDX-License-Identifier: Apache-2.0
"""What the peers are told: their input files lie in bench/peer_inputs, the values of the variables in them here."""
import math
import os

from .places import INPUTS, PROGRAMS

# Radius (m), Young's modulus (Pa), Poisson's ratio, restitution: as in scenes::Stuff of validation/scene.hpp.
MODULUS, POISSON, RESTITUTION = 5e6, 0.3, 0.5
SURFACE_ENERGY = 0.05  # J/m^2 of one surface, as LAMMPS has it
MORE = {"hertz": "rolling_friction epsd2", "sjkr": "cohesion sjkr rolling_friction epsd2"}  # LIGGGHTS
POSITIONS, FORCES = 10, 6  # how many real numbers stand behind the ids in a dump


def tsuji(restitution):
    """LAMMPS's polynomial for `damping tsuji`: the dashpot over sqrt(m* k_n), k_n the secant stiffness."""
    e, value = restitution, 0.0
    for coefficient in (4.8218, -18.022, 27.467, -22.348, 11.087, -4.2783, 1.2728):
        value = value * e + coefficient
    return value


def dashpot(restitution):
    """The same where a Hertz contact really shows that restitution: sqrt(5) |beta| (docs/laws.md, damping)."""
    logarithm = math.log(restitution)
    return math.sqrt(5.0) * -logarithm / math.hypot(logarithm, math.pi)


def lammps_restitution(wanted):
    """What LAMMPS must be told so that its dashpot gives the restitution that is wanted (0.5: 0.36665)."""
    low, high = 0.0, 1.0
    for _ in range(60):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if tsuji(middle) > dashpot(wanted) else (low, middle)
    return low


def tangential_damping(poisson):
    """Tangential over normal dashpot where both follow from their stiffnesses: sqrt(4 G*/E*), 0.9075 for 0.3."""
    return math.sqrt(2.0 * (1.0 - poisson) / (2.0 - poisson))


def lammps_normal(law):
    numbers = f"{MODULUS:g} {lammps_restitution(RESTITUTION):.12g} {POISSON:g}"
    return f"hertz/material {numbers}" if law == "hertz" else f"jkr {numbers} {SURFACE_ENERGY:g}"


def set_variables(**values):
    return [f'variable {name} string "{value}"' for name, value in values.items()]


def beginning(code, ends):
    """Input up to where the spheres are read; `ends` of the box along x and y: p periodic, f open."""
    return [*set_variables(inputs=INPUTS, ends=ends), f"include ${{inputs}}/head.{code}"]


def laws(code, law, dt, real_numbers):
    """The law, and how numbers are written into dumps of so many columns behind the ids."""
    whole = "%d %d" if real_numbers == POSITIONS else "%d"
    if code == "liggghts":
        lines = set_variables(more=MORE[law], dt=dt, numbers=f"format '{whole}" + " %.15g" * real_numbers + "'")
    else:
        lines = set_variables(normal=lammps_normal(law), floor=lammps_normal("hertz"), dt=dt,
                              damping=f"{tangential_damping(POISSON):.12g}", numbers="format float %.15g")
    return [*lines, f"include ${{inputs}}/law.{code}"]


def command(code):
    return [PROGRAMS[code], "-log", "none"]


def data_file(path, box, spheres):
    """Writes spheres (id, radius, position, velocity, spin) for read_data, at which both peers look alike."""
    with open(path + ".part", "w", encoding="utf-8") as file:
        file.write(f"spheres for bench/peers\n\n{len(spheres)} atoms\n1 atom types\n")
        for name, (low, high) in zip("xyz", box):
            file.write(f"{low:g} {high:g} {name}lo {name}hi\n")
        file.write("\nAtoms\n\n")
        for number, radius, position, _, _ in spheres:
            file.write(f"{number} 1 {2 * radius!r} 2500 " + " ".join(map(repr, position)) + "\n")
        file.write("\nVelocities\n\n")
        for number, _, _, velocity, spin in spheres:
            file.write(f"{number} " + " ".join(map(repr, (*velocity, *spin))) + "\n")
    os.replace(path + ".part", path)


def last_frame(text):
    """The last frame of a dump: rows as dictionaries from the names of the columns to numbers."""
    frame = text.rsplit("ITEM: ATOMS ", 1)
    if len(frame) != 2:
        raise RuntimeError("a dump without atoms")
    header, *lines = frame[1].splitlines()
    names = header.split()
    rows = [dict(zip(names, map(float, line.split()))) for line in lines if line]
    if any(len(row) != len(names) for row in rows):
        raise RuntimeError("a dump that was cut off")
    return rows
