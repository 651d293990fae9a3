/** Head of a row or column of a joint: its name and, if the joint slides, the unit of its lengths. */

import type { JointInfo } from '../../link/protocol';
import { el, setText } from '../parts/dom';

export interface JointHead {
  readonly element: HTMLElement;
  /** Sets the unit's name; a joint that turns does not show it. */
  set(unit: string): void;
}

export function jointHead(
  { label, slides }: JointInfo,
  scope: 'row' | 'col' = 'row',
  attributes: Readonly<Record<string, string>> = {},
): JointHead {
  const unit = el('i');
  return {
    element: el(
      'th',
      { scope, ...attributes },
      slides ? el('span', { class: 'sliding' }, el('span', {}, label), ' ', unit) : label,
    ),
    set(name) {
      if (slides) setText(unit, name);
    },
  };
}
