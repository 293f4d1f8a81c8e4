// Elements in short: h("p", { class: "note" }, "text", child).

type Child = Node | string | null | undefined;
type Value = string | number | boolean | null | undefined | ((event: Event) => void);

function setAll(element: Element, attributes: Record<string, Value>): void {
  for (const [name, value] of Object.entries(attributes)) {
    if (typeof value === "function") element.addEventListener(name, value);
    else if (value === true) element.setAttribute(name, "");
    else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, String(value));
  }
}

/** An HTML element; functions are listeners for the event of that name, false and null leave an attribute out. */
export function h<K extends keyof HTMLElementTagNameMap>(
  tag: K,
  attributes: Record<string, Value> = {},
  ...children: Child[]
): HTMLElementTagNameMap[K] {
  const element = document.createElement(tag);
  setAll(element, attributes);
  element.append(...children.filter((child): child is Node | string => child !== null && child !== undefined));
  return element;
}

/** A table with column headers; the first cell of each row is its header. */
export function table(caption: string, head: string[], rows: (Child | Child[])[][], numeric: number[] = []): HTMLElement {
  const place = (i: number) => (numeric.includes(i) ? "number" : null);
  const cell = (content: Child | Child[], i: number) =>
    h(i === 0 ? "th" : "td", { scope: i === 0 ? "row" : null, class: place(i) }, ...(Array.isArray(content) ? content : [content]));
  return h(
    "div",
    { class: "scroll", tabindex: 0, role: "region", "aria-label": caption },
    h(
      "table",
      {},
      h("caption", {}, caption),
      h("thead", {}, h("tr", {}, ...head.map((text, i) => h("th", { scope: "col", class: place(i) }, text)))),
      h("tbody", {}, ...rows.map((row) => h("tr", {}, ...row.map(cell)))),
    ),
  );
}

/** A command with a button that copies it. */
export function command(text: string): HTMLElement {
  const button = h("button", { type: "button", class: "copy", "aria-label": `Copy the command ${text}` }, "Copy");
  button.addEventListener("click", () => {
    const done = (word: string) => {
      button.textContent = word;
      setTimeout(() => (button.textContent = "Copy"), 1500);
    };
    navigator.clipboard.writeText(text).then(
      () => done("Copied"),
      () => done("Not allowed"),
    );
  });
  return h("span", { class: "command" }, h("code", {}, text), button);
}
