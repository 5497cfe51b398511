# SPDX-License-Identifier: Apache-2.0
"""Whether the codes compute the same contact: two spheres that are held, at given velocities, for some steps."""
import math
import os
import subprocess

from . import inputs
from .places import program
from .session import Session

LIMIT = 1e-6  # of the force
DT = 1e-9  # s: short, as pulvis sees the velocities of the middle of a step, and its dashpots know of dt
REST = (0.0, 0.0, 0.0)


class Contact:
    """The first sphere lies at smaller x and has the velocity."""

    def __init__(self, says, overlap, velocity, spins=(REST, REST), steps=1, radii=(0.00125, 0.0015)):
        self.says, self.overlap, self.velocity, self.spins, self.steps, self.radii = (
            says, overlap, velocity, spins, steps, radii)

    def question(self, law):
        numbers = (*self.radii, self.overlap, *self.velocity, *self.spins[0], *self.spins[1], DT)
        return f"{law} {' '.join(f'{n:.17g}' for n in numbers)} {self.steps}\n"

    def spheres(self):
        middle = 0.05
        distance = sum(self.radii) - self.overlap
        return [(1, self.radii[0], (middle, middle, middle), self.velocity, self.spins[0]),
                (2, self.radii[1], (middle + distance, middle, middle), REST, self.spins[1])]


NORMAL = [Contact("pressed at rest", 1e-5, REST),
          Contact("closing", 1e-5, (0.1, 0, 0)),
          Contact("opening", 2e-5, (-0.02, 0, 0)),
          Contact("barely touching", 1e-8, (0.001, 0, 0), radii=(0.00125, 0.00125))]
SLIDING = [Contact("sticking", 1e-5, (0, 0.002, 0.001), steps=1000),
           Contact("sliding", 1e-5, (0, 2.0, 1.0), steps=5000),
           Contact("closing and sliding", 1e-5, (0.05, 0, -2.0), steps=5000)]
ROLLING = [Contact("sticking and turning", 1e-5, (0, 0.002, 0.001), ((0, 1.0, -0.5), (0, 0.3, 0.2)), 1000),
           Contact("rolling beyond the limit", 1e-5, REST, ((0, 300.0, 100.0), (0, -240.0, -80.0)), 2000)]


def of_pulvis(law, contacts):
    """Forces and torques as peer_contact prints them, a list of nine numbers for each contact."""
    said = subprocess.run([program("peer_contact")], input="".join(c.question(law) for c in contacts),
                          capture_output=True, text=True, check=True)
    return [list(map(float, line.split())) for line in said.stdout.splitlines()]


def of_peer(code, law, contact, folder):
    """The same nine numbers."""
    data, look = os.path.join(folder, "contact.data"), os.path.join(folder, "contact.dump")
    inputs.data_file(data, [(0.0, 0.1)] * 3, contact.spheres())
    if os.path.exists(look):
        os.remove(look)
    with Session(code, inputs.command(code), folder, str(max(os.sched_getaffinity(0)))) as session:
        session.send(*inputs.beginning(code, "f"), "read_data contact.data",
                     *inputs.laws(code, law, f"{DT:g}", inputs.FORCES),
                     *inputs.set_variables(steps=contact.steps, look="contact.dump"),
                     "include ${inputs}/contact.peers", 'print "peers: done"')
        session.wait("done")
        session.close()
    with open(look, encoding="utf-8") as file:
        first, second = sorted(inputs.last_frame(file.read()), key=lambda row: row["id"])
    return [first[n] for n in ("fx", "fy", "fz", "tqx", "tqy", "tqz")] + [second[n] for n in ("tqx", "tqy", "tqz")]


def deviation(ours, theirs):
    """Largest difference of vectors, each over its own length; infinite if a number is none."""
    if not all(map(math.isfinite, [*ours, *theirs])):
        return math.inf
    worst = 0.0
    for at in range(0, len(ours), 3):
        scale = math.hypot(*theirs[at:at + 3])
        difference = math.dist(ours[at:at + 3], theirs[at:at + 3])
        worst = max(worst, difference / scale if scale > 0.0 else (math.inf if difference > 0.0 else 0.0))
    return worst


def compare(code, law, contacts, folder, limit=LIMIT):
    """Rows (what, deviation of force and torques, limit)."""
    return [(f"{law}, {code}: {contact.says}", deviation(ours, of_peer(code, law, contact, folder)), limit)
            for contact, ours in zip(contacts, of_pulvis(law, contacts), strict=True)]
