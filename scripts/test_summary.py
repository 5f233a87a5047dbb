#!/usr/bin/env python3
"""Counts the tests in the JUnit results that gtest, rostest and script tests left.

Usage: test_summary.py RESULTS_FOLDER CTEST_LOG
CTest's own output adds the tests that left no result. Names failed and skipped tests, ends with "N passed, N failed, N skipped" and exits non-zero unless
at least one test passed and none failed.
"""

import pathlib
import re
import sys
import xml.etree.ElementTree as ElementTree


def shorten(text):
    return " ".join((text or "no reason given").split())[:200]


def read_cases(path):
    """Returns (name, outcome, reason) of each test case in one result file."""
    try:
        suites = ElementTree.parse(path).getroot()
    except ElementTree.ParseError as error:
        return [(path.name, "failed", "unreadable result: %s" % error)]
    cases = []
    for case in suites.iter("testcase"):
        name = "%s.%s" % (case.get("classname"), case.get("name"))
        # An element of ElementTree without children is false.
        problem = next((e for e in case if e.tag in ("failure", "error")), None)
        skip = case.find("skipped")
        if problem is not None:
            cases.append((name, "failed", shorten(problem.get("message") or problem.text)))
        elif skip is not None:
            cases.append((name, "skipped", shorten(skip.get("message") or skip.text)))
        elif case.get("status") == "notrun":
            cases.append((name, "skipped", "disabled"))
        else:
            cases.append((name, "passed", ""))
    return cases


def collect(folder):
    """Returns the cases of all files, each test once."""
    results = {path: read_cases(path) for path in sorted(folder.rglob("*.xml"))}
    cases = []
    for path, found in results.items():
        if path.name.startswith("rostest-"):
            # rostest repeats each of its programs as one case. That case counts only if the program
            # left no result of its own, or failed without a failure in it.
            for name, outcome, reason in found:
                program = name.rpartition(".test")[2]
                own = results.get(path.parent / ("rosunit-%s.xml" % program), [])
                told = any(case[1] == "failed" for case in own)
                if not own or (outcome == "failed" and not told):
                    cases.append(("%s: %s" % (path.stem, program), outcome, reason))
        else:
            cases += [("%s: %s" % (path.stem, name), outcome, reason)
                      for name, outcome, reason in found]
    return cases


def read_ctest_log(path):
    """Returns the cases of tests that CTest ended or could not start."""
    text = path.read_text(errors="replace")
    stopped = re.findall(r"Test +#\d+: (?:_ctest_)?(\S+) \.*\*\*\*(Timeout|Not Run|Exception)", text)
    return [("ctest: " + name, "failed", state.lower()) for name, state in stopped]


def main():
    log = pathlib.Path(sys.argv[2])
    cases = collect(pathlib.Path(sys.argv[1])) + read_ctest_log(log)
    # Any other failure of CTest must not count as success.
    if "tests passed, 0 tests failed" not in log.read_text(errors="replace"):
        if all(outcome != "failed" for _, outcome, _ in cases):
            cases.append(("ctest", "failed", "no result names the reason, see %s" % log))
    count = {"passed": 0, "failed": 0, "skipped": 0}
    for name, outcome, reason in sorted(cases, key=lambda case: case[1], reverse=True):
        count[outcome] += 1
        if outcome != "passed":
            print("%-8s %s (%s)" % (outcome.upper(), name, reason))
    print("%(passed)d passed, %(failed)d failed, %(skipped)d skipped" % count)
    return int(count["failed"] > 0 or count["passed"] == 0)


if __name__ == "__main__":
    sys.exit(main())
