#!/usr/bin/env python3
"""Finds constants whose unit is not spelled as in other names: kNearM for kNear_m. Exit 1 if there is one.

    constants.py ROOT
"""
import pathlib
import re
import sys

ROOMS = ["controller", "examples", "models", "render", "sim", "tests"]
DEFINED = re.compile(r"\bconst(?:expr)?\b[^;(]*?\b(k[A-Z]\w*[a-z](?:M|Px|Rad|Deg|N|S|Ms|Nm|Hz|Pa|Kg|MPerS2?|RadPerS2?|NPerM))"
                     r"\s*(?:=|\{|\[)")


def misspelled(root):
    """(place, name) of each such constant."""
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            if path.suffix not in (".h", ".cc"):
                continue
            text = path.read_text(encoding="utf-8")
            for found in DEFINED.finditer(text):
                if found[1] != "kNaN":
                    line = text.count("\n", 0, found.start(1)) + 1
                    yield f"{path.relative_to(root)}:{line}", found[1]


faults = list(misspelled(pathlib.Path(sys.argv[1])))
for place, name in faults:
    print(f"{place}: {name}: expected the unit after an underscore, as in kNear_m")
sys.exit(1 if faults else 0)
