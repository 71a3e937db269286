"""Values that pages state of their commands' results: what is found, compared and put right.

    python3 stated_values_test.py SOURCE
"""

import json
import os
import sys
import tempfile
import unittest

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(sys.argv.pop(), "scripts"))
import stated_values  # noqa: E402

OUTCOME = {"tip_depth_m": 0.2301781625982762, "sim_time_s": 99.52, "docked": True, "outcome": "docked", "pairs": [{"at": 3}, 5]}


class Folder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.file = os.path.join(self.folder.name, "outcome.json")
        with open(self.file, "w", encoding="utf-8") as file:
            json.dump(OUTCOME, file)

    def tearDown(self):
        self.folder.cleanup()

    def true(self, stated, key):
        (item,) = stated_values.items(f"so {stated}<!-- = {self.file} {key} --> is it")
        self.assertEqual(item.text, stated)
        return stated_values.true_text(item, "")

    def test_numbers_are_compared_as_they_are_printed(self):
        for right in ("0.2302", "0.230", "0.2", "0"):
            self.assertEqual(self.true(right, "tip_depth_m"), right)
        for wrong, true in (("0.229", "0.230"), ("0.2303", "0.2302"), ("-0.230", "0.230"), ("1", "0")):
            self.assertEqual(self.true(wrong, "tip_depth_m"), true)
        self.assertEqual(self.true("122.2", "sim_time_s"), "99.5")

    def test_words_and_counts(self):
        self.assertEqual(self.true("`false_docked`", "outcome"), "`docked`")
        self.assertEqual(self.true("no", "docked"), "true")
        self.assertEqual(self.true("eight", "pairs.count()"), "two")
        self.assertEqual(self.true("Six", "pairs.count()"), "Two")
        self.assertEqual(self.true("7", "pairs.0.at"), "3")
        self.assertEqual(self.true("twelve", "sim_time_s"), "99.52")

    def test_a_source_that_is_not_there_is_said(self):
        for key in ("tip", "pairs.9", "pairs.0.at.deeper"):
            with self.assertRaisesRegex(ValueError, "outcome.json"):
                self.true("1", key)
        with self.assertRaisesRegex(ValueError, "expected a number"):
            self.true("1", "outcome")
        with self.assertRaisesRegex(ValueError, "right before"):
            stated_values.items("0.23 <!-- = a.json b -->")

    def test_a_source_may_be_what_was_printed(self):
        (item,) = stated_values.items('46<!-- = output "axel: {} kg" --> kg')
        self.assertEqual(stated_values.true_text(item, "rover:  axel:\n  46 kg, arm 1 m\n"), "46")
        with self.assertRaisesRegex(ValueError, "not printed"):
            stated_values.true_text(item, "rover: axel: heavy\n")
        (item,) = stated_values.items('7<!-- = output "^exit code {}" -->')
        self.assertEqual(stated_values.true_text(item, "it had exit code 1\nexit code 4\n"), "4")
        (item,) = stated_values.items('nine<!-- = lines "left * detected" -->')
        self.assertEqual(stated_values.true_text(item, "left 0 detected\nleft 1 lost\nleft 2  detected\n"), "two")


class Printed(unittest.TestCase):
    def true(self, lines, output):
        page = f"```sh\na command\n```\n\n```text\n{lines}\n```\n"
        return stated_values.true_text(stated_values.items(page)[1], output)

    def test_lines_are_those_that_were_printed_in_order(self):
        self.assertEqual(self.true("two 2\nfour 4", "one\ntwo 2\nthree\nfour 4\n"), "two 2\nfour 4\n")
        for lines in ("two 2\none", "five"):
            with self.assertRaisesRegex(ValueError, "not printed"):
                self.true(lines, "one\ntwo 2\n")

    def test_other_numbers_are_put_right(self):
        self.assertEqual(self.true("a.urdf:160:3: a joint ...", "a.urdf:172:3: a joint of m\n"), "a.urdf:172:3: a joint ...\n")

    def test_a_block_behind_prose_is_none_of_it(self):
        self.assertEqual(len(stated_values.items("```sh\na\n```\n\nThe rooms:\n\n```text\nb\n```\n")), 1)


unittest.main()
