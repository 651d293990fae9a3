/** Functions that create and change elements. They write to the document only if something changes. */

type Child = Node | string;
type Attributes = Readonly<Record<string, string>>;

export function el<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const node = document.createElement(tag);
  write(node, attributes);
  node.append(...children);
  return node;
}

export function svg<K extends keyof SVGElementTagNameMap>(
  tag: K,
  attributes: Attributes = {},
  ...children: Child[]
): SVGElementTagNameMap[K] {
  const node = document.createElementNS('http://www.w3.org/2000/svg', tag);
  write(node, attributes);
  node.append(...children);
  return node;
}

function write(node: HTMLElement | SVGElement, attributes: Attributes): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (name === 'style') setStyle(node, value);
    else node.setAttribute(name, value);
  }
}

/** Makes a push button. After a click by pointer, the button loses the focus, so that keys control the arm again. */
export function button(attributes: Attributes, children: Child[], pressed: () => void): HTMLButtonElement {
  const node = el('button', { type: 'button', ...attributes }, ...children);
  node.addEventListener('click', (event) => {
    if (event.detail > 0) node.blur();
    pressed();
  });
  return node;
}

/** Makes a group of the desk, with its title in a bracket. */
export function group(name: string, title: string, ...children: Child[]): HTMLElement {
  const id = `group-${name}`;
  return el(
    'section',
    { class: `group ${name}`, 'aria-labelledby': id },
    el('h2', { id }, el('b', {}, title), el('span', { class: 'about' })),
    ...children,
  );
}

/** Writes the words after a group's title. */
export function setAbout(section: HTMLElement, text: string): void {
  const about = section.querySelector('h2 .about');
  if (!about) return;
  setText(about, text);
  setAttribute(about, 'title', text);
}

export function setText(node: Element, text: string): void {
  const { firstChild } = node;
  if (firstChild instanceof Text && firstChild === node.lastChild) {
    if (firstChild.data !== text) firstChild.data = text; // cheaper than a new node
  } else if (node.textContent !== text) node.textContent = text;
}

export function setAttribute(node: Element, name: string, value: string): void {
  if (node.getAttribute(name) !== value) node.setAttribute(name, value);
}

/** Texts of the styles that `setStyle` has set. The browser's own text of a style differs from the given text. */
const styles = new WeakMap<Element, string>();

/** Sets the style of one element by script, because the page's content policy forbids style attributes. */
export function setStyle(node: HTMLElement | SVGElement, text: string): void {
  if (styles.get(node) === text) return;
  styles.set(node, text);
  node.style.cssText = text;
}

export function setClass(node: Element, name: string, on: boolean): void {
  if (node.classList.contains(name) !== on) node.classList.toggle(name, on);
}

/** Lights a flag or puts it out; screen readers read only lit flags. */
export function setLit(node: Element, on: boolean): void {
  setClass(node, 'lit', on);
  setAttribute(node, 'aria-hidden', String(!on));
}

/** Shows whether a switch is set. A switch that is set is white with black text. */
export function setPressed(node: Element, on: boolean): void {
  setAttribute(node, 'aria-pressed', String(on));
}
