#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""What bench/peers reads out of texts and makes of times, on texts and times that are known. Nothing is timed.

usage: peers_test.py FOLDER_BENCH
"""
import contextlib
import io
import os
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv.pop(1))
from peer_codes import contacts, inputs, sameness, session, summary  # noqa: E402

DUMP = """ITEM: TIMESTEP
0
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS pp pp ff
0 0.1
0 0.1
0 0.4
ITEM: ATOMS id type x radius
1 1 0.5 0.00125
2 1 0.25 0.00125
ITEM: TIMESTEP
10
ITEM: NUMBER OF ATOMS
2
ITEM: BOX BOUNDS pp pp ff
0 0.1
0 0.1
0 0.4
ITEM: ATOMS id type x radius
2 1 -1.5e-3 0.00125
1 1 0.75 0.00125
"""

BENCH = {"rows": [{"parcels": 10000, "time_over_smallest_bed": 1.0}, {"parcels": 1000000, "time_over_smallest_bed": 1.4}]}


class Texts(unittest.TestCase):
    def test_of_a_dump_the_last_frame_counts(self):
        self.assertEqual(inputs.last_frame(DUMP), [{"id": 2.0, "type": 1.0, "x": -0.0015, "radius": 0.00125},
                                                   {"id": 1.0, "type": 1.0, "x": 0.75, "radius": 0.00125}])

    def test_a_dump_that_was_cut_off_is_refused(self):
        with self.assertRaisesRegex(RuntimeError, "cut off"):
            inputs.last_frame(DUMP[:DUMP.rindex("0.75")])
        with self.assertRaisesRegex(RuntimeError, "without atoms"):
            inputs.last_frame("ERROR: lost atoms\n")

    def test_a_bed_is_read_by_names(self):
        self.assertEqual(summary.read_look("peers: bed parcels 60000 kinetic 1.5e-09 contacts 2.5"),
                         {"parcels": 60000.0, "kinetic": 1.5e-9, "contacts": 2.5})
        with self.assertRaisesRegex(RuntimeError, "not what peer_bed says"):
            summary.read_look("peers: done")

    def test_growth_is_that_of_the_largest_bed(self):
        self.assertEqual(summary.growth(BENCH), 1.4)
        with self.assertRaisesRegex(RuntimeError, "two sizes"):
            summary.growth({"rows": BENCH["rows"][:1]})

    def test_numbers_that_are_none_are_no_agreement(self):
        self.assertEqual(contacts.deviation([1.0, 0.0, float("nan")], [1.0, 0.0, 0.0]), float("inf"))
        self.assertEqual(contacts.deviation([1.0, 0.0, 0.0], [1.0, 0.0, 0.0]), 0.0)

    def test_spheres_are_written_to_the_last_digit(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "two.data")
            inputs.data_file(path, [(0, 0.1)] * 3, [(7, 0.00125, (0.1 / 3, 0.0, 0.2), (1e-17, 0.0, -0.5), (0.0, 0.0, 3.0))])
            with open(path, encoding="utf-8") as file:
                lines = file.read().splitlines()
        self.assertIn("1 atoms", lines)
        self.assertIn("7 1 0.0025 2500 0.03333333333333333 0.0 0.2", lines)
        self.assertIn("7 1e-17 0.0 -0.5 0.0 0.0 3.0", lines)


class Ratios(unittest.TestCase):
    def test_a_ratio_is_the_median_of_the_rounds_own(self):
        # The second round was disturbed, both codes alike: its ratio is as good as any.
        self.assertEqual(summary.ratios([10.0, 40.0, 12.0], [2.0, 8.0, 2.0]), (5.0, 5.0, 6.0))

    def test_rounds_that_are_not_pairs_are_refused(self):
        for slower, faster in (([1.0], [1.0, 2.0]), ([], [])):
            with self.assertRaises(ValueError):
                summary.ratios(slower, faster)

    def test_a_row_has_speeds_ratio_and_memory(self):
        row = summary.row("hertz/lammps", 1.2e7, [1.0, 2.0, 1.5], [6.0, 6.0, 6.0], "LAMMPS 1", 500.4, 900.6)
        self.assertEqual((row["pulvis"], row["peer"], row["ratio"]), (8e6, 2e6, 4.0))
        self.assertEqual((row["ratio_lowest"], row["ratio_highest"], row["rounds"]), (3.0, 6.0, 3))
        self.assertEqual((row["bytes_per_particle"], row["peer_bytes_per_particle"]), (500, 901))
        self.assertIn("4.00", summary.show_row(row))
        self.assertIn(">= 4: met", summary.show_row(row))

    def test_targets_are_at_least_or_at_most(self):
        self.assertTrue(summary.meets("hertz/liggghts", 5.0))
        self.assertFalse(summary.meets("hertz/liggghts", 4.99))
        self.assertTrue(summary.meets("bytes per particle", 600))
        self.assertFalse(summary.meets("bytes per particle", 601))
        self.assertIsNone(summary.meets("GiB at most for 10^7 particles", None))
        self.assertIn("MISSED", summary.show_figure(summary.figure("bytes per particle", 601)))
        self.assertIn("not measured", summary.show_figure(summary.figure("GiB at most for 10^7 particles", None)))


class Inputs(unittest.TestCase):
    def test_a_restitution_of_one_half_is_told_to_lammps_as_its_polynomial_wants_it(self):
        self.assertAlmostEqual(inputs.lammps_restitution(0.5), 0.36665, places=5)
        self.assertAlmostEqual(inputs.tsuji(inputs.lammps_restitution(0.8)), inputs.dashpot(0.8), places=12)
        self.assertAlmostEqual(inputs.tangential_damping(0.3), 0.9075, places=4)


class Sameness(unittest.TestCase):
    def test_a_force_is_compared_as_a_vector_and_a_zero_only_with_zero(self):
        self.assertEqual(contacts.deviation([3.0, 4.0, 0.0, 0.0, 0.0, 0.0], [3.0, 4.0, 0.0, 0.0, 0.0, 0.0]), 0.0)
        self.assertAlmostEqual(contacts.deviation([3.0, 4.5, 0.0], [3.0, 4.0, 0.0]), 0.1)
        self.assertGreater(contacts.deviation([1.0, 0.0, 0.0, 1e-9, 0.0, 0.0], [1.0, 0.0, 0.0, 0.0, 0.0, 0.0]), 1.0)

    def test_one_limit_that_is_not_kept_spoils_it_and_none_is_no_limit(self):
        for rows, same in (([("a", 1e-7, 1e-6), ("b", 0.1, None)], True), ([("a", 1e-7, 1e-6), ("b", 2e-6, 1e-6)], False),
                           ([("a", float("nan"), 1e-6)], False)):
            said = io.StringIO()
            with contextlib.redirect_stdout(said):
                self.assertEqual(sameness.show(rows), same)
            self.assertEqual("NOT THE SAME" in said.getvalue(), not same)


CODE = "import sys\nprint('hello')\nfor line in sys.stdin:\n    print('peers:', line.strip(), flush=True)\n"


class Sessions(unittest.TestCase):
    def start(self, code):
        return session.Session("code", [sys.executable, "-u", "-c", code], ".", str(max(os.sched_getaffinity(0))))

    def test_a_code_answers_when_it_is_done(self):
        with self.start(CODE) as code:
            code.send("done 1", "done 2")
            self.assertEqual(code.wait("done 2"), "peers: done 2")
            self.assertGreater(code.processor_seconds(), 0.0)
            self.assertGreater(code.memory(), 0)
            code.close()

    def test_a_code_that_ends_too_soon_is_named_with_what_it_said(self):
        with self.start("import sys; print('ERROR: lost atoms'); sys.exit(3)") as code:
            with self.assertRaisesRegex(RuntimeError, "code ended with status 3:\nERROR: lost atoms"):
                code.wait("done")


if __name__ == "__main__":
    unittest.main()
