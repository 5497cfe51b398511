# SPDX-License-Identifier: Apache-2.0
"""Where things are, and what must be there first."""
import os
import shutil
import subprocess

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
INPUTS = os.path.join(ROOT, "bench", "peer_inputs")
CACHE = os.path.join(ROOT, "build", "peers")
BUILD = os.path.join(ROOT, "build", "release")
PROGRAMS = {"liggghts": "liggghts", "lammps": "lmp"}  # package: program


def install_peers():
    """Installs what is missing of the peers; raises RuntimeError where that cannot be done."""
    def missing():
        return [package for package, program in PROGRAMS.items() if not shutil.which(program)]

    if not missing():
        return
    subprocess.run([os.path.join(ROOT, "tools", "setup"), *missing()], check=False)  # says itself what goes wrong
    if missing():
        raise RuntimeError(f"not installed: {', '.join(missing())}. Needed are LIGGGHTS 3.8.0 (program liggghts) and LAMMPS "
                           "20220106 (program lmp) with its package GRANULAR")


def build_pulvis():
    """What is needed of pulvis, in preset release."""
    os.makedirs(CACHE, exist_ok=True)
    log = os.path.join(CACHE, "build.log")
    with open(log, "w", encoding="utf-8") as said:
        for command in (["cmake", "--preset", "release"],
                        ["cmake", "--build", "--preset", "release", "--target", "peer_bed", "peer_contact", "pulvis"]):
            if subprocess.run(command, cwd=ROOT, stdout=said, stderr=said, check=False).returncode != 0:
                raise RuntimeError(f"{' '.join(command)} failed; see {log}")


def program(name):
    return os.path.join(BUILD, "bench", name)


def version_of(package):
    """The version of a Debian package, or "?" where there is none."""
    said = subprocess.run(["dpkg-query", "--show", "--showformat=${Version}", package], capture_output=True, text=True,
                          check=False) if shutil.which("dpkg-query") else None
    return said.stdout if said and said.returncode == 0 else "?"
