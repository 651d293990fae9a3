// Generated from simulation/frame.py, report/ and station/messages by `make generate`; do not edit.
// All quantities are SI and radians; station/messages/kinds.py defines panel and scene axes.

export const PROTOCOL = 8;

export type Vec2 = readonly [number, number];
export type Axis = 'x' | 'y' | 'z';
export type Material = 'blanket' | 'liner' | 'tiles' | 'leading_edge' | 'radiator' | 'boom' | 'padding' | 'housing' | 'bright' | 'dark' | 'glass' | 'metal' | 'foil' | 'structure' | 'silver' | 'solar' | 'rail' | 'scuffed' | 'glow';
export type Shape = Box | Cylinder | Shell | Ring | Sphere | Plate | Loft | Hexahedron | Light | Group;
export type Level = 'info' | 'caution' | 'warning';
export type FlightLamp = 'SINGULAR' | 'REACH LIM' | 'SOFT STOP' | 'RATE LIM' | 'CLEARANCE' | 'DERIGIDIZE' | 'RELEASE' | 'CONTR ERR' | 'TIME LOST';
export type Quantity = 'time' | 'seconds' | 'count' | 'share' | 'part of limit' | 'ratio' | 'length' | 'gap' | 'distance' | 'angle' | 'speed' | 'turn rate' | 'force' | 'impulse' | 'torque' | 'milliseconds' | 'words';
export type Quat = readonly [number, number, number, number];
export type Rate = 'coarse' | 'vernier';
export type LawChoice = 'position' | 'closed loop' | 'open loop';
export type EffectorSwitch = 'stop' | 'close' | 'open';
export type ProblemPart = 'full problem' | 'acquisition' | 'extraction' | 'manoeuvring';
export type ControllerKind = 'keyboard' | 'pad' | 'thc pad' | 'rhc pad' | 'thc joystick' | 'rhc joystick' | 'spacemouse' | 'touch';
export type WaitsFor = '' | 'page' | 'laws';
export type Plant = 'kinematic' | 'rigid' | 'flexible';
export type Vec3 = readonly [number, number, number];
export type FromPage = Sticks | Drawn | Shown | ShowPolygons | Announce | Controllers | DriveCamera | SetLight | Pulse | EnterMode | SelectJoint | SelectRate | SelectLaw | PayloadAxes | RateHold | PositionHold | AskSticks | GiveSticks | KeepSticks | SetName | LeaveSeat | TakeSeat | HandsOff | LookAhead | TurnStep | SetBrakes | SetSafing | SetTarget | Proceed | Stop | Restart | FlyScenario | SetEffector | SetEffectorMode | SetRigid | PressLatch | SetMaster | Initialise | TypeLine | CompleteLine;
export type DeskGroup = 'thc' | 'rhc' | 'mode' | 'target' | 'joints' | 'clearance' | 'conditions' | 'effector' | 'limits' | 'singularity';
export type Use = '-X' | '+X' | '-Y' | '+Y' | '-Z' | '+Z' | '-roll' | '+roll' | '-pitch' | '+pitch' | '-yaw' | '+yaw' | '-telescope' | '+telescope' | '-pan' | '+pan' | '-tilt' | '+tilt' | '-zoom' | '+zoom' | 'stop' | 'rate' | 'rate hold' | 'pulse' | 'close' | 'open' | 'latch' | 'brakes' | 'safing' | 'position hold' | 'mode -' | 'mode +' | 'enter' | 'proceed' | 'joint -' | 'joint +' | 'fly orbiter' | 'acknowledge' | 'announce' | 'plane' | 'bending' | 'otherMonitor' | 'cameraStep -' | 'cameraStep +' | 'split' | 'matrix' | 'offered pair' | 'slow camera' | 'light' | 'mute' | 'lock exposure' | 'control page' | 'console' | 'leave' | 'camera 1' | 'camera 2' | 'camera 3' | 'camera 4' | 'camera 5' | 'camera 6' | 'camera 7' | 'camera 8' | 'camera 9' | 'camera 10';
export type Grade = 'A' | 'B' | 'C' | 'D';
export type AutopilotName = 'script' | 'policy' | 'synthetic operator';
export type ScenarioGroup = 'learn' | 'fly' | 'study';
export type Answers = Typed | Completed | Refused;
export type FromServer = Preparing | Welcome | Changed | Scenarios | Role | Frame | Polygons | Events | Recent | Readiness | Typed | Completed | Refused;
export type Block = readonly Moment[];
export type Rows = readonly [Vec3, Vec3, Vec3];
export type Six = readonly [number, number, number, number, number, number];
export type Sequence = 'idle' | 'checking' | 'ready' | 'in progress';
export type LimitKind = 'joint rate' | 'soft stop' | 'hard stop' | 'singularity' | 'joint acceleration' | 'POR translation' | 'POR rotation' | 'POR acceleration' | 'seat' | 'contact' | 'switch';
export type Cause = '' | 'reach' | 'seat' | 'switch' | 'contact' | 'limit' | 'miss' | 'time';
export type Holder = 'end effector' | 'orbiter' | 'space';

export const UNITS = {
  "time": "s",
  "seconds": "s",
  "count": "",
  "share": "",
  "part of limit": "",
  "ratio": "",
  "length": "m",
  "gap": "m",
  "distance": "m",
  "angle": "rad",
  "speed": "m/s",
  "turn rate": "rad/s",
  "force": "N",
  "impulse": "N s",
  "torque": "N m",
  "milliseconds": "ms",
  "words": ""
} as const;

export const READOUTS = {
  "clearance": {
    "title": "Clearance",
    "about": "Minimum clearance of all monitored pairs"
  },
  "torque_of_limit": {
    "title": "Joint torque",
    "about": "Torque of motor or brake, as a fraction of its greatest torque"
  }
};

/** A box, centred at its position. */
export interface Box {
  readonly kind: 'box';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  /** Edges along x, y, z [m]. */
  readonly size: Vec3;
}

/** A solid cylinder or truncated cone, centred at its position. */
export interface Cylinder {
  readonly kind: 'cylinder';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly axis: Axis;
  readonly length: number;
  /** Radius at the end with the smaller axis coordinate [m]. */
  readonly radius: number;
  /** Radius at the other end [m]; None if it equals `radius`. */
  readonly radius_end: number | null;
}

/**
 * A wall bent round an axis: a tube, nozzle or door, or a sector of a disc if the thickness equals the radius.
 *
 * Angles run from y to z about axis x, from z to x about y, from x to y about z.
 */
export interface Shell {
  readonly kind: 'shell';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly axis: Axis;
  readonly length: number;
  /** Outer radius at the end with the smaller axis coordinate [m]. */
  readonly radius: number;
  /** Outer radius at the other end [m]; None if it equals `radius`. */
  readonly radius_end: number | null;
  readonly thickness: number;
  readonly start: number;
  readonly sweep: number;
}

/** A round bar bent about an axis by a full turn or less; angles are as in `Shell`. */
export interface Ring {
  readonly kind: 'ring';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly axis: Axis;
  /** Radius of the bar's centre line [m]. */
  readonly radius: number;
  /** Radius of the bar [m]. */
  readonly bar: number;
  readonly start: number;
  readonly sweep: number;
}

/** A sphere. */
export interface Sphere {
  readonly kind: 'sphere';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly radius: number;
}

/** A flat plate. Half of its thickness is on each side of the plane through its position. */
export interface Plate {
  readonly kind: 'plate';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  readonly normal: Axis;
  /** Corners in order, each listed once: (y, z), (x, z) or (x, y) for normal x, y or z [m]. */
  readonly outline: readonly Vec2[];
  readonly thickness: number;
  /** Distance by which the edges are cut back, at most half the thickness [m]. */
  readonly bevel: number;
}

/** A skin over cross-sections along x, closed at both ends. */
export interface Loft {
  readonly kind: 'loft';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  /** Sections in order of increasing x. */
  readonly sections: readonly Section[];
}

/**
 * A rounded cross-section of a loft: an upper and a lower half of a superellipse.
 *
 * The points of a half satisfy |y/half_width|^n + |(z - middle)/height|^n = 1. The height is from `middle` to `top` or
 * `bottom`; n is the exponent of the half. Exponent 2 gives an ellipse, 5 nearly a rectangle.
 */
export interface Section {
  readonly x: number;
  readonly half_width: number;
  readonly top: number;
  readonly middle: number;
  readonly bottom: number;
  /** Exponents of the upper and the lower half. */
  readonly exponents: Vec2;
}

/** A body of eight vertices and six flat faces, numbered as in `aftdeck.bodies.hexahedron`. */
export interface Hexahedron {
  readonly kind: 'hexahedron';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly material: Material;
  /** Vertices in the body's own axes [m]. Vertex v has v - 1 = 4 (if at +y) + 2 (if at +x) + 1 (if at +z). */
  readonly vertices: readonly Vec3[];
}

/** A lamp: a round face that points along its own x axis and lights the space in front. */
export interface Light {
  readonly kind: 'light';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly radius: number;
  /** Half angle of the beam [rad]; above pi/2 the lamp shines in all directions. */
  readonly cone: number;
  /** Range of the light [m]. */
  readonly reach: number;
  /** Intensity on the lamp's axis [cd]; on this scale full sunlight is 4.1 lx. */
  readonly intensity: number;
  /** Name of the panel's switch for this lamp. Several lamps may have the same switch. */
  readonly switch: string;
}

/** Shapes that are moved together. A group can be repeated in equal steps, and mirrored. */
export interface Group {
  readonly kind: 'group';
  /** Position [m]. */
  readonly position: Vec3;
  /** Roll, pitch, yaw about fixed x, y, z, applied in that order [rad]. */
  readonly rotation: Vec3;
  readonly shapes: readonly Shape[];
  /** Number of copies. */
  readonly count: number;
  /** Translation from one copy to the next, along the group's own axes [m]. */
  readonly step: Vec3;
  /**
   * Roll, pitch, yaw about the group's own axes, as in `rotation` [rad]. For copy i, counted from 0, each angle is
   * multiplied by i.
   */
  readonly turn: Vec3;
  /** Whether all copies are also drawn mirrored across the plane y = 0 of the frame in which the group is listed. */
  readonly mirror: boolean;
}

/**
 * Deflections of the hand controllers, after deadband and expo, each axis in [-1, 1].
 *
 * The page sends them whenever they change. While a stick is deflected or RATE HOLD is on, it sends them at least
 * every 0.2 s. After 0.5 s without a message the server centres the sticks and treats the controls as unattended
 * (`HandsOff`).
 */
export interface Sticks {
  readonly type: 'sticks';
  /** Sequence number. The server rejects a message if its number is not greater than the previous message's number. */
  readonly seq: number;
  /** THC: +X, +Y, +Z of the present control frame. */
  readonly translation: Vec3;
  /** RHC: roll about +X, pitch about +Y, yaw about +Z of the present control frame. */
  readonly rotation: Vec3;
  /** DRIVE switch, in [-1, 1]; it moves the selected joint in SINGLE and DIRECT. */
  readonly drive: number;
  /** Telescope: + longer, - shorter, in [-1, 1]. */
  readonly telescope: number;
  /** Translation of the orbiter: forward, starboard, down, each in [-1, 1]. */
  readonly orbiter: Vec3;
}

/** Tell that the page has drawn its first pictures of the run: a run that waits for them goes on. */
export interface Drawn {
  readonly type: 'drawn';
  readonly seq: number;
}

/**
 * Report the measured latency and the displayed cameras, for the recording and the strips.
 *
 * The page sends this message once a second and when a monitor changes its camera.
 */
export interface Shown {
  readonly type: 'shown';
  readonly seq: number;
  /** Time from stick to picture, 95th percentile of the last 10 s [ms]; null if not measured. */
  readonly latency_ms: number | null;
  /** Cameras that MON 1 and MON 2 show. */
  readonly monitors: readonly (readonly string[])[];
}

/**
 * Ask for `Polygons` of these cameras, until the next such message; every page may ask.
 *
 * The page asks again after each welcome.
 */
export interface ShowPolygons {
  readonly type: 'show_polygons';
  readonly seq: number;
  readonly pictures: readonly PolygonPicture[];
}

/** Picture of a camera in the look of 1972. */
export interface PolygonPicture {
  readonly camera: string;
  /** Width of the picture divided by its height; the server may draw more above and below the picture. */
  readonly aspect: number;
  /** Eye of an engineering view; null for a view as the scenario has it. */
  readonly eye: FreeEye | null;
}

/** Eye of an engineering view, which each page directs by itself; in the scene. */
export interface FreeEye {
  /** Position [m]. */
  readonly position: Vec3;
  /** Direction of view. */
  readonly ahead: Vec3;
  /** Direction that is upwards in the picture; it differs from `ahead`. */
  readonly up: Vec3;
  /** Horizontal field of view [rad]. */
  readonly field_of_view: number;
}

/** Announce a clearance problem that the operator or an observer has noticed; it is logged and recorded. */
export interface Announce {
  readonly type: 'announce';
  readonly seq: number;
}

/**
 * Report the devices in use, for the recording.
 *
 * The page sends this message when it takes control, and when the devices or their settings change.
 */
export interface Controllers {
  readonly type: 'controllers';
  readonly seq: number;
  readonly controllers: readonly ControllerInUse[];
}

/** Device that moves the hand controllers: its settings, and the functions of its keys, buttons and axes. */
export interface ControllerInUse {
  readonly kind: ControllerKind;
  /** Name that the browser reports. */
  readonly name: string;
  /** Fraction of an axis' travel, about its centre, that counts as zero. */
  readonly deadband: number;
  /** 0 linear, 1 cubic. The output is (1 - expo) x + expo x**3, where x is the deflection beyond the deadband. */
  readonly expo: number;
  /** Key, button or axis, and its function: `KeyW +X`, `a1 -X`, `b9+b12 +telescope`. */
  readonly bindings: readonly string[];
  /** Rest position of each axis, as the operator has confirmed it; an axis without an entry rests at 0. */
  readonly centres: readonly number[];
}

/** Set the switches that drive a camera, each in [-1, 1]. The server centres them 0.5 s after the last message. */
export interface DriveCamera {
  readonly type: 'drive_camera';
  readonly seq: number;
  readonly camera: string;
  /** + to the right in the picture. */
  readonly pan: number;
  /** + upwards. */
  readonly tilt: number;
  /** + zooms in, to a narrower field of view. */
  readonly zoom: number;
  /** True for the low speed, if the drive has two speeds. */
  readonly slow: boolean;
}

/** Set the complete lighting. It is recorded, but it is not an input of the simulation. */
export interface SetLight {
  readonly type: 'set_light';
  readonly seq: number;
  readonly lighting: Lighting;
}

/** Present light: the condition, the lamps that are on, and the locked exposures. */
export interface Lighting {
  /** Name of the condition, as in `LightCondition.name`. */
  readonly condition: string;
  /** Names of the switches that are on. */
  readonly lamps: readonly string[];
  readonly locked: readonly LockedExposure[];
}

/** Locked exposure of a camera. A locked exposure does not follow the brightness of the picture. */
export interface LockedExposure {
  readonly camera: string;
  /** Exposure of the camera [photographic stops above the exposure for full sunlight]. */
  readonly stops: number;
}

/**
 * Deflect sticks for one pulse, which moves the arm by a small fixed distance or angle: each axis is -1, 0 or 1.
 *
 * The fields are those of `Sticks`. The server computes the deflection and its duration.
 */
export interface Pulse {
  readonly type: 'pulse';
  readonly seq: number;
  readonly translation: Vec3;
  readonly rotation: Vec3;
  readonly drive: number;
  readonly telescope: number;
  readonly orbiter: Vec3;
}

/** Turn the MODE rotary to a position and press ENTER. */
export interface EnterMode {
  readonly type: 'enter_mode';
  readonly seq: number;
  /** Position of the rotary, as in `ModeInfo.position`. */
  readonly mode: string;
}

/** Turn the JOINT rotary. */
export interface SelectJoint {
  readonly type: 'select_joint';
  readonly seq: number;
  /** Number of the joint, from 0, in the order of `Welcome.joints`. */
  readonly joint: number;
}

/** Set the COARSE/VERNIER switch. */
export interface SelectRate {
  readonly type: 'select_rate';
  readonly seq: number;
  readonly rate: Rate;
}

/** Set the switch beside OPR CMD and AUTO 1-4, which selects their steering law (1 to 3). */
export interface SelectLaw {
  readonly type: 'select_law';
  readonly seq: number;
  readonly law: LawChoice;
}

/** Set the switch beside ORB LD: rotate about payload axes (steering law 7) or orbiter axes (steering law 4). */
export interface PayloadAxes {
  readonly type: 'payload_axes';
  readonly seq: number;
  readonly on: boolean;
}

/** Press RATE HOLD: keep the present stick command, or cancel RATE HOLD if it is on. */
export interface RateHold {
  readonly type: 'rate_hold';
  readonly seq: number;
}

/** Set POSITION HOLD: keep position and attitude while the sticks are centred. */
export interface PositionHold {
  readonly type: 'position_hold';
  readonly seq: number;
  readonly on: boolean;
}

/** Ask for control of the arm. The request expires if the page in control does not answer within 10 s. */
export interface AskSticks {
  readonly type: 'ask_sticks';
  readonly seq: number;
}

/** Give the sticks, which must be centred, to the page that asks for them. */
export interface GiveSticks {
  readonly type: 'give_sticks';
  readonly seq: number;
}

/** Keep the sticks; the server informs the page that asks for them. */
export interface KeepSticks {
  readonly type: 'keep_sticks';
  readonly seq: number;
}

/** Set the name of the person at this page, for the other pages and for the log. */
export interface SetName {
  readonly type: 'set_name';
  readonly seq: number;
  /** One line of at most 24 characters; empty removes the name. */
  readonly name: string;
}

/**
 * Give up control and the right to ask for it: the page has become too narrow, and now only shows the run.
 *
 * If this page was in control, the page that connected first takes control.
 */
export interface LeaveSeat {
  readonly type: 'leave_seat';
  readonly seq: number;
}

/**
 * Allow this page to take control: it has become wide enough.
 *
 * If no page is in control, this page takes control; otherwise it observes.
 */
export interface TakeSeat {
  readonly type: 'take_seat';
  readonly seq: number;
}

/**
 * Leave the controls unattended: the server centres the sticks, cancels RATE HOLD and sets POSITION HOLD.
 *
 * A sequence in progress continues.
 */
export interface HandsOff {
  readonly type: 'hands_off';
  readonly seq: number;
  readonly cause: 'page hidden' | 'device lost';
}

/** Set the time span of the look-ahead. */
export interface LookAhead {
  readonly type: 'look_ahead';
  readonly seq: number;
  /** Time span [s]. */
  readonly seconds: number;
}

/** Go to the next step of the task without completing the present one, or back to the previous step. */
export interface TurnStep {
  readonly type: 'turn_step';
  readonly seq: number;
  readonly to: 'next' | 'previous';
}

/** Set or release BRAKES, which stop every joint immediately. */
export interface SetBrakes {
  readonly type: 'brakes';
  readonly seq: number;
  readonly on: boolean;
}

/** Set or cancel SAFING, which commands zero joint rates. */
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

/** Set the AUTO SEQ switch to PROCEED. */
export interface Proceed {
  readonly type: 'proceed';
  readonly seq: number;
}

/** Set the AUTO SEQ switch to STOP. This also sets the sticks to zero and stops the end effector. */
export interface Stop {
  readonly type: 'stop';
  readonly seq: number;
}

/** Restart the scenario from its beginning. */
export interface Restart {
  readonly type: 'restart';
  readonly seq: number;
}

/**
 * Run another scenario, or the same one on another plant.
 *
 * The server completes and keeps the recording of the present run.
 */
export interface FlyScenario {
  readonly type: 'fly_scenario';
  readonly seq: number;
  /** Index in `Scenarios.scenarios`. */
  readonly number: number;
  /** Plant; null for that of the scenario's file. */
  readonly plant: Plant | null;
  /** Whether the script flies the first run, until the operator moves a stick or sends a command. */
  readonly demo: boolean;
}

/** Set the end effector switch: the prong closes or opens; the snares capture or release. */
export interface SetEffector {
  readonly type: 'effector';
  readonly seq: number;
  readonly switch: EffectorSwitch;
}

/** Set END EFFECTOR MODE of the snares: auto runs the whole sequence; manual moves the snares alone. */
export interface SetEffectorMode {
  readonly type: 'effector_mode';
  readonly seq: number;
  readonly mode: 'auto' | 'manual';
}

/** Set END EFFECTOR MAN CONTR of the snares: in manual mode, this switch moves the carriage alone. */
export interface SetRigid {
  readonly type: 'rigid';
  readonly seq: number;
  readonly rigid: 'off' | 'rigid' | 'derigid';
}

/** Latch or unlatch the payload in its berth (bay or docking port). */
export interface PressLatch {
  readonly type: 'latch';
  readonly seq: number;
  readonly latch: 'latch' | 'unlatch';
}

/** Set the joint angles of the master arm, which the arm follows in MASTER. */
export interface SetMaster {
  readonly type: 'master';
  readonly seq: number;
  /** Joint angles of the master arm [rad]; lengths of joints that slide [m]. */
  readonly angles: readonly number[];
}

/** Re-initialise arm and payload at a task phase. */
export interface Initialise {
  readonly type: 'initialise';
  readonly seq: number;
  readonly part: ProblemPart;
}

/** Type a line on the console, the report's typewriter: `Typed` answers it. */
export interface TypeLine {
  readonly type: 'type_line';
  readonly seq: number;
  readonly line: string;
}

/** Ask how the last word of a line on the console can go on: `Completed` answers it. */
export interface CompleteLine {
  readonly type: 'complete_line';
  readonly seq: number;
  readonly line: string;
}

/** Answer of the console to a line. */
export interface Typed {
  readonly type: 'typed';
  /** `seq` of the line. */
  readonly seq: number;
  readonly lines: readonly string[];
  /** Whether the line was not understood, or its change was refused; the lines say why. */
  readonly refused: boolean;
}

/** Words with which the last word of a line on the console can go on. */
export interface Completed {
  readonly type: 'completed';
  /** `seq` of the request. */
  readonly seq: number;
  /** The words, whole; at most 40. */
  readonly words: readonly string[];
}

/** Rejection of a message or command. `text` gives the operator the reason, in one sentence. */
export interface Refused {
  readonly type: 'refused';
  /** `seq` of the rejected message; -1 if the message could not be decoded, or if `text` is not about a message. */
  readonly seq: number;
  readonly text: string;
}

/** One line about the progress of preparing the first session; sent before the welcome. */
export interface Preparing {
  readonly type: 'preparing';
  readonly text: string;
}

/** Answer to `Hello`, sent again when the scenario changes: all data that stays the same in a session. */
export interface Welcome {
  readonly type: 'welcome';
  readonly protocol: number;
  readonly version: string;
  readonly scenario: string;
  readonly title: string;
  /** Task of the operator in this scenario, in a sentence or two. */
  readonly text: string;
  readonly arm: string;
  /** Model that turns commanded rates into motion. */
  readonly plant: Plant;
  readonly control_period_s: number;
  /** Time from a command to its arrival at the arm [s]. */
  readonly command_delay_s: number;
  /** Delay with which the page displays numbers, lamps and log [s]. */
  readonly telemetry_delay_s: number;
  /** Delay with which the page displays pictures [s]. */
  readonly camera_delay_s: number;
  /** Units of the panel's read-outs, as given in the arm file. */
  readonly units: 'ft-in' | 'SI';
  readonly joints: readonly JointInfo[];
  readonly modes: readonly ModeInfo[];
  readonly bodies: readonly BodyInfo[];
  /** Parts of the arm that bend, from the base to the wrist; empty if nothing bends. */
  readonly flexures: readonly FlexureInfo[];
  /** Indices of the bodies whose poses are in `Ahead.poses`. */
  readonly ghost: readonly number[];
  readonly cameras: readonly Camera[];
  readonly work: WorkInfo;
  /** Light conditions that the operator can select: directions of sun and Earth. */
  readonly conditions: readonly LightCondition[];
  /** Names of the lamps of this scenario. */
  readonly lamps: readonly string[];
  /** Payload table by PL ID, from 0. */
  readonly payloads: readonly PayloadInfo[];
  readonly sequences: readonly StoredSequence[];
  /** Names of the arm's singularities, in the order of `Frame.singularity`. */
  readonly singularities: readonly string[];
  /** Normalised distance from a singularity; the page shows a caution below this value. */
  readonly singular: number;
  /** Steps of the operator's task; empty if the scenario describes none. */
  readonly steps: readonly StepInfo[];
  /** Name of the scenario that the page proposes after the last step; empty if it proposes none. */
  readonly next: string;
  /**
   * Names of the script's phases in order, as in `Frame.phase`.
   *
   * Empty if the scenario has no script, or if the session does not begin with the script.
   */
  readonly phases: readonly string[];
}

/**
 * Joint of the arm: names, limits [rad], rate limits [rad/s] and torque limits [N m].
 *
 * A joint that slides has [m], [m/s] and [N] in their places, here and in frames.
 */
export interface JointInfo {
  /** Name in the arm file: `shoulder_yaw`. */
  readonly name: string;
  /** Name on the page: `Sho yaw`. */
  readonly label: string;
  /** Axis of the hand controllers that moves this joint of the master arm: `THC Y`; null if no axis moves it. */
  readonly stick: string | null;
  /** Whether the joint slides along its axis; otherwise it turns about it. */
  readonly slides: boolean;
  readonly hard: Vec2;
  readonly soft: Vec2;
  readonly reach: Vec2;
  readonly coarse: number;
  readonly vernier: number;
  readonly servo: number;
  /** Greatest torque of the motor; null on the kinematic plant. */
  readonly torque: number | null;
  /** Greatest torque of the brake; null on the kinematic plant. */
  readonly holding: number | null;
}

/** Position of the MODE rotary. */
export interface ModeInfo {
  /** Name as printed on the panel: `ORB UNL`. */
  readonly position: string;
  /** Steering laws of this position, the default first; 0 for TEST, 9 for DIRECT, 10 for MASTER. */
  readonly laws: readonly number[];
  /** Motion in this mode, in a few words: `tip along its own axes`. */
  readonly title: string;
  readonly kind: 'automatic' | 'manual' | 'single' | 'test' | 'master';
  /** Point that this mode moves: `tip`, `payload`. */
  readonly point: string;
  /**
   * False only for a mode of AUTO 1-4 without stored points in this scenario.
   *
   * A mode that moves a payload also needs a captured payload; this value does not include that condition.
   */
  readonly enabled: boolean;
  /** Axes along which the sticks act: `orbiter axes`. */
  readonly axes: string;
  /** Meaning of + for the three axes of the THC: `+X fwd`, `+Y stbd`, `+Z down`. */
  readonly axis_names: readonly [string, string, string];
}

/** Rigid body to draw; its pose is in `Display.poses`, at the body's index in `Welcome.bodies`. */
export interface BodyInfo {
  readonly name: string;
  readonly shapes: readonly Shape[];
  /** Shapes that only decorate the body: they hide nothing in the survey of cameras, and ghosts do not have them. */
  readonly details: readonly Shape[];
}

/** Part of the arm that bends: the base or a boom; its bend is in `Dynamics.bends`, at the same index. */
export interface FlexureInfo {
  /** Index in `Welcome.bodies` of the body that carries the part. */
  readonly body: number;
  /** Place of the part's end in this body, as long as the part is straight [m]; zero for the base. */
  readonly end: Vec3;
}

/** Television camera, window eye or engineering view on a body, with its initial setting. */
export interface Camera {
  /** Short name on the selector, such as `B`. */
  readonly name: string;
  /** Full name, such as `Aft bulkhead port`. */
  readonly title: string;
  /** Name of the body that carries the camera. */
  readonly body: string;
  /** Position of the lens in the body's frame [m]. */
  readonly position: Vec3;
  /** Direction of view in the body's frame (any length above zero). */
  readonly boresight: Vec3;
  /**
   * Direction in the body's frame that is up in the picture. It is the pan axis, and it is not parallel to the
   * boresight.
   */
  readonly up: Vec3;
  /** Horizontal field of view [rad]. */
  readonly field_of_view: number;
  /** Pan and tilt unit; None if the camera is fixed. */
  readonly drive: Drive | null;
  readonly kind: 'camera' | 'window' | 'engineering';
  /** Opening of a window; None for any other kind. */
  readonly pane: Pane | null;
  /**
   * Name of the part that contains the lens by design, such as the cabin around an eye behind a window; empty if this
   * is a housing of the camera's own.
   */
  readonly inside: string;
}

/** Pan and tilt unit with its lens. If `pan`, `tilt` or `zoom` is None, it stays at the camera's initial setting. */
export interface Drive {
  /** Direction of zero pan and tilt in the body's frame, perpendicular to the camera's `up`. */
  readonly zero: Vec3;
  /** Distance of the lens ahead of the intersection of the pan and tilt axes [m]. */
  readonly lens: number;
  readonly pan: Travel | null;
  readonly tilt: Travel | null;
  /** Range and rates of the horizontal field of view. */
  readonly zoom: Travel | null;
}

/** Range and rates of one of a camera's drives. */
export interface Travel {
  /** Least position [rad]. */
  readonly least: number;
  /** Greatest position [rad]. */
  readonly greatest: number;
  /** Rate, or the high rate of a drive with two rates [rad/s]. */
  readonly rate: number;
  /** Low rate of a drive with two rates [rad/s]; None if the drive has one rate. */
  readonly slow: number | null;
}

/**
 * Opening of a window, perpendicular to the line of sight and centred on it.
 *
 * The picture shows only objects that are beyond the opening and visible through it.
 */
export interface Pane {
  /** Distance from the eye [m]. */
  readonly distance: number;
  /** Width of the opening [m]. */
  readonly width: number;
  /** Height of the opening [m]. */
  readonly height: number;
}

/** Equipment of arm and worksite, and thresholds of the clearance. */
export interface WorkInfo {
  /** Kind of the arm's end effector. */
  readonly hand: 'prong' | 'snares';
  /** Names of the end effector's bodies: the one that carries the tip, then a prong. */
  readonly effector: readonly string[];
  /** Telescope under the arm; null if the arm has no telescope. */
  readonly stand: StandInfo | null;
  /** Names of the payloads; each payload has a body of the same name. */
  readonly cargo: readonly string[];
  /** Berths of the worksite. */
  readonly seats: readonly SeatInfo[];
  /** Task phases at which the operator can re-initialise; `full problem` is the start. */
  readonly parts: readonly ProblemPart[];
  /** Clearance below which the page shows a caution [m]. */
  readonly caution: number;
  /** Clearance below which the page shows a warning [m]. */
  readonly warning: number;
}

/** Telescope under an arm: minimum and maximum length, and rate. */
export interface StandInfo {
  /** Minimum length [m]. */
  readonly least: number;
  /** Maximum length [m]. */
  readonly greatest: number;
  /** Rate of the length [m/s]. */
  readonly rate: number;
}

/** Berth: location where a payload can be fixed. */
export interface SeatInfo {
  /** Name of the berth in frames (`Cargo.seat`). */
  readonly name: string;
  /** Name for display. */
  readonly title: string;
}

/** Directions to the sun and the Earth, and the light from them. */
export interface LightCondition {
  readonly name: string;
  /** Vector towards the sun, of any length, in the scene coordinate frame. */
  readonly to_sun: Vec3;
  /** Vector towards the Earth's centre, of any length, in the scene coordinate frame. */
  readonly nadir: Vec3;
  readonly sun: Glow;
  readonly earthshine: Glow;
  readonly sky: SkyGlow;
  /** Initial exposure of the cameras [photographic stops above the exposure for full sunlight]. */
  readonly exposure: number;
  readonly source: string;
}

/** Light from one side. */
export interface Glow {
  readonly colour: string;
  /** Illuminance in relative units; full sunlight is 4.1. */
  readonly strength: number;
}

/** Light from all sides. */
export interface SkyGlow {
  readonly above: string;
  /** Colour of the half sphere below the orbiter; `above` is the colour of the half sphere above it. */
  readonly below: string;
  readonly strength: number;
}

/** Row of the payload table (SPEC 94 item 3): rate limits with this payload captured. */
export interface PayloadInfo {
  /** PL ID; 0 is the row without a payload. */
  readonly id: number;
  readonly name: string;
  /** Mass [kg]. */
  readonly mass: number;
  /** Speed limit of the point of resolution, coarse and vernier [m/s]. */
  readonly translation: Vec2;
  /** Angular rate limit of the point of resolution, coarse and vernier [rad/s]. */
  readonly rotation: Vec2;
  /** Joint rate limits in SINGLE, DIRECT and MASTER with the rate setting coarse [rad/s]. */
  readonly coarse: readonly number[];
  /** Joint rate limits in SINGLE, DIRECT and MASTER with the rate setting vernier [rad/s]. */
  readonly vernier: readonly number[];
}

/** Stored points of one mode, AUTO 1 to 4 (SPEC 94 items 13-16). */
export interface StoredSequence {
  /** Position of the MODE rotary, as in `ModeInfo.position`. */
  readonly position: string;
  readonly points: readonly StoredPoint[];
}

/** Stored point of AUTO 1-4, in panel components. */
export interface StoredPoint {
  /** X, Y, Z [m]. */
  readonly position: Vec3;
  /** Pitch, yaw, roll [rad], each in [0, 2 pi). */
  readonly attitude: Vec3;
  /** True if the sequence waits for PROCEED at this point; false for a fly-by point. */
  readonly pause: boolean;
}

/**
 * Step of the operator's task.
 *
 * In the texts, `{+X}` stands for the key or button of a function, `{0.05 m}` for a length, `{wanting}` for the first
 * condition that fails; `*...*` quotes a text on the desk.
 */
export interface StepInfo {
  readonly title: string;
  readonly text: string;
  /** Position of the MODE rotary that the step needs; null if any will do. */
  readonly mode: string | null;
  readonly uses: readonly UseInfo[];
  /** Groups of the desk that the step needs. */
  readonly groups: readonly DeskGroup[];
  /** The two cameras that show the step best; empty if the scenario names none. */
  readonly cameras: readonly string[];
  readonly hints: readonly HintInfo[];
}

/** Function of the controls that a step of the task needs. */
export interface UseInfo {
  readonly use: Use;
  /** Effect of the function in this step, in one or two words. */
  readonly does: string;
}

/** Text that replaces a step's text in a certain state. */
export interface HintInfo {
  readonly text: string;
  readonly uses: readonly UseInfo[];
}

/** New values of fields of the welcome, after a change in flight or a restart; all other fields stay the same. */
export interface Changed {
  readonly type: 'changed';
  readonly joints: readonly JointInfo[];
  readonly cameras: readonly Camera[];
  readonly work: WorkInfo;
  readonly payloads: readonly PayloadInfo[];
  readonly singular: number;
  readonly telemetry_delay_s: number;
  readonly camera_delay_s: number;
}

/** Scenarios that this station can run. The server sends the list on connection and whenever it changes. */
export interface Scenarios {
  readonly type: 'scenarios';
  readonly scenarios: readonly ScenarioInfo[];
  /** Number of the scenario that is running. */
  readonly flown: number;
  /**
   * Number of the scenario that is being prepared; null if no scenario is being prepared.
   *
   * During the preparation the sticks are centred. When the scenario starts, every page receives a new `Welcome`.
   */
  readonly coming: number | null;
}

/** Scenario that this station can run. */
export interface ScenarioInfo {
  readonly name: string;
  readonly title: string;
  /** Task of the operator, in a sentence or two. */
  readonly text: string;
  readonly group: ScenarioGroup;
  /** Time that the task takes a practised operator, or the script if there are no steps [min]; null if unknown. */
  readonly minutes: number | null;
  /** True for the user's own file; false for a built-in scenario. */
  readonly given: boolean;
  /** Whether the scenario has a script that can fly it. */
  readonly scripted: boolean;
}

/**
 * Role of this page, and the page in control.
 *
 * The server sends this message on connection, and whenever its content changes.
 */
export interface Role {
  readonly type: 'role';
  readonly flying: boolean;
  /** False if the page's address is for observing only: this page cannot take control. */
  readonly may_fly: boolean;
  /** Number of observers: pages that can take control but are not in control. */
  readonly watchers: number;
  /** Number of this page, from 1; 0 if it cannot take control. */
  readonly number: number;
  /** Number of the page in control; 0 if no page is in control. */
  readonly flier: number;
  /** Number of the page that asks for the sticks; 0 if no page asks. */
  readonly asking: number;
  /** Name that the person at this page has set; empty if no name is set. */
  readonly name: string;
  /** Names of all pages that have a name, including this page. */
  readonly names: readonly NamedPage[];
}

/** Number of a page, and the name of its user. */
export interface NamedPage {
  readonly number: number;
  /** Name for display on all pages; if two pages have the same name, the page's number is appended. */
  readonly name: string;
}

/** All data that the page shows of one control step. The server may skip frames and sends the newest one. */
export interface Frame {
  readonly type: 'frame';
  /** number of control steps done */
  readonly tick: number;
  /** simulated time: tick x control period [s] */
  readonly time_s: number;
  /** name of the script's phase; empty with manual inputs */
  readonly phase: string;
  /** source of this step's inputs */
  readonly by: 'hand' | 'script';
  /** mode: selected panel position */
  readonly mode: string;
  /** number of the steering law: 1 to 8 as in the report, 0 TEST, 9 DIRECT, 10 MASTER */
  readonly law: number;
  /** position of the switch that selects the steering law of OPR CMD and AUTO 1-4 */
  readonly law_choice: LawChoice;
  /** whether the switch beside ORB LD selects rotation about payload axes */
  readonly payload_axes: boolean;
  /** whether RATE HOLD keeps a stick command */
  readonly rate_hold: boolean;
  /** whether POSITION HOLD is on */
  readonly position_hold: boolean;
  /** whether BRAKES are on */
  readonly brakes: boolean;
  /** whether SAFING commands zero joint rates */
  readonly safing: boolean;
  /** selected joint, from 0 */
  readonly joint: number;
  /** rate setting */
  readonly rate: Rate;
  /** state of an automatic mode; `checking` while CMD CK runs */
  readonly sequence: Sequence;
  /** AUTO 1-4: number of the present or next point, from 1; 0 in other modes */
  readonly point: number;
  /** AUTO 1-4: total number of points; 0 in other modes */
  readonly points: number;
  /** result of CMD CK for the present target; null if there is none */
  readonly check: Check | null;
  /** THC deflection that acted, in [-1, 1], along the axes of control */
  readonly translation: Vec3;
  /** RHC deflection that acted, in [-1, 1], along the axes of control */
  readonly rotation: Vec3;
  /** DRIVE deflection that acted, in [-1, 1] */
  readonly drive: number;
  /** joint angles, measured [rad] */
  readonly angles: readonly number[];
  /** joint rates, measured [rad/s] */
  readonly rates: readonly number[];
  /** joint angles that the commanded rates alone would give [rad] */
  readonly angles_commanded: readonly number[];
  /** joint rates, commanded [rad/s] */
  readonly rates_commanded: readonly number[];
  /** joint rate limits in force [rad/s] */
  readonly rate_limits: readonly number[];
  /** for each joint: 0 free, 1 beyond the reach limit, 2 beyond the soft stop, 3 at the hard stop */
  readonly zones: readonly number[];
  /** position of the tip [m], along the axes of L */
  readonly position: Vec3;
  /** attitude of frame 7, along the axes of L */
  readonly orientation: Rows;
  /** T_B5: attitude of the wrist-pitch frame 5 in the orbiter's body axes; on the concept arm, attitude of the lower arm's frame; null in a recording that does not contain it, along the axes of orbiter */
  readonly wrist_pitch: Rows | null;
  /** position of the point of resolution: the payload's in ORB LD and PL, else the tip [m], along the axes of L */
  readonly resolution: Vec3;
  /** payload in the grasp; null if the grasp is empty */
  readonly payload: readonly [position: Vec3, orientation: Rows] | null;
  /** if the payload in the grasp is one of `Scenario.own_payloads`, its number, from 1; 0 for any other payload, and for an empty grasp */
  readonly attached: number;
  /** angular velocity, and velocity of the point of resolution [rad/s, m/s], along the axes of L */
  readonly twist: Six;
  /** twist after RATLMT's limits [rad/s, m/s], along the axes of L */
  readonly twist_commanded: Six;
  /** twist that the mode demands, before all limits [rad/s, m/s], along the axes of L */
  readonly twist_demanded: Six;
  /** speed limit and angular rate limit of the point of resolution in this step [m/s, rad/s] */
  readonly por_limits: Vec2;
  /** fraction of the demand that RATLMT permits, 0 to 1 */
  readonly ratio: number;
  /** limits that were active in this step */
  readonly limits: readonly Limit[];
  /** signed distances from the arm's singularities: shoulder, elbow, wrist; or only rank */
  readonly singularity: readonly number[];
  /** singularities nearer than the arm's threshold */
  readonly singular: readonly string[];
  /** escape direction from each singularity in `singular` and each joint beyond a limit; while a contact inhibits the arm, only the escape direction from the contact */
  readonly ways_out: readonly WayOut[];
  /** target of an automatic mode; null if there is none */
  readonly goal: Goal | null;
  /** TP, ETA and ETAP */
  readonly times: Times;
  /** state of the worksite: contacts, captures and payloads */
  readonly work: Work;
  /** events of this step */
  readonly events: readonly Event[];
  /** pan, tilt and field of view of the driven cameras, in the order of `scenario.all_cameras.cameras_of` [rad] */
  readonly views: readonly (readonly [pan: number, tilt: number, zoom: number])[];
  /** SHA-256 of the exact state */
  readonly sha256: string;
  /** motion of the bodies; null on the kinematic plant, where the encoders show it */
  readonly dynamics: Dynamics | null;
  /** mechanisms in motion: latches, snares, carriage, prong, telescope */
  readonly motions: readonly Motion[];
  /** changes in flight that are in force, each as KEY=VALUE; empty if there are none */
  readonly changes: readonly string[];
  readonly display: Display;
}

/** Verdict of CMD CK, from a rehearsal of the motion to a target. */
export interface Check {
  /** true for GOOD, false for FAIL */
  readonly good: boolean;
  /** verdict as displayed: `GOOD: 83 s` or `FAIL: elbow pitch reaches its soft stop, after 12 s` */
  readonly text: string;
  /** GOOD: duration of the motion; FAIL: time from the start of the motion to the failure [s] */
  readonly seconds: number;
  /** cause of a FAIL; empty for GOOD */
  readonly cause: Cause;
  /** GOOD in mode 1: joint angles at the target; null in modes 2 and 3, and for FAIL [rad] */
  readonly joints: readonly number[] | null;
}

/** Limit that acted in a step. */
export interface Limit {
  /** kind of limit */
  readonly kind: LimitKind;
  /** joint to which the limit applies, from 0; -1 if the limit applies to no joint */
  readonly joint: number;
  /** text for the operator */
  readonly text: string;
}

/** Command that leads away from a singularity or joint limit, or out of contacts that inhibit the arm. */
export interface WayOut {
  /** cause of the escape direction: `elbow` (a singularity), a joint's name, or `contact` */
  readonly cause: string;
  /** text for the operator: `THC -X`, `RHC +pitch`, `SINGLE elbow pitch -` */
  readonly text: string;
  /** stick or switch to deflect */
  readonly stick: 'translation' | 'rotation' | 'joint' | 'telescope';
  /** axis of the stick, 0 to 2, or number of the joint */
  readonly axis: number;
  /** direction: +1 or -1 */
  readonly sign: number;
  /** panel position to select first; empty if the stick acts in the present position */
  readonly position: string;
}

/** Target of an automatic mode (pose of frame 7), and the remaining distance, angle and time. */
export interface Goal {
  /** position of the tip at the target [m], along the axes of L */
  readonly position: Vec3;
  /** attitude of frame 7 at the target, along the axes of L */
  readonly rotation: Rows;
  /** remaining distance [m] */
  readonly distance: number;
  /** remaining rotation [rad] */
  readonly angle: number;
  /** ETA - TP; 0 if no motion is in progress, or while the arm slows to rest before a motion in mode 1 or 3 [s] */
  readonly remaining_s: number;
}

/**
 * Times of the present phase (JSC-12628's term), counted from the beginning of the phase.
 *
 * Such a phase begins with an automatic motion, a phase of the script, the selection of a panel position or a
 * re-initialisation.
 */
export interface Times {
  /** TP: time since the beginning of the phase [s] */
  readonly tp_s: number;
  /** ETA: end of the phase; an estimate in automatic modes, else the duration of the script's phase; null if unknown [s] */
  readonly eta_s: number | null;
  /** ETAP: time at which the rotation would end without the translation, with the angular rate limit; null in all modes except 2 and 3 [s] */
  readonly etap_s: number | null;
}

/** The worksite after a step. */
export interface Work {
  /** task phase, the report's MODE: 1 acquisition, 2 extraction, 3 manoeuvring, 4 docked */
  readonly task: number;
  /** monitored pair with the minimum clearance; null if no pair is monitored. A pair that the task brings into contact is left out, because the conditions report its distance */
  readonly nearest: Near | null;
  /** alarm level of the minimum clearance, from the scenario's thresholds */
  readonly clearance_level: Level;
  /** pairs that touch or overlap */
  readonly contacts: readonly Near[];
  /** whether a contact inhibits the arm */
  readonly arm_inhibit: boolean;
  /** whether a contact inhibits the finger */
  readonly finger_inhibit: boolean;
  /** reasons for which the arm or the finger is inhibited */
  readonly inhibits: readonly string[];
  /** action that becomes possible once the conditions hold; null if no action is near */
  readonly objective: Objective | null;
  /** conditions of capture, docking or latching */
  readonly conditions: readonly Condition[];
  /** state of the end effector */
  readonly hand: Hand;
  /** length of the telescope; null on an arm without a telescope [m] */
  readonly stand: number | null;
  /** displacement of the orbiter since the start [m], along the axes of L */
  readonly orbiter: Vec3;
  /** velocity of the orbiter [m/s], along the axes of L */
  readonly orbiter_velocity: Vec3;
  /** state of each payload of the worksite */
  readonly cargo: readonly Cargo[];
  /** joint angles of the master arm; null in modes other than MASTER [rad] */
  readonly master: readonly number[] | null;
}

/** Two monitored parts. */
export interface Near {
  /** name of the first part: `lower boom` */
  readonly a: string;
  /** name of the second part */
  readonly b: string;
  /** distance of the two parts; negative if they overlap [m] */
  readonly clearance: number;
  /** speed at which the two closest points approach each other; negative if they separate [m/s] */
  readonly closing: number;
  /** closest point of the first part [m], along the axes of L */
  readonly point_a: Vec3;
  /** closest point of the second part [m], along the axes of L */
  readonly point_b: Vec3;
  /** unit normal of a plane between the two parts, from `a` to `b`; zero if the parts are in contact, along the axes of L */
  readonly normal: Vec3;
  /** distance of that plane from the origin; 0 if the parts are in contact [m], along the axes of L */
  readonly distance: number;
  /** whether a contact of the two parts belongs to the task and therefore inhibits nothing */
  readonly essential: boolean;
  /** feature of `a` that touches `b`: `vertex 3`; empty if the parts are not in contact */
  readonly feature_a: string;
  /** feature of `b` that touches `a`; empty if the parts are not in contact */
  readonly feature_b: string;
}

/** Action that becomes possible at the present position of the end effector once the conditions hold. */
export interface Objective {
  /** kind of action that becomes possible */
  readonly action: 'acquire' | 'capture' | 'dock' | 'insert' | 'berth';
  /** the action as a text for the operator: `acquire payload`, `berth in the Cargo bay` */
  readonly text: string;
}

/** One condition with its measured value, its limit and its margin. */
export interface Condition {
  /** name of the condition, such as `palm height` */
  readonly name: string;
  /** whether the condition holds */
  readonly holds: boolean;
  /** measured value, in `unit` */
  readonly value: number;
  /** bound with which the value is compared, in `unit`: the nearer bound of two, or the exceeded bound */
  readonly limit: number;
  /** unit of value, limit and margin; empty for a count */
  readonly unit: 'm' | 'rad' | 'm/s' | 'rad/s' | 's' | '';
  /** margin, in `unit`; negative if the condition fails */
  readonly margin: number;
  /** text for the operator with `{}` in place of each number: `palm {} above the bar, {} to {} allowed` */
  readonly words: string;
  /** numbers of the text, in `unit` */
  readonly numbers: readonly number[];
}

/** The end effector. */
export interface Hand {
  /** position of the end effector's switch */
  readonly switch: EffectorSwitch;
  /** opening of the prong or the snares, from 0 (closed) to 1 (open) */
  readonly opening: number;
  /** distance from the prong to the fixed finger; null on an arm without a prong [m] */
  readonly spacing: number | null;
  /** position of the carriage, from 0 (extended) to 1 (retracted); null on an arm without a carriage */
  readonly carriage: number | null;
  /** flags that are lit on the panel: `CAPTURE`, `RIGID` */
  readonly flags: readonly string[];
  /** position of END EFFECTOR MODE */
  readonly mode: 'auto' | 'manual';
  /** position of END EFFECTOR MAN CONTR */
  readonly rigid: 'off' | 'rigid' | 'derigid';
}

/** A payload of the worksite. */
export interface Cargo {
  /** name of the payload */
  readonly name: string;
  /** position of the payload's centre [m], along the axes of L */
  readonly position: Vec3;
  /** orientation of the payload's axes, along the axes of L */
  readonly orientation: Rows;
  /** velocity of the payload's centre [m/s], along the axes of L */
  readonly velocity: Vec3;
  /** whether the end effector holds the payload */
  readonly held: boolean;
  /** berth to which the payload is fixed; empty if it is not fixed to a berth */
  readonly seat: string;
}

/** Event of a step, as a line of the log. */
export interface Event {
  /** simulated time [s] */
  readonly time_s: number;
  /** kind of event, such as `mode` or `contact` */
  readonly kind: string;
  /** urgency */
  readonly level: Level;
  /** text for the operator */
  readonly text: string;
}

/**
 * Motion of the bodies behind the joints: what the encoders do not show, on a plant with masses.
 *
 * Fields of `Frame` about the arm follow from the measured angles; the fields here follow from the bodies.
 */
export interface Dynamics {
  /** true position of the tip [m], along the axes of L */
  readonly position: Vec3;
  /** true attitude of frame 7, along the axes of L */
  readonly orientation: Rows;
  /** true distance and angle of the tip from the target; null if there is none [m, rad] */
  readonly miss: Vec2 | null;
  /** torque of motor or brake about each joint, at the end of the step [N m] */
  readonly torques: readonly number[];
  /** joints, from 0, that turn against a motor or brake at its greatest torque */
  readonly overdriven: readonly number[];
  /** pose of L, relative to its pose at the start of the run [m, 1], along the axes of L */
  readonly orbiter: readonly [position: Vec3, orientation: Rows];
  /** time for which the orbiter's jets have fired, about and along forward, starboard, down [s] */
  readonly fired: Six;
  /** forces between parts in contact */
  readonly contacts: readonly Force[];
  /** forces that hold the worksite's payloads */
  readonly holds: readonly Holding[];
  /** bends of base and booms; empty if the arm is rigid */
  readonly bends: readonly Bend[];
  /** forces and torques that disturb bodies */
  readonly disturbances: readonly Wrench[];
}

/** Force between two parts in contact, in one control step. */
export interface Force {
  /** first part */
  readonly a: string;
  /** second part */
  readonly b: string;
  /** mean force on the second part; times the control period, the impulse [N], along the axes of L */
  readonly force: Vec3;
  /** point at which it acts [m], along the axes of L */
  readonly position: Vec3;
  /** greatest force within the control step; null in files of earlier versions, whose `force` is that at its end [N] */
  readonly greatest: number | null;
}

/** Force by which something holds a payload of the worksite. */
export interface Holding {
  /** name of the payload */
  readonly payload: string;
  /** what holds the payload */
  readonly by: Holder;
  /** force at the payload's centre, at the end of the step [N] */
  readonly force: number;
  /** greatest force within the control step, if solids are near each other, else that at its end; null in files of earlier versions [N] */
  readonly greatest: number | null;
}

/**
 * How far a part of the arm is bent: the motion of its end relative to the straight part.
 *
 * Its components are in the frame that carries the part: L for the base, the frame of the joint for a boom.
 */
export interface Bend {
  /** name of the part: `base`, `upper_boom` or `lower_boom` */
  readonly part: string;
  /** displacement of the part's end [m], along the axes of part */
  readonly displacement: Vec3;
  /** rotation vector of the part's end [rad], along the axes of part */
  readonly rotation: Vec3;
}

/** Disturbance that acts on a body in one control step, in the axes that L has when the step begins. */
export interface Wrench {
  /** what it acts on: `tip`, `orbiter`, or the name of a payload */
  readonly body: string;
  /** mean force on the body [N], along the axes of L */
  readonly force: Vec3;
  /** mean torque on the body in addition to that of the force [N m], along the axes of L */
  readonly torque: Vec3;
  /** point at which the force acts [m], along the axes of L */
  readonly position: Vec3;
}

/** A mechanism in motion. */
export interface Motion {
  /** mechanism and what it does: `latches close`, `snares open` */
  readonly text: string;
  /** time in which the mechanism reaches its end position [s] */
  readonly remaining_s: number;
}

/** Data that a page needs to display a frame: read-outs in panel components, lamps, and poses in the scene frame. */
export interface Display {
  /** Steps that the page shows; null in a replay, which shows this step. */
  readonly link: LinkSteps | null;
  /** `seq` of the last `Sticks` received before this step; the page computes the latency from this number. */
  readonly stick_seq: number;
  /** `seq` of the `Sticks` that acted in this step, after the command delay; -1 if no page's `Sticks` acted. */
  readonly flown_seq: number;
  /** What supplied the inputs of this step, until a stick moves; null with the inputs of a page. */
  readonly autopilot: AutopilotName | null;
  /** Simulated time in the recording so far [s]; null if the run is not recorded. */
  readonly recording_s: number | null;
  readonly actual: Resolution;
  readonly commanded: Resolution;
  /** Target of an automatic mode. */
  readonly aim: Aim | null;
  /** PL ID of the captured payload, as in `Welcome.payloads`; 0 if there is none. */
  readonly payload_id: number;
  /** Vector from the tip to the point of resolution of ORB LD and PL, in the end effector's axes [m]. */
  readonly por_offset: Vec3;
  /** Newest pair that the present step of the task brings together, or takes apart; null if there is none. */
  readonly task_pair: TaskPair | null;
  /** Remaining motion; null if there is no place to move to. */
  readonly to_go: ToGo | null;
  /** Progress through the task; null in a replay. */
  readonly task: TaskNow | null;
  /** Displacement of the orbiter: forward, starboard, down [m]. */
  readonly orbiter: Vec3;
  /** Velocity of the orbiter along the same axes [m/s]. */
  readonly orbiter_velocity: Vec3;
  readonly lamps: readonly Lamp[];
  /** Closest points of `Work.nearest`. */
  readonly gap: ClosestPoints | null;
  /** Closest points of each contact, in the order of `Work.contacts`. */
  readonly contacts: readonly ClosestPoints[];
  /** Forces between parts in contact, in the order of `Dynamics.contacts`, then those of `Dynamics.disturbances`. */
  readonly pushes: readonly Push[];
  /** Newest look-ahead; null before the first one. */
  readonly ahead: Ahead | null;
  /** Orientation of the control frame in the scene frame; the page draws these axes in the pictures. */
  readonly axes: Quat;
  /** Seven numbers for each body, in the order of `Welcome.bodies`: x, y, z [m], w, x, y, z, in the scene frame. */
  readonly poses: readonly number[];
  readonly lighting: Lighting;
}

/**
 * Number of a step, and the steps that the pages show when it has been made.
 *
 * The numbers count all steps of a session from 1; a restart does not reset them. A page shows the newest frame that
 * it has up to a step, or else its first one. A number below 1 belongs to no step: nothing has arrived yet.
 */
export interface LinkSteps {
  /** Number of the step itself. */
  readonly step: number;
  /** Step whose values, lamps and log the pages show. */
  readonly telemetry: number;
  /** Step that the pictures of all cameras show, except those in `cameras`. */
  readonly pictures: number;
  /** Cameras whose pictures show another step. */
  readonly cameras: readonly (readonly [camera: string, step: number])[];
}

/** Point of resolution, in panel components. */
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

/** Target of an automatic mode, in panel components; `Frame.goal` has the remaining distance and angle. */
export interface Aim {
  readonly position: Vec3;
  readonly attitude: Vec3;
}

/** Two parts that the present step of the task brings together, or takes apart. */
export interface TaskPair {
  readonly a: string;
  readonly b: string;
  /** Distance of the two parts [m]; negative if they overlap. */
  readonly clearance: number;
  /** Speed at which their closest points approach each other [m/s]; negative if they separate. */
  readonly closing: number;
}

/** Remaining motion to the place where the task needs the tip or the held payload. */
export interface ToGo {
  /** The place: `pin`, `bar`, a berth's title, `target`, or a joint's name. */
  readonly to: string;
  /** Displacement of the point that the sticks move, along the axes of the sticks [m]; null without sticks. */
  readonly translation: Vec3 | null;
  /** Rotation vector about the axes of the sticks: roll, pitch, yaw [rad]; null without sticks. */
  readonly rotation: Vec3 | null;
  /** Distance to the place, or of a joint that slides [m]; 0 for a joint that turns. */
  readonly distance: number;
  /** Rotation that is left [rad]; for a joint, its signed motion [rad or m]. */
  readonly angle: number;
  /** Distance [m] and angle [rad] within which the place is reached; for a joint that slides, a length twice. */
  readonly near: Vec2;
  /** Speed at which the distance becomes smaller [m/s]; negative if it grows, null if it is not known. */
  readonly closing: number | null;
  /**
   * Motion of the tip, and of a held payload, to the place, in the scene frame: x, y, z [m], then w, x, y, z.
   *
   * Empty if a joint has to move.
   */
  readonly shift: readonly number[];
}

/** Progress through `Welcome.steps`. */
export interface TaskNow {
  /** Index of the present step; the number of steps when all are past. */
  readonly at: number;
  /** Index of the present step's hint that applies; -1 for the step's own text. */
  readonly hint: number;
  /** Index of the step at which the run began; above 0 after a re-initialisation to a part of the problem. */
  readonly first: number;
  /** For each step, the simulated time at which it was completed [s]; null if it is open or was skipped. */
  readonly done_s: readonly (number | null)[];
  /** Result of the run; null until all steps are past. */
  readonly debrief: Debrief | null;
}

/** Result of a run, when all steps of the task are past. */
export interface Debrief {
  /** A without faults; each kind of fault lowers the grade by one. Null if a step was skipped or the script flew. */
  readonly grade: Grade | null;
  /** Kinds of faults: `2 warnings by CLEARANCE`. */
  readonly faults: readonly string[];
  /** Values that summarise the run. */
  readonly figures: readonly Measure[];
}

/** Number or text that describes the whole run. */
export interface Measure {
  readonly name: string;
  readonly quantity: Quantity;
  readonly value: number | null;
  /** Value as text if `quantity` is `words`; otherwise empty. */
  readonly text: string;
  /** Explanation of the figure, in a sentence. */
  readonly about: string;
  /** Angle between the two objects whose distance is `value` [rad]; null if not applicable. */
  readonly angle: number | null;
  /** Worst alarm level of this figure during the run. */
  readonly level: Level;
}

/** A lit lamp and its cause. */
export interface Lamp {
  readonly name: FlightLamp;
  readonly level: Level;
  /** Cause, such as `elbow 0.12` for SINGULAR. */
  readonly text: string;
  /** Whether the lamp raises no alarm: lit at this level since the first step of the run, or about the computer. */
  readonly standing: boolean;
}

/** Closest points of two monitored parts, in the scene frame. */
export interface ClosestPoints {
  readonly point_a: Vec3;
  readonly point_b: Vec3;
  /** Point of the separating plane, halfway between the closest points. */
  readonly plane: Vec3;
  /** Unit normal of this plane, from a to b; zero if the parts overlap. */
  readonly normal: Vec3;
}

/** Force between two parts in contact, or of a disturbance, in the scene frame. */
export interface Push {
  /** Point at which the force acts [m]. */
  readonly point: Vec3;
  /** Force on the second part, or on the disturbed body [N]. */
  readonly force: Vec3;
}

/**
 * Look-ahead: predicted state of the arm after some seconds with the present stick command.
 *
 * The station computes it every 10 control steps: five times a second with the default control period.
 */
export interface Ahead {
  /** Time span of the look-ahead [s]. */
  readonly seconds: number;
  /**
   * True if the look-ahead was computed with the present stick command.
   *
   * False under BRAKES or SAFING, and if the sticks are centred. In the last case, the look-ahead may assume full
   * deflection of the axis that was deflected last.
   */
  readonly held: boolean;
  /** True if the arm's pose at the end of the time span differs from the present pose. */
  readonly moves: boolean;
  /** Minimum clearance at the end of the time span [m]; null if no pair then counts for CLEARANCE. */
  readonly clearance: number | null;
  /** `a` and `b`: the two parts with this clearance; empty if `clearance` is null. */
  readonly a: string;
  readonly b: string;
  /** Time to the first contact [s]; null if the look-ahead found no contact. */
  readonly contact_s: number | null;
  /** Distance that the tip still moves if the sticks are centred now [m]. */
  readonly stopping: number;
  /** Joint nearest to a reach limit at the end of the time span, from 0. */
  readonly joint: number;
  /** Motion from this joint to its reach limit at the end of the time span [rad or m]; negative past the limit. */
  readonly room: number;
  /** Seven numbers for each body of `Welcome.ghost`, as in `Display.poses`. */
  readonly poses: readonly number[];
}

/**
 * Picture of a camera in the look of 1972: convex polygons, in the order in which they are painted.
 *
 * The server sends it to the pages that have asked for it (`ShowPolygons`), with each frame that it draws.
 */
export interface Polygons {
  readonly type: 'polygons';
  /** Step of the frame: `LinkSteps.step`, in a replay `Frame.tick`; -1 if the picture belongs to no frame. */
  readonly step: number;
  readonly camera: string;
  /**
   * x and y of all corners, as 16-bit integers (little-endian): 10,000 is half the width of the picture.
   *
   * The origin is the middle of the picture; x points to the right and y downwards.
   */
  readonly points: string;
  /** Number of corners of each polygon, a byte each. */
  readonly corners: string;
  /** Grey of each polygon, 0 to 255, a byte each. */
  readonly greys: string;
  /** Sentence that says why there are no polygons; empty if there are. */
  readonly text: string;
  /** Part of the preparation of the first picture that is done, 0 to 1; null if none is in progress. */
  readonly share: number | null;
}

/** New log lines, oldest first. The server may skip frames, but never a log line. */
export interface Events {
  readonly type: 'events';
  readonly events: readonly Event[];
}

/** Data for a page that draws strips: at first the data of the last minutes of the run, later only new data. */
export interface Recent {
  readonly type: 'recent';
  /**
   * All strips, with empty curves, in the first message about a run: the page then deletes all older data.
   *
   * Empty in later messages.
   */
  readonly strips: readonly Strip[];
  readonly samples: readonly Sample[];
  /**
   * All lanes of the last minutes, if an interval of any lane has started since the last message.
   *
   * Otherwise empty: the last interval of each lane then continues.
   */
  readonly lanes: readonly Lane[];
}

/** Strip chart of one quantity over the run. */
export interface Strip {
  readonly name: string;
  readonly quantity: Quantity;
  readonly curves: readonly Curve[];
  readonly low: number;
  /** `low` and `high`: least and greatest value; the range includes zero if `rests` is true. */
  readonly high: number;
  /** Limit that the page draws as a line across the strip; null if the quantity has no limit. */
  readonly limit: number | null;
  /** Threshold below which a value causes a caution, such as a clearance threshold; null if not applicable. */
  readonly caution: number | null;
  /** Threshold below which a value causes a warning; null if not applicable. */
  readonly warning: number | null;
  /** True if the page draws the strip before the user selects strips. */
  readonly shown: boolean;
  /** True if zero is the value at rest; the drawn range then includes zero. */
  readonly rests: boolean;
}

/** Curve of a strip, with fewer points than steps; it keeps every peak. */
export interface Curve {
  readonly role: 'actual' | 'commanded';
  readonly times_s: readonly number[];
  /** Values at `times_s`; null where the quantity had no value. */
  readonly values: readonly (number | null)[];
}

/** Values of all strips in one control step. */
export interface Sample {
  readonly time_s: number;
  /** Values of all curves, in the order of the strips; null where a curve has no value. */
  readonly values: readonly (number | null)[];
  /** Name of the joint nearest to its rate limit; empty if no joint moves. */
  readonly worst: string;
}

/** Row of consecutive intervals, up to the last frame. */
export interface Lane {
  readonly name: string;
  readonly stretches: readonly Stretch[];
}

/** Interval of a lane in which the label and the level do not change. */
export interface Stretch {
  readonly start_s: number;
  readonly end_s: number;
  /** State in this interval; empty if the lane shows nothing. */
  readonly label: string;
  readonly level: Level;
}

/**
 * What is not ready yet, and whether the run waits for it. Sent on connection and whenever it changes.
 *
 * Until the laws are compiled, the run uses them as plain Python, and has no look-ahead.
 */
export interface Readiness {
  readonly type: 'readiness';
  /** What the run waits for: the first pictures of the page in control, or the laws; empty if it goes on. */
  readonly waits_for: WaitsFor;
  /** Part of the compilation of the laws that is done, 0 to 1 in steps of 0.01; null if none is in progress. */
  readonly share: number | null;
  /** Time until its end, in whole seconds [s]; null if it is not known. */
  readonly left_s: number | null;
  /** Sentence that says why the laws stay plain Python; empty if they are compiled or will be. */
  readonly failure: string;
}

/** Recorded frame, with the value of each curve in this step. */
export interface Moment {
  readonly frame: Frame;
  /** Values of all curves, in the order of the strips; null where a curve has no value. */
  readonly values: readonly (number | null)[];
  /** Name of the joint nearest to its rate limit; empty if no joint moves. */
  readonly worst: string;
}

/** First message of a page, with the protocol version that the page uses. */
export interface Hello {
  readonly type: 'hello';
  readonly protocol: number;
  /**
   * True for a secondary window or a page that is too narrow: it cannot take control.
   *
   * A page that becomes wide enough sends `TakeSeat`; it can then take control.
   */
  readonly shows: boolean;
  /** True if the page draws strips: the server then also sends `Recent` messages. */
  readonly strips: boolean;
}

/** Cameras that the monitors of the operator's page showed from `time_s` on. */
export interface Pictured {
  readonly time_s: number;
  /** Names of the cameras on MON 1 and on MON 2: two if the monitor was split, none if no page was in control. */
  readonly monitors: readonly (readonly string[])[];
}

/** Result of comparing the re-simulated frames with the recorded ones. */
export interface Verdict {
  readonly state: 'checking' | 'equal' | 'different' | 'impossible';
  /** Text for display: `all 2002 frames equal`. */
  readonly text: string;
}

/** File in the folder of a station that records. */
export interface Recorded {
  /** Name of the file, without its folder. */
  readonly file: string;
  /** Wall time of the last write to the file, ISO 8601, UTC. */
  readonly changed: string;
  /** True if the present run is being recorded into this file. */
  readonly now: boolean;
  /** Title of the scenario; empty if the list of recordings does not have this file. */
  readonly title: string;
  /** Simulated time of the run [s]; null during the run, and if the list does not have this file. */
  readonly time_s: number | null;
  /** End of the run: `completed`, `time`, `fault`, `stopped`, `restarted`, `cut`; empty if not known. */
  readonly ended: string;
  /** Grade of the operator's task: `A` to `D`; empty if the task was not completed or has no grade. */
  readonly grade: string;
}

/** Fields of the welcome that are in force from a step on. */
export interface ChangedFrom {
  readonly tick: number;
  readonly fields: Changed;
}

/** Data of a recording that the page needs before it draws the first frame. */
export interface PlaybackIndex {
  readonly welcome: Welcome;
  /** Name of the file, without its folder. */
  readonly file: string;
  /** Wall time at which the run began, ISO 8601, UTC. */
  readonly began: string;
  /** Version of Aftdeck that made the recording. */
  readonly version: string;
  readonly seed: number;
  /** Changes that a re-run made to the scenario, each as KEY=VALUE. */
  readonly changes: readonly string[];
  /** Code of the participant; empty if not given. */
  readonly participant: string;
  /** Condition of the trial; empty if not given. */
  readonly condition: string;
  /** Duration of a control step [s]. */
  readonly period_s: number;
  /** Number of steps in the recording. */
  readonly ticks: number;
  /** Number of steps from one frame to the next: 1 if the blocks contain every frame. */
  readonly stride: number;
  /** Number of moments in each block except the last. */
  readonly block: number;
  /** Reason for the end of the run; empty if the recording was cut short. */
  readonly ended: string;
  readonly verdict: Verdict;
  readonly events: readonly Event[];
  readonly lanes: readonly Lane[];
  readonly pictures: readonly Pictured[];
  readonly strips: readonly Strip[];
  readonly measures: readonly Measure[];
  /**
   * Fields of the welcome that changes in flight have changed, in the order of the steps; the first one is in force
   * at the start. Empty if nothing was changed.
   */
  readonly changed: readonly ChangedFrom[];
}
