/**
 * A SpaceMouse, read through WebHID. Report 1 contains three translations or all six axes, report 2 three rotations,
 * and report 3 the buttons, one bit for each. An axis is a little-endian 16-bit number; full deflection is about 350.
 * Sources of these layouts: PySpaceMouse's table of devices, and spacenavd. If a report has an unknown length, the page
 * says so, and nothing moves.
 */

import { clamp } from '../basics/clamp';
import { Silence } from '../basics/silence';
import type { Reading } from './reading';

/** Vendors: Logitech (early models) and 3Dconnexion. */
const VENDORS = [0x046d, 0x256f];
/** Usage “generic desktop, multi-axis controller”, which excludes these vendors' mice and keyboards. */
const PAGE = 0x01;
const USAGE = 0x08;
const FULL = 350;
const AXES = 6;
const MOST_BUTTONS = 32;
/** A deflected cap sends reports continuously. After this time without a report, the SpaceMouse counts as lost [ms]. */
const SILENCE_MS = 500;
/** Silence between two readings counts at most as this time [ms], because a busy page receives reports late. */
const MOST_SILENCE_MS = 50;
/** A cap that is silent for this time after the SpaceMouse was opened is at rest [ms]. */
const SETTLED_MS = 200;

const [TRANSLATION, ROTATION, BUTTONS] = [1, 2, 3];

export interface Cap {
  readonly axes: readonly number[];
  readonly buttons: readonly boolean[];
}

export const CAP_AT_REST: Cap = { axes: Array<number>(AXES).fill(0), buttons: [] };

/** Returns the cap's reading after a report; null if the report has an unknown length. Other reports are ignored. */
export function parsed(cap: Cap, report: number, data: DataView): Cap | null {
  if (report === BUTTONS) return { ...cap, buttons: bits(data) };
  if (report !== TRANSLATION && report !== ROTATION) return cap;
  const first = report === TRANSLATION ? 0 : 3;
  const count = data.byteLength >= 12 && report === TRANSLATION ? AXES : 3;
  if (data.byteLength < 2 * count || (count === 3 && data.byteLength > 8)) return null;
  const axes = [...cap.axes];
  for (let i = 0; i < count; i += 1) {
    axes[first + i] = clamp(data.getInt16(2 * i, true) / FULL);
  }
  return { ...cap, axes };
}

function bits(data: DataView): readonly boolean[] {
  const count = Math.min(MOST_BUTTONS, 8 * data.byteLength);
  return Array.from({ length: count }, (_, i) => ((data.getUint8(i >> 3) >> (i & 7)) & 1) === 1);
}

/** The part of WebHID that is used here, which TypeScript's library lacks. */
interface HidDevice extends EventTarget {
  readonly vendorId: number;
  readonly productName: string;
  readonly opened: boolean;
  readonly collections: readonly { readonly usagePage?: number; readonly usage?: number }[];
  open(): Promise<void>;
}

interface Hid extends EventTarget {
  getDevices(): Promise<readonly HidDevice[]>;
  requestDevice(options: { filters: readonly object[] }): Promise<readonly HidDevice[]>;
}

interface ReportEvent extends Event {
  readonly reportId: number;
  readonly data: DataView;
}

function hid(): Hid | undefined {
  return (navigator as Navigator & { hid?: Hid }).hid;
}

export class SpaceMouse {
  /** Product name; empty before a SpaceMouse is connected. */
  name = '';
  /** Problem that prevents the use of the SpaceMouse, in a sentence; empty if there is none. */
  problem = '';
  private device: HidDevice | null = null;
  private cap = CAP_AT_REST;
  /** Whether a report has arrived since the SpaceMouse was opened. */
  private heard = false;
  private readonly silence = new Silence(MOST_SILENCE_MS);
  private readonly ended = new AbortController();

  constructor() {
    const { signal } = this.ended;
    hid()?.addEventListener(
      'disconnect',
      (event) => this.gone((event as Event & { device: HidDevice }).device),
      {
        signal,
      },
    );
    hid()?.addEventListener('connect', () => void this.find((all) => all.getDevices()), { signal });
    // If the user has allowed a device in an earlier visit, the page uses it without asking again.
    void this.find((all) => all.getDevices());
  }

  /** Whether this browser supports WebHID. */
  get possible(): boolean {
    return hid() !== undefined;
  }

  /** Asks the user to choose a device; the browser allows this only after a click or a key. */
  async connect(): Promise<void> {
    const filters = VENDORS.map((vendorId) => ({ vendorId, usagePage: PAGE, usage: USAGE }));
    await this.find((all) => all.requestDevice({ filters }));
  }

  /**
   * Returns the reading at `now` [ms]; null if the SpaceMouse is not connected, is lost, sends unknown reports, or if it
   * is not known yet whether something deflects the cap.
   */
  reading(now: number): Reading | null {
    if (!this.device || this.problem) return null;
    const { axes, buttons } = this.cap;
    const silence = this.silence.at(now);
    const deflected = axes.some((value) => value !== 0);
    if (deflected ? silence > SILENCE_MS : !this.heard && silence < SETTLED_MS) return null;
    return { axes, buttons: buttons.map((pressed) => ({ pressed, value: Number(pressed) })) };
  }

  dispose(): void {
    this.ended.abort();
  }

  private async find(ask: (all: Hid) => Promise<readonly HidDevice[]>): Promise<void> {
    const all = hid();
    if (!all) return;
    try {
      await this.open((await ask(all)).find(isOurs));
    } catch (error) {
      this.problem = `The browser cannot open the SpaceMouse: ${error instanceof Error ? error.message : error}`;
    }
  }

  private async open(device: HidDevice | undefined): Promise<void> {
    if (!device || !isOurs(device) || this.device) return;
    if (!device.opened) await device.open();
    this.device = device;
    this.name = device.productName || 'SpaceMouse';
    this.problem = '';
    this.cap = CAP_AT_REST;
    this.heard = false;
    this.silence.end();
    device.addEventListener('inputreport', (event) => this.report(event as ReportEvent), {
      signal: this.ended.signal,
    });
  }

  private gone(device: HidDevice): void {
    if (device === this.device) this.device = null;
  }

  private report({ reportId, data }: ReportEvent): void {
    const cap = parsed(this.cap, reportId, data);
    this.heard = true;
    this.silence.end();
    if (cap) this.cap = cap;
    else
      this.problem = `Report ${reportId} with ${data.byteLength} bytes is unknown: this model is not supported.`;
  }
}

function isOurs(device: HidDevice): boolean {
  const capped = device.collections.some(({ usagePage, usage }) => usagePage === PAGE && usage === USAGE);
  return VENDORS.includes(device.vendorId) && capped;
}
