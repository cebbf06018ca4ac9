import type { StudyWords } from "./study-en";

const INSTRUCTIONS = {
  cross:
    "In jedem Durchgang erscheint zuerst ein Kreuz: Sieh es bitte an. Dann bewegen sich zwei Figuren nebeneinander. ",
  answer:
    "\n\nWenn sie fertig sind, sag, auf welcher Seite du die natürlichere Bewegung gesehen hast: Drücke die linke oder die rechte Pfeiltaste, oder tippe auf diese Seite. Du hast so viel Zeit, wie du willst, aber antworte nach dem ersten Eindruck. Wenn du es nicht weißt, rate.",
};

export const study: StudyWords = {
  consent: [
    "Du siehst Paare kurzer Bewegungen und sagst, welche von beiden dir natürlicher vorkommt.\n\nDie Teilnahme ist freiwillig. Du kannst jederzeit aufhören, ohne einen Grund zu nennen. Deine Antworten bleiben auf diesem Computer und werden nirgendwohin gesendet. Weder dein Name noch Bild oder Ton von dir werden aufgenommen.",
  ],
  instructions: [
    `${INSTRUCTIONS.cross}Die eine Bewegung kommt aus einer Aufnahme, die andere von einem Computermodell.${INSTRUCTIONS.answer}`,
    `${INSTRUCTIONS.cross}Die eine ist ein Programm dieses Projekts, das nach veröffentlichten Kurven des menschlichen Gangs geht: Sie steht hier für die natürliche Bewegung, denn das Projekt enthält keine Aufnahmen. Die andere hat ein Modell gemacht, das von diesem Programm gelernt hat.${INSTRUCTIONS.answer}`,
  ],
  question: ["Auf welcher Seite hast du die natürlichere Bewegung wahrgenommen?"],
  pause: ["Zeit für eine Pause. Ruh deine Augen einen Moment aus."],
  end: ["Das war alles. Danke, dass du mitgemacht hast!"],
};
