/** The operator's task: its present step as a line below the rail, or as a card over the desk. */

import type { PairOffer } from '../cameras/pair-offer';
import type { InHand } from '../input/active-device';
import { revision } from '../input/store';
import type { HintInfo, StepInfo, TaskNow, UseInfo } from '../link/protocol';
import { keeper } from '../page/local-storage';
import { button, el, setAttribute, setClass, setPressed, setText } from '../panel/parts/dom';
import type { Desk, View } from '../panel/parts/part';
import { durationText } from '../words/format';
import { Card, countWords } from './card';
import { Line } from './line';
import { barred, modeHint, moving, rateHoldHint } from './state-words';
import { NOTHING_LEFT } from './to-go';
import { type Piece, pieces, present, saidText } from './words';

/** Built-in scenario for beginners. */
export const TUTORIAL = 'tutorial';
/** Whether the user left the last scenario with an open guide; the guide of the next one then opens too. */
let kept = false;
/** Storage key: whether the guide was opened before. Without storage, the guide opens at each visit to the tutorial. */
const KEY = 'aftdeck.tutorial';
const OPENED = 'opened';
const OPEN = 'Show this step with its controls';
const notice = (text: string): readonly Piece[] => [
  { kind: 'text', text },
  { kind: 'use', text: 'stop' },
  { kind: 'text', text: ' stops all motion.' },
];

export interface TaskListener {
  /** Loads a scenario. */
  flyIt(scenario: string): void;
  /** Offers the cameras of a step that begins. */
  offer(offer: PairOffer): void;
}

export class Task {
  /** Button in the rail: in the tutorial, opens and closes the guide; in another scenario, loads the tutorial. */
  readonly key: HTMLButtonElement;
  readonly line: Line;
  readonly card: Card;
  /** The instruction for screen readers, written when another text begins to apply; numbers in it then stay. */
  readonly said = el('p', { class: 'unseen', role: 'status', 'aria-label': 'Instruction' });
  private readonly titles: readonly string[];
  private open = false;
  /** Whether the card opens by itself as soon as this page is in control. */
  private unasked: boolean;
  private drawn = '';
  private announced = '';
  /** Mode that the present step needs, if another one is entered; else empty. */
  private needs = '';
  /** Whether the last frame had the result of the run. */
  private ended = false;
  /** Index of the step of the last frame; null before the first frame. */
  private at: number | null = null;

  /** `script` is the button of a scenario without steps that lets its script fly. */
  constructor(
    private readonly desk: Desk,
    private readonly inHand: InHand,
    private readonly listener: TaskListener,
    script: HTMLElement,
  ) {
    const { steps } = desk.welcome;
    this.titles = steps.map(({ title }) => title);
    this.unasked = this.isTutorial && keeper.getItem(KEY) !== OPENED;
    const [name, title] = this.isTutorial
      ? ['Guide', 'Show the present step of the task with its controls']
      : ['Tutorial', 'Learn a first capture in six steps'];
    this.key = button({ title }, [name], () => this.toggle());
    const guide = button({ title: OPEN }, ['Open the guide'], () => this.show(true));
    this.line = new Line(inHand, desk.welcome, this.exists ? guide : script);
    const note = this.isTutorial ? 'You cannot damage anything here. ' : 'Contacts lower the grade. ';
    this.card = new Card(inHand, desk.welcome, notice(note), {
      back: () => desk.send({ type: 'turn_step', to: 'previous' }),
      skip: () => desk.send({ type: 'turn_step', to: 'next' }),
      close: () => this.show(false),
      enterMode: () => this.enterMode(),
      again: () => desk.send({ type: 'restart' }),
      next: (name) => listener.flyIt(name),
    });
    this.show(false);
    this.unasked ||= kept && this.exists;
  }

  /**
   * Called when the user chooses a scenario. For the tutorial, the guide opens: at once if this scenario is already
   * loaded, otherwise after it has been loaded.
   */
  chosen(scenario: string): void {
    if (scenario !== TUTORIAL) return;
    if (this.isTutorial) this.show(true);
    else keeper.setItem(KEY, 'asked');
  }

  values({ frame, flying, units }: View): void {
    const { task, recording_s } = frame.display;
    if (!task) return;
    if (this.unasked && flying) this.show(true);
    const { welcome } = this.desk;
    const step = welcome.steps[task.at];
    this.offerCameras(task.at, step);
    if (task.debrief && !this.ended && flying) this.show(true);
    this.ended = task.debrief !== null;
    const held = frame.work.cargo.some((cargo) => cargo.held);
    const marked = { units, conditions: frame.work.conditions, held };
    const done = task.done_s.map((time, i) => time !== null || i < task.first);
    const shown = step ? present(step, task) : null;
    const [title, words] =
      step && shown ? [step.title, shown.text] : this.exists ? ending(task) : ['', welcome.text];
    const way = barred(frame, welcome.joints, this.inHand);
    // First away from the contact: its direction is one of the present mode's sticks.
    this.needs = way.length === 0 && step?.mode && step.mode !== frame.mode ? step.mode : '';
    const manual = welcome.modes.find(({ position }) => position === frame.mode)?.kind === 'manual';
    const leg =
      shown && manual
        ? rateHoldHint(
            frame,
            shown.uses.map(({ use }) => use),
          )
        : [];
    const said = way.length > 0 ? way : [...pieces(words, marked), ...leg, ...moving(frame.motions)];
    // The numbers are along the sticks of the present mode: not of use before the step's own mode is entered.
    const left = this.needs === '' ? frame.display : NOTHING_LEFT;
    const all = [...(this.needs === '' ? [] : modeHint(this.needs)), ...said];
    this.announce(`${task.at} ${task.hint} ${this.needs} ${way.length} ${leg.length}`, title, all);
    if (!this.open) {
      this.line.set(this.exists ? countWords(task.at, done) : '', title, all);
      this.line.setGo(left, units);
      return;
    }
    if (shown) this.drawCaps(task, this.needs === '' ? shown : { ...shown, uses: [enterUse(this.needs)] });
    else setAttribute(document.body, 'data-step', '');
    this.card.set({
      at: task.at,
      titles: this.titles,
      done,
      title,
      pieces: said,
      needs: this.needs,
      mode: frame.mode,
    });
    this.card.setGo(step ? left : NOTHING_LEFT, units);
    this.card.setDebrief(task.debrief, units, recording_s !== null, flying);
  }

  light(): void {
    if (this.open) this.card.light();
  }

  dispose(): void {
    kept = this.open;
    this.show(false);
    setClass(document.body, 'tasked', false);
  }

  private get isTutorial(): boolean {
    return this.desk.welcome.scenario === TUTORIAL;
  }

  private get exists(): boolean {
    return this.desk.welcome.steps.length > 0;
  }

  private toggle(): void {
    if (this.isTutorial) this.show(!this.open);
    else this.listener.flyIt(TUTORIAL);
  }

  /** Enters the mode that the present step needs, if another one is entered. */
  enterMode(): void {
    if (this.needs !== '') this.desk.send({ type: 'enter_mode', mode: this.needs });
  }

  private show(open: boolean): void {
    if (open) {
      this.unasked = false;
      if (this.isTutorial) keeper.setItem(KEY, OPENED);
    }
    this.open = open;
    this.card.element.hidden = !open;
    this.line.element.hidden = open;
    if (this.isTutorial) setPressed(this.key, open);
    setClass(document.body, 'guided', open);
    setClass(document.body, 'tasked', !open);
  }

  private announce(text: string, title: string, said: readonly Piece[]): void {
    if (text === this.announced) return;
    this.announced = text;
    setText(this.said, `${title}. ${saidText(said, this.inHand)}`);
  }

  /** Offers the cameras of a step when it begins, but not when the page opens. */
  private offerCameras(at: number, step: StepInfo | undefined): void {
    if (at === this.at) return;
    const [first, second] = step?.cameras ?? [];
    if (this.at !== null && step && first && second)
      this.listener.offer({ cameras: [first, second], why: step.title });
    this.at = at;
  }

  private drawCaps(task: TaskNow, { uses }: HintInfo): void {
    const drawn = `${task.at} ${task.hint} ${this.needs} ${this.inHand.kinds.join()} ${revision()}`;
    if (drawn === this.drawn) return;
    this.drawn = drawn;
    this.card.setCaps(uses);
    const step = this.desk.welcome.steps[task.at];
    setAttribute(document.body, 'data-step', step?.groups.join(' ') ?? '');
  }
}

function enterUse(mode: string): UseInfo {
  return { use: 'enter', does: mode };
}

/** Returns the closing title and text, when all steps are past. */
export function ending({
  done_s,
  first,
}: Pick<TaskNow, 'done_s' | 'first'>): readonly [title: string, words: string] {
  const times = done_s.flatMap((time) => time ?? []);
  if (times.length < done_s.length - first)
    return [
      'Not complete yet',
      'These were all the steps, but some were skipped. Open the guide and go back to a skipped step, or press *Restart* to begin again.',
    ];
  const took = durationText(Math.max(0, ...times));
  return [
    'Complete',
    `All steps are done, ${took} after the start. Continue as you like; *Keys ?* shows all keys, *Restart* begins again.`,
  ];
}
