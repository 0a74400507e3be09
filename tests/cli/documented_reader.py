#!/usr/bin/env python3
"""Runs the reader that docs/model-package.md shows, as printed there.

    documented_reader.py docs/model-package.md PACKAGE.glb

Prints how many numbers it found by group and key, and how the springs stiffen, as JSON.
"""
import json
import re
import sys

document, package = sys.argv[1:]
with open(document, encoding="utf-8") as stream:
    snippet = re.search(r"```python\n(.*?)```", stream.read(), re.DOTALL).group(1)
names = {}
exec(compile(snippet, document, "exec"), names)
model = names["read_package"](package)
stiffening = model.pop("stiffening")
counts = {group: {key: len(values) for key, values in arrays.items()} for group, arrays in model.items()}
print(json.dumps({**counts, "stiffening": stiffening}))
