"""Commands ``replay`` and ``recordings``."""

from __future__ import annotations

import math
import re
import sys
from contextlib import ExitStack
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

from aftdeck.arms.by_joint import shown
from aftdeck.cli.app import Host, Json, Names, NoBrowser, Port, app
from aftdeck.cli.printing import print_json
from aftdeck.errors import InputError, RecordingError
from aftdeck.lines import print_error, print_line, visible
from aftdeck.progress_bar import ProgressBar

if TYPE_CHECKING:
    from aftdeck.recording.changed import Outcome
    from aftdeck.recording.index import Entry
    from aftdeck.recording.reader import Recording
    from aftdeck.recording.replay import Verdict

MAX_FIELDS = 10
"""Maximum number of fields printed for the first difference."""
MAX_EVENTS = 20
"""Maximum number of changed log lines that are printed."""
CHAINS = {
    "broken": "the hash chain is broken: messages were changed, removed, added or moved after the recording",
    "removed": "the hash chain was removed after the recording",
    "unlisted": "the list of recordings has another hash chain: the file was rewritten after the recording",
}
"""Sentences for the results of a hash chain that show a change of the file."""
ENDS = ("completed", "time", "fault", "stopped", "restarted", "cut", "recording")
"""Values of --ended: the reasons for the end of a recording, and ``recording`` if it has not ended."""
_SINCE = re.compile(r"|\d{4}(-\d\d(-\d\d(T\d\d(:\d\d(:\d\d)?)?)?)?)?")


@app.command(
    short_help="Verify a recording, re-run it with changes, or play it back.",
    epilog="Examples: aftdeck replay run.mcap --verify; aftdeck replay run.mcap --set command_delay=0.5; "
    "aftdeck replay run.mcap --open; aftdeck replay run.mcap --html run.html",
)
def replay(
    file: Annotated[Path, typer.Argument(metavar="RECORDING", help="A recording (.mcap).")],
    verify: Annotated[
        bool,
        typer.Option("--verify", help="Re-simulate the recording and compare all its messages (default)."),
    ] = False,
    changes: Annotated[
        list[str] | None,
        typer.Option(
            "--set",
            metavar="KEY=VALUE",
            help="Re-run the inputs with a change of the scenario: rate=vernier, command_delay=0.5, "
            "limits.por.translation='1 ft/s', arm=mine.toml. May be given several times.",
        ),
    ] = None,
    out: Annotated[Path | None, typer.Option(help="Record the re-run into this file. Requires --set.")] = None,
    play: Annotated[bool, typer.Option("--open", help="Play the recording back in the browser.")] = False,
    html: Annotated[
        Path | None, typer.Option(help="Write one HTML file that plays the recording without a server.")
    ] = None,
    max_lost: Annotated[
        float | None,
        typer.Option(
            metavar="SECONDS", help="Verify, and reject a recording that lost more time, or does not tell its delays."
        ),
    ] = None,
    words: Annotated[
        Path | None,
        typer.Option(metavar="FILE", help="Verify, and write the 1972 report's channels and frame words (JSON lines)."),
    ] = None,
    host: Host = "127.0.0.1",
    port: Port = 8340,
    names: Names = None,
    no_browser: NoBrowser = False,
    as_json: Json = False,
) -> None:
    """Verify, re-run or play back a recording.

    The exit code is 1 if the re-simulation differs from the recording, if the recording was changed, or if the run lost
    more time than allowed. It is 2 if the file is damaged or not a whole recording.
    """
    if verify + bool(changes) + play + (html is not None) > 1:
        raise InputError("--verify, --set, --open and --html cannot be combined")
    if out is not None and not changes:
        raise InputError("--out requires --set: it records the re-run")
    if (words is not None or max_lost is not None) and (changes or play or html is not None):
        raise InputError("--words and --max-lost can be combined only with --verify")
    if changes:
        _rerun(file, tuple(changes), out, as_json)
    elif play:
        from aftdeck.station.server.playback_server import serve_recording

        serve_recording(file, host=host, port=port, names=tuple(names or ()), open_browser=not no_browser)
    elif html is not None:
        from aftdeck.cli.laws import compiled_meanwhile
        from aftdeck.recording.bundle import scenario_of
        from aftdeck.recording.reader import Recording
        from aftdeck.station.playback.one_file import write_html
        from aftdeck.station.session.warm import warm_up

        with compiled_meanwhile(warm_up, scenario_of(Recording(file).opening)):
            write_html(file, html)
        print_line(f"{html}: {html.stat().st_size / 1e6:.2f} MB; open it in any browser")
    else:
        _verify(file, words, max_lost, as_json)


def _verify(file: Path, words: Path | None, max_lost: float | None, as_json: bool) -> None:
    from aftdeck.cli.laws import compiled_meanwhile
    from aftdeck.recording.bundle import scenario_of
    from aftdeck.recording.reader import Recording
    from aftdeck.recording.replay import verify
    from aftdeck.simulation.warm import warm_up

    recording = Recording(file)
    with ExitStack() as open_files:
        stepped = None
        if words is not None:
            from aftdeck.cli.words import writing

            stepped = open_files.enter_context(writing(scenario_of(recording.opening), words))
        open_files.enter_context(compiled_meanwhile(warm_up, scenario_of(recording.opening), bar=False))
        progress = open_files.enter_context(ProgressBar(recording.opening.title))
        verdict = verify(file, progress, stepped, _listed(file))
    if as_json:
        print_json(verdict, indent=2)
    else:
        _print_verdict(recording, verdict)
    lost = math.inf if verdict.delays is None else verdict.delays.lost_s
    if max_lost is not None and not lost <= max_lost:
        told = "the recording does not tell its delays" if verdict.delays is None else f"{lost:.2f} s"
        print_error(f"time lost: {told}; allowed: {max_lost:g} s")
        raise typer.Exit(1)
    if not verdict.agrees:
        raise typer.Exit(1)


def _listed(file: Path) -> str:
    """Return the head of the recording's hash chain in the list of recordings; empty if there is no such list."""
    from aftdeck.recording.index import Index

    index = Index()
    try:
        there = index.path.is_file()
    except RecordingError:
        return ""
    return index.chain_of(file) if there else ""


def _print_verdict(recording: Recording, v: Verdict) -> None:
    start = recording.opening
    print_line(f"{recording.path}: {start.title!r} ({start.scenario}), seed {start.seed}, began {start.began}")
    if start.participant:
        print_line(f"  participant  {start.participant}")
    if start.condition:
        print_line(f"  condition    {start.condition}")
    if start.changes:
        print_line(f"  changed      {', '.join(start.changes)}")
    if v.recorded_by != v.version:
        print_line(f"  made by      Aftdeck {v.recorded_by}; verified with {v.version}")
    if v.cut:
        print_line(f"  cut short    after {v.time_s:.2f} s; verified up to this time")
    if v.delays is not None:
        print_line(f"  delays       {v.delays.text()}")
    differs = "within     " if v.agrees else "DIFFERENT  "
    if not v.different:
        scope = "bit for bit" if v.whole else "in every recorded value; digests of another version are not comparable"
        print_line(f"  {'equal      ' if v.equal else 'frames     '}  all {v.frames} frames, {v.time_s:.2f} s, {scope}")
    else:
        print_line(f"  {differs}  {v.different} of {v.frames} frames differ{_tolerance() if v.agrees else ''}")
        _print_difference(v)
    for change in v.changes:
        print_line(f"  {differs}  {change.messages} messages in {change.channel}, the first at {change.time_s:.2f} s")
    if v.chain in CHAINS:
        print_line(f"  CHANGED      {CHAINS[v.chain]}")
    for name, channels in (("recomputed", v.recomputed), ("unchanged", v.unchanged), ("not covered", v.not_covered)):
        if channels:
            print_line(f"  {name:<11}  {', '.join(channels)}")


def _tolerance() -> str:
    """Return the tolerance for a run with masses in another environment, as text."""
    from aftdeck.recording.apart import TOLERANCE_M, TOLERANCE_RAD

    return f", within the tolerance for another environment: {TOLERANCE_M:g} m and {TOLERANCE_RAD:g} rad"


def _print_difference(v: Verdict) -> None:
    """Print by how much the frames differ, and possible causes."""
    if v.apart is not None:
        lengths = "a length in one run only" if v.apart.metres is None else f"{v.apart.metres:.1g} m"
        angles = "an angle in one run only" if v.apart.radians is None else f"{v.apart.radians:.1g} rad"
        print_line(f"  by           at most {lengths} and {angles}, from frame {v.apart.tick} on")
    if not v.same_laws:
        print_line("  other laws   the laws have changed since the recording; the last digits may differ")
    if not v.same_machine:
        print_line("  computed by  another environment; the last digits may differ")
        for change in v.environment:
            print_line(f"    {change.field}: {change.before or 'none'} -> {change.after or 'none'}")
    if v.first is not None:
        print_line(f"  first        at {v.first.time_s:.2f} s (step {v.first.tick})")
        _print_fields(v.first.fields)


def _print_fields(fields: tuple[object, ...]) -> None:
    from aftdeck.recording.compare import FieldChange

    if not fields:
        print_line("    only beyond the recorded decimals")
    for change in fields[:MAX_FIELDS]:
        assert isinstance(change, FieldChange)
        print_line(f"    {change.field}: {change.before} -> {change.after}")
    if len(fields) > MAX_FIELDS:
        print_line(f"    and {len(fields) - MAX_FIELDS} more values")


def _rerun(file: Path, changes: tuple[str, ...], out: Path | None, as_json: bool) -> None:
    from aftdeck.cli.laws import compiled_meanwhile
    from aftdeck.recording.bundle import scenario_of
    from aftdeck.recording.changed import rerun
    from aftdeck.recording.index import Index
    from aftdeck.recording.reader import Recording
    from aftdeck.simulation.warm import warm_up

    scenario = scenario_of(Recording(file).opening)
    with (
        compiled_meanwhile(warm_up, scenario, bar=False),
        ProgressBar("with " + ", ".join(changes)) as progress,
    ):
        outcome = rerun(file, changes, out, progress=progress, index=Index())
    if as_json:
        print_json(outcome, indent=2)
    else:
        _print_outcome(file, outcome)
    if out is not None and not as_json:
        print_line(f"  recorded   {out}")


def _print_outcome(file: Path, o: Outcome) -> None:
    print_line(f"{file} with {', '.join(o.changes)}:")
    before, after = f"{o.ended_before} after {o.time_before_s:.2f} s", f"{o.ended_after} after {o.time_after_s:.2f} s"
    print_line(f"  ended        {before} -> {after}")
    if not o.compared:
        print_line("  not compared: the two runs have no frame at the same time")
        return
    if o.first is None and not o.events:
        print_line(f"  no difference in {o.compared} frames")
        return
    if o.first is not None:
        print_line(f"  first        at {o.first.time_s:.2f} s:")
        _print_fields(o.first.fields)
    print_line(
        f"  true tip     difference at most {o.greatest_tip_m.value:.3f} m, at {o.greatest_tip_m.time_s:.2f} s; "
        f"{o.tip_at_end_m:.3f} m at the end"
    )
    if o.joint:
        most = shown(o.greatest_joint_rad.value, o.joint_slides, ".3f" if o.joint_slides else ".2f")
        print_line(f"  joints       difference at most {most}: {o.joint}, at {o.greatest_joint_rad.time_s:.2f} s")
    for event in o.events[:MAX_EVENTS]:
        when = [f"{t:.2f} s" if t is not None else "never" for t in (event.before_s, event.after_s)]
        print_line(f"  event        {when[0]} -> {when[1]}: {event.text}")
    if len(o.events) > MAX_EVENTS:
        print_line(f"  and {len(o.events) - MAX_EVENTS} more events")


@app.command(
    short_help="List, filter and delete recordings of this machine.",
    epilog="Examples: aftdeck recordings --scenario first-flight --since 2026-11; "
    "aftdeck recordings --participant P07 --json; "
    "aftdeck recordings --ended cut --delete",
)
def recordings(
    scenario: Annotated[str, typer.Option(help="List only recordings of this scenario.")] = "",
    ended: Annotated[
        str,
        typer.Option(
            help="List only recordings with this end: completed, time, fault, stopped, restarted, cut; "
            "or recording, for those that have not ended."
        ),
    ] = "",
    participant: Annotated[str, typer.Option(metavar="CODE", help="List only recordings of this participant.")] = "",
    since: Annotated[
        str,
        typer.Option(
            metavar="DATE", help="List only recordings that began at this time or later (2026-11, 2026-11-21T14)."
        ),
    ] = "",
    gone: Annotated[bool, typer.Option("--gone", help="List only recordings whose files are missing.")] = False,
    forget: Annotated[
        bool, typer.Option("--forget", help="Remove the listed recordings from the list; keep their files.")
    ] = False,
    delete: Annotated[bool, typer.Option("--delete", help="Delete the files of the listed recordings.")] = False,
    yes: Annotated[bool, typer.Option("--yes", help="Delete without confirmation.")] = False,
    as_json: Json = False,
) -> None:
    """List the recordings made on this machine by `run --out` and `fly --record`."""
    from aftdeck.recording.index import Index

    if ended not in ("", *ENDS):
        raise InputError(f"--ended must be one of {', '.join(ENDS)}, got {ended!r}")
    since = since.replace(" ", "T")
    if not _SINCE.fullmatch(since):
        raise InputError(
            f"--since must be a year, month, day or time, such as 2026, 2026-11 or 2026-11-21T14:30, got {since!r}"
        )
    if forget and delete:
        raise InputError("--forget and --delete cannot be combined")
    index = Index()
    entries = index.entries(scenario, ended, since, participant)
    if gone:
        entries = [entry for entry in entries if entry.state == "gone"]
    if as_json:
        print_json(entries)
    else:
        _print_entries(entries)
    if forget:
        index.forget(entries)
        print_line(f"{len(entries)} removed from the list; their files were kept", sys.stderr)
    elif delete and entries and (yes or typer.confirm(f"Delete {_files(entries)}?", err=True)):
        index.delete(entries)
        print_line(f"{_files(entries)} deleted", sys.stderr)


def _print_entries(entries: list[Entry]) -> None:
    from aftdeck.recording.delays import Delays

    if not entries:
        print_line("no recordings found; record with `aftdeck fly --record DIR` or `aftdeck run SCENARIO --out FILE`")
        return
    width = max(len(visible(entry.scenario)) for entry in entries)
    for entry in entries:
        ended = entry.ended if entry.state == "here" else entry.state
        began = entry.began[:19].replace("T", " ")
        scenario, size = visible(entry.scenario), entry.bytes / 1e6
        print_line(f"{began}  {scenario:<{width}}  {ended:<10}  {entry.time_s:>8.1f} s  {size:>7.2f} MB")
        print_line(f"  {entry.path}")
        for name in ("participant", "condition", "changes"):
            if text := getattr(entry, name):
                print_line(f"  {name:<11}  {text}")
        if entry.late_steps:
            delays = Delays(entry.late_steps, entry.worst_s or 0.0, entry.lost_s or 0.0)
            print_line(f"  delays       {delays.text()}")


def _files(entries: list[Entry]) -> str:
    """Return the number of recordings and the size of their files: ``2 recordings, 5.1 MB``."""
    return f"{len(entries)} recording{'s' if len(entries) != 1 else ''}, {sum(e.bytes for e in entries) / 1e6:.1f} MB"
