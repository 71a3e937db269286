"""Holds docs/reference/nominal.md against the nominal parameters that programs get.

Usage: nominal_check.py PROGRAM SOURCE FOLDER. Starts a program as the controller of a run of each
system and compares the keys of its hello with the page's tables, in both directions.
"""

import json
import os
import re
import subprocess
import sys

PROGRAM, SOURCE, FOLDER = sys.argv[1:4]
SCENARIOS = {
    "axel": ["axel_typical.yaml"],
    "raposa": ["raposa_point_9.yaml"],
    "rocky7": ["rocky7_grasp.yaml"],
    "custom": ["../examples/docks/charger/scenario.yaml"],
}
CONTROLLER = """import json, os, struct
def read(n):
    data = b""
    while len(data) < n:
        data += os.read(0, n - len(data))
    return data
size, kind = struct.unpack("<IB", read(5))
open(OUT, "wb").write(read(size))
"""


def nominal_of(system, scenario):
    out = os.path.join(FOLDER, system + ".json")
    with open(os.path.join(FOLDER, "tell.py"), "w") as file:
        file.write(f"OUT = {out!r}\n" + CONTROLLER)
    command = f"controller={{command: [python3, tell.py], folder: {FOLDER}}}"
    subprocess.run(
        [PROGRAM, "run", os.path.join(SOURCE, "scenarios", scenario), "--allow-commands"]
        + ["--set", command, "--out", os.path.join(FOLDER, system)],
        capture_output=True,
    )
    return json.load(open(out))["nominal"]


def tables():
    """The rows of each section: key, type and meaning."""
    found, section = {}, None
    for line in open(os.path.join(SOURCE, "docs/reference/nominal.md"), encoding="utf-8"):
        if line.startswith("## "):
            section = found.setdefault(line[3:].strip(), [])
        elif section is not None and line.startswith("| `"):
            section.append([cell.strip() for cell in line.strip().strip("|").split("|")])
    return found


def flat(value, path, types, parts, sent):
    """Notes the paths of a value; parts are checked against their own table."""
    kind = types.get(path)
    if kind in parts:
        for key in value:
            if key not in parts[kind]:
                sent.add(path + "." + key)
        sent.add(path)
    elif isinstance(value, dict) and path not in types:
        for key, each in value.items():
            flat(each, path + "." + key if path else key, types, parts, sent)
    elif isinstance(value, list) and path not in types and value:
        for each in value:
            flat(each, path + "[]", types, parts, sent)
    else:
        sent.add(path)


def main():
    rows, faults = tables(), []
    parts = {}
    for part, keys, _ in rows.pop("Parts"):
        parts.setdefault(part.strip("`"), set()).update(re.findall(r"`(\w+)`", keys))
    if set(rows) != set(SCENARIOS):
        faults.append(f"sections {sorted(rows)}")
    for system, scenarios in SCENARIOS.items():
        types = {row[0].strip("`"): row[1] for row in rows[system]}
        needed = {row[0].strip("`") for row in rows[system] if not row[2].startswith("only")}
        sent = set()
        for scenario in scenarios:
            flat(nominal_of(system, scenario), "", types, parts, sent)
        optional_empty = {path for path in sent if any(key.startswith(path + "[]") for key in types)}
        for path in sorted(sent - set(types) - optional_empty):
            faults.append(f"{system}: {path} is sent and not documented")
        for path in sorted(needed - sent):
            faults.append(f"{system}: {path} is documented and not sent")
    print("\n".join(faults))
    sys.exit(1 if faults else 0)


main()
