// Reads bytes from a stream up to a limit, so that neither a small packed text nor a host can fill the memory.
import { LinkError } from "./problem";

/** The largest document that a link may bring, in bytes: ten times a model of four parts with 40 points. */
export const LARGEST_DOCUMENT = 8_000_000;

/** All bytes of a stream as text. Stops reading at the limit. */
export async function textWithin(
  stream: ReadableStream<Uint8Array>,
  most = LARGEST_DOCUMENT,
): Promise<string> {
  const reader = stream.getReader();
  const decoder = new TextDecoder();
  let [text, read] = ["", 0];
  for (;;) {
    const { done, value } = await reader.read();
    if (done) return text + decoder.decode();
    read += value.length;
    if (read > most) {
      await reader.cancel();
      throw new LinkError({ what: "large", most });
    }
    text += decoder.decode(value, { stream: true });
  }
}
