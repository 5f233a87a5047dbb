#!/usr/bin/env python3
"""Runs a program as a test and writes a JUnit result like those of gtest and rostest.

Usage: script_test.py RESULT.xml NAME PROGRAM [ARGUMENT]...
Exit status 0 of the program is a pass and 77 a skip, whose last line of output is the reason;
anything else is a failure.
"""

import os
import re
import subprocess
import sys
import time
import xml.etree.ElementTree as ElementTree

SKIPPED = 77


def main():
    result_file, name, command = sys.argv[1], sys.argv[2], sys.argv[3:]
    start = time.monotonic()
    try:
        run = subprocess.run(command, stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                             stderr=subprocess.STDOUT)
        status, output = run.returncode, run.stdout.decode(errors="replace")
    except OSError as error:
        status, output = 127, str(error)
    seconds = "%.3f" % (time.monotonic() - start)
    print(output, end="")
    # XML has no place for the control characters of a terminal.
    output = re.sub(r"[^\t\n\x20-\ud7ff\ue000-\ufffd]", "?", output)

    failed = status not in (0, SKIPPED)
    suite = ElementTree.Element("testsuite", name="script", tests="1", failures=str(int(failed)),
                                errors="0", skipped=str(int(status == SKIPPED)), time=seconds)
    case = ElementTree.SubElement(suite, "testcase", classname="script", name=name, time=seconds)
    if status == SKIPPED:
        reason = output.strip().splitlines()[-1:] or ["no reason given"]
        ElementTree.SubElement(case, "skipped", message=reason[0])
    elif failed:
        failure = ElementTree.SubElement(case, "failure", message="exit status %d" % status)
        failure.text = output
    os.makedirs(os.path.dirname(os.path.abspath(result_file)), exist_ok=True)
    ElementTree.ElementTree(suite).write(result_file, encoding="utf-8", xml_declaration=True)
    return int(failed)


if __name__ == "__main__":
    sys.exit(main())
