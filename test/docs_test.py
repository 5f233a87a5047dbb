#!/usr/bin/env python3
"""Checks the documents against the repository that they describe.

Usage: docs_test.py REPOSITORY
Fails on a long sentence, a dead link, a path that does not exist, a table of parameters that
differs from config/mapping.yaml, and a table of arrows that differs from layering_test.py.
"""

import importlib.util
import pathlib
import re
import sys

LONGEST = 29  # words in a sentence
CODE_BLOCK = re.compile(r"^ *```.*?^ *```$", re.DOTALL | re.MULTILINE)
FORMULA = re.compile(r"^ {4}.*$", re.MULTILINE)
LINK = re.compile(r"\]\(([^)\s]+)\)|src=\"([^\"]+)\"")
PATH = re.compile(r"`((?:src|include|test|doc|config|launch|scripts|msg|srv|rviz)/[\w./-]+)`")
SENTENCE_END = re.compile(r"(?<=[.!?])[)\"*]*\s+(?=[A-Z0-9`\"*(\[])")
PARAMETER = re.compile(r"^\| `([a-z_]+(?:/[a-z_]+)?)` \|", re.MULTILINE)


def documents(root):
    return [root / "README.md"] + sorted((root / "doc").rglob("*.md"))


def blocks(text):
    """The paragraphs, list items and table cells of a document, without markup."""
    text = FORMULA.sub("", CODE_BLOCK.sub("\n", text))
    text = re.sub(r"<[^>]*>", " ", text)
    text = re.sub(r"!?\[([^\]]*)\]\([^)]*\)", r"\1", text)
    text = re.sub(r"`[^`]*`", "Code", text)
    for paragraph in re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.|\|)\s?)|\n(?=#)|(?<=\|)\n", text):
        yield from (re.split(r"\|", paragraph) if "|" in paragraph else [paragraph])


def long_sentences(name, text):
    for block in blocks(text):
        for sentence in SENTENCE_END.split(" ".join(block.split())):
            words = [word for word in sentence.split() if re.search(r"\w", word)]
            if len(words) > LONGEST:
                yield "%s: a sentence of %d words: %s" % (name, len(words), sentence)


def anchors(text):
    """The anchors that a viewer makes of the headings."""
    headings = re.findall(r"^#+ (.+)$", CODE_BLOCK.sub("", text), re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def dead_links(file, text):
    for target in (a or b for a, b in LINK.findall(CODE_BLOCK.sub("", text))):
        if re.match(r"\w+:", target):
            continue
        path, _, anchor = target.partition("#")
        linked = (file.parent / path) if path else file
        if not linked.exists():
            yield "%s: the link to %s is dead" % (file.name, target)
        elif anchor and anchor not in anchors(linked.read_text()):
            yield "%s: %s has no heading #%s" % (file.name, linked.name, anchor)


def missing_paths(root, name, text):
    for path in PATH.findall(text):
        if not (root / path).exists():
            yield "%s: there is no %s" % (name, path)


def settings(root):
    """The names of the settings in config/mapping.yaml, with their groups."""
    group = ""
    for line in (root / "config" / "mapping.yaml").read_text().splitlines():
        found = re.match(r"( *)([a-z_]+):(.*)", line)
        if not found:
            continue
        indent, key, value = found.groups()
        if value.split("#")[0].strip():
            yield ((group + "/" if indent else "") + key,)
        else:
            group = key


def differences(file, documented, actual):
    documented, actual = set(documented), set(actual)
    for entry in sorted(documented ^ actual):
        problem = "is missing in the table" if entry in actual else "does not exist"
        yield "%s: %s %s" % (file, " ".join(entry), problem)


def section(text, heading):
    """The text under a heading, up to the next heading of any level."""
    return re.split(r"^#+ ", text.split("\n%s\n" % heading)[1], flags=re.MULTILINE)[0]


def documented_arrows(root):
    rows = section((root / "doc" / "architecture.md").read_text(), "### Allowed arrows")
    for room, used in re.findall(r"^\| `(\w+)` \| (.*) \|$", rows, re.MULTILINE):
        yield room, " ".join(sorted(re.findall(r"\w+", used)))


def allowed_arrows(root):
    spec = importlib.util.spec_from_file_location("layering", root / "test" / "layering_test.py")
    layering = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(layering)
    return [(room, " ".join(sorted(used.split()))) for room, used in layering.ALLOWED.items()]


def problems(root):
    for file in documents(root):
        name, text = str(file.relative_to(root)), file.read_text()
        yield from long_sentences(name, text)
        yield from dead_links(file, text)
        yield from missing_paths(root, name, text)
    parameters = section((root / "doc" / "interfaces.md").read_text(), "## Parameters")
    documented = [(name,) for name in PARAMETER.findall(parameters)]
    yield from differences("doc/interfaces.md", documented, settings(root))
    yield from differences("doc/architecture.md", documented_arrows(root), allowed_arrows(root))


if __name__ == "__main__":
    sys.dont_write_bytecode = True
    FOUND = [str(problem) for problem in problems(pathlib.Path(sys.argv[1]))]
    print("\n".join(FOUND))
    sys.exit(bool(FOUND))
