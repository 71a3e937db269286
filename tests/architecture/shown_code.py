"""Every ```cpp block of the tutorials stands word for word in a file of examples/, which CI builds.

    shown_code.py ROOT
"""

import glob
import re
import sys

root = sys.argv[1]
sources = [open(path).read() for path in glob.glob(root + "/examples/**/*.*", recursive=True)
           if path.endswith((".cc", ".h"))]
count = 0
for page in sorted(glob.glob(root + "/docs/tutorials/*.md")):
    for block in re.findall(r"(?ms)^```cpp\n(.*?)^```", open(page).read()):
        count += 1
        if not any(block in source for source in sources):
            sys.exit(f"{page}: expected this block in a file of examples/:\n{block}")
if count == 0:
    sys.exit("expected a ```cpp block in docs/tutorials")
