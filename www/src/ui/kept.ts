// Choices of the visitor that the browser keeps. A browser that stores nothing has none.

const PREFIX = "vcgpdm ";

/** Does something with the browser's storage, which may be forbidden. */
function attempt<Result>(work: () => Result, otherwise: Result): Result {
  try {
    return work();
  } catch {
    return otherwise;
  }
}

export const kept = (name: string): string | null => attempt(() => localStorage.getItem(PREFIX + name), null);

export const keep = (name: string, value: string): void =>
  attempt(() => localStorage.setItem(PREFIX + name, value), undefined);

/** Forgets all choices. Returns a function that brings them back. */
export function forgetKept(): () => void {
  const names = attempt(() => Object.keys(localStorage), []).filter((key) => key.startsWith(PREFIX));
  const choices = names.map((key) => [key.slice(PREFIX.length), localStorage.getItem(key) ?? ""] as const);
  for (const key of names) localStorage.removeItem(key);
  return () => {
    for (const [name, value] of choices) keep(name, value);
  };
}
