#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Shows tools/check-layers small trees, sound and faulty, and looks at what it says.

usage: check_layers_test.py PATH_OF_CHECK_LAYERS
"""
import os
import subprocess
import sys
import tempfile
import unittest

SOUND = {
    "CMakeLists.txt": "function(pulvis_room name)\nendfunction()\n",
    "engine/CMakeLists.txt": "# pulvis_room(engine/ghost MAY_INCLUDE case)\n"
                             "pulvis_room(engine/base)\n"
                             "pulvis_room(engine/math)\n"
                             "pulvis_room(engine/laws SOURCES laws/a.cpp\n  MAY_INCLUDE engine/math)\n",
    "engine/base/failure.hpp": "#include <string>\n",
    "engine/math/scalar.hpp": "#include <cstdint>\n",
    "engine/laws/a.cpp": '#include "engine/laws/deep/b.hpp"\n#include <cmath>\n',
    "engine/laws/deep/b.hpp": '#include "engine/math/scalar.hpp"\n',
    "case/CMakeLists.txt": "pulvis_room(case SOURCES read.cpp MAY_INCLUDE engine/base LIBRARIES toml)\n",
    "case/read.cpp": '#include "engine/base/failure.hpp"\n#include "other/library.h"\n',
    "tests/any_test.cpp": '#include "case/read.cpp"\n',
    "build/copy.cpp": '#include "nowhere"\n',
}


def check(changes):
    """Runs the tool on the sound tree with changes; returns its exit status and what it said."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in {**SOUND, **changes}.items():
            full = os.path.join(root, path)
            os.makedirs(os.path.dirname(full), exist_ok=True)
            with open(full, "w", encoding="utf-8") as file:
                file.write(text)
        run = subprocess.run([sys.executable, TOOL, root], capture_output=True, text=True, check=False)
        return run.returncode, run.stdout + run.stderr


class CheckLayers(unittest.TestCase):
    def expect_fault(self, changes, words):
        status, said = check(changes)
        self.assertIn(words, said)
        self.assertEqual(status, 1, said)
        self.assertIn("check-layers: 1 fault(s)", said)

    def test_accepts_a_sound_tree(self):
        status, said = check({})
        self.assertEqual(status, 0, said)
        self.assertIn("4 rooms", said)

    def test_finds_an_include_that_is_not_listed(self):
        self.expect_fault(
            {"case/more.hpp": '#pragma once\n#include "engine/math/scalar.hpp"\n'},
            "case/more.hpp:2: room case may not include room engine/math (its CMakeLists lists: engine/base)")

    def test_finds_a_listed_room_that_is_never_included(self):
        self.expect_fault({"case/read.cpp": "\n"},
                          "case/CMakeLists.txt:1: room case lists engine/base, but includes nothing from it")

    def test_finds_a_listed_room_that_does_not_exist(self):
        self.expect_fault({"case/CMakeLists.txt": "pulvis_room(case MAY_INCLUDE engine/base engine/bse)\n"},
                          "room case lists engine/bse, which is not a room")

    def test_finds_a_cycle(self):
        self.expect_fault(
            {"engine/CMakeLists.txt": SOUND["engine/CMakeLists.txt"].replace(
                "pulvis_room(engine/math)", "pulvis_room(engine/math MAY_INCLUDE engine/laws)"),
             "engine/math/scalar.hpp": '#include "engine/laws/deep/b.hpp"\n'},
            "engine/laws -> engine/math -> engine/laws")

    def test_keeps_the_engine_ignorant_of_cases(self):
        self.expect_fault({"engine/base/more.cpp": '#include "case/read.cpp"\n'},
                          "engine/base/more.cpp:1: the engine knows nothing of case/")

    def test_keeps_laws_to_mathematics(self):
        words = "engine/laws includes only engine/math and standard headers"
        self.expect_fault({"engine/laws/more.cpp": "#include <omp.h>\n"}, words)
        self.expect_fault({"engine/laws/more.cpp": '#include "engine/base/failure.hpp"\n'}, words)

    def test_finds_a_file_in_no_room(self):
        self.expect_fault({"engine/lost/file.hpp": "\n"}, "engine/lost/file.hpp: belongs to no room")

    def test_finds_an_include_not_written_from_the_root(self):
        self.expect_fault({"case/more.cpp": '#include "read.cpp"\n'}, "written from the root")


if __name__ == "__main__":
    TOOL = os.path.abspath(sys.argv.pop(1))
    unittest.main()
