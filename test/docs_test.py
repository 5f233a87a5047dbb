#!/usr/bin/env python3
"""Checks the documents against the repository that they describe.

Usage: docs_test.py REPOSITORY
Fails on a long sentence, a dead link, a path that does not exist, a message in
doc/troubleshooting.md that no source has, a test in doc/reliability.md that does not exist, and a
table that differs from config/mapping.yaml or from layering_test.py.
"""

import pathlib
import re
import runpy
import sys

ROOT = pathlib.Path(sys.argv[1])
LONGEST = 29  # words in a sentence
CODE_BLOCK = re.compile(r"^ *```.*?^ *```$", re.DOTALL | re.MULTILINE)
FORMULA = re.compile(r"^ {4}.*$", re.MULTILINE)
BLOCK_END = re.compile(r"\n\s*\n|\n(?=\s*(?:[-*#]|\d+\.)\s)|\|")  # paragraph, list item, table cell
SENTENCE_END = re.compile(r"(?<=[.!?])[)\"*]*\s+(?=[A-Z0-9`\"*(\[])")
LINK = re.compile(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"")
PATH = re.compile(r"`((?:src|include|test|doc|config|launch|scripts|msg|srv|rviz)/[\w./-]+)`")
FIRST_CELL = re.compile(r"^\| `([^`]+)`", re.MULTILINE)


def read(name):
    return (ROOT / name).read_text()


def long_sentences(text):
    text = re.sub(r"<[^>]*>", " ", FORMULA.sub("", CODE_BLOCK.sub("\n\n", text)))
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    for block in BLOCK_END.split(re.sub(r"`[^`]*`", "Code", text)):
        for sentence in SENTENCE_END.split(" ".join(block.split())):
            words = [word for word in sentence.split() if re.search(r"\w", word)]
            if len(words) > LONGEST:
                yield "a sentence of %d words: %s" % (len(words), sentence)


def anchors(text):
    """The anchors that a viewer makes of the headings."""
    headings = re.findall(r"^#+ (.+)$", CODE_BLOCK.sub("", text).lower(), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading).replace(" ", "-") for heading in headings}


def dead_links(file, text):
    for target in (a or b for a, b in LINK.findall(CODE_BLOCK.sub("", text))):
        path, _, anchor = target.partition("#")
        linked = (file.parent / path) if path else file
        if re.match(r"\w+:", target):
            continue
        if not linked.exists():
            yield "the link to %s is dead" % target
        elif anchor and anchor not in anchors(linked.read_text()):
            yield "%s has no heading #%s" % (linked.name, anchor)


def missing_paths(text):
    return ["there is no " + path for path in PATH.findall(text) if not (ROOT / path).exists()]


def missing_messages(text):
    files = [path for folder in ("src", "scripts") for path in sorted((ROOT / folder).rglob("*"))]
    source = "\n".join(path.read_text() for path in files if path.is_file())
    source = re.sub(r'"\s*"', "", source)  # adjacent literals are one text
    return ["no source says '%s'" % message for message in FIRST_CELL.findall(text)
            if message not in source]


def missing_tests(text):
    """The tests that a document names and no file of test/ has."""
    files = [path for path in sorted((ROOT / "test").rglob("*")) if path.suffix in (".cpp", ".py")]
    source = "\n".join(path.read_text() for path in files)
    present = set(re.findall(r"^TEST(?:_F|_P)?\(\s*\w+,\s*(\w+)", source, re.MULTILINE) +
                  re.findall(r"def (test_\w+)\(", source))
    return ["there is no test " + name for name in re.findall(r"`(test_\w+|[A-Z]\w+)`", text)
            if name not in present]


def settings():
    """The names of the settings in config/mapping.yaml, with their groups."""
    group = ""
    for indent, key, value in re.findall(r"^( *)([a-z0-9_]+):(.*)", read("config/mapping.yaml"), re.M):
        if value.split("#")[0].strip():
            yield (group + "/" if indent else "") + key
        else:
            group = key


def table(name, heading):
    """The rows of the table under a heading."""
    text = re.split(r"^#+ ", read(name).split("\n%s\n" % heading)[1], flags=re.MULTILINE)[0]
    return [line for line in text.splitlines() if line.startswith("| `")]


def differences(documented, actual):
    for entry in sorted(set(documented) ^ set(actual)):
        yield entry + (" is not in the table" if entry in actual else " does not exist")


def problems():
    for file in [ROOT / "README.md"] + sorted((ROOT / "doc").rglob("*.md")):
        text = file.read_text()
        for problem in [*long_sentences(text), *dead_links(file, text), *missing_paths(text)]:
            yield file, problem
    for problem in missing_messages(read("doc/troubleshooting.md")):
        yield ROOT / "doc/troubleshooting.md", problem
    for problem in missing_tests(read("doc/reliability.md")):
        yield ROOT / "doc/reliability.md", problem
    documented = [FIRST_CELL.match(row)[1] for row in table("doc/interfaces.md", "## Parameters")]
    for problem in differences(documented, list(settings())):
        yield ROOT / "doc/interfaces.md", problem
    drawn = [re.findall(r"\w+", row) for row in table("doc/architecture.md", "### Allowed arrows")]
    allowed = runpy.run_path(str(ROOT / "test/layering_test.py"))["ALLOWED"].items()
    for problem in differences([" ".join([row[0]] + sorted(row[1:])) for row in drawn],
                               [" ".join([room] + sorted(used.split())) for room, used in allowed]):
        yield ROOT / "doc/architecture.md", problem


if __name__ == "__main__":
    FOUND = ["%s: %s" % (file.relative_to(ROOT), problem) for file, problem in problems()]
    print("\n".join(FOUND))
    sys.exit(bool(FOUND))
