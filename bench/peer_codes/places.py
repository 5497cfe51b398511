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
    missing = [package for package, program in PROGRAMS.items() if not shutil.which(program)]
    if not missing:
        return
    by_hand = f"apt-get update && apt-get install --no-install-recommends {' '.join(missing)}"
    if not shutil.which("apt-get"):
        raise RuntimeError(f"not installed: {', '.join(missing)}. This is no Debian system: install LIGGGHTS 3.8.0 "
                           "(program liggghts) and LAMMPS 20220106 (program lmp) with its package GRANULAR")
    as_root = [] if os.geteuid() == 0 else ["sudo"]
    if as_root and not shutil.which("sudo"):
        raise RuntimeError(f"these packages are missing and need root (there is no sudo here). As root, run:\n  {by_hand}")
    print(f"peers: installing {' '.join(missing)}", flush=True)
    quiet = {**os.environ, "DEBIAN_FRONTEND": "noninteractive"}
    subprocess.run([*as_root, "apt-get", "update", "-qq"], env=quiet, check=False)
    install = [*as_root, "apt-get", "install", "-y", "-qq", "--no-install-recommends", *missing]
    if subprocess.run(install, env=quiet, stdout=subprocess.DEVNULL, check=False).returncode != 0:
        raise RuntimeError(f"apt-get could not install {' '.join(missing)}: is there a network, and is this Debian 12?\n"
                           f"  {by_hand}")


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
