// Choices of the visitor that the browser keeps. A browser that stores nothing has none.

const PREFIX = "vcgpdm ";

export function kept(name: string): string | null {
  try {
    return localStorage.getItem(PREFIX + name);
  } catch {
    return null;
  }
}

export function keep(name: string, value: string): void {
  try {
    localStorage.setItem(PREFIX + name, value);
  } catch {
    // The page then opens as at a first visit.
  }
}

export function forgetKept(...names: string[]): void {
  try {
    for (const name of names) localStorage.removeItem(PREFIX + name);
  } catch {
    // Nothing is stored.
  }
}
