// The model file that an address names (`#model=FILE`): a JSON file on the page's own host.
import { textWithin } from "./bytes";
import { LinkError } from "./problem";

/** Milliseconds: a host may answer and then never end. */
const LONGEST = 120_000;

/** The address of the file, relative to the page. */
export function addressOf(name: string, page: string): string {
  const wrong = new LinkError({ what: "name", found: name.slice(0, 100) });
  if (!URL.canParse(name, page)) throw wrong;
  const [address, own] = [new URL(name, page), new URL(page)];
  // A blob has the origin of its page.
  const isOwn = address.origin === own.origin && address.protocol === own.protocol;
  if (!isOwn || !/\.json$/i.test(address.pathname)) throw wrong;
  return address.href;
}

/** The text of the file. Throws a `LinkError`. */
export async function textOfFile(name: string): Promise<string> {
  const missing = (found: string) => new LinkError({ what: "missing", file: name, found });
  // A redirect could lead to another host.
  const answer = await fetch(addressOf(name, document.baseURI), {
    redirect: "error",
    signal: AbortSignal.timeout(LONGEST),
  }).catch(() => null);
  if (!answer?.ok || !answer.body) throw missing(answer ? String(answer.status) : "");
  return textWithin(answer.body).catch((problem: unknown) => {
    throw problem instanceof LinkError ? problem : missing("");
  });
}
