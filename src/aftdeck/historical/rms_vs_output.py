"""TABLE II of the Remote Manipulator Simulation: the 32 words that the program sent to the scene generator.

The control word contains the selected camera and the positions of the operator's switches in the step (subroutine
READADC). The program detects the limits of telescope and prong (section VI.E): a switch that drives one of them against
its limit has no bit. It also has none if anything but an inhibit stops the part. Under an inhibit the switch has its
bit, and the scene generator obeys the inhibit's flag. Angles, inhibits and task phase (mode) are values after the step.

D1 to D3 are planes between the end effector's hexahedra and the bar. While no payload is held, they are the separating
planes of the collision test. While a payload is held, they are the planes of face d of HEX 1, face b of HEX 2 and
face e of HEX 3 (subroutines CALSP1 to CALSP3).
"""

from __future__ import annotations

from typing import Literal, NamedTuple, cast

from aftdeck.arrays import Array
from aftdeck.bodies.hexahedron import NX, NY, NZ, D
from aftdeck.historical.frame_words import STATIONS, ControlWord, Direction, FrameBlock, WordPlane, direction_of
from aftdeck.historical.rms_vs_input import PRONG_DIRECTIONS
from aftdeck.simulation.camera_drives import CameraDrive
from aftdeck.simulation.constants.flight import Flight
from aftdeck.simulation.constants.site import Site
from aftdeck.simulation.inputs import Inputs
from aftdeck.simulation.observe.look_work import all_near
from aftdeck.simulation.parts.worksite_state import WorksiteState
from aftdeck.simulation.state import State
from aftdeck.units import FOOT
from aftdeck.worksite.capture.bar import HEXES, Bar

INNER = (3, 1, 4)
"""Indices, from 0, of face d of HEX 1, face b of HEX 2 and face e of HEX 3. These faces are next to a held bar."""
NO_CODE = "A"
"""Station in the control word if the commanded camera has no code. Its code is 0000, as for a disabled function."""
FARTHEST = 2.0**11 * FOOT
"""Greatest distance that a word can hold at scale B11, the report's scale for distances [m]."""

Planes = tuple[WordPlane | None, WordPlane | None, WordPlane | None]


class Places(NamedTuple):
    """Positions before or after a step: they show whether a switch has moved its part.

    Attributes:
        stand: length of the telescope [m].
        prong: position of the prong [m].
    """

    stand: float
    prong: float


class Block(NamedTuple):
    """Data of one step for the scene generator.

    Attributes:
        block: the block of TABLE II.
        unsaid: names of values that TABLE II cannot express.
    """

    block: FrameBlock
    unsaid: tuple[str, ...]


def places_of(state: State) -> Places:
    """Return the positions in a state."""
    return Places(state.plant.stand.position, state.worksite.prong.position)


def block_of(flight: Flight, state: State, flown: Inputs, before: Places) -> Block:
    """Return the frame block after a step.

    Args:
        flight: constants of the run.
        state: state after the step.
        flown: inputs of the step.
        before: positions before the step.
    """
    worksite, now, unsaid = state.worksite, places_of(state), []
    initialised = any(event.kind == "initialise" for event in state.events)
    if initialised:  # a change of position by initialisation is not a motion
        before = now
    station = state.panel.camera or NO_CODE
    drive = flown.camera or CameraDrive(station)
    pan, tilt = direction_of(drive.pan), direction_of(drive.tilt)
    if pan * tilt < 0:
        unsaid.append("tilt")  # TABLE II has one sign bit for pan and tilt
        tilt = 0
    inhibit = worksite.contacts.inhibit
    if station not in STATIONS:
        unsaid.append("station")
    control = ControlWord(
        mode=cast("Literal[1, 2, 3, 4]", worksite.task),
        station=station if station in STATIONS else NO_CODE,
        initialise=initialised,
        telescope=_bits(direction_of(flown.telescope), now.stand != before.stand or inhibit.arm),
        pan=pan,
        tilt=tilt,
        zoom=direction_of(drive.zoom),
        prong=_bits(PRONG_DIRECTIONS[worksite.switch], now.prong != before.prong or inhibit.finger),
        finger_inhibited=inhibit.finger,
        arm_inhibited=inhibit.arm,
    )
    planes = list(planes_of(flight.site, state.worksite, flight.scenario.control_period))
    for k, plane in enumerate(planes):
        if plane is not None and abs(plane.distance) > FARTHEST:
            unsaid.append(f"D{k + 1}")
            planes[k] = None
    ho, po, p1, h2, p2, r2 = state.plant.angles.tolist()
    return Block(FrameBlock(control, (ho, po, p1, h2, p2, r2), cast("Planes", tuple(planes))), tuple(unsaid))


def _bits(switch: Direction, free: bool) -> Direction:
    """Return a switch's direction in the control word; `free`: its part has moved, or only an inhibit stops it."""
    return switch if free else 0


def planes_of(site: Site, worksite: WorksiteState, period: float) -> Planes:
    """Return D1 to D3 in R. A plane is None if there is no bar, or if hexahedron and bar collide."""
    bar, held = site.capture, worksite.held
    if isinstance(bar, Bar) and held is not None and (solids := bar.solids(held)) is not None:
        d1, d2, d3 = (_face(worksite.watch.placed[solid], face) for solid, face in zip(solids, INNER, strict=False))
        return d1, d2, d3
    near = [
        pair for pair in all_near(site.layout, worksite, period) if pair.a in HEXES and pair.b.endswith("receptacle")
    ]
    nearest = next((pair.b for pair in near if pair.a == HEXES[0]), None)
    pairs = {pair.a: pair for pair in near if pair.b == nearest and any(pair.normal)}
    first, second, third = (
        WordPlane(pairs[name].normal, pairs[name].distance) if name in pairs else None for name in HEXES
    )
    return first, second, third


def _face(body: Array, face: int) -> WordPlane:
    """Return the plane of a solid's face; the normal points outwards."""
    return WordPlane((float(body[NX + face]), float(body[NY + face]), float(body[NZ + face])), float(body[D + face]))
