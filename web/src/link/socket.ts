/** The connection to the station: handshake, typed messages, and reconnection after a loss. */

import { assertUnreachable } from '../basics/assert';
import { type FromPage, type FromServer, type Hello, PROTOCOL, type Preparing } from './protocol';

type WithoutSeq<M> = M extends unknown ? Omit<M, 'seq'> : never;

/** Commands of the page, without their numbers, which the link adds. */
export type Command = WithoutSeq<FromPage>;

/** Messages that the server sends after the session is prepared. */
export type FromSession = Exclude<FromServer, Preparing>;

export type LinkState =
  | { readonly kind: 'connecting' }
  | { readonly kind: 'preparing'; readonly text: string }
  | { readonly kind: 'open' }
  | { readonly kind: 'lost'; readonly attempt: number }
  | { readonly kind: 'refused'; readonly sentence: string };

export interface LinkListener {
  message(message: FromSession): void;
  state(state: LinkState): void;
}

const RETRY_MS = 1000;

export class Link {
  private socket: WebSocket;
  private seq = 0;
  private welcomed = false;
  private refused = false;
  private attempt = 0;
  /** Last value of `shows` sent to the station. */
  private sentShows = false;

  constructor(
    private readonly url: string,
    private readonly listener: LinkListener,
    /** `shows`: whether the page only observes (secondary or narrow window); `strips`: whether it draws strips. */
    private readonly itself: () => Pick<Hello, 'shows' | 'strips'>,
  ) {
    listener.state({ kind: 'connecting' });
    this.socket = this.connect();
  }

  /** Sends a command and returns its number. Without a connection the command is dropped. */
  send(command: Command): number {
    this.seq += 1;
    if (this.welcomed) this.socket.send(JSON.stringify({ ...command, seq: this.seq }));
    return this.seq;
  }

  /** Reports whether the page only observes, if this has changed. */
  reseat(): void {
    const { shows } = this.itself();
    if (!this.welcomed || shows === this.sentShows) return;
    this.sentShows = shows;
    this.send({ type: shows ? 'leave_seat' : 'take_seat' });
  }

  private connect(): WebSocket {
    const socket = new WebSocket(this.url);
    socket.onopen = () => {
      const { shows, strips } = this.itself();
      this.sentShows = shows;
      socket.send(JSON.stringify({ type: 'hello', protocol: PROTOCOL, shows, strips } satisfies Hello));
    };
    socket.onmessage = (event) => this.receive(event.data);
    socket.onclose = (event) => this.closed(event.reason);
    return socket;
  }

  private receive(data: unknown): void {
    if (this.refused) return;
    let message: FromServer;
    try {
      message = parse(data);
    } catch (error) {
      this.refuse(error instanceof Error ? error.message : String(error));
      return;
    }
    if (message.type === 'welcome') {
      if (message.protocol !== PROTOCOL) {
        this.refuse(
          `This page uses protocol ${PROTOCOL}, the station uses ${message.protocol}: reload the page.`,
        );
        return;
      }
      this.welcomed = true;
      this.attempt = 0;
      this.listener.state({ kind: 'open' });
      this.reseat();
    } else if (message.type === 'preparing') {
      this.attempt = 0;
      this.listener.state({ kind: 'preparing', text: message.text });
      return;
    } else if (message.type === 'refused' && !this.welcomed) {
      this.refuse(message.text);
      return;
    }
    this.listener.message(message);
  }

  private refuse(sentence: string): void {
    this.refused = true;
    this.socket.close();
    this.listener.state({ kind: 'refused', sentence });
  }

  private closed(reason: string): void {
    this.welcomed = false;
    if (this.refused) return;
    if (reason !== '' && this.attempt === 0) console.info(`The station closed the connection: ${reason}`);
    this.attempt += 1;
    this.listener.state({ kind: 'lost', attempt: this.attempt });
    setTimeout(() => {
      this.socket = this.connect();
    }, RETRY_MS);
  }
}

/** Returns the message that a WebSocket text contains. Only the message's type is checked, not its fields. */
export function parse(data: unknown): FromServer {
  if (typeof data !== 'string') throw new Error('The station sent a message that is not text.');
  const message = JSON.parse(data) as FromServer;
  switch (message.type) {
    case 'preparing':
    case 'welcome':
    case 'scenarios':
    case 'role':
    case 'frame':
    case 'polygons':
    case 'events':
    case 'recent':
    case 'readiness':
    case 'changed':
    case 'typed':
    case 'completed':
    case 'refused':
      return message;
    default:
      return assertUnreachable(message);
  }
}
