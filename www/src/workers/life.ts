// How the page hears of a worker's death. No DOM.

/** Kept when this worker holds the lock of its name, which it does for as long as it lives. */
export function showLife(): Promise<void> {
  const { locks } = navigator;
  if (!locks) return Promise.resolve();
  return new Promise((held, failed) => {
    const forLife = () => new Promise<never>(() => held());
    locks.request(self.name, forLife).catch(failed);
  });
}
