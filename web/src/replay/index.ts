/** Plays a recording, in this page or in a secondary window. */

import { notice, startOrNotice } from '../page/notice';
import type { Drawing } from '../page/quality';
import { showsPlanes, tornHere } from '../windows/opened';
import { Replay } from './replay';
import { follow } from './second';
import type { Source } from './source';

/** Fills the page with a recording, or with the reason why the recording cannot be played. */
export function play(root: HTMLElement, drawing: Drawing, source: Source): void {
  notice(root, 'Opening the recording.');
  source.index().then(
    (index) => {
      const torn = tornHere(location.search);
      startOrNotice(root, () => {
        if (torn === null || showsPlanes(torn)) new Replay(root, drawing, source, index);
        else follow(root, drawing, source, index, torn);
      });
    },
    () => notice(root, 'Cannot open the recording: its file is damaged, or its server does not answer.'),
  );
}
