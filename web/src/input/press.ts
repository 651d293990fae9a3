/** A press of a pointer (a finger, a pen or a mouse button) on an element, until its release arrives or is lost. */

import { whenSwallowed } from './swallowed';

export interface Press {
  moved?(event: PointerEvent): void;
  /** Called once; `lost`: the release itself was not reported. */
  ended(lost: boolean): void;
}

/** `begun` is called when a pointer presses the element, and returns null to ignore it. */
export function onPress(element: HTMLElement, begun: (event: PointerEvent) => Press | null): void {
  element.addEventListener('pointerdown', (event) => {
    const press = begun(event);
    if (press) follow(event, press);
  });
}

/** Listens at the window: an element that leaves the page or is hidden does not receive the release. */
function follow({ pointerId, pointerType }: PointerEvent, press: Press): void {
  const over = new AbortController();
  const { signal } = over;
  const end = (lost = true) => {
    if (signal.aborted) return;
    over.abort();
    press.ended(lost);
  };
  const options = { capture: true, signal };
  for (const type of ['pointerup', 'pointercancel', 'lostpointercapture'] as const)
    window.addEventListener(
      type,
      (event) => event.pointerId === pointerId && end(type !== 'pointerup'),
      options,
    );
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
  whenSwallowed(end, signal);
}
