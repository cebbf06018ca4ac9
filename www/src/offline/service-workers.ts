// The browser's service workers, for pages that have them. Loaded when the page has nothing else to do.
import { Workbox } from "workbox-window";
import type { ServiceWorkers } from "./offline-store";

export const serviceWorkers = () =>
  new Workbox(new URL("service.js", document.baseURI).href) as ServiceWorkers;
