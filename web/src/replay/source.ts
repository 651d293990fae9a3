/** Source of a recording: the server of `aftdeck replay --open`, or the HTML file that contains page and recording. */

import type { Block, PlaybackIndex, PolygonPicture, Polygons, Verdict } from '../link/protocol';

export interface Source {
  index(): Promise<PlaybackIndex>;
  block(number: number): Promise<Block>;
  /** The pictures of a step in the look of 1972; absent if nothing computes them. */
  readonly polygons?: (tick: number, pictures: readonly PolygonPicture[]) => Promise<readonly Polygons[]>;
  /** Result of the re-simulation so far; null if none was started. */
  verdict(): Promise<Verdict> | null;
}

/** Returns the address of the station with the present run; null if there is none. */
export function flyingHere(page: Document): string | null {
  return page.querySelector<HTMLMetaElement>('meta[name=flying]')?.content ?? null;
}

/** Returns the recording of this page; null if the page shows a live run. */
export function recordingHere(page: Document): Source | null {
  const served = page.querySelector<HTMLMetaElement>('meta[name=recording]');
  if (served) return fromServer(served.content);
  return page.getElementById('recording-index') ? fromPage(page) : null;
}

function fromServer(where: string): Source {
  async function get<T>(path: string): Promise<T> {
    const answer = await fetch(`${where}${path}`);
    if (!answer.ok) throw new Error(`${path}: ${answer.status}`);
    return answer.json();
  }
  return {
    index: () => get('index.json'),
    block: (number) => get(`blocks/${number}`),
    polygons: (tick, pictures) =>
      get(`polygons/${tick}?pictures=${encodeURIComponent(JSON.stringify(pictures))}`),
    verdict: () => get('verdict.json'),
  };
}

function fromPage(page: Document): Source {
  async function unpack<T>(name: string | number): Promise<T> {
    const packed = page.getElementById(`recording-${name}`)?.textContent;
    if (!packed) throw new Error(`Part ${name} of the recording is missing.`);
    const bytes = Uint8Array.from(atob(packed), (letter) => letter.charCodeAt(0));
    const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('gzip'));
    return new Response(stream).json();
  }
  return { index: () => unpack('index'), block: unpack, verdict: () => null };
}
