/**
 * Draws still pictures in small pieces, so that a moving picture never waits long for one: each piece is a part of a
 * picture, drawn with one sample of its pixels.
 */

import type { Piece, Rect, View } from '../scene/drawn';
import { SAMPLES } from '../scene/samples';
import { parts, uncovered } from './tiles';

export class Still {
  private key = '';
  private pieces: Piece[] = [];

  /** Whether the still pictures are complete. */
  get done(): boolean {
    return this.pieces.length === 0;
  }

  /**
   * Returns the pieces to draw next; empty if the pictures are complete.
   *
   * @param key text that changes with everything in the pictures.
   * @param views the pictures; a later one covers an earlier one.
   * @param most greatest area of the returned pieces [CSS px]; a piece has at least one row.
   */
  next(key: string, views: readonly View[], most: number): readonly Piece[] {
    if (key !== this.key) {
      this.key = key;
      this.pieces = piecesOf(views, most);
    }
    let area = 0;
    let count = 0;
    for (const { part } of this.pieces) {
      area += part.width * part.height;
      if (count > 0 && area > most) break;
      count += 1;
    }
    return this.pieces.splice(0, count);
  }

  /** Begins again with the next call: pieces were not drawn. */
  forget(): void {
    this.key = '';
  }
}

function piecesOf(views: readonly View[], most: number): Piece[] {
  const shown = views.flatMap((view, i) => {
    const above = views.slice(i + 1).map(({ rect }) => rect);
    const rects = uncovered(view.rect, above);
    return rects.flatMap((rect) => parts(rect, most).map((part): [View, Rect] => [view, part]));
  });
  return SAMPLES.flatMap((_, sample) => shown.map(([view, part]) => ({ view, part, sample })));
}
