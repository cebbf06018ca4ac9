// How abort signals and functions cross to a worker. The page and its workers load this file.
import * as Comlink from "comlink";

/** The other side gets a signal of its own, which is aborted when this one is. */
const signals: Comlink.TransferHandler<AbortSignal, MessagePort> = {
  canHandle: (value): value is AbortSignal => value instanceof AbortSignal,
  serialize(signal) {
    const { port1, port2 } = new MessageChannel();
    const abort = () => port1.postMessage(null);
    if (signal.aborted) abort();
    else signal.addEventListener("abort", abort, { once: true });
    return [port2, [port2]];
  },
  deserialize(port) {
    const controller = new AbortController();
    port.onmessage = () => {
      port.close();
      controller.abort();
    };
    return controller.signal;
  },
};

/** The other side gets a function that calls this one. */
const functions: Comlink.TransferHandler<object, MessagePort> = {
  canHandle: (value): value is object => typeof value === "function" && !(Comlink.proxyMarker in value),
  serialize(call) {
    const { port1, port2 } = new MessageChannel();
    Comlink.expose(call, port1);
    return [port2, [port2]];
  },
  deserialize(port) {
    port.start();
    return Comlink.wrap(port);
  },
};

Comlink.transferHandlers.set("signal", signals);
Comlink.transferHandlers.set("function", functions);
