#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Gives tools/instruction-count a valgrind that writes canned dumps, and looks at what it makes of them.

usage: instruction_count_test.py PATH_OF_INSTRUCTION_COUNT
"""
import os
import subprocess
import sys
import tempfile
import unittest

# 100 + 40 of the program; not: 7 of a library, and what the lines after `calls=` say of callees.
DUMP = """# callgrind format
version: 1
pid: 1
cmd: counted_steps
part: 1
desc: Trigger: --dump-after=counted_{work}
positions: line
events: Ir

ob=(1) {folder}/bench/counted_steps
fl=(1) steps.cpp
fn=(1) counted_{work}
12 {count}
cob=(2) /usr/lib/libc.so.6
cfn=(2) memmove
calls=3 0
12 7

ob=(2)
fn=(2)
0 7

ob=(1)
fn=(3) pulvis::sum
+3 40
calls=1 5
* 1000

totals: 147
"""
LAST = "version: 1\npart: 3\ndesc: Trigger: Program termination\nevents: Ir\n\ntotals: 0\n"
BUILD = "GNU-12.2.0 RelWithDebInfo-assertions"
COUNTS = f"# why\n{BUILD} one 140\n{BUILD} two 240\nGNU-99 Release one 5\n"


class InstructionCount(unittest.TestCase):
    def setUp(self):
        holder = tempfile.TemporaryDirectory()
        self.addCleanup(holder.cleanup)
        self.folder = holder.name
        self.counts = os.path.join(self.folder, "counts.txt")
        self.about("one two")
        self.dumps({"one": 100, "two": 200})

    def program(self, name, text):
        path = os.path.join(self.folder, name)
        os.makedirs(os.path.dirname(path), exist_ok=True)
        with open(path, "w", encoding="utf-8") as file:
            file.write(f"#!/bin/sh\n{text}\n")
        os.chmod(path, 0o755)

    def about(self, works):
        self.program("bench/counted_steps", f"echo '{BUILD}'; echo '{works}'")

    def dumps(self, works):
        """What the false valgrind leaves."""
        texts = [DUMP.format(work=work, count=count, folder=self.folder) for work, count in works.items()] + [LAST]
        script = ['for word in "$@"; do case $word in --callgrind-out-file=*) out=${word#*=};; esac; done']
        for number, text in enumerate(texts, start=1):
            script.append(f"cat >$out.{number} <<'END'\n{text}END")
        self.program("bin/valgrind", "\n".join(script))

    def call(self, *options, counts=COUNTS, path=None):
        if counts is not None:
            with open(self.counts, "w", encoding="utf-8") as file:
                file.write(counts)
        path = path or f"{self.folder}/bin:{os.environ['PATH']}"
        run = subprocess.run([sys.executable, TOOL, "--build", self.folder, "--counts", self.counts, *options],
                             env={**os.environ, "PATH": path}, capture_output=True, text=True, check=False)
        return run.returncode, run.stdout + run.stderr

    def test_passes_where_counts_are_those_stored(self):
        status, said = self.call()
        self.assertEqual(status, 0, said)
        self.assertIn("140 instructions", said)
        self.assertIn("+0.00 %", said)

    def test_lets_five_per_cent_more_pass_and_no_more(self):
        self.assertEqual(self.call(counts=COUNTS.replace("240", "229"))[0], 0)
        status, said = self.call(counts=COUNTS.replace("240", "228"))
        self.assertEqual(status, 1, said)
        self.assertIn("two needs 5.3 % more instructions than is stored", said)
        self.assertNotIn("one needs", said)

    def test_asks_to_renew_what_got_better(self):
        status, said = self.call(counts=COUNTS.replace("240", "300"))
        self.assertEqual(status, 0, said)
        self.assertIn("needs less than is stored", said)

    def test_fails_if_a_piece_of_work_is_new_or_gone(self):
        for counts, words in ((COUNTS.replace(f"{BUILD} two 240\n", ""), "two is new"),
                              (COUNTS + f"{BUILD} three 1\n", "three is not counted any more")):
            status, said = self.call(counts=counts)
            self.assertEqual(status, 1, said)
            self.assertIn(words, said)

    def test_skips_another_compiler_or_other_options(self):
        status, said = self.call(counts=COUNTS.replace(BUILD, "GNU-13 Release"))
        self.assertEqual(status, 77, said)
        self.assertIn(f"no counts for {BUILD}", said)

    def test_skips_without_valgrind(self):
        status, said = self.call(path="/nowhere")
        self.assertEqual(status, 77, said)
        self.assertIn("no valgrind", said)

    def test_says_why_it_cannot_count(self):
        self.program("bin/valgrind", "echo unknown instruction >&2; exit 3")
        status, said = self.call()
        self.assertEqual(status, 2, said)
        self.assertIn("unknown instruction", said)
        self.dumps({"one": 100})
        status, said = self.call()
        self.assertEqual(status, 2, said)
        self.assertIn("not all of one, two", said)
        os.remove(os.path.join(self.folder, "bench/counted_steps"))
        self.assertEqual(self.call()[0], 2)

    def test_renews_with_a_reason_and_leaves_other_compilers_alone(self):
        self.dumps({"one": 500, "two": 200})
        self.assertEqual(self.call()[0], 1)
        status, said = self.call("--renew", "a better law")
        self.assertEqual(status, 0, said)
        with open(self.counts, encoding="utf-8") as file:
            text = file.read()
        self.assertTrue(text.startswith("# why\n"), text)
        self.assertIn(f"{BUILD}: a better law\n", text)
        self.assertIn(f"{BUILD} one 540\n{BUILD} two 240\n", text)
        self.assertIn("GNU-99 Release one 5\n", text)
        self.assertEqual(self.call(counts=None)[0], 0)


if __name__ == "__main__":
    TOOL = os.path.abspath(sys.argv.pop(1))
    unittest.main()
