/** A live run: connects to the station's server, and gives every message to the page. */

import { assertUnreachable } from '../basics/assert';
import type { Sharpness } from '../cameras/fineness';
import { publish } from '../page/hook';
import { notice, startOrNotice } from '../page/notice';
import type { Drawing } from '../page/quality';
import { onTooNarrow, tooNarrow } from '../page/room';
import { Station } from '../page/station';
import type { DrawnBody } from '../scene/bodies';
import { LiveStrips } from '../windows/live-strips';
import { Display } from '../windows/monitor-window';
import { PLANES, showsPlanes, tornHere } from '../windows/opened';
import { PlanesWindow } from '../windows/planes-window';
import { renew } from './changed';
import { PolygonPictures } from './polygon-pictures';
import type { Frame, Event as LogEvent, Recent, Role, Scenarios, Welcome } from './protocol';
import { type FromSession, Link, type LinkState } from './socket';

/** Sentence that fills the page before the first run is available. */
function words(link: LinkState): string {
  if (link.kind === 'preparing') return link.text;
  return link.kind === 'lost'
    ? `No answer from the station, attempt ${link.attempt}. Check that aftdeck fly still runs, or start it again and open ` +
        'the address that it prints.'
    : 'Connecting to the station.';
}

/** The station, or the content of a secondary window. */
interface Content {
  readonly drawn: number;
  readonly shown: { readonly frame: Frame | null; readonly restarts: number };
  readonly bodies: readonly DrawnBody[];
  readonly sharpness: Sharpness | null;
  /** Pictures in the look of 1972; absent if none are shown. */
  readonly polygons?: PolygonPictures | null;
  setFrame(frame: Frame): void;
  addEvents?(events: readonly LogEvent[]): void;
  /** The station sends all lines of the log again. */
  forgetEvents?(): void;
  setRecent?(recent: Recent): void;
  /** Changes in flight have changed the welcome. */
  changed?(): void;
  dispose(): void;
}

export function fly(root: HTMLElement, drawing: Drawing): void {
  let station: Content | null = null;
  const torn = tornHere(location.search);
  let welcomed: Welcome | null = null;
  /** The welcome as it came: changes in flight change `welcomed`. */
  let welcomedText = '';
  let role: Role | null = null;
  let scenarios: Scenarios | null = null;

  function welcome(message: Welcome): void {
    // After a reconnection to the same run the page stays, and the server sends the whole log again.
    const text = JSON.stringify(message);
    if (station && text === welcomedText) {
      station.forgetEvents?.();
      station.polygons?.askAgain();
      return;
    }
    station?.dispose();
    station = null;
    welcomed = message;
    welcomedText = text;
    startOrNotice(root, () => start(message));
  }

  function start(message: Welcome): void {
    if (torn === 'strips') {
      station = new LiveStrips(root, message);
      return;
    }
    if (showsPlanes(torn)) {
      station = new PlanesWindow(root, message, torn === PLANES[0] ? 0 : 1);
      return;
    }
    if (torn !== null) {
      const polygons = new PolygonPictures((command) => link.send(command));
      station = new Display(root, message, drawing, torn, null, polygons);
      return;
    }
    const own = new Station(root, message, drawing, (command) => link.send(command));
    own.setTooNarrow(tooNarrow());
    if (role) own.setRole(role);
    if (scenarios) own.setScenarios(scenarios);
    station = own;
    document.title = `${message.title} · Aftdeck`;
  }

  function message(received: FromSession): void {
    switch (received.type) {
      case 'welcome':
        welcome(received);
        break;
      case 'scenarios':
        scenarios = received;
        if (station instanceof Station) station.setScenarios(received);
        break;
      case 'role':
        role = received;
        if (station instanceof Station) station.setRole(received);
        break;
      case 'frame':
        station?.setFrame(received);
        break;
      case 'polygons':
        station?.polygons?.put(received);
        break;
      case 'events':
        station?.addEvents?.(received.events);
        break;
      case 'recent':
        station?.setRecent?.(received);
        break;
      case 'readiness':
        if (station instanceof Station) station.setReadiness(received);
        break;
      case 'changed':
        if (welcomed) renew(welcomed, received);
        station?.changed?.();
        break;
      case 'typed':
      case 'completed':
        if (station instanceof Station) station.answer(received);
        break;
      case 'refused':
        if (station instanceof Station) station.refuse(received.text, received.seq);
        break;
      default:
        assertUnreachable(received);
    }
  }

  function state(now: LinkState): void {
    if (station instanceof Station) station.setLink(now);
    if (now.kind === 'refused') {
      station?.dispose();
      station = null;
      notice(root, now.sentence);
    } else if (now.kind !== 'open' && !station) {
      notice(root, words(now));
    }
  }

  const socket = new URL('ws', location.href);
  socket.protocol = location.protocol === 'https:' ? 'wss:' : 'ws:';
  socket.search = '';
  const link = new Link(socket.href, { message, state }, () => ({
    shows: torn !== null || tooNarrow(),
    strips: torn === 'strips',
  }));
  onTooNarrow(() => {
    if (station instanceof Station) station.setTooNarrow(tooNarrow());
    link.reseat();
  });
  publish(
    drawing.renderer,
    () => ({
      frames: station?.drawn ?? 0,
      lastFrame: station?.shown.frame ?? null,
      restarts: station?.shown.restarts ?? 0,
      bodies: station?.bodies ?? [],
      sharpness: station?.sharpness ?? null,
      latency95: station instanceof Station ? station.latency95 : null,
    }),
    () => (station instanceof Station ? station.views : null),
  );
}
