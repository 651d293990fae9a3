"""Constants of alignment: payloads before berths, probes before ports, trunnions over guides, pins before snares."""

from __future__ import annotations

from typing import TYPE_CHECKING, NamedTuple, get_args

import numpy as np

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.flat import block, line
from aftdeck.law import law
from aftdeck.simulation.row.now import FIXED, Flat, table
from aftdeck.simulation.row.on_way import PLACES
from aftdeck.simulation.row.world import WORLD_INDICES, WORLD_MARKS, WORLD_NUMBERS, rest_of
from aftdeck.worksite.berths.bay import GuidedFit
from aftdeck.worksite.berths.berthing import Guides, prepare
from aftdeck.worksite.capture.snares import Snares
from aftdeck.worksite.relation import Relation

if TYPE_CHECKING:
    from aftdeck.simulation.constants.flight import Flight


class Aligning(NamedTuple):
    """Constants of alignment; m meetings, b berths of all payloads one after the other, t trunnions of these berths.

    Attributes:
        outs: (b, 3) `Fit.way_out`.
        on_way: (b * PLACES, g) `least_on_way` of each berth [m]; NaN until it is needed (`constants.learn_way`).
        depths: (m,) `Meeting.depth` [m].
        trunnions: (t, 3) `GuidedFit.trunnions` [m].
        seats: (t, 3) `Guides.seats` [m].
        axes: (9 t,) `Guides.axes`.
        opening: (t,) `Guides.opening`.
        throat: (t,) `Guides.throat` [m].
        height: (t,) `Guides.height` [m].
        play: (t,) `Guides.play` [m].
        envelope: (6,) `CaptureEnvelope.packed`; (0,) without snares.
        payloads: (m,) `Meeting.payload`.
        relations: (m,) `Meeting.relation`, as its number in `RELATIONS`.
        fits: (b,) `Fit.relation`, as its number; -1 for none.
        guides: (b + 1,) index of each berth's first trunnion.
        meeting_begins: (m + 1,) index of each meeting's first pair of solids in the two fields that follow.
        meeting_pairs: (p, 2) `Meeting.pairs` of all meetings with trunnions.
        meeting_trunnions: (p,) `Meeting.trunnions`.
        seated: (b, g) `Site.seated`.
        grasped: (c, g) `Site.held`.
    """

    outs: Array
    on_way: Array
    depths: Array
    trunnions: Array
    seats: Array
    axes: Array
    opening: Array
    throat: Array
    height: Array
    play: Array
    envelope: Array
    payloads: Indices
    relations: Indices
    fits: Indices
    guides: Indices
    meeting_begins: Indices
    meeting_pairs: Indices
    meeting_trunnions: Indices
    seated: Mask
    grasped: Mask


RELATIONS: tuple[Relation, ...] = get_args(Relation)
ACQUISITION, CAPTURE = RELATIONS.index("acquisition"), RELATIONS.index("capture")
DOCKING, GUIDES = RELATIONS.index("docking"), RELATIONS.index("guides")
ALIGNING_NUMBERS, ALIGNING_INDICES, ON_WAY = 11, 7, 1
"""Number of fields that are float64 and int64; index of `on_way` among the fields."""


def aligning_arrays(flight: Flight) -> Aligning:
    """Return the constants of alignment of a run as separate arrays."""
    site, groups = flight.site, len(flight.site.layout.groups)
    fits = [(k, fit) for k, own in enumerate(site.fits) for fit in own]
    none = np.zeros((0, 3))
    guided: list[tuple[Array, Guides]] = [
        (fit.trunnions, fit.guides) if isinstance(fit, GuidedFit) else (none, prepare(())) for _, fit in fits
    ]
    guides = [own for _, own in guided]

    def joined(arrays: list[Array]) -> Array:
        return np.concatenate([np.zeros(0), *(array.ravel() for array in arrays)])

    return Aligning(
        np.array([fit.way_out for *_, fit in fits]).reshape(-1, 3),
        np.full((len(fits) * PLACES, groups), np.nan),
        np.array([meeting.depth for meeting in site.meetings], np.float64),
        joined([trunnions for trunnions, _ in guided]).reshape(-1, 3),
        joined([own.seats for own in guides]).reshape(-1, 3),
        joined([own.axes for own in guides]),
        joined([own.opening for own in guides]),
        joined([own.throat for own in guides]),
        joined([own.height for own in guides]),
        joined([own.play for own in guides]),
        site.capture.envelope.packed if isinstance(site.capture, Snares) else np.zeros(0),
        np.array([meeting.payload for meeting in site.meetings], np.int64),
        np.array([RELATIONS.index(meeting.relation) for meeting in site.meetings], np.int64),
        np.array([-1 if fit.relation is None else RELATIONS.index(fit.relation) for *_, fit in fits], np.int64),
        np.cumsum([0, *(len(trunnions) for trunnions, _ in guided)], dtype=np.int64),
        np.cumsum([0, *(len(meeting.trunnions) for meeting in site.meetings)], dtype=np.int64),
        np.array(
            [pair for meeting in site.meetings if len(meeting.trunnions) for pair in meeting.pairs.tolist()], np.int64
        ).reshape(-1, 2),
        np.array([t for meeting in site.meetings for t in meeting.trunnions.tolist()], np.int64),
        np.array([site.seated[k, fit.berth.name] for k, fit in fits], np.uint8).reshape(len(fits), groups),
        np.array(site.held, np.uint8).reshape(len(site.held), groups),
    )


@law
def aligning_of(flat: Flat) -> Aligning:
    """Return the constants of alignment; they follow those of `world`."""
    numbers, marks, rest = flat.fixed_numbers, flat.fixed_marks, rest_of(flat.fixed_indices)
    own, whole = table(flat.fixed_indices, FIXED), table(flat.fixed_indices, FIXED + 1)
    flags, n, i, f = table(flat.fixed_indices, FIXED + 2), WORLD_NUMBERS + 2, WORLD_INDICES + 4, WORLD_MARKS
    return Aligning(
        block(numbers, own, n), block(numbers, own, n + 1), line(numbers, own, n + 2), block(numbers, own, n + 3),
        block(numbers, own, n + 4), line(numbers, own, n + 5), line(numbers, own, n + 6), line(numbers, own, n + 7),
        line(numbers, own, n + 8), line(numbers, own, n + 9), line(numbers, own, n + 10),
        line(rest, whole, i), line(rest, whole, i + 1), line(rest, whole, i + 2), line(rest, whole, i + 3),
        line(rest, whole, i + 4), block(rest, whole, i + 5), line(rest, whole, i + 6),
        block(marks, flags, f), block(marks, flags, f + 1),
    )  # fmt: skip
