import type { NumbersWords } from "../en/numbers";

export const words: NumbersWords = {
  failed: "Diese Zahlen konnten nicht berechnet werden.",
  empty: "Hier erscheinen die Zahlen des Modells und seiner Bewegung.",
  modelNow: "das Modell jetzt",
  asLearned: "wie gelernt",
  logDensity: {
    title: "Log-Dichte der latenten Zustände",
    of: "Bewegung",
    rollout: "ein Bild von ihr",
    training: "ein Bild des Trainings",
    difference: "Unterschied",
    about: (elbo) =>
      `Wie wahrscheinlich die latenten Zustände eines Bildes unter der gelernten Dynamik sind, in Nat. Knopp et al. (2019) sagten mit einer anderen Zahl vorher, wie natürlich Menschen das Gehen fanden: mit der Dynamik-ELBO des trainierten Modells, hier ${elbo}.`,
    caution:
      "Nach dieser hat niemand Menschen gefragt. Vergleiche nur Bewegungen eines Modells. Ohne Rauschen kann eine Bewegung über 0 liegen, auch in Ruhe.",
  },
  couplings: {
    title: "[Kopplungen|coupling]",
    label: "Kopplungen",
    decides: "wer entscheidet",
    about: "über",
    alphaLearned: "[α|alpha] gelernt",
    alphaNow: "α jetzt",
    weightNow: "[w|weight] jetzt",
  },
  angles: {
    title: "Gelenkwinkel",
    channel: "Gelenk und Kanal",
    against: "über",
    time: "der Zeit",
    speed: "seinem Tempo (Phasenbild)",
    save: "CSV speichern",
    chart: (upward, across) => `${upward} über ${across}`,
    axes: {
      time: "Zeit (s)",
      speed: (channel, unit) => `Tempo von ${channel} (${unit}/s)`,
      fileUnits: "Einheiten der Datei",
    },
    about: (name) =>
      `Wie in der BVH-Datei: ${name}, Winkel in Grad. Der Punkt ist jetzt; er läuft, während die Bühne spielt.`,
  },
  kernels: {
    poses: "[Posenabbildungen|pose-map]: vom latenten Zustand zur Pose",
    posesLabel: "Kerne der Posenabbildungen",
    part: "Teil",
    along: "[Längenskala|lengthscale] √λ entlang",
    experts: (order) =>
      `[Experten|expert]: ${order === 1 ? "vom letzten Bild" : `von den letzten ${order} Bildern`} zum nächsten latenten Zustand`,
    expertsLabel: "Kerne der Experten",
    from: "von",
    note: "Jeder Kern ist quadratisch-exponentiell, ohne linearen Anteil. Die Signalvarianz jedes Experten ist 1: Sonst könnte seine Größe die Kopplung ersetzen.",
  },
};
