#!/usr/bin/python3
"""Fails on retired words in the sources, texts and documents of the project, and in the subjects of newer commits.

Usage: check_terms.py ROOT
The words and their replacements are the last table of resources/docs/GLOSSARY.md.
"""
import re
import subprocess
import sys
from pathlib import Path

root = Path(sys.argv[1])
glossary = "resources/docs/GLOSSARY.md"
kinds = {".cpp", ".h", ".def", ".txt", ".cmake", ".py", ".pyi", ".sh", ".md", ".json", ".ts", ".yml", ".html", ".cff"}


def git(*words):
    return subprocess.run(["git", "-C", root, *words], capture_output=True, text=True).stdout.splitlines()


def retired():
    """Regular expression and replacement; a bar within a cell is escaped."""
    table = (root / glossary).read_text().split("## Retired words")[1]
    rows = re.findall(r"^\| `(.+)` \| (.+) \|$", table, re.M)
    return [(re.compile(word.replace(r"\|", "|")), use) for word, use in rows]


def texts():
    """Where a text is, and the text. Of translations only the English."""
    for path in git("ls-files") or [str(p.relative_to(root)) for p in root.rglob("*") if ".git" not in p.parts]:
        file = root / path
        if path in (glossary, "tests/check_terms.py") or file.suffix not in kinds or not file.is_file():
            continue
        for number, line in enumerate(file.read_text(errors="replace").splitlines(), 1):
            if file.suffix != ".ts" or "<translation" not in line:
                yield f"{path}:{number}", line
    for first in git("log", "--diff-filter=A", "--format=%H", "--", "tests/check_terms.py")[-1:]:
        for subject in git("log", "--format=%h %s", f"{first}..HEAD"):
            yield "commit " + subject.split(" ", 1)[0], subject


words = retired()
if len(words) < 15:
    sys.exit(f"{glossary}: only {len(words)} retired words were read")
found = [f"{where}: “{match.group(0)}”: use {use}" for where, text in texts() for word, use in words
         if (match := word.search(text))]
print("\n".join(found))
sys.exit(f"{len(found)} retired words" if found else 0)
