"""Recordings as lists of scans, for the scripts that make the results of doc/results."""

import csv
import os
import re
import subprocess

ENVIRONMENT = dict(os.environ, PATH="/usr/bin:/bin:" + os.environ.get("PATH", ""))
COLUMNS = ["stamp", "x", "y", "bssid", "rssi_dbm"]

# Options of `sfw simulate`.
OFFICE = ["--generate", "office", "--area", 400, "--access-point-count", 12, "--noise", "hard",
          "--path", "sparse"]
FLAT = ["--generate", "flat", "--area", 120, "--access-point-count", 5]


def scans_of(file):
    """The rows of each stamp, by stamp."""
    scans = {}
    with open(file) as rows:
        for row in csv.DictReader(rows):
            scans.setdefault(float(row["stamp"]), []).append(row)
    return [scan for _, scan in sorted(scans.items())]


def place_of(scan):
    return float(scan[0]["x"]), float(scan[0]["y"])


def write(file, scans):
    with open(file, "w", newline="") as out:
        writer = csv.DictWriter(out, COLUMNS, extrasaction="ignore")
        writer.writeheader()
        for scan in scans:
            writer.writerows(scan)


def simulated(sfw, output, options, seed):
    """The scans of a simulated drive, which is written to the folder `output`."""
    subprocess.run([sfw, "simulate", *map(str, options), "--seed", str(seed), "--force",
                    "--output", output], env=ENVIRONMENT, stderr=subprocess.DEVNULL, check=True)
    return scans_of(output / "readings.csv")


def markdown(head, rows):
    lines = [head, ["---"] * len(head)] + rows
    return "\n".join("| " + " | ".join(line) + " |" for line in lines) + "\n"


def update(doc, name, table):
    """Puts a table between its marks in a document."""
    doc.write_text(re.sub(r"(<!-- table: %s -->\n).*?(<!-- end -->)" % re.escape(name),
                          lambda found: found[1] + table + found[2], doc.read_text(),
                          flags=re.DOTALL))
