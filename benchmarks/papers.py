"""How long the papers take to recompute: python benchmarks/papers.py [--quick]

All findings of all papers in a process that has them imported, and the whole command, cold, with its JSON and with
its page. The exit code is 1 where a limit is missed, or where a cell or an equation has no finding.
"""

import os

for pool in ("OMP_NUM_THREADS", "OPENBLAS_NUM_THREADS", "MKL_NUM_THREADS"):
    os.environ[pool] = "1"

import argparse
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

from kinematics import Result, seconds
from kinlab.papers.recompute import recompute

# What a person waits for without wondering.
LIMIT_S = 3.0


def command(*args: str) -> float:
    """Seconds of a fresh `kinlab papers`."""
    line = [sys.executable, "-m", "kinlab", "papers", *args]
    return seconds(lambda: subprocess.run(line, check=True, capture_output=True))


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--quick", action="store_true", help="fewer rounds")
    rounds = 3 if parser.parse_args().quick else 11
    reports = recompute()
    findings = sum(len(report.findings) for report in reports)
    missing = [f"{report.paper.name}: {where}" for report in reports for where in report.coverage.missing]

    def median(*args: str) -> float:
        return statistics.median(command(*args) for _ in range(rounds))

    warm = statistics.median(seconds(recompute) for _ in range(rounds))
    note = f"{findings} findings of {len(reports)} papers"
    results = [Result("all findings, imported", warm, LIMIT_S, "s", note)]
    results.append(Result("kinlab papers --json, cold", median("--json"), LIMIT_S, "s"))
    with tempfile.TemporaryDirectory() as folder:
        page = Path(folder) / "papers.html"
        took = median("--html", str(page))
        results.append(
            Result("kinlab papers --html, cold", took, LIMIT_S, "s", f"{page.stat().st_size / 1e3:.0f} kB")
        )
    for result in results:
        print(result)
    for where in missing:
        print(f"no finding: {where}")
    return int(bool(missing) or any(result.missed for result in results))


if __name__ == "__main__":
    sys.exit(main())
