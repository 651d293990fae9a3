"""Constants of arm and worksite in a run."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from aftdeck.arrays import Array, Indices, Mask
from aftdeck.bodies.pose import POSE
from aftdeck.flat import block, line
from aftdeck.law import law
from aftdeck.lent import lend_line
from aftdeck.simulation.row import scalars
from aftdeck.simulation.row.now import FIXED, TABLES, Flat, table
from aftdeck.worksite.berths.berth import Fit
from aftdeck.worksite.berths.port import PortFit
from aftdeck.worksite.capture.bar import HEXES, Bar
from aftdeck.worksite.capture.snares import WIDEST, Snares
from aftdeck.worksite.watch.groups import PackedLayout

if TYPE_CHECKING:
    from aftdeck.simulation.constants.flight import Flight


class World(NamedTuple):
    """Constants of arm and worksite, besides those of the monitored pairs.

    Attributes:
        constants: single values, at the indices of `scalars`.
        joints: `Frames.joints`.
        scene: `Site.scene`.
        axes: `Site.axes`.
        stops: (n, 2) hard stops [rad].
        reach: (n, 2) reach limits [rad].
        soft: (n, 2) soft stops [rad].
        links: the arm's links.
        bay: (2, 3) `Site.bay`; (0, 3) without a bay.
        effector: (12,) `Site.effector`.
        fixtures: (c, 12) `Snares.fixtures`, NaN for a payload without one; (0, 12) without snares.
        tolerances: (5,) `Bar.packed`; (0,) without a prong.
        snare_times: (3,) `SnareTimes.packed`; (0,) without snares.
        places: (b, 12) `Site.berth_places` of all payloads, one after the other.
        ports: (b, 38) `PortFit` of each of these berths, packed (`PORT` to `ONLY_Y`); of other kinds the tolerances.
        probes: (p, 3) `PortFit.probe` of these berths, one after the other [m].
        bars: (c, 4) `Bar.bars`; (0, 4) without a prong.
        rows: (c,) `Site.payload_rows`.
        bodies: `Site.bodies` of all payloads, one after the other.
        body_begins: (c + 1,) index in `bodies` of each payload's first solid.
        berths: (b,) `Site.berth_rows` of all payloads, one after the other.
        berth_begins: (c + 1,) index in `berths` of each payload's first berth.
        by_itself: (b,) 1 for a berth that closes by itself.
        probe_begins: (b + 1,) index in `probes` of each berth's first vertex.
        meetings: `Site.meeting_groups`.
        hand: (1,) `Site.last_joint`.
        by_prong: `Site.by_prong`.
        task: (g,) `Site.essential`.
        detrimental: `Site.detrimental`.
        aligns: `Site.meeting_aligns`.
        slides: (c, g) `Site.slides`.
        of_payload: (c, g) `Site.of_payload`.
    """

    constants: Array
    joints: Array
    scene: Array
    axes: Array
    stops: Array
    reach: Array
    soft: Array
    links: Array
    bay: Array
    effector: Array
    fixtures: Array
    tolerances: Array
    snare_times: Array
    places: Array
    ports: Array
    probes: Array
    bars: Indices
    rows: Indices
    bodies: Indices
    body_begins: Indices
    berths: Indices
    berth_begins: Indices
    by_itself: Indices
    probe_begins: Indices
    meetings: Indices
    hand: Indices
    by_prong: Mask
    task: Mask
    detrimental: Mask
    aligns: Mask
    slides: Mask
    of_payload: Mask


PORT, ENVELOPE, TIP, MOST, MOST_ANGLE, ONLY_Y = 0, 12, 32, 35, 36, 37
"""Indices in a row of `World.ports`: pose of the port in its frame, planes of its docking envelope, centre of the
probe's face [m]; greatest distance [m] and angle [rad] at which the port docks the payload; 1 if only y axes count."""
PORT_SIZE = 38
ROUNDING = 1e-9
"""Added to a limit below which a measured length is never rejected [m]: more than a rounding error."""
WORLD_NUMBERS, WORLD_INDICES, WORLD_MARKS = 16, 10, 6
"""Number of fields of `World` that are float64, int64 and uint8."""


def world_arrays(flight: Flight) -> World:
    """Return the constants of a run as separate arrays."""
    site, scenario = flight.site, flight.scenario
    payloads, groups, device = len(site.payloads), len(site.layout.groups), site.capture
    bar = device if isinstance(device, Bar) else None
    snares = device if isinstance(device, Snares) else None
    constants = np.zeros(scalars.CONSTANTS)
    constants[scalars.PERIOD], constants[scalars.WITHIN] = scenario.control_period, flight.within
    constants[scalars.TELESCOPE_LOW : scalars.PRONG_LOW] = flight.telescope
    constants[scalars.PRONG_LOW : scalars.FIXED_FINGER] = flight.prong
    if bar is not None:
        constants[scalars.FIXED_FINGER], constants[scalars.SPACING] = bar.fixed_finger, bar.tolerances.spacing
    constants[scalars.SINGULAR] = scenario.arm.model.singular
    constants[scalars.KEEPS_CLOCK], constants[scalars.INHIBITS] = scenario.strict, flight.inhibits
    constants[scalars.RADIUS] = -1.0 if snares is None else WIDEST * snares.envelope.radial + ROUNDING
    if (rule := site.worksite.translation) is not None:
        constants[scalars.ORBITER_SPEED], constants[scalars.ORBITER_REACHED_IN] = rule.speed, rule.reached_in
    fits = [fit for own in site.fits for fit in own]
    probes = [fit.probe if isinstance(fit, PortFit) else np.zeros((0, 3)) for fit in fits]

    def begins(lists: Sequence[NDArray[Any]]) -> Indices:
        return np.cumsum([0, *map(len, lists)], dtype=np.int64)

    def joined(lists: tuple[Indices, ...]) -> Indices:
        return np.concatenate([np.zeros(0, np.int64), *lists])

    limits = scenario.arm.model.limits
    return World(
        constants,
        site.arm.joints,
        site.scene,
        site.axes,
        limits.hard,
        limits.reach,
        limits.soft,
        scenario.arm.model.links,
        np.zeros((0, 3)) if site.bay is None else site.bay,
        site.effector,
        np.zeros((0, POSE)) if snares is None else _fixtures(snares),
        np.zeros(0) if bar is None else bar.packed,
        np.zeros(0) if snares is None else snares.times.packed,
        np.array([fit.place for fit in fits]).reshape(-1, POSE),
        np.array([_port(fit) for fit in fits]).reshape(-1, PORT_SIZE),
        np.concatenate([np.zeros((0, 3)), *probes]),
        np.zeros((0, len(HEXES) + 1), np.int64) if bar is None else bar.bars,
        np.array(site.payload_rows, np.int64),
        joined(site.bodies),
        begins(site.bodies),
        joined(site.berth_rows),
        begins(site.berth_rows),
        np.array([fit.berth.closes == "by itself" for fit in fits], np.int64),
        begins(probes),
        site.meeting_groups,
        np.array([site.last_joint], np.int64),
        site.by_prong,
        site.essential,
        site.detrimental,
        site.meeting_aligns,
        np.array(site.slides, np.uint8).reshape(payloads, groups),
        np.array(site.of_payload, np.uint8).reshape(payloads, groups),
    )


def _port(fit: Fit) -> Array:
    """Return a packed `PortFit` (38,); for a berth of another kind zeros and its tolerances."""
    row = np.zeros(PORT_SIZE)
    row[MOST], row[MOST_ANGLE] = fit.berth.distance, fit.berth.angle
    if isinstance(fit, PortFit):
        row[PORT:ENVELOPE], row[ENVELOPE:TIP] = fit.pose, fit.berth.envelope.ravel()
        row[TIP:MOST] = fit.tip
        row[ONLY_Y] = fit.tolerances.axes == "y"
    return row


def _fixtures(snares: Snares) -> Array:
    """Return the poses (c, 12) of the payloads' fixtures, NaN for a payload without one."""
    nothing = np.full(POSE, np.nan)
    return np.array([nothing if one is None else one for one in snares.fixtures]).reshape(-1, POSE)


@law
def rest_of(fixed_indices: Indices) -> Indices:
    """Return the constants' indices after the tables."""
    begin = fixed_indices[TABLES]
    return lend_line(fixed_indices, begin, len(fixed_indices) - begin)


@law
def world_of(flat: Flat) -> World:
    """Return the constants of arm and worksite."""
    numbers, marks, rest = flat.fixed_numbers, flat.fixed_marks, rest_of(flat.fixed_indices)
    own, whole = table(flat.fixed_indices, FIXED), table(flat.fixed_indices, FIXED + 1)
    flags = table(flat.fixed_indices, FIXED + 2)
    return World(
        line(numbers, own, 0), block(numbers, own, 1), line(numbers, own, 2), block(numbers, own, 3),
        block(numbers, own, 4), block(numbers, own, 5), block(numbers, own, 6), line(numbers, own, 7),
        block(numbers, own, 8), line(numbers, own, 9), block(numbers, own, 10), line(numbers, own, 11),
        line(numbers, own, 12), block(numbers, own, 13), block(numbers, own, 14), block(numbers, own, 15),
        block(rest, whole, 0), line(rest, whole, 1), line(rest, whole, 2), line(rest, whole, 3), line(rest, whole, 4),
        line(rest, whole, 5), line(rest, whole, 6), line(rest, whole, 7), line(rest, whole, 8), line(rest, whole, 9),
        line(marks, flags, 0), line(marks, flags, 1), line(marks, flags, 2), line(marks, flags, 3),
        block(marks, flags, 4), block(marks, flags, 5),
    )  # fmt: skip


@law
def pairs_of(flat: Flat) -> PackedLayout:
    """Return the monitored pairs."""
    numbers, rest = flat.fixed_numbers, rest_of(flat.fixed_indices)
    own, whole = table(flat.fixed_indices, FIXED), table(flat.fixed_indices, FIXED + 1)
    return PackedLayout(
        block(numbers, own, WORLD_NUMBERS), line(rest, whole, WORLD_INDICES), block(rest, whole, WORLD_INDICES + 1),
        line(rest, whole, WORLD_INDICES + 2), block(rest, whole, WORLD_INDICES + 3),
        line(numbers, own, WORLD_NUMBERS + 1),
    )  # fmt: skip
