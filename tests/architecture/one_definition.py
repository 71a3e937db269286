#!/usr/bin/env python3
"""Finds names that two files of the tree define differently in one namespace.

The language asks for one definition of each type and inline function in a program. No compiler sees
two files at once, so neither it nor the linker complains: link order decides which one is kept.

Usage: one_definition.py ROOT      exit 1 and a line for each name defined twice
"""
import collections
import pathlib
import re
import sys

ROOMS = ["controller", "models", "render", "sim", "tests"]

COMMENT_OR_TEXT = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|\'(?:\\.|[^\'\\\n])\'|^[ \t]*#[^\n]*',
    re.S | re.M)
NAMESPACE = re.compile(r"(?:inline\s+)?namespace\s*([\w:]*)\s*$")
TYPE = re.compile(r"\b(?:struct|class|union|enum(?:\s+class|\s+struct)?)\s+(?:\[\[.*?\]\]\s*)?(\w+(?:::\w+)*)[^;=()]*$")
TEMPLATE = re.compile(r"\btemplate\s*<[^<>]+>")  # its parameters define no type
FUNCTION = re.compile(r"\b(?:inline|constexpr)\b.*?\b(operator\s*\S+?|\w+)\s*\((.*)\)[\w\s&]*$", re.S)
CONSTANT = re.compile(r"\binline\b[^(]*?\b(\w+)\s*(?:\[\w*\]\s*)?(?:=.*)?$", re.S)
WORDS = {"const", "unsigned", "signed", "long"}  # before a type's last word, not a parameter's name
ALIAS = re.compile(r"\busing\s+(\w+)\s*=")


def split_parameters(text):
    parts, depth, part = [], 0, ""
    for c in text:
        depth += (c in "<({[") - (c in ">)}]")
        if c == "," and depth == 0:
            parts.append(part)
            part = ""
        else:
            part += c
    return parts + [part] if part.strip() else parts


def signature(name, parameters):
    """The function's name with the types of its parameters, their names and defaults left out."""
    types = []
    for part in split_parameters(parameters):
        tokens = re.findall(r"[\w:]+|[^\s\w]", part.split("=")[0])
        if len(tokens) > 1 and re.fullmatch(r"[A-Za-z_]\w*", tokens[-1]) and tokens[-2] not in WORDS:
            tokens.pop()
        types.append(" ".join(tokens))
    return f"{name}({', '.join(types)})"


def defined_by(head, body_follows):
    """What the text before a '{' or ';' defines, or None."""
    if body_follows:
        found = TYPE.search(TEMPLATE.sub(" ", head))
        if found and not re.search(r"\bfriend\b|\bextern\b", head):
            if "template <>" not in head and not re.search(r"\w+<.*>\s*$", head):
                return found.group(1)
        found = FUNCTION.search(head)
        if found and "template <>" not in head:
            return signature(found.group(1), found.group(2))
    else:
        found = ALIAS.search(head)
        if found:
            return found.group(1)
    found = CONSTANT.search(head) if "(" not in head.split("=")[0] else None
    return found.group(1) if found else None


def definitions(text, header):
    """(namespace, name, line) of what a file defines at namespace scope for the whole program."""
    blank = lambda found: re.sub(r"[^\n]", " ", found.group(0))
    text = COMMENT_OR_TEXT.sub(blank, text)
    scopes, start = [], 0  # one per open brace: a namespace's name, or None for any other
    for i, c in enumerate(text):
        if c not in "{};":
            continue
        head = text[start:i].strip()
        start = i + 1
        if c == "}":
            if scopes:
                scopes.pop()
            continue
        outside = all(scope is not None for scope in scopes)
        space = NAMESPACE.search(head) if c == "{" else None
        if space:
            scopes.append(space.group(1))
            continue
        if outside and "" not in scopes:  # an unnamed namespace is the file's own
            name = defined_by(head, c == "{")
            # An alias or constant of a source file is its own business: no other file sees it.
            if name and (header or c == "{"):
                yield "::".join(scopes), name, text.count("\n", 0, i) + 1
        if c == "{":
            scopes.append(None)


def main(root):
    places = collections.defaultdict(dict)
    files = [path for room in ROOMS for path in sorted((root / room).rglob("*"))
             if path.suffix in (".h", ".cc")]
    if not files:
        sys.exit(f"one_definition: no source files under '{root}'")
    for path in files:
        header = path.suffix == ".h"
        # Each source file of tests/ belongs to one program of its own.
        if not header and path.relative_to(root).parts[0] == "tests":
            continue
        for space, name, line in definitions(path.read_text(encoding="utf-8"), header):
            places[(space, name)].setdefault(path.relative_to(root), line)
    twice = {key: where for key, where in places.items() if len(where) > 1}
    for (space, name), where in sorted(twice.items()):
        print(f"{space}::{name} is defined in " + " and ".join(f"{p}:{n}" for p, n in where.items()))
    print(f"one_definition: {len(places)} names in {len(files)} files, {len(twice)} defined twice")
    return 1 if twice else 0


if __name__ == "__main__":
    sys.exit(main(pathlib.Path(sys.argv[1])))
