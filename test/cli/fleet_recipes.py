"""The recipes of doc/fleet.md, so that tests run them as they stand there."""

import pathlib
import re


def recipe(source, word):
    """The one code block of the document that holds the word."""
    text = (pathlib.Path(source) / "doc/fleet.md").read_text()
    blocks = [block for block in re.findall(r"^```\w*\n(.*?)^```$", text, re.M | re.S)
              if word in block]
    assert len(blocks) == 1, "doc/fleet.md has %d blocks with %s" % (len(blocks), word)
    return blocks[0]


def contents(folder):
    """Every file below a folder but those of the shards themselves, with its bytes."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and path.name != ".lock" and not path.name.startswith("shard-")}
