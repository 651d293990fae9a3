/** A secondary window of a replay: a monitor, all cameras or the strips, at the playhead of the replay's page. */

import type { Frame, PlaybackIndex } from '../link/protocol';
import { publish } from '../page/hook';
import type { Drawing } from '../page/quality';
import { Display } from '../windows/monitor-window';
import type { Pictured, WindowMessage } from '../windows/opened';
import { PLAYED, Tether } from '../windows/secondary-window';
import { StripWindow } from '../windows/strip-window';
import { missionTime } from '../words/format';
import { unitsOf } from '../words/units';
import { FlownChanges } from './flown-changes';
import { Player } from './player';
import { minutes } from './quantity';
import { RecordedPolygons } from './recorded-polygons';
import type { Source } from './source';
import { STEP } from './span';

/** Keys that zoom the time axis. They act in the window of the strips, not in the replay's page. */
const ZOOMS: Readonly<Record<string, 1 | -1>> = { Equal: 1, NumpadAdd: 1, Minus: -1, NumpadSubtract: -1 };

/** Fills a secondary window with one view of a recording. */
export function follow(
  root: HTMLElement,
  drawing: Drawing,
  source: Source,
  index: PlaybackIndex,
  what: Pictured | 'strips',
): void {
  const player = new Player(index, (number) => source.block(number));
  const heard = (message: WindowMessage) => {
    if (message.kind !== 'head') return;
    player.speed = message.speed;
    player.seek(message.position);
  };
  if (what === 'strips') showStrips(root, drawing, index, player, heard);
  else showPictures(root, drawing, index, player, source.polygons, what, heard);
}

function showPictures(
  root: HTMLElement,
  drawing: Drawing,
  index: PlaybackIndex,
  player: Player,
  polygons: Source['polygons'],
  what: Pictured,
  heard: (message: WindowMessage) => void,
): void {
  const { welcome, file } = index;
  const played = { file, heard };
  const changes = new FlownChanges(index);
  const flat = polygons ? new RecordedPolygons(polygons) : null;
  const display = new Display(root, welcome, drawing, what, played, flat);
  const next = () => {
    requestAnimationFrame(next);
    player.advance(0);
    if (player.moment && changes.show(player.moment.frame.tick)) display.changed();
    if (player.moment) display.setFrame(player.moment.frame);
  };
  next();
  publish(drawing.renderer, () => ({
    frames: display.drawn,
    lastFrame: display.shown.frame,
    restarts: 0,
    bodies: display.bodies,
    sharpness: display.sharpness,
    latency95: null,
  }));
}

function showStrips(
  root: HTMLElement,
  drawing: Drawing,
  index: PlaybackIndex,
  player: Player,
  heard: (message: WindowMessage) => void,
): void {
  const { welcome } = index;
  let [frames, shown]: [number, Frame | null] = [0, null];
  const tether: Tether = new Tether(
    { ...PLAYED, name: 'Strips', title: welcome.title, file: index.file },
    { heard, own: (code) => code in ZOOMS },
  );
  const strips = new StripWindow(index, player.duration, {
    sought: (position) => {
      player.seek(position);
      tether.say({ kind: 'seek', position: player.position });
    },
    zoom,
  });

  function zoom(way: 1 | -1): void {
    strips.timeline.zoom(way > 0 ? STEP : 1 / STEP, player.position);
  }

  function next(): void {
    requestAnimationFrame(next);
    player.advance(0);
    const { moment, position, duration } = player;
    const units = unitsOf(tether.page?.units ?? welcome.units);
    strips.timeline.show(position, moment, units);
    strips.show(minutes(position, 2), ` of ${minutes(duration, 2)}`, strips.timeline.isZoomed, true);
    if (!moment) return;
    tether.show(missionTime(moment.frame.time_s), player.failure && 'Lost');
    if (moment.frame !== shown) frames += 1;
    shown = moment.frame;
  }

  window.addEventListener('keydown', ({ code, ctrlKey, altKey, metaKey }) => {
    const way = ZOOMS[code];
    if (way && !ctrlKey && !altKey && !metaKey) zoom(way);
  });
  root.classList.add('torn-off');
  root.replaceChildren(tether.rail, strips.element);
  const none = { restarts: 0, bodies: [], sharpness: null, latency95: null };
  publish(drawing.renderer, () => ({ frames, lastFrame: shown, ...none }));
  next();
}
