# SPDX-License-Identifier: Apache-2.0
"""The yardstick bed, made once with LIGGGHTS, and the codes on it."""
import os

from . import inputs
from .places import program
from .session import Session
from .summary import read_look

HEIGHT = 0.4  # m, of the column that spheres fall in
SETTLING = 2000  # steps that every code makes from the same bed before anything is measured
DT = "1e-5"  # s


class Size:
    """A bed: spheres on a square of some width, and how long they fall and settle (steps)."""

    def __init__(self, name, width, count, making, falling):
        self.name, self.width, self.count, self.making, self.falling = name, width, count, making, falling


FULL = Size("bed", 0.1, 60000, 40000, 20000)
SMALL = Size("small-bed", 0.025, 3750, 40000, 4000)


class Beds:
    """The bed of one size in its folder, and sessions of the codes on it."""

    def __init__(self, size, cache, cpu):
        self.size, self.cpu = size, str(cpu)
        self.folder = os.path.join(cache, size.name)
        os.makedirs(self.folder, exist_ok=True)

    def path(self, name):
        return os.path.join(self.folder, name)

    def there(self, name):
        return os.path.exists(self.path(name))

    def make(self):
        """fall: just inserted; bed: settled. Each as dump (for pulvis) and data file (for the peers)."""
        if self.there("bed.data"):
            return
        print(f"peers: making a bed of {self.size.count} spheres with LIGGGHTS, once (20 minutes for 60000)", flush=True)
        with self.session("liggghts") as session:
            session.send(*inputs.beginning("liggghts", "p"),
                         *inputs.set_variables(width=self.size.width, count=self.size.count),
                         "include ${inputs}/column.liggghts",
                         *inputs.laws("liggghts", "hertz", DT, inputs.POSITIONS), "include ${inputs}/fill.liggghts")
            self.dump(session, "fall.part")
            session.send(f"run {self.size.making}")
            self.dump(session, "bed.part")
            session.close()
        for name in ("fall", "bed"):  # the settled one last: it says that all is there
            self.keep(name)

    def keep(self, name):
        """Makes a dump that is whole by now the one that counts, and the data file of it."""
        os.replace(self.path(name + ".part"), self.path(name + ".dump"))
        with open(self.path(name + ".dump"), encoding="utf-8") as file:
            rows = sorted(inputs.last_frame(file.read()), key=lambda row: row["id"])

        def triple(row, names):
            return tuple(row[name] for name in names)

        inputs.data_file(self.path(name + ".data"), [(0, self.size.width)] * 2 + [(0, HEIGHT)],
                         [(int(row["id"]), row["radius"], triple(row, "xyz"), triple(row, ("vx", "vy", "vz")),
                           triple(row, ("omegax", "omegay", "omegaz"))) for row in rows])

    def session(self, code):
        session = Session(code, inputs.command(code), self.folder, self.cpu)
        session.send('print "peers: started"')
        session.wait("started")
        return session

    def dump(self, session, name):
        session.send(*inputs.set_variables(look=name), "include ${inputs}/look.peers", 'print "peers: done"')
        session.wait("done")

    def peer(self, code, law, skin, start):
        """A peer that has read `start` (NAME.data or NAME.restart); the memory it had before is in `empty`."""
        session = self.session(code)
        session.empty = session.memory()
        session.send(*inputs.beginning(code, "p"),
                     f"read_{'data' if start.endswith('.data') else 'restart'} {start}", f"neighbor {skin:g} bin",
                     *inputs.laws(code, law, DT, inputs.POSITIONS), f"include ${{inputs}}/floor.{code}",
                     "run 0", 'print "peers: done"')
        session.wait("done")
        session.go_on = lambda steps: session.send(f"run {steps} pre no post no", 'print "peers: done"')
        return session

    def pulvis(self, law, dump, threads=1, cpus=None, tiles=1):
        """pulvis on a dump; `empty` as with a peer."""
        command = [program("peer_bed"), law, self.path(dump), "--width", f"{self.size.width:g}", "--height",
                   f"{HEIGHT:g}", "--threads", str(threads), "--tiles", str(tiles)]
        session = Session("pulvis", command, self.folder, cpus or self.cpu, threads)
        session.wait("started")
        session.empty = session.memory()
        session.wait("ready")
        session.go_on = lambda steps: session.send(f"run {steps}")
        return session

    def settle_peer(self, code, law):
        """Lets a peer settle from the bed, once; leaves CODE-LAW.restart and CODE-LAW.dump."""
        name = f"{code}-{law}"
        if self.there(name + ".dump"):
            return
        print(f"peers: {code} settles with {law}, once", flush=True)
        with self.peer(code, law, 0.0005, "bed.data") as session:
            session.send(f"run {SETTLING}", f"write_restart {name}.restart")
            self.dump(session, name + ".part")
            session.close()
        os.replace(self.path(name + ".part"), self.path(name + ".dump"))

    def look(self, law, dump):
        """What pulvis says of a dump without a step: the same measure for every code."""
        with self.pulvis(law, dump) as session:
            session.send("look")
            said = read_look(session.wait("bed"))
            session.close()
        return said


def settled_pulvis(beds, law):
    """pulvis after the same settling, and what its bed is then."""
    session = beds.pulvis(law, "bed.dump")
    session.go_on(SETTLING)
    session.wait("done")
    session.send("look")
    return session, read_look(session.wait("bed"))
