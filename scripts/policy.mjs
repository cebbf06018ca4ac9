// What the page may do in a browser: its own files, the wasm, pictures and downloads that it makes itself;
// nothing inline, no other host. A meta element of the built page says it, for hosts that send no headers,
// and our own server sends it, so that it applies to workers too.
export const policy = [
  "default-src 'self'",
  "script-src 'self' 'wasm-unsafe-eval'",
  "style-src 'self'",
  "img-src 'self' data: blob:",
  "worker-src 'self'",
  "connect-src 'self'",
  "object-src 'none'",
  "base-uri 'self'",
  "form-action 'none'",
].join("; ");
