"""What a page states of its commands' results, compared with what came out.

Each stated value is followed by its source, in a comment that readers of the page do not see:

    0.230<!-- = out/first/outcome.json tip_depth_m -->   a value of a JSON file; a.0.b goes down
    `docked`<!-- = out/first/outcome.json outcome -->    a word of it, in backticks
    six<!-- = out/first/sightings.json count() -->       small whole numbers may be words
    46<!-- = output "axel: {} kg" -->                    {} in what the ```sh block before printed
    4<!-- = output "^exit code {}" -->                   ^ matches the beginning of a line
    eight<!-- = lines "left * detected" -->              how many lines of it have this; * matches anything

Numbers are compared at the precision in which they are printed. A ```text block holds lines of what the ```sh
block right before it printed, in their order; "..." at the end of a line matches the rest of it.
"""

import json
import re
from dataclasses import dataclass
from decimal import ROUND_HALF_EVEN, Decimal, InvalidOperation

WORDS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve")
MARK = "<!-- ="
VALUE = re.compile(r"(?P<token>`[^`\n]+`|[A-Za-z]+|-?\d+(?:\.\d+)?)<!-- =\s(?P<source>.*?)\s-->", re.S)
BLOCK = re.compile(r"(?ms)^```(?P<kind>sh|text)\n(?P<body>.*?)^```")


@dataclass
class Item:
    """Of a page: a block of commands (sh), a block of output (text), or a value with its source (value)."""

    kind: str
    line: int
    text: str
    begin: int = 0  # of the text in the page
    source: str = ""


def items(page_text):
    """The items of a page, in order. Throws ValueError for a source without a value before it."""
    found = []
    commands_end = None
    for match in BLOCK.finditer(page_text):
        printed = commands_end is not None and not page_text[commands_end : match.start()].strip()
        commands_end = match.end() if match["kind"] == "sh" else None
        if match["kind"] == "text" and not printed:
            continue
        found.append(Item(match["kind"], line_of(page_text, match.start()) + 1, match["body"], match.start("body")))
    for match in VALUE.finditer(page_text):
        source = " ".join(match["source"].split())
        found.append(Item("value", line_of(page_text, match.start()), match["token"], match.start(), source))
    if page_text.count(MARK) != sum(item.kind == "value" for item in found):
        raise ValueError(f"expected a number, a word or `code` right before each '{MARK}'")
    return sorted(found, key=lambda item: item.begin)


def line_of(page_text, at):
    return page_text[:at].count("\n") + 1


def true_text(item, output):
    """The text that the item should have. output: of the commands before it. Throws ValueError."""
    if item.kind == "text":
        return "".join(line + "\n" for line in true_lines(item.text.splitlines(), output.splitlines()))
    value = value_of(item.source, output)
    if item.text.startswith("`"):
        return f"`{value}`"
    if item.text.lower() in WORDS or not item.text[-1].isdigit():
        return word_for(value, like=item.text)
    digits = len(item.text.partition(".")[2])
    try:
        rounded = Decimal(str(value)).quantize(Decimal(1).scaleb(-digits), ROUND_HALF_EVEN)
    except InvalidOperation:
        raise ValueError(f"{item.source}: expected a number, found '{value}'") from None
    return str(abs(rounded) if rounded == 0 else rounded)


def word_for(value, like):
    """A small whole number as a word; any other value as it is."""
    number = str(value)
    if like.lower() not in WORDS or not number.isdigit() or int(number) >= len(WORDS):
        return number
    word = WORDS[int(number)]
    return word.capitalize() if like[0].isupper() else word


def value_of(source, output):
    """The value that a source names."""
    printed = re.fullmatch(r'output "(.*)"', source)
    if printed:
        before, hole, after = printed[1].partition("{}")
        if not hole:
            raise ValueError(f"{source}: expected {{}} in place of the value")
        start = "(?m)^" if before.startswith("^") else ""
        pattern = start + spaced(before.removeprefix("^")) + r"([^\s,;()]+)" + spaced(after)
        found = re.search(pattern, output)
        if not found:
            raise ValueError(f"not printed: {source}")
        return found[1]
    counted = re.fullmatch(r'lines "(.*)"', source)
    if counted:
        pattern = ".*".join(spaced(part) for part in counted[1].split("*"))
        return sum(re.search(pattern, line) is not None for line in output.splitlines())
    path, _, key = source.partition(" ")
    if not path.endswith(".json") or not key:
        raise ValueError(f'{source}: expected FILE.json KEY, output "..." or lines "..."')
    try:
        with open(path, encoding="utf-8") as file:
            value = json.load(file, parse_float=Decimal)
        for step in key.split("."):
            value = len(value) if step == "count()" else value[int(step) if isinstance(value, list) else step]
    except (OSError, KeyError, IndexError, ValueError, TypeError) as error:
        raise ValueError(f"{source}: {type(error).__name__}: {error}") from None
    return str(value).lower() if isinstance(value, bool) else value


def spaced(text):
    """A pattern for this text with any width of its spaces."""
    return re.sub(r"(?:\\ )+", r"\\s+", re.escape(text))


def true_lines(lines, printed):
    """The lines as they were printed. One that differs in its numbers alone is put right."""
    at = 0
    for line in lines:
        exact = re.escape(line.removesuffix("...")) + (".*" if line.endswith("...") else "")
        for pattern in (exact, re.sub(r"\d+", r"\\d+", exact)):
            place = next((i for i in range(at, len(printed)) if re.fullmatch(pattern, printed[i])), None)
            if place is not None:
                break
        if place is None:
            raise ValueError(f"not printed: {line}")
        at = place + 1
        yield shortened(printed[place], line) if line.endswith("...") else printed[place]


def shortened(printed, line):
    """A printed line up to where the page's line breaks off."""
    stem = re.sub(r"\d+", r"\\d+", re.escape(line.removesuffix("...")))
    return re.match(stem, printed)[0] + "..."
