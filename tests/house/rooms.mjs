// The order of the rooms as ARCHITECTURE.md draws it, and what breaks it.

/**
 * @typedef {object} Rooms
 * @property {Map<string, number>} floors the floor of each room; a room may use the rooms of lower floors
 * @property {{ room: string, files: string[] }[]} usesOnly rooms that may use only these files of others
 * @property {Rule[]} rules who may use which package
 *
 * @typedef {{ verb: string, places: string[], packages: string[] }} Rule `places` are rooms or files; none
 * may where it is empty
 * @typedef {{ from: string, to: string }} Use one file uses another; paths below the rooms' folder, with
 * their endings
 */

const list = (/** @type {string} */ text) => text.split(/,\s*/);

/**
 * Reads the fenced block of a document that is headed "rooms FOLDER". Each line names a floor, the lowest
 * first: one room, or several that do not use each other. Further lines are rules: "ROOM uses only FILE,
 * ...", "only PLACE, ... VERB PACKAGE, ...", "nothing VERB PACKAGE". Two spaces begin a remark.
 * @param {string} document
 * @param {string} folder
 * @returns {Rooms}
 */
export function readRooms(document, folder) {
  const block = document.split(`\n\`\`\`rooms ${folder}\n`)[1]?.split("\n```")[0];
  if (block === undefined) throw new Error(`the document has no block of the rooms of ${folder}`);
  /** @type {Rooms} */
  const rooms = { floors: new Map(), usesOnly: [], rules: [] };
  let floor = 0;
  for (const line of block.split("\n").filter((line) => line.trim() !== "")) {
    const text = line.split("  ")[0] ?? "";
    const floorOf = text.match(/^[\w-]+(, [\w-]+)*$/);
    const usesOnly = text.match(/^([\w-]+) uses only (.+)$/);
    const only = text.match(/^only (.+?) (imports?|loads?|names?) (.+)$/);
    const nothing = text.match(/^nothing (imports|loads|names) (.+)$/);
    if (floorOf) {
      floor += 1;
      for (const room of list(text)) rooms.floors.set(room, floor);
    } else if (usesOnly) {
      rooms.usesOnly.push({ room: usesOnly[1] ?? "", files: list(usesOnly[2] ?? "") });
    } else if (only) {
      rooms.rules.push({ verb: verb(only[2]), places: list(only[1] ?? ""), packages: list(only[3] ?? "") });
    } else if (nothing) {
      rooms.rules.push({ verb: verb(nothing[1]), places: [], packages: list(nothing[2] ?? "") });
    } else {
      throw new Error(`the rooms of ${folder}: expected a floor or a rule, found "${line}"`);
    }
  }
  return rooms;
}

const verb = (/** @type {string | undefined} */ text) => (text ?? "").replace(/s$/, "");

/** `motion/bvh/parse.rs` stands in `motion`, `words.rs` in `words`. */
export const roomOf = (/** @type {string} */ file) => (file.split("/")[0] ?? "").replace(/\.\w+$/, "");

/** Whether a file is this one, named without its ending, or stands in this room. */
export const standsIn = (/** @type {string} */ file, /** @type {string} */ place) =>
  place.includes("/") ? file.replace(/\.\w+$/, "") === place : roomOf(file) === place;

/**
 * Which rooms of the document are not there, and which that are there it does not name.
 * @param {string[]} files
 * @param {Rooms} rooms
 */
export function strangeRooms(files, { floors }) {
  const there = new Set(files.map(roomOf));
  return [
    ...[...there]
      .filter((room) => !floors.has(room))
      .map((room) => `${room}: a room that the order does not name`),
    ...[...floors.keys()]
      .filter((room) => !there.has(room))
      .map((room) => `${room}: in the order, but no such room`),
  ];
}

/**
 * Uses that go up, or sideways to a room of the same floor.
 * @param {Use[]} uses
 * @param {Rooms} rooms
 */
export function againstOrder(uses, { floors, usesOnly }) {
  const allowed = (/** @type {Use} */ { from, to }) => {
    const [user, used] = [roomOf(from), roomOf(to)];
    if (user === used) return true;
    const only = usesOnly.find(({ room }) => room === user);
    if (only && !only.files.some((file) => standsIn(to, file))) return false;
    return (floors.get(used) ?? Infinity) < (floors.get(user) ?? 0);
  };
  return uses.filter((use) => !allowed(use)).map(({ from, to }) => `${from} uses ${to}`);
}

/**
 * Circles: files that use each other, also by way of others. One line for each.
 * @param {Use[]} uses
 */
export function circles(uses) {
  /** @type {Map<string, Set<string>>} */
  const next = new Map();
  for (const { from, to } of uses) {
    if (from !== to) next.set(from, (next.get(from) ?? new Set()).add(to));
  }
  /** @type {Set<string>} */
  const done = new Set();
  /** @type {string[]} */
  const found = [];
  const visit = (/** @type {string} */ file, /** @type {string[]} */ path) => {
    const start = path.indexOf(file);
    if (start >= 0) return void found.push([...path.slice(start), file].join(" -> "));
    if (done.has(file)) return;
    for (const used of next.get(file) ?? []) visit(used, [...path, file]);
    done.add(file);
  };
  for (const file of next.keys()) visit(file, []);
  return found;
}
