// The service worker: it keeps every file of the page, so that the page works without a network. A program of
// its own; a new version of it waits until the visitor asks for it. No DOM.
import { clientsClaim } from "workbox-core";
import { type PrecacheEntry, precacheAndRoute } from "workbox-precaching";

/** All files of the built page; www/offline.ts lists them. */
declare const FILES: PrecacheEntry[];

precacheAndRoute(FILES);
// The first visit is served from here as soon as all is there, not only the next one.
clientsClaim();

addEventListener("message", ({ data }) => {
  const scope = self as unknown as { skipWaiting(): Promise<void> };
  if ((data as { type?: unknown } | null)?.type === "SKIP_WAITING") void scope.skipWaiting();
});
