// The model file that an address names (`#model=FILE`): a JSON file on the page's own host.
import { textWithin } from "./bytes";
import { LinkError } from "./problem";

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
  // A redirect could lead to another host.
  const answer = await fetch(addressOf(name, document.baseURI), { redirect: "error" }).catch(() => null);
  if (!answer?.ok || !answer.body) {
    const found = answer ? String(answer.status) : "";
    throw new LinkError({ what: "missing", file: name, found });
  }
  return textWithin(answer.body);
}
