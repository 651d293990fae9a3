/** A press of a pointer (a finger, a pen or a mouse button) on an element, until its release arrives or is lost. */

import { NOT_HELD } from './hold';
import { whenSwallowed } from './swallowed';

export interface Press {
  moved?(event: PointerEvent): void;
  /** Called once; `at`: time of the release [ms, as performance.now()], NOT_HELD if the release was not reported. */
  ended(at: number): void;
}

/** `start` is called when a pointer presses the element, and returns null to ignore it. */
export function onPress(element: HTMLElement, start: (event: PointerEvent) => Press | null): void {
  element.addEventListener('pointerdown', (event) => {
    const press = start(event);
    if (press) follow(event, press);
  });
}

/** Listens at the window: an element that leaves the page or is hidden does not receive the release. */
function follow({ pointerId, pointerType }: PointerEvent, press: Press): void {
  const over = new AbortController();
  const { signal } = over;
  const end = (at = NOT_HELD) => {
    if (signal.aborted) return;
    over.abort();
    press.ended(at);
  };
  const options = { capture: true, signal };
  // A page that stood still handles the release late: only the event has its time.
  window.addEventListener(
    'pointerup',
    (event) => event.pointerId === pointerId && end(event.timeStamp),
    options,
  );
  for (const type of ['pointercancel', 'lostpointercapture'] as const)
    window.addEventListener(type, (event) => event.pointerId === pointerId && end(), options);
  window.addEventListener(
    'pointermove',
    (event) => {
      if (event.pointerId !== pointerId) return;
      if (event.buttons === 0) end();
      else press.moved?.(event);
    },
    options,
  );
  // A primary pointer is the only one of its type: no earlier one is still pressed.
  window.addEventListener(
    'pointerdown',
    (event) => event.isPrimary && event.pointerType === pointerType && end(),
    options,
  );
  // A finger that rests opens a menu in some browsers: it may be holding a button or a stick.
  window.addEventListener(
    'contextmenu',
    (event) => (event as PointerEvent).pointerType === 'touch' && event.preventDefault(),
    options,
  );
  whenSwallowed(end, signal);
}
