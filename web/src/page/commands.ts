/** Carries out the actions that keys and buttons request. */

import { assertUnreachable } from '../basics/assert';
import type { Pictures } from '../cameras/pictures';
import type { Action } from '../input/keymap';
import type { Groups } from '../panel/desk/desk';

/** A sheet or list that opens and closes. */
interface Sheet {
  close(): void;
}

export interface Acting {
  readonly groups: Groups;
  readonly pictures: Pictures;
  readonly light: { toggle(): void; lock(): void };
  readonly controlPage: Sheet & { toggle(): void };
  readonly keys: Sheet & { toggle(): void };
  /** Further sheets that Escape closes. */
  readonly sheets: readonly Sheet[];
  stop(): void;
  changeRate(): void;
  /** Enters the selected mode or, if none is selected, the mode that the task needs. */
  enterMode(): void;
  holdRate(): void;
  /** Switches PULSE on or off. */
  pulse(): void;
  acknowledge(): void;
  /** Announces a clearance problem. */
  announce(): void;
  mute(): void;
  showPlane(): void;
  showBending(): void;
  flyOrbiter(): void;
}

export function act(action: Action, by: Acting): void {
  const { groups, pictures, light, controlPage, keys } = by;
  switch (action.name) {
    case 'stop':
      by.stop();
      break;
    case 'rate':
      by.changeRate();
      break;
    case 'rate hold':
      by.holdRate();
      break;
    case 'pulse':
      by.pulse();
      break;
    case 'proceed':
      groups.target.proceed();
      break;
    case 'turn mode':
      groups.mode.turn(action.by);
      break;
    case 'enter':
      by.enterMode();
      break;
    case 'turn joint':
      groups.mode.turnJoint(action.by);
      break;
    case 'camera':
      pictures.monitors.chooseDigit(action.number - 1, performance.now());
      break;
    case 'cameraStep':
      pictures.monitors.step(action.by);
      break;
    case 'otherMonitor':
      pictures.monitors.takeOther();
      break;
    case 'matrix':
      pictures.toggleMatrix();
      break;
    case 'offered pair':
      pictures.offers.take();
      break;
    case 'split':
      pictures.monitors.toggleSplit();
      break;
    case 'slow camera':
      pictures.monitors.toggleSlow();
      break;
    case 'acknowledge':
      by.acknowledge();
      break;
    case 'announce':
      by.announce();
      break;
    case 'mute':
      by.mute();
      break;
    case 'grip':
      groups.grip(action);
      break;
    case 'safing':
      groups.safe();
      break;
    case 'position hold':
      groups.holdPosition();
      break;
    case 'plane':
      by.showPlane();
      break;
    case 'bending':
      by.showBending();
      break;
    case 'fly orbiter':
      by.flyOrbiter();
      break;
    case 'light':
      light.toggle();
      break;
    case 'lock exposure':
      light.lock();
      break;
    case 'control page':
      controlPage.toggle();
      break;
    case 'keys':
      keys.toggle();
      break;
    case 'leave':
      for (const sheet of [keys, controlPage, ...by.sheets]) sheet.close();
      if (document.activeElement instanceof HTMLElement) document.activeElement.blur();
      break;
    default:
      assertUnreachable(action);
  }
}
