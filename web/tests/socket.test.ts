import { afterEach, beforeEach, expect, test, vi } from 'vitest';
import { PROTOCOL } from '../src/link/protocol';
import { type Command, Link, type LinkState, parse } from '../src/link/socket';

const STOP: Command = { type: 'stop' };

/** A socket whose messages come from the test, not from the station. */
class FakeSocket {
  readonly sent: Record<string, unknown>[] = [];
  closed = false;
  onopen = () => {};
  onmessage: (event: { data: unknown }) => void = () => {};
  onclose: (event: { reason: string }) => void = () => {};
  send = (text: string) => void this.sent.push(JSON.parse(text));
  close = () => {
    this.closed = true;
  };
}

let sockets: FakeSocket[];

beforeEach(() => {
  sockets = [];
  vi.useFakeTimers();
  vi.spyOn(console, 'info').mockImplementation(() => {});
  vi.stubGlobal(
    'WebSocket',
    class extends FakeSocket {
      constructor(readonly url: string) {
        super();
        sockets.push(this);
      }
    },
  );
});

afterEach(() => {
  vi.useRealTimers();
  vi.unstubAllGlobals();
  vi.restoreAllMocks();
});

/** A link whose socket has not opened yet. */
function linked() {
  const page = { shows: false, strips: true };
  const states: LinkState[] = [];
  const messages: string[] = [];
  const link = new Link(
    'ws://station',
    { message: ({ type }) => messages.push(type), state: (state) => states.push(state) },
    () => page,
  );
  const socket = () => sockets.at(-1) as FakeSocket;
  const receive = (message: object) => socket().onmessage({ data: JSON.stringify(message) });
  return {
    ...{ page, states, messages, link, socket, receive },
    kinds: () => states.map(({ kind }) => kind),
    welcome: (protocol = PROTOCOL) => receive({ type: 'welcome', protocol }),
    lose: (reason = '') => socket().onclose({ reason }),
  };
}

test('parsing rejects a message of an unknown type; the error names the type', () => {
  expect(parse('{"type":"refused","seq":-1,"text":"No."}')).toMatchObject({ seq: -1 });
  expect(() => parse('{"type":"rumour"}')).toThrow('rumour');
  expect(() => parse('{')).toThrow(SyntaxError);
});

test('parsing rejects data that is not text, even if its conversion to text is a message', () => {
  expect(parse('{"type":"frame"}')).toEqual({ type: 'frame' });
  expect(() => parse(['{"type":"frame"}'])).toThrow();
});

test('the first message of a page is its hello', () => {
  const { link, socket, page } = linked();
  page.shows = true;
  link.send(STOP);
  socket().onopen();
  expect(socket().sent).toEqual([{ type: 'hello', protocol: PROTOCOL, shows: true, strips: true }]);
});

test('commands are sent only after the welcome, and every command has its own number', () => {
  const { link, socket, welcome } = linked();
  socket().onopen();
  expect(link.send(STOP)).toBe(1);
  expect(socket().sent).toHaveLength(1);
  welcome();
  expect([link.send(STOP), link.send({ type: 'rate_hold' })]).toEqual([2, 3]);
  expect(socket().sent.slice(1)).toEqual([
    { type: 'stop', seq: 2 },
    { type: 'rate_hold', seq: 3 },
  ]);
});

test('the link passes on every message of the session, but no message about its preparation', () => {
  const { states, messages, receive, welcome } = linked();
  receive({ type: 'preparing', text: 'a step' });
  expect(messages).toEqual([]);
  expect(states.at(-1)).toEqual({ kind: 'preparing', text: 'a step' });
  welcome();
  for (const type of ['scenarios', 'role', 'frame', 'events', 'recent']) receive({ type });
  expect(messages).toEqual(['welcome', 'scenarios', 'role', 'frame', 'events', 'recent']);
});

test('a rejected command leaves the link open', () => {
  const { kinds, messages, receive, welcome } = linked();
  welcome();
  receive({ type: 'refused', seq: 4, text: 'No.' });
  expect(messages).toEqual(['welcome', 'refused']);
  expect(kinds()).toEqual(['connecting', 'open']);
});

test.each<[string, RegExp, (link: ReturnType<typeof linked>) => void]>([
  [
    'the station rejects the page',
    /^No\.$/,
    ({ receive }) => receive({ type: 'refused', seq: -1, text: 'No.' }),
  ],
  [
    'the station has another protocol',
    new RegExp(`\\b${PROTOCOL}\\b.*\\b${PROTOCOL + 1}\\b`),
    ({ welcome }) => welcome(PROTOCOL + 1),
  ],
  ['a message is not text', /not text/, ({ socket }) => socket().onmessage({ data: new ArrayBuffer(1) })],
  ['a message has an unknown type', /rumour/, ({ receive }) => receive({ type: 'rumour' })],
])('a link ends for good when %s; its state has the reason', (_, reason, act) => {
  const link = linked();
  act(link);
  expect(link.kinds()).toEqual(['connecting', 'refused']);
  expect(link.states.at(-1)).toMatchObject({ sentence: expect.stringMatching(reason) });
  expect(link.socket().closed).toBe(true);
  link.welcome();
  link.lose();
  vi.advanceTimersByTime(60_000);
  expect(link.kinds()).toEqual(['connecting', 'refused']);
  expect(link.messages).toEqual([]);
  expect(sockets).toHaveLength(1);
});

test('a lost link connects again after 1 s', () => {
  const { lose } = linked();
  lose();
  vi.advanceTimersByTime(999);
  expect(sockets).toHaveLength(1);
  vi.advanceTimersByTime(1);
  expect(sockets).toHaveLength(2);
});

test('attempts are counted until the station answers', () => {
  const { states, lose, receive, welcome } = linked();
  const loseAgain = () => {
    lose();
    vi.advanceTimersByTime(1000);
    const state = states.at(-1);
    return state?.kind === 'lost' ? state.attempt : null;
  };
  expect([loseAgain(), loseAgain(), loseAgain()]).toEqual([1, 2, 3]);
  receive({ type: 'preparing', text: 'a step' });
  expect([loseAgain(), loseAgain()]).toEqual([1, 2]);
  welcome();
  expect(loseAgain()).toBe(1);
});

test('commands on a lost link are dropped, and are not sent after the reconnection', () => {
  const { link, socket, welcome, lose } = linked();
  welcome();
  const before = link.send(STOP);
  lose();
  link.send(STOP);
  vi.advanceTimersByTime(1000);
  socket().onopen();
  link.send(STOP);
  welcome();
  expect(socket().sent.map(({ type }) => type)).toEqual(['hello']);
  expect(link.send(STOP)).toBe(before + 3);
});

test('at each change, a page reports once whether it only observes', () => {
  const { link, socket, page, welcome } = linked();
  socket().onopen();
  welcome();
  link.reseat();
  page.shows = true;
  link.reseat();
  link.reseat();
  page.shows = false;
  link.reseat();
  expect(socket().sent.map(({ type }) => type)).toEqual(['hello', 'leave_seat', 'take_seat']);
});

test('a page that only observes from the start reports this only in its hello', () => {
  const { link, socket, page, welcome } = linked();
  page.shows = true;
  socket().onopen();
  welcome();
  link.reseat();
  expect(socket().sent.map(({ type }) => type)).toEqual(['hello']);
});

test('a page that changes before the welcome reports the change at the welcome', () => {
  const { link, socket, page, welcome } = linked();
  socket().onopen();
  page.shows = true;
  link.reseat();
  expect(socket().sent).toHaveLength(1);
  welcome();
  expect(socket().sent.map(({ type }) => type)).toEqual(['hello', 'leave_seat']);
});
