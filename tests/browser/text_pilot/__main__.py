"""Command: fly built-in scenarios by their texts alone, and print a report."""

from __future__ import annotations

import argparse
import sys

from playwright.sync_api import sync_playwright

from tests.browser.conftest import FLAGS, running_station
from tests.browser.flight import WAIT_MS
from tests.browser.text_pilot.pilot import Pilot, Report
from tests.conftest import find_chromium

SCENARIOS = ("tutorial", "srms-deploy", "srms-berth", "concept-1972")
LIMIT_S = 2400.0
"""Longest flight [s]."""


def main() -> int:
    """Fly the scenarios that the command line names, or all four; return 1 if one is not completed."""
    options = argparse.ArgumentParser(description=main.__doc__)
    options.add_argument("scenarios", nargs="*", default=SCENARIOS)
    options.add_argument("--tell", action="store_true", help="print each decision")
    options.add_argument("--limit", type=float, default=LIMIT_S, help="longest flight [s]")
    given = options.parse_args()
    reports = []
    with sync_playwright() as playwright:
        browser = playwright.chromium.launch(executable_path=find_chromium(), args=FLAGS, timeout=WAIT_MS)
        for scenario in given.scenarios:
            with running_station(scenario) as address:
                page = browser.new_page(viewport={"width": 1440, "height": 900})
                page.set_default_timeout(WAIT_MS)
                page.goto(f"{address}?quality=low")
                report = Pilot(page, tell=given.tell).fly(given.limit)
                page.close()
            show(scenario, report)
            reports.append(report)
        browser.close()
    return 0 if all(report.complete for report in reports) else 1


def show(scenario: str, report: Report) -> None:
    """Print the figures of a run."""
    print(f"{scenario}: {'complete' if report.complete else 'NOT COMPLETE'}, {report.presses} key presses")
    for title, at in report.steps:
        print(f"  {at:8.1f} s  {title}")
    print(f"  {report.result}")
    for why in report.lost:
        print(f"  no idea: {why}")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
