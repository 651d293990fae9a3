import { vi } from 'vitest';

/** A small document in which tests make and read components of the panel. It computes no layout. */

class SmallText {
  constructor(public data: string) {}

  get textContent(): string {
    return this.data;
  }
}

type Child = SmallElement | SmallText | string;

export class SmallElement {
  readonly attributes = new Map<string, string>();
  readonly style = { setProperty() {} };
  readonly offsetTop = 0;
  readonly offsetHeight = 0;
  hidden = false;
  value = '';
  children: (SmallElement | SmallText)[] = [];
  parent: SmallElement | null = null;
  private readonly listeners = new Map<string, ((event: object) => void)[]>();

  constructor(readonly tag: string) {}

  setAttribute(name: string, value: string): void {
    this.attributes.set(name, value);
    if (name === 'hidden') this.hidden = true;
  }

  getAttribute(name: string): string | null {
    return this.attributes.get(name) ?? null;
  }

  removeAttribute(name: string): void {
    this.attributes.delete(name);
  }

  get classes(): readonly string[] {
    return (this.getAttribute('class') ?? '').split(' ').filter((name) => name !== '');
  }

  get classList() {
    const toggle = (name: string, on: boolean) => {
      const others = this.classes.filter((each) => each !== name);
      this.setAttribute('class', [...others, ...(on ? [name] : [])].join(' '));
    };
    return {
      toggle,
      add: (name: string) => toggle(name, true),
      contains: (name: string) => this.classes.includes(name),
    };
  }

  get firstChild() {
    return this.children[0] ?? null;
  }

  get lastChild() {
    return this.children.at(-1) ?? null;
  }

  get textContent(): string {
    return this.children.map((child) => child.textContent).join('');
  }

  set textContent(text: string) {
    this.replaceChildren(text);
  }

  append(...children: Child[]): void {
    for (const child of children) {
      if (child instanceof SmallElement) {
        child.remove();
        child.parent = this;
      }
      this.children.push(typeof child === 'string' ? new SmallText(child) : child);
    }
  }

  replaceChildren(...children: Child[]): void {
    this.children = [];
    this.append(...children);
  }

  remove(): void {
    if (this.parent) this.parent.children = this.parent.children.filter((child) => child !== this);
    this.parent = null;
  }

  contains(other: unknown): boolean {
    return this.all.some((each) => each === other);
  }

  /** All elements within this one, in their order on the page. */
  get all(): readonly SmallElement[] {
    return this.children.flatMap((child) => (child instanceof SmallElement ? [child, ...child.all] : []));
  }

  /** The elements that match `selector`: steps such as `button.key`, separated by spaces. */
  querySelectorAll(selector: string): readonly SmallElement[] {
    let within: readonly SmallElement[] = [this];
    for (const step of selector.split(' ')) {
      const [tag, ...classes] = step.split('.');
      within = within.flatMap(({ all }) =>
        all.filter(
          (each) => (!tag || each.tag === tag) && classes.every((name) => each.classes.includes(name)),
        ),
      );
    }
    return within;
  }

  /** The first element that matches `selector`. */
  querySelector(selector: string): SmallElement | null {
    return this.querySelectorAll(selector)[0] ?? null;
  }

  addEventListener(type: string, listener: (event: object) => void): void {
    this.listeners.set(type, [...(this.listeners.get(type) ?? []), listener]);
  }

  /** Calls the listeners of `type`. */
  dispatch(type: string, event: object): void {
    for (const listener of this.listeners.get(type) ?? []) listener(event);
  }

  /** Calls the click listeners, as a click by keyboard does: `detail` is 0. */
  click(): void {
    this.dispatch('click', { detail: 0 });
  }

  /** The first button with this text. */
  button(text: string): SmallElement | undefined {
    return this.all.find((each) => each.tag === 'button' && each.textContent === text);
  }
}

/** Replaces the global document by the small document, until `vi.unstubAllGlobals`. */
export function useSmallPage(): void {
  const createElement = (tag: string) => new SmallElement(tag);
  vi.stubGlobal('Text', SmallText);
  vi.stubGlobal('document', {
    createElement,
    createElementNS: (_: string, tag: string) => createElement(tag),
  });
}

/** Returns `element` with its type in the small document. */
export function small(element: Element): SmallElement {
  return element as unknown as SmallElement;
}
