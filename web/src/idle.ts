// Work that can wait: done in order while the page is idle, all at once before printing.

const waiting: (() => void)[] = [];
let scheduled = false;

function run(deadline: () => boolean): void {
  scheduled = false;
  while (waiting.length > 0 && deadline()) waiting.shift()?.();
  if (waiting.length > 0) schedule();
  else document.documentElement.dataset["idle"] = "true";
}

function schedule(): void {
  if (scheduled) return;
  scheduled = true;
  const begin = () => {
    const end = performance.now() + 12;
    run(() => performance.now() < end);
  };
  setTimeout(begin, 0);
}

/** Does this soon. The attribute data-idle of the document says when nothing waits any more. */
export function whenIdle(work: () => void): void {
  delete document.documentElement.dataset["idle"];
  waiting.push(work);
  schedule();
}

addEventListener("beforeprint", () => run(() => true));
