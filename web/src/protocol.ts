// Generated from station/from_page.py, to_page.py and playback.py by `make generate`; do not edit.
// All quantities are SI and radians; see there for frames.

export const PROTOCOL = 3;

export type Vec2 = readonly [number, number];
export type Vec3 = readonly [number, number, number];
export type Axis = 'x' | 'y' | 'z';
export type Material = 'blanket' | 'liner' | 'tiles' | 'leading_edge' | 'radiator' | 'boom' | 'padding' | 'housing' | 'bright' | 'dark' | 'glass' | 'metal' | 'foil' | 'structure' | 'glow';
export type Shape = Box | Cylinder | Shell | Ring | Sphere | Plate | Loft | Hexahedron | Light | Group;
export type Six = readonly [number, number, number, number, number, number];
export type Quat = readonly [number, number, number, number];
export type Rate = 'coarse' | 'vernier';
export type LawChoice = 'position' | 'closed loop' | 'open loop';
export type Level = 'info' | 'caution' | 'warning';
export type EffectorSwitch = 'stop' | 'close' | 'open';
export type ProblemPart = 'full problem' | 'acquisition' | 'extraction' | 'manoeuvring';
export type ControllerKind = 'keyboard' | 'pad' | 'thc pad' | 'rhc pad' | 'thc joystick' | 'rhc joystick' | 'spacemouse' | 'touch';
export type FromPage = Sticks | Shown | Controllers | DriveCamera | SetLight | EnterMode | SelectJoint | SelectRate | SelectLaw | PayloadAxes | RateHold | PositionHold | AskSticks | GiveSticks | KeepSticks | SetName | LeaveSeat | TakeSeat | HandsOff | LookAhead | SetBrakes | SetSafing | SetTarget | Proceed | Stop | Restart | FlyScenario | SetEffector | SetEffectorMode | SetRigid | PressLatch | SetMaster | Initialise;
export type LimitKind = 'joint rate' | 'soft stop' | 'hard stop' | 'singularity' | 'joint acceleration' | 'POR translation' | 'POR rotation' | 'POR acceleration' | 'seat' | 'contact' | 'switch';
export type FlightLamp = 'SINGULAR' | 'REACH LIM' | 'SOFT STOP' | 'RATE LIM' | 'CLEARANCE' | 'DERIGIDIZE' | 'RELEASE';
export type FromServer = Welcome | Scenarios | Role | Frame | Events | Recent | Refused;
export type Quantity = 'time' | 'count' | 'share' | 'part of limit' | 'ratio' | 'length' | 'gap' | 'distance' | 'angle' | 'speed' | 'turn rate' | 'milliseconds' | 'words';
export type Block = readonly Moment[];

/** A box about its centre. */
export interface Box {
  readonly kind: 'box';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  /** Edges along x, y, z [m]. */
  readonly size: Vec3;
}

/** A solid cylinder or truncated cone about its centre. */
export interface Cylinder {
  readonly kind: 'cylinder';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly axis: Axis;
  readonly length: number;
  /** At the end of smaller axis coordinate [m]. */
  readonly radius: number;
  /** At the other end [m]; as `radius` where not given. */
  readonly radius_end: number | null;
}

/**
 * A wall bent round an axis: tube, nozzle, door, or, where it is as thick as its radius, a piece of disc.
 *
 * Angles run from y to z about axis x, from z to x about y, from x to y about z.
 */
export interface Shell {
  readonly kind: 'shell';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly axis: Axis;
  readonly length: number;
  /** Outer, at the end of smaller axis coordinate [m]. */
  readonly radius: number;
  /** Outer, at the other end [m]; as `radius` where not given. */
  readonly radius_end: number | null;
  readonly thickness: number;
  readonly start: number;
  readonly sweep: number;
}

/** A round bar bent about an axis, a full turn or part of one; angles as in `Shell`. */
export interface Ring {
  readonly kind: 'ring';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly axis: Axis;
  /** Of the bar's middle line [m]. */
  readonly radius: number;
  /** Radius of the bar [m]. */
  readonly bar: number;
  readonly start: number;
  readonly sweep: number;
}

/** A sphere. */
export interface Sphere {
  readonly kind: 'sphere';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly radius: number;
}

/** A flat outline given thickness, half to each side of the plane through its position. */
export interface Plate {
  readonly kind: 'plate';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly normal: Axis;
  /** Corners in order, not closed, as (y, z), (x, z) or (x, y) for normal x, y or z [m]. */
  readonly outline: readonly Vec2[];
  readonly thickness: number;
  /** How far the rims are cut back, at most half the thickness [m]. */
  readonly bevel: number;
}

/** A skin over cross-sections along x, closed at both ends. */
export interface Loft {
  readonly kind: 'loft';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  /** In order of growing x. */
  readonly sections: readonly Section[];
}

/**
 * A rounded cross-section of a loft: an upper and a lower half of a superellipse.
 *
 * Its points satisfy |y/half_width|^n + |z/height|^n = 1 about `middle`, n being the exponent of its half:
 * 2 is an ellipse, 5 nearly a rectangle.
 */
export interface Section {
  readonly x: number;
  readonly half_width: number;
  readonly top: number;
  readonly middle: number;
  readonly bottom: number;
  /** Of the upper and of the lower half. */
  readonly exponents: Vec2;
}

/** A body of eight vertices and six flat faces, numbered as in `aftdeck.bodies.hexahedron`. */
export interface Hexahedron {
  readonly kind: 'hexahedron';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  /** Numbered v - 1 = 4 (on the +y side) + 2 (+x) + 1 (+z), in axes of the body's own [m]. */
  readonly vertices: readonly Vec3[];
}

/** A lamp: a round face that looks along its own x and lights what lies before it. */
export interface Light {
  readonly kind: 'light';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly radius: number;
  /** Half angle of its beam [rad]; above pi/2 it shines all round. */
  readonly cone: number;
  /** How far it lights [m]. */
  readonly reach: number;
  /** On its axis [cd], in the scale in which the sun gives 4.1 lx. */
  readonly intensity: number;
  /** Which switch of the panel lights it, with others of that name. */
  readonly switch: string;
}

/** Shapes that share a place; drawn once, or several times in even steps, or also mirrored. */
export interface Group {
  readonly kind: 'group';
  /** [m] */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly shapes: readonly Shape[];
  /** How many copies. */
  readonly count: number;
  /** From a copy to the next, along the group's own axes [m]. */
  readonly step: Vec3;
  /** From a copy to the next, about the group's own axes, as a `rotation` [rad]. */
  readonly turn: Vec3;
  /** Draw all once more, reflected in the plane y = 0 of the frame that the group is listed in. */
  readonly mirror: boolean;
}

/**
 * Where the hand controllers stand, after deadband and expo, each axis in [-1, 1].
 *
 * Sent whenever they change and at least every 0.2 s while they are deflected or RATE HOLD keeps a rate: sticks
 * that have been silent for 0.5 s return to zero, and nobody is held to be at the controls (`HandsOff`).
 */
export interface Sticks {
  readonly type: 'sticks';
  /** Grows with every message of a page; an older one is refused. */
  readonly seq: number;
  /** THC: +X, +Y, +Z of the present control frame. */
  readonly translation: Vec3;
  /** RHC: roll about +X, pitch about +Y, yaw about +Z of the present control frame. */
  readonly rotation: Vec3;
  /** SINGLE/DIRECT DRIVE switch: + or - for the selected joint (modes SINGLE and DIRECT). */
  readonly drive: number;
  /** The stand: + longer, - shorter, in [-1, 1]. */
  readonly telescope: number;
  /** Translation of the orbiter: forward, starboard, down, each in [-1, 1]. */
  readonly orbiter: Vec3;
}

/** What the page measures of itself and shows, told once a second and when it changes; for recording and strips. */
export interface Shown {
  readonly type: 'shown';
  readonly seq: number;
  /** Stick to picture, 95th percentile of the last 10 s [ms]. */
  readonly latency_ms: number | null;
  /** What MON 1 and MON 2 show. */
  readonly monitors: readonly (readonly string[])[];
}

/** The hand controllers in use, told when the page begins to fly and whenever they change; for the recording. */
export interface Controllers {
  readonly type: 'controllers';
  readonly seq: number;
  readonly controllers: readonly ControllerInUse[];
}

/** A device that moves the hand controllers, and what each part of it is put to. */
export interface ControllerInUse {
  readonly kind: ControllerKind;
  /** As the browser calls it. */
  readonly name: string;
  /** Part of an axis' travel about its centre that counts as zero. */
  readonly deadband: number;
  /** 0 straight, 1 the cube: (1 - expo) x + expo x**3 of what is left beyond the deadband. */
  readonly expo: number;
  /** What is pressed or moved, and what it does: `KeyW +X`, `a1 -X`, `b9+b12 +telescope`. */
  readonly bindings: readonly string[];
  /** Where each axis rests, as the operator has confirmed; beyond the last: 0. */
  readonly centres: readonly number[];
}

/** The switches that turn a camera, each in [-1, 1]; sent and forgotten as `Sticks` are. */
export interface DriveCamera {
  readonly type: 'drive_camera';
  readonly seq: number;
  readonly camera: string;
  /** To the right in the picture. */
  readonly pan: number;
  /** Upwards. */
  readonly tilt: number;
  /** In, to a narrower field of view. */
  readonly zoom: number;
  /** At the low speed, where the drive has two. */
  readonly slow: boolean;
}

/** How the light shall stand from now on, as a whole; it is no input of the flight, and is recorded. */
export interface SetLight {
  readonly type: 'set_light';
  readonly seq: number;
  readonly lighting: Lighting;
}

/** How the light stands. */
export interface Lighting {
  /** As `LightCondition.name`. */
  readonly condition: string;
  /** The switches that are on. */
  readonly lamps: readonly string[];
  readonly locked: readonly LockedExposure[];
}

/** A camera that does not follow its picture's brightness. */
export interface LockedExposure {
  readonly camera: string;
  /** Its exposure [stops over that of full sunlight]. */
  readonly stops: number;
}

/** Turn the MODE rotary to a position and press ENTER. */
export interface EnterMode {
  readonly type: 'enter_mode';
  readonly seq: number;
  /** A panel position, as `ModeInfo.position`. */
  readonly mode: string;
}

/** Turn the JOINT rotary. */
export interface SelectJoint {
  readonly type: 'select_joint';
  readonly seq: number;
  /** 0 to 5, in the order of `Welcome.joints`. */
  readonly joint: number;
}

/** Set the COARSE/VERNIER switch. */
export interface SelectRate {
  readonly type: 'select_rate';
  readonly seq: number;
  readonly rate: Rate;
}

/** Set the switch beside OPR CMD and AUTO 1-4: which of the report's modes 1 to 3 they fly. */
export interface SelectLaw {
  readonly type: 'select_law';
  readonly seq: number;
  readonly law: LawChoice;
}

/** Set the switch beside ORB LD: rotate in payload axes (mode 7) or in orbiter axes (mode 4). */
export interface PayloadAxes {
  readonly type: 'payload_axes';
  readonly seq: number;
  readonly on: boolean;
}

/** Press RATE HOLD: keep the present stick command; pressed again, let it go. */
export interface RateHold {
  readonly type: 'rate_hold';
  readonly seq: number;
}

/** Set POSITION HOLD: with sticks at rest, keep position and attitude. */
export interface PositionHold {
  readonly type: 'position_hold';
  readonly seq: number;
  readonly on: boolean;
}

/** A page that watches wants to fly; the one that flies gives or keeps within 10 s. */
export interface AskSticks {
  readonly type: 'ask_sticks';
  readonly seq: number;
}

/** Give the sticks, which are at rest, to the page that asks. */
export interface GiveSticks {
  readonly type: 'give_sticks';
  readonly seq: number;
}

/** Keep the sticks; the page that asks is told. */
export interface KeepSticks {
  readonly type: 'keep_sticks';
  readonly seq: number;
}

/** What the person at this page is called from now on, to the other pages and in the log. */
export interface SetName {
  readonly type: 'set_name';
  readonly seq: number;
  /** One line of 24 characters at most; empty: the page goes by its number again. */
  readonly name: string;
}

/** The page has become too narrow to fly from: it shows the flight from now on, and the next page flies. */
export interface LeaveSeat {
  readonly type: 'leave_seat';
  readonly seq: number;
}

/** The page is wide enough to fly from again: it flies if nobody else does, and else watches. */
export interface TakeSeat {
  readonly type: 'take_seat';
  readonly seq: number;
}

/** Nobody is at the controls: sticks at rest, RATE HOLD let go, POSITION HOLD on; a sequence goes on. */
export interface HandsOff {
  readonly type: 'hands_off';
  readonly seq: number;
  readonly cause: 'page hidden' | 'device lost';
}

/** How far to look ahead. */
export interface LookAhead {
  readonly type: 'look_ahead';
  readonly seq: number;
  /** [s] */
  readonly seconds: number;
}

/** Set BRAKES: on, every joint stands at once. */
export interface SetBrakes {
  readonly type: 'brakes';
  readonly seq: number;
  readonly on: boolean;
}

/** Set SAFING: on, zero joint rates are commanded; off is its CANCEL. */
export interface SetSafing {
  readonly type: 'safing';
  readonly seq: number;
  readonly on: boolean;
}

/** Key in the end position and attitude of OPR CMD (SPEC 94 items 18-23), in panel components. */
export interface SetTarget {
  readonly type: 'set_target';
  readonly seq: number;
  /** X, Y, Z [m]. */
  readonly position: Vec3;
  /** Pitch, yaw, roll [rad]. */
  readonly attitude: Vec3;
}

/** AUTO SEQ switch to PROCEED. */
export interface Proceed {
  readonly type: 'proceed';
  readonly seq: number;
}

/** AUTO SEQ switch to STOP; sticks go to zero too. */
export interface Stop {
  readonly type: 'stop';
  readonly seq: number;
}

/** Put the scenario back to its first instant. */
export interface Restart {
  readonly type: 'restart';
  readonly seq: number;
}

/** Leave this flight and fly another scenario; what is recorded of this one is finished and kept. */
export interface FlyScenario {
  readonly type: 'fly_scenario';
  readonly seq: number;
  /** Its place in `Scenarios.scenarios`. */
  readonly number: number;
}

/** Put the end effector's switch: the prong closes or opens; the snares capture or release. */
export interface SetEffector {
  readonly type: 'effector';
  readonly seq: number;
  readonly switch: EffectorSwitch;
}

/** END EFFECTOR MODE of the snares: the whole sequence, or the snares alone. */
export interface SetEffectorMode {
  readonly type: 'effector_mode';
  readonly seq: number;
  readonly mode: 'auto' | 'manual';
}

/** END EFFECTOR MAN CONTR: the carriage alone, in manual. */
export interface SetRigid {
  readonly type: 'rigid';
  readonly seq: number;
  readonly rigid: 'off' | 'rigid' | 'derigid';
}

/** Hold the payload in its seat (retention latches, docking port), or let it go. */
export interface PressLatch {
  readonly type: 'latch';
  readonly seq: number;
  readonly latch: 'latch' | 'unlatch';
}

/** Put the master arm, which MASTER follows. */
export interface SetMaster {
  readonly type: 'master';
  readonly seq: number;
  /** [rad] */
  readonly angles: Six;
}

/** Put arm and payload back to where a part of the problem begins. */
export interface Initialise {
  readonly type: 'initialise';
  readonly seq: number;
  readonly part: ProblemPart;
}

/** Answer to `Hello`: all that a page needs to know once. */
export interface Welcome {
  readonly type: 'welcome';
  readonly protocol: number;
  readonly version: string;
  readonly scenario: string;
  readonly title: string;
  /** What the scenario asks of the operator, a sentence or two. */
  readonly text: string;
  readonly arm: string;
  readonly control_period_s: number;
  /** How long a command is under way before the arm has it [s]. */
  readonly command_delay_s: number;
  /** So late the page shows figures, lamps and log [s]. */
  readonly telemetry_delay_s: number;
  /** So late it shows pictures [s]. */
  readonly camera_delay_s: number;
  /** The arm file's preference for the panel's read-outs. */
  readonly units: 'ft-in' | 'SI';
  readonly joints: readonly JointInfo[];
  readonly modes: readonly ModeInfo[];
  readonly bodies: readonly BodyInfo[];
  /** Indices of the bodies that `Frame.ahead` tells of. */
  readonly ghost: readonly number[];
  readonly cameras: readonly Camera[];
  readonly work: WorkInfo;
  /** Where sun and Earth can stand. */
  readonly conditions: readonly LightCondition[];
  /** Switches of the lamps that are there. */
  readonly lamps: readonly string[];
  /** By PL ID, from 0. */
  readonly payloads: readonly PayloadInfo[];
  readonly sequences: readonly StoredSequence[];
  /** Normalised distance under which a singularity is cautioned of. */
  readonly singular: number;
  /** Names of the script's phases in order, as in `Frame.phase`; empty where the scenario has none. */
  readonly phases: readonly string[];
}

/** One joint of the arm flown: names, limits [rad] and rate limits [rad/s]. */
export interface JointInfo {
  /** As in the arm file: `shoulder_yaw`. */
  readonly name: string;
  /** As on the page: `Sho yaw`. */
  readonly label: string;
  /** The axis of the hand controllers that turns the master arm's: `THC Y`. */
  readonly stick: string;
  readonly hard: Vec2;
  readonly soft: Vec2;
  readonly reach: Vec2;
  readonly coarse: number;
  readonly vernier: number;
  readonly servo: number;
}

/** One position of the MODE rotary. */
export interface ModeInfo {
  /** As printed on the panel: `ORB UNL`. */
  readonly position: string;
  /** The report's mode numbers that it can fly, the default first; 0 TEST, 9 DIRECT, 10 MASTER. */
  readonly laws: readonly number[];
  /** What it flies, in a few words. */
  readonly title: string;
  readonly kind: 'automatic' | 'manual' | 'single' | 'test' | 'master';
  /** The point that it moves: `tip`, `payload`. */
  readonly point: string;
  /**
   * Whether this scenario has what it needs, as AUTO 1-4 their points. Those that move a payload need one in the
   * grasp as well.
   */
  readonly enabled: boolean;
  /** The axes that the sticks act along: `orbiter axes`. */
  readonly axes: string;
  /** What + means for the THC: `+X fwd`, `+Y stbd`, `+Z down`. */
  readonly axis_names: readonly [string, string, string];
}

/** A rigid body to draw; its pose is found in `Frame.poses` at its index in `Welcome.bodies`. */
export interface BodyInfo {
  readonly name: string;
  readonly shapes: readonly Shape[];
}

/** A television camera on a body, as it is set at the start; or an eye that looks from there. */
export interface Camera {
  /** Short name on the selector: `B`. */
  readonly name: string;
  /** `Aft bulkhead port`. */
  readonly title: string;
  /** Name of the body that carries it. */
  readonly body: string;
  /** Lens, in the body's frame [m]. */
  readonly position: Vec3;
  /** Direction of view in the body's frame (any length above zero). */
  readonly boresight: Vec3;
  /** Direction in the body's frame that is up in the picture, not along the boresight; the axis of pan. */
  readonly up: Vec3;
  /** Horizontal field of view [rad]. */
  readonly field_of_view: number;
  /** How it can be turned; None: it is fixed. */
  readonly drive: Drive | null;
  readonly kind: 'camera' | 'window' | 'engineering';
  /** What a window leaves open; of windows alone. */
  readonly pane: Pane | null;
}

/** A pan and tilt unit with its lens; what it has no drive for stays as the camera has it. */
export interface Drive {
  /** Direction in the body's frame in which pan and tilt are zero, square to the camera's `up`. */
  readonly zero: Vec3;
  /** How far the lens stands ahead of where the axes of pan and tilt meet [m]. */
  readonly lens: number;
  readonly pan: Travel | null;
  readonly tilt: Travel | null;
  /** Of the horizontal field of view. */
  readonly zoom: Travel | null;
}

/** How far and how fast one of a camera's drives goes. */
export interface Travel {
  /** [rad] */
  readonly least: number;
  /** [rad] */
  readonly greatest: number;
  /** [rad/s] */
  readonly rate: number;
  /** Its low speed, where it has two [rad/s]. */
  readonly slow: number | null;
}

/** A window's opening, square to the line of sight through its middle: nothing is seen beside it or before it. */
export interface Pane {
  /** From the eye [m]. */
  readonly distance: number;
  /** [m] */
  readonly width: number;
  /** [m] */
  readonly height: number;
}

/** What can be done at this worksite. */
export interface WorkInfo {
  /** Which kind of end effector the arm has. */
  readonly hand: 'prong' | 'snares';
  /** None: the arm stands on no telescope. */
  readonly stand: StandInfo | null;
  /** Names of the payloads; each has a body of that name. */
  readonly cargo: readonly string[];
  /** Where payloads can be fixed, for people. */
  readonly seats: readonly string[];
  /** The parts of the problem that can be begun anew. */
  readonly parts: readonly ProblemPart[];
  /** Clearance under which the page cautions [m]. */
  readonly caution: number;
  /** Clearance under which the page warns [m]. */
  readonly warning: number;
}

/** The telescope that an arm stands on. */
export interface StandInfo {
  /** [m] */
  readonly least: number;
  readonly greatest: number;
  /** [m/s] */
  readonly rate: number;
}

/** Where sun and Earth stand, and what comes from them. */
export interface LightCondition {
  readonly name: string;
  /** Direction in the scene, of any length. */
  readonly to_sun: Vec3;
  /** Direction to the Earth's centre in the scene, of any length. */
  readonly nadir: Vec3;
  readonly sun: Glow;
  readonly earthshine: Glow;
  readonly sky: SkyGlow;
  /** Where the cameras' exposure begins [stops over that of full sunlight]. */
  readonly exposure: number;
  readonly source: string;
}

/** Light from one side. */
export interface Glow {
  readonly colour: string;
  /** [lx], in the scale in which full sunlight is 4.1 lx. */
  readonly strength: number;
}

/** Light from all sides. */
export interface SkyGlow {
  readonly above: string;
  /** Of the half spheres above and below the orbiter. */
  readonly below: string;
  readonly strength: number;
}

/** A row of the payload table (SPEC 94 item 3): what the steering keeps to with this payload in the grasp. */
export interface PayloadInfo {
  /** PL ID; 0: nothing is held. */
  readonly id: number;
  readonly name: string;
  /** [kg] */
  readonly mass: number;
  /** Greatest speed of the point of resolution, coarse and vernier [m/s]. */
  readonly translation: Vec2;
  /** The same of its rotation [rad/s]. */
  readonly rotation: Vec2;
  /** Joint rates of SINGLE, DIRECT and MASTER [rad/s]. */
  readonly coarse: Six;
  readonly vernier: Six;
}

/** What one of AUTO 1-4 flies through (SPEC 94 items 13-16). */
export interface StoredSequence {
  /** As `ModeInfo.position`. */
  readonly position: string;
  readonly points: readonly StoredPoint[];
}

/** A prestored point of AUTO 1-4, panel components. */
export interface StoredPoint {
  /** X, Y, Z [m]. */
  readonly position: Vec3;
  /** Pitch, yaw, roll [rad], each in [0, 2 pi). */
  readonly attitude: Vec3;
  /** It is waited at for PROCEED; else only come near. */
  readonly pause: boolean;
}

/** What this station can fly: sent on connection and whenever something of it changes. */
export interface Scenarios {
  readonly type: 'scenarios';
  readonly scenarios: readonly ScenarioInfo[];
  /** Number of the one that is flown. */
  readonly flown: number;
  /** Number of the one that is made ready; the sticks rest meanwhile. Then every page is welcomed anew. */
  readonly coming: number | null;
}

/** A scenario that this station can fly. */
export interface ScenarioInfo {
  readonly name: string;
  readonly title: string;
  /** What it asks of the operator, a sentence or two. */
  readonly text: string;
  /** The user's own file; the others are built in. */
  readonly given: boolean;
}

/** Who flies: sent on connection and whenever it changes. */
export interface Role {
  readonly type: 'role';
  readonly flying: boolean;
  /** Pages that watch, besides the one that flies. */
  readonly watchers: number;
  /** What this page is called, from 1. */
  readonly number: number;
  /** The page that flies. */
  readonly flier: number;
  /** The page that asks for the sticks; 0: none. */
  readonly asking: number;
  /** As it was given at this page; empty: none was. */
  readonly name: string;
  /** Of all pages that have one, this one too. */
  readonly names: readonly NamedPage[];
}

/** A page at which somebody has given a name. */
export interface NamedPage {
  readonly number: number;
  /** As the others are told it: with the page's number behind it where two have given the same. */
  readonly name: string;
}

/** All that the page shows of one instant; newest wins, frames may be skipped. */
export interface Frame {
  readonly type: 'frame';
  readonly tick: number;
  readonly time_s: number;
  /** `seq` of the last `Sticks` that this step has taken; the page times stick-to-picture by it. */
  readonly stick_seq: number;
  /** `seq` of the last `Sticks` that this step has flown, after the command delay; -1: none, or the script flew. */
  readonly flown_seq: number;
  /** How long the recording goes on already [s]; null: nothing is recorded. */
  readonly recording_s: number | null;
  /** Name of the script's phase; empty when flown by hand. */
  readonly phase: string;
  readonly by: 'hand' | 'script';
  readonly mode: string;
  /** The report's mode number flown; 0 TEST, 9 DIRECT, 10 MASTER. */
  readonly law: number;
  readonly law_choice: LawChoice;
  readonly payload_axes: boolean;
  readonly rate_hold: boolean;
  readonly position_hold: boolean;
  readonly brakes: boolean;
  readonly safing: boolean;
  readonly joint: number;
  readonly rate: Rate;
  /** READY and IN PROG of the automatic modes. */
  readonly sequence: 'idle' | 'checking' | 'ready' | 'in progress';
  /** AUTO 1-4: the point, from 1, that is flown to or comes next; 0 in other modes. */
  readonly point: number;
  readonly points: number;
  /** CMD CK of the present target. */
  readonly check: Check | null;
  readonly translation: Vec3;
  readonly rotation: Vec3;
  /** Sticks as this step has flown them. */
  readonly drive: number;
  /** Actual [rad]. */
  readonly joints: Six;
  /** Where the commanded rates would have brought them [rad]. */
  readonly joints_commanded: Six;
  /** Actual [rad/s]. */
  readonly rates: Six;
  readonly rates_commanded: Six;
  /** In force in this mode [rad/s]. */
  readonly rate_limits: Six;
  /** Per joint: 0 free, 1 past the reach limit, 2 past the soft stop, 3 at the hard stop. */
  readonly zones: readonly [number, number, number, number, number, number];
  readonly actual: Resolution;
  readonly commanded: Resolution;
  /** POR translation [m/s] and rotation [rad/s] limits in force. */
  readonly por_limits: Vec2;
  /** PL ID of what is in the grasp, as in `Welcome.payloads`. */
  readonly payload: number;
  /** From the tip to the point of resolution of ORB LD and PL, in the end effector's axes [m]. */
  readonly por_offset: Vec3;
  /** Limits acting in this step. */
  readonly limits: readonly Limit[];
  /** Shoulder, elbow, wrist: signed normalised distances, 0 at the singularity. */
  readonly singularity: Vec3;
  /** For each singularity that is near and each joint past a limit: what leads away from it. */
  readonly ways_out: readonly WayOut[];
  readonly lamps: readonly Lamp[];
  readonly aim: Aim | null;
  readonly work: WorkFrame;
  /** The newest look ahead; null: none was made yet. */
  readonly ahead: Ahead | null;
  /** The control frame's axes in the scene, for the frame axes in the pictures. */
  readonly axes: Quat;
  /** Seven numbers a body, in the order of `Welcome.bodies`: x, y, z [m], w, x, y, z in the scene. */
  readonly poses: readonly number[];
  /**
   * Pan, tilt and horizontal field of view [rad] of the cameras that have a drive, in the order of
   * `Welcome.cameras`.
   */
  readonly views: readonly Vec3[];
  readonly lighting: Lighting;
}

/** CMD CK: what a rehearsal of the way to a target found. */
export interface Check {
  readonly good: boolean;
  readonly text: string;
}

/** The point of resolution, panel components. */
export interface Resolution {
  /** X, Y, Z [m]. */
  readonly position: Vec3;
  /** Pitch, yaw, roll [rad], each in [0, 2 pi). */
  readonly attitude: Vec3;
  /** Rate of X, Y, Z [m/s]. */
  readonly velocity: Vec3;
  /** Angular velocity about panel pitch, yaw, roll axes [rad/s]. */
  readonly turn_rate: Vec3;
}

/** A limit that acted in this step. */
export interface Limit {
  readonly kind: LimitKind;
  /** 0 to 5, or -1 where no single joint is concerned. */
  readonly joint: number;
  /** For people: `elbow pitch at its rate limit`. */
  readonly text: string;
}

/** How to leave a singularity or a joint's stop. */
export interface WayOut {
  /** `shoulder`, `elbow`, `wrist` (a singularity) or a joint's name. */
  readonly cause: string;
  /** For people: `THC −X`, `RHC +pitch`, `SINGLE elbow pitch −`. */
  readonly text: string;
  readonly stick: 'translation' | 'rotation' | 'joint';
  readonly axis: number;
  readonly sign: number;
}

/** A lit lamp and its cause. */
export interface Lamp {
  readonly name: FlightLamp;
  readonly level: Level;
  /** The cause: `elbow 0.12 from straight`. */
  readonly text: string;
}

/** The keyed-in target of an automatic mode and what is left to it. */
export interface Aim {
  readonly position: Vec3;
  readonly attitude: Vec3;
  /** [m] */
  readonly distance: number;
  /** [rad] */
  readonly angle: number;
  /** Estimated time to go [s]; 0 when not under way. */
  readonly remaining_s: number;
}

/** Contacts, captures and the worksite's things. */
export interface WorkFrame {
  /** The report's mode: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked. */
  readonly task: number;
  readonly nearest: Near | null;
  /** What the clearance of `nearest` calls for, by the scenario's thresholds. */
  readonly clearance_level: Level;
  readonly contacts: readonly Near[];
  readonly arm_inhibit: boolean;
  readonly finger_inhibit: boolean;
  /** Why the arm or the finger is inhibited, and what frees it. */
  readonly inhibits: readonly string[];
  /** What the conditions are for: `acquire payload`; empty: nothing is near. */
  readonly pursuit: string;
  readonly conditions: readonly Condition[];
  readonly hand: HandFrame;
  /** Length of the telescope [m]. */
  readonly stand: number | null;
  /** How far the orbiter has moved: forward, starboard, down [m]. */
  readonly orbiter: Vec3;
  /** [m/s] */
  readonly orbiter_velocity: Vec3;
  readonly cargo: readonly CargoFrame[];
  /** Where the master arm stands [rad]; null in other modes than MASTER. */
  readonly master: Six | null;
  /** From the empty snares to where they would be at the nearest grapple fixture [m]; null: there is none for them. */
  readonly fixture: number | null;
  /** The same way, along the axes that the sticks move the end effector along [m]; null in modes without sticks. */
  readonly to_fixture: Vec3 | null;
}

/** Two watched parts; points and directions in the scene. */
export interface Near {
  readonly a: string;
  readonly b: string;
  /** [m], negative where they overlap. */
  readonly clearance: number;
  /** Speed at which the closest points approach [m/s]. */
  readonly closing: number;
  readonly point_a: Vec3;
  readonly point_b: Vec3;
  /** A point of the plane between them, halfway. */
  readonly plane: Vec3;
  /** The plane's unit normal, from a to b; zero where they collide. */
  readonly normal: Vec3;
  /** Made to touch: inhibits nothing. */
  readonly essential: boolean;
}

/** A condition of a capture, a docking or a latching. */
export interface Condition {
  readonly name: string;
  readonly holds: boolean;
  /** In `unit`: m, rad, m/s, or a number. */
  readonly value: number;
  readonly limit: number;
  readonly unit: string;
  /** By how much it holds, or fails where negative, in `unit`. */
  readonly margin: number;
  /** For people: `palm 2.5 in above the bar: 0 to 0.75 in`. */
  readonly text: string;
}

/** The end effector. */
export interface HandFrame {
  readonly switch: EffectorSwitch;
  /** 0 closed to 1 open: of the prong, or of the snares. */
  readonly opening: number;
  /** Prong to fixed finger [m]. */
  readonly spacing: number | null;
  /** 0 extended to 1 rigid. */
  readonly carriage: number | null;
  /** Lit: `CAPTURE`, `CLOSE`, `RIGID`, `EXTEND`, `OPEN`, `DERIGID`. */
  readonly flags: readonly string[];
  /** END EFFECTOR MODE of the snares. */
  readonly mode: 'auto' | 'manual';
  /** END EFFECTOR MAN CONTR of the snares. */
  readonly rigid: 'off' | 'rigid' | 'derigid';
}

/** A payload of the worksite; its pose is its body's. */
export interface CargoFrame {
  readonly name: string;
  readonly held: boolean;
  /** Title of the seat that it is fixed to, as in `WorkInfo.seats`; empty: none. */
  readonly seat: string;
  /** Of its centre against the arm's base [m/s]. */
  readonly speed: number;
}

/** Look ahead: what the sticks as they stand would do in some seconds; told five times a second. */
export interface Ahead {
  /** How far is looked [s]. */
  readonly seconds: number;
  /** The sticks as they stand; false: they rest, and this is the last axis used at full deflection. */
  readonly held: boolean;
  /** Whether the arm is then elsewhere than now. */
  readonly moves: boolean;
  /** Least clearance then [m]; null: nothing is watched. */
  readonly clearance: number | null;
  /** The two parts that have it. */
  readonly a: string;
  readonly b: string;
  /** When the first contact is found on the way [s]; null: none is. */
  readonly contact_s: number | null;
  /** How far the tip goes on if the sticks are let go now [m]. */
  readonly stopping: number;
  /** The joint nearest to a reach limit then, 0 to 5. */
  readonly joint: number;
  /** How far it is from that limit then; negative past it [rad]. */
  readonly room: number;
  /** Seven numbers for each body of `Welcome.ghost`, as in `Frame.poses`. */
  readonly poses: readonly number[];
}

/** New log lines, oldest first; none is ever skipped. */
export interface Events {
  readonly type: 'events';
  readonly events: readonly Event[];
}

/** One line of the log. */
export interface Event {
  readonly time_s: number;
  readonly kind: string;
  readonly level: Level;
  readonly text: string;
}

/** To a window that draws strips: at first the flight's last minutes, then what is new. */
export interface Recent {
  readonly type: 'recent';
  /** Every strip, its curves without a point: a flight begins, and what was told is over. Empty: it goes on. */
  readonly strips: readonly Strip[];
  readonly samples: readonly Sample[];
  /** Of the last minutes, when something in them has begun, else none; the last stretch of each goes on. */
  readonly lanes: readonly Lane[];
}

/** A quantity over the run. */
export interface Strip {
  readonly name: string;
  readonly quantity: Quantity;
  readonly curves: readonly Curve[];
  readonly low: number;
  /** Range of all values, with zero in it where zero means rest. */
  readonly high: number;
  /** A bound to draw across it. */
  readonly limit: number | null;
  /** Values below this are cautioned of; of a clearance, as the scenario has it. */
  readonly caution: number | null;
  /** Values below this are warned of. */
  readonly warning: number | null;
  /** Drawn until the reader chooses others. */
  readonly shown: boolean;
  /** Zero means rest, and belongs into the picture. */
  readonly rests: boolean;
}

/** A line of a strip, thinned so that no peak is lost. */
export interface Curve {
  readonly role: 'actual' | 'commanded';
  readonly times_s: readonly number[];
  /** None: there was no such thing. */
  readonly values: readonly (number | null)[];
}

/** What every strip shows of one instant. */
export interface Sample {
  readonly time_s: number;
  /** Of every curve, strip after strip. */
  readonly values: readonly (number | null)[];
  /** The joint that is nearest to its rate limit; empty at rest. */
  readonly worst: string;
}

/** A row of stretches that follow one another from the run's beginning to its end. */
export interface Lane {
  readonly name: string;
  readonly stretches: readonly Stretch[];
}

/** A part of a lane through which one thing was so. */
export interface Stretch {
  readonly start_s: number;
  readonly end_s: number;
  /** What was so; empty: nothing that this lane tells of. */
  readonly label: string;
  readonly level: Level;
}

/** A message or command that was not taken, and why, in a sentence for the operator. */
export interface Refused {
  readonly type: 'refused';
  /** `seq` of the message, or -1 where it could not be read. */
  readonly seq: number;
  readonly text: string;
}

/** One recorded frame, with each curve's exact value in it. */
export interface Moment {
  readonly frame: Frame;
  /** Of every curve, strip after strip. */
  readonly values: readonly (number | null)[];
  /** The joint that is nearest to its rate limit; empty at rest. */
  readonly worst: string;
}

/** First message of a page: the protocol that it speaks. */
export interface Hello {
  readonly type: 'hello';
  readonly protocol: number;
  /** A second window, or a page too narrow to fly from: it shows the flight and is nobody's hands (`TakeSeat`). */
  readonly shows: boolean;
  /** It draws strips: it is sent the flight's last minutes, too. */
  readonly strips: boolean;
}

/** What the monitors of the page that flew showed from a time on. */
export interface Pictured {
  readonly time_s: number;
  /** Of MON 1 and MON 2: the camera's name, two where it was split; none: no page flew. */
  readonly monitors: readonly (readonly string[])[];
}

/** A figure of the whole run. */
export interface Measure {
  readonly name: string;
  readonly quantity: Quantity;
  readonly value: number | null;
  /** In words, where the quantity is such. */
  readonly text: string;
  /** How it is reckoned, in a sentence. */
  readonly about: string;
  /** What belongs to a distance: how far the two are turned against each other [rad]. */
  readonly angle: number | null;
  /** The worst alarm that it stands for. */
  readonly level: Level;
}

/** Whether the recomputed frames are equal to the recorded ones. */
export interface Verdict {
  readonly state: 'checking' | 'equal' | 'different' | 'impossible';
  /** For people: `all 2002 frames equal`. */
  readonly text: string;
}

/** A recording in the folder of a station that records. */
export interface Recorded {
  /** The file's name, without its folder. */
  readonly file: string;
  /** Wall time at which it was written to last, ISO 8601, UTC. */
  readonly changed: string;
  /** The present flight goes on in it. */
  readonly now: boolean;
}

/** All that is known of a recording before its first frame is drawn. */
export interface PlaybackIndex {
  readonly welcome: Welcome;
  /** The file's name, without its folder. */
  readonly file: string;
  /** Wall time at which the run began, ISO 8601, UTC. */
  readonly began: string;
  /** Of the Aftdeck that recorded it. */
  readonly version: string;
  readonly seed: number;
  /** KEY=VALUE, where a replay changed the scenario. */
  readonly changes: readonly string[];
  /** Code of who took part; empty: none was given. */
  readonly participant: string;
  /** Of the trial; empty: none was given. */
  readonly condition: string;
  /** A control step. */
  readonly period_s: number;
  /** Steps that the recording holds. */
  readonly ticks: number;
  /** Steps from one drawn frame to the next; 1: every frame is drawn. */
  readonly stride: number;
  /** Moments in each block but the last. */
  readonly block: number;
  /** How the run ended; empty where the recording was cut short. */
  readonly ended: string;
  readonly verdict: Verdict;
  readonly events: readonly Event[];
  readonly lanes: readonly Lane[];
  readonly pictures: readonly Pictured[];
  readonly strips: readonly Strip[];
  readonly measures: readonly Measure[];
}
