#!/usr/bin/env python3
"""Counts words and patterns of our own, for which the field has a standard term, by room.

The counts of words.txt are ceilings: a room's count may only fall. The check fails when a count rose, and also
when it fell and words.txt still has the former count.

    words.py ROOT            compares the tree with ROOT/tests/architecture/words.txt; exit 1 if a count differs
    words.py ROOT --write    writes lower counts; refuses when a word's total over all rooms rises
    words.py ROOT --where WORD [ROOM]   the lines that have the word

It reads identifiers (split at capitals and underscores), comments, help, messages and pages alike: every file of
the rooms that ends in .h, .cc, .js, .mjs, .py or .md, and scripts without an ending.
"""
import collections
import pathlib
import re
import sys

ROOMS = ["controller", "docs", "examples", "models", "packaging", "python", "render", "scripts", "sim", "tests"]
PAGES = ["README.md"]
ENDINGS = {".h", ".cc", ".js", ".mjs", ".py", ".md"}
LISTED = "tests/architecture/words.txt"
OWN_FILES = {"tests/architecture/words.py", LISTED}

# What to write instead. Plurals and other forms count as the word.
WORDS = {
    "askew": ("askew", "tilted, off the axis"),
    "beholder": ("beholder", "viewer"),
    "beside": ("beside|besides", "next to, as well as"),
    "born": ("born", "initialised"),
    "brain": ("brain|brains", "controller"),
    "eye": ("eye|eyes", "camera, perception"),
    "foretold": ("foretold|foretell|foretells", "predicted"),
    "haul": ("haul|hauls|hauled|hauling|hauler", "tow, reel in"),
    "home": ("home", "seated"),
    "look": ("look|looks|looked|looking", "image, observation, sighting"),
    "mother": ("mother", "station"),
    "naming": ("naming|namings", "correspondence"),
    "peek": ("peek|peeks|peeked", "single observation"),
    "picture": ("picture|pictures|pictured", "image"),
    "righting": ("righting", "recovery"),
    "seeker": ("seeker", "search"),
    "seen": ("seen|unseen", "detected, observed"),
    "sheet": ("sheet|sheets", "nominal parameters, page"),
    "stands": ("stands|stand", "is"),
    "suppose": ("suppose|supposes|supposed", "hypothesis"),
    "told": ("told", "nominal, reported"),
    "way": ("way|ways", "distance, path, method"),
}
# Patterns over the running text, comment marks and line ends taken away.
PATTERNS = {
    "as-many": (r"\b(?:so|as) (?:many|much)\b(?! as)", "say what is counted"),
    "of-first": (r"(?:^|[.!?] )Of (?:all|more|the|these|those|a|an|[0-9])\b", "a sentence with subject and verb"),
    "what-is": (r"(?:^|[.!?] )What (?!is\b[^.?]*\?)[a-z]+[^.?!]*\.", "a noun as the subject"),
}

PART = re.compile(r"[A-Z]+(?![a-z])|[A-Z]?[a-z]+")
FORMS = {form: word for word, (forms, _) in WORDS.items() for form in forms.split("|")}
MARKS = re.compile(r"^\s*(?:///?|#|\*|<!--|-->|\|)\s?", re.M)


def room_of(path):
    """docs/reference, sim/app, tests/axel; the folder alone for a file that stands in it."""
    parts = path.parts[:-1]
    return "/".join(parts[:2]) if parts else path.name


def is_text(path):
    return path.suffix in ENDINGS or (path.parts[0] == "scripts" and not path.suffix)


def files(root):
    for page in PAGES:
        if (root / page).is_file():
            yield pathlib.Path(page)
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            relative = path.relative_to(root)
            if "node_modules" not in path.parts and path.is_file() and is_text(relative) and str(relative) not in OWN_FILES:
                yield relative


def parts(text):
    """The words of a text in lower case, identifiers taken apart."""
    return (part.lower() for part in PART.findall(text))


def counts_of(text):
    found = collections.Counter(FORMS[part] for part in parts(text) if part in FORMS)
    running = re.sub(r"\s+", " ", MARKS.sub(" ", text))
    for name, (pattern, _) in PATTERNS.items():
        found[name] += len(re.findall(pattern, running))
    return +found


def counted(root):
    """{room: {word: count}} of the tree; rooms without any are left out."""
    rooms = collections.defaultdict(collections.Counter)
    for path in files(root):
        rooms[room_of(path)].update(counts_of((root / path).read_text(encoding="utf-8", errors="replace")))
    return {room: counts for room, counts in rooms.items() if counts}


def listed(root):
    """{room: {word: count}} of words.txt: `room: word count, word count`."""
    rooms = {}
    file = root / LISTED
    for number, line in enumerate(file.read_text(encoding="utf-8").splitlines() if file.is_file() else [], 1):
        if not line.strip() or line.startswith("#"):
            continue
        room, _, rest = line.partition(":")
        rooms[room] = collections.Counter()
        for entry in rest.split(","):
            word, _, count = entry.strip().partition(" ")
            if word not in WORDS and word not in PATTERNS or not count.isdigit():
                sys.exit(f"{file}:{number}: expected 'room: word count, ...' with words of words.py, found '{entry.strip()}'")
            rooms[room][word] = int(count)
    return rooms


def total(rooms):
    return sum(rooms.values(), collections.Counter())


def advice(word):
    return (WORDS.get(word) or PATTERNS[word])[1]


def differences(now, before):
    """(room, word, count now, count before) where they differ."""
    for room in sorted(now.keys() | before.keys()):
        have, had = now.get(room, {}), before.get(room, {})
        for word in sorted(have.keys() | had.keys()):
            if have.get(word, 0) != had.get(word, 0):
                yield room, word, have.get(word, 0), had.get(word, 0)


def write(root, now):
    with open(root / LISTED, "w", encoding="utf-8") as file:
        file.write("# Uses of words of our own, by room. words.py counts and writes them; a count may only fall.\n")
        for room in sorted(now):
            file.write(f"{room}: " + ", ".join(f"{word} {count}" for word, count in sorted(now[room].items())) + "\n")


def show_where(root, word, room):
    if word not in WORDS and word not in PATTERNS:
        sys.exit(f"words.py: expected one of {', '.join([*WORDS, *PATTERNS])}; found '{word}'")
    for path in files(root):
        if room and room_of(path) != room:
            continue
        for number, line in enumerate((root / path).read_text(encoding="utf-8", errors="replace").splitlines(), 1):
            if counts_of(line)[word]:
                print(f"{path}:{number}: {line.strip()}")


def main(arguments):
    root = pathlib.Path(arguments[0])
    if "--where" in arguments:
        show_where(root, arguments[2], arguments[3] if len(arguments) > 3 else "")
        return 0
    now, before = counted(root), listed(root)
    if not any(files(root)):
        sys.exit(f"words.py: no files under '{root}'")
    rise = {word: (count, total(before)[word]) for word, count in total(now).items() if count > total(before)[word]}
    if "--write" in arguments:
        if before and rise:
            sys.exit("\n".join(f"words.py: '{word}': {count} uses, {had} before: write {advice(word)}"
                               for word, (count, had) in sorted(rise.items())))
        write(root, now)
        return 0
    changed = list(differences(now, before))
    for room, word, count, had in changed:
        if count > had:
            print(f"{room}: '{word}' {count} times, at most {had}: write {advice(word)}"
                  f" (tests/architecture/words.py . --where {word} {room})")
        else:
            print(f"{room}: '{word}' {count} times, words.txt still has {had}: tests/architecture/words.py . --write")
    print(f"words: {sum(total(now).values())} uses of {len(WORDS) + len(PATTERNS)} words and patterns, {len(changed)} counts differ")
    return 1 if changed else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
