#!/usr/bin/env python3
"""Finds units that include each other in a circle. Exit 1 if there is one. A unit is a header with the .cc file of
its name, with each .cc file without a header that defines members of a class of this one, and with NAME_impl.h.

    circles.py ROOT
"""
import pathlib
import re
import sys

ROOMS = ["controller", "models", "render", "sim", "tests"]
INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]+"([^"]+)"', re.M)
CLASS = re.compile(r"^(?:class|struct)\s+(\w+)[^;]*?\{", re.M)
MEMBER = re.compile(r"^[A-Za-z][^\n;=({]*?\b(\w+)::(?:\w+::)?~?\w+\(", re.M)


def unit_of(path):
    return re.sub(r"(?:_impl)?[.]\w+$", "", path)


def read_units(root):
    """The units that each unit includes. A unit is its header's path without the ending."""
    includes, classes, members = {}, {}, {}
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            if path.suffix not in (".h", ".cc"):
                continue
            text, name = path.read_text(encoding="utf-8"), str(path.relative_to(root))
            found = [one if (root / one).is_file() else "tests/" + one for one in INCLUDE.findall(text)]
            includes[name] = [one for one in found if (root / one).is_file()]
            classes[name] = set(CLASS.findall(text))
            members[name] = set(MEMBER.findall(text))
    units = {}
    for path, named in includes.items():
        unit = unit_of(path)
        if path.endswith(".cc") and unit + ".h" not in includes:
            of = [one for one in named if members[path] & classes.get(one, set())]
            unit = unit_of(of[0]) if of else path
        units.setdefault(unit, set()).update(unit_of(one) for one in named)
    return {unit: sorted(named - {unit}) for unit, named in units.items()}


def circles(units):
    """The strongly connected components of more than one unit (Tarjan 1972), without recursion."""
    order, low, stack, found = {}, {}, [], []
    for start in sorted(units):
        if start in order:
            continue
        work = [(start, iter(units[start]))]
        order[start] = low[start] = len(order)
        stack.append(start)
        while work:
            unit, rest = work[-1]
            following = next(rest, None)
            if following is None:
                work.pop()
                if work:
                    low[work[-1][0]] = min(low[work[-1][0]], low[unit])
                if low[unit] == order[unit]:
                    at = stack.index(unit)
                    if len(stack) - at > 1:
                        found.append(sorted(stack[at:]))
                    del stack[at:]
            elif following not in order:
                order[following] = low[following] = len(order)
                stack.append(following)
                work.append((following, iter(units.get(following, []))))
            elif following in stack:
                low[unit] = min(low[unit], order[following])
    return sorted(found)


def main():
    units = read_units(pathlib.Path(sys.argv[1]))
    found = circles(units)
    for circle in found:
        print("these units include each other in a circle: " + ", ".join(circle))
    print(f"{len(units)} units, {len(found)} circles")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
