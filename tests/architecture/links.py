"""Every link of the Markdown pages leads to a file, and to a heading where it names one.

    links.py ROOT        exit 1 and a line per broken link
"""

import os
import re
import sys

LINK = re.compile(r"\]\(([^)#\s]*)(?:#([^)\s]*))?\)")
SKIPPED = (".git", "out", "results", "build")


def slug(heading):
    """The anchor that web pages give a heading."""
    return re.sub(r"[^a-z0-9 _-]", "", heading.lower()).strip().replace(" ", "-")


def pages(root):
    for folder, folders, files in os.walk(root):
        if folder == root:
            folders[:] = [f for f in folders if not f.startswith(SKIPPED)]
        folders[:] = [f for f in folders if f != "node_modules"]  # packages of others
        yield from (os.path.join(folder, f) for f in files if f.endswith(".md"))


def broken(page):
    text = open(page).read()
    for path, anchor in LINK.findall(text):
        if path.startswith("http"):
            continue
        target = os.path.normpath(os.path.join(os.path.dirname(page), path)) if path else page
        if not os.path.exists(target):
            yield f"{path}: no such file"
        elif anchor and target.endswith(".md"):
            if anchor not in map(slug, re.findall(r"(?m)^#+ (.*)$", open(target).read())):
                yield f"{path}#{anchor}: no such heading"


found = [f"{page}: {fault}" for page in pages(sys.argv[1]) for fault in broken(page)]
print("\n".join(found))
sys.exit(1 if found else 0)
