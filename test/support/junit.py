"""Runs the unittest cases of a script and writes one JUnit result a case, as gtest does.

A script ends with `junit.run()` and is called as: SCRIPT RESULT.xml [ARGUMENT]...
The arguments after the result's name stay in sys.argv[1:] for the script.
"""

import os
import re
import sys
import time
import unittest
import xml.etree.ElementTree as ElementTree


def printable(text):
    """XML has no place for the control characters of a terminal."""
    return re.sub(r"[^\t\n\x20-\ud7ff\ue000-\ufffd]", "?", text)


class Result(unittest.TextTestResult):
    def __init__(self, *arguments, **options):
        super().__init__(*arguments, **options)
        self.suite = ElementTree.Element("testsuite")
        self.started = time.monotonic()

    def startTest(self, test):
        super().startTest(test)
        self.started = time.monotonic()

    def note(self, test, outcome=None, message="", text=""):
        # A failing setUpClass is reported under a name of unittest's own, without a method.
        name = getattr(test, "_testMethodName", str(test))
        case = ElementTree.SubElement(
            self.suite, "testcase", classname=type(test).__name__, name=name,
            time="%.3f" % (time.monotonic() - self.started))
        if outcome:
            ElementTree.SubElement(case, outcome, message=printable(message)).text = printable(text)

    def note_error(self, test, error):
        text = self._exc_info_to_string(error, test)
        self.note(test, "failure", text.strip().splitlines()[-1], text)

    def addSuccess(self, test):
        super().addSuccess(test)
        self.note(test)

    def addFailure(self, test, err):
        super().addFailure(test, err)
        self.note_error(test, err)

    def addError(self, test, err):
        super().addError(test, err)
        self.note_error(test, err)

    def addSubTest(self, test, subtest, err):
        super().addSubTest(test, subtest, err)
        if err is not None:
            self.note_error(test, err)

    def addSkip(self, test, reason):
        super().addSkip(test, reason)
        self.note(test, "skipped", reason)


def run():
    result_file = sys.argv.pop(1)
    suite = unittest.defaultTestLoader.loadTestsFromModule(sys.modules["__main__"])
    # unbuffered, so that what a case prints stands with it
    sys.stdout.reconfigure(line_buffering=True)
    result = unittest.TextTestRunner(stream=sys.stdout, verbosity=2, resultclass=Result).run(suite)
    failures = len(result.failures) + len(result.errors)
    result.suite.attrib.update(name=os.path.basename(sys.argv[0]), tests=str(len(result.suite)),
                               failures=str(failures), errors="0", skipped=str(len(result.skipped)))
    os.makedirs(os.path.dirname(os.path.abspath(result_file)), exist_ok=True)
    ElementTree.ElementTree(result.suite).write(result_file, encoding="utf-8",
                                                xml_declaration=True)
    sys.exit(int(failures > 0))
