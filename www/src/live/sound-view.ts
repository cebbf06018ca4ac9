// The button Sound: a click for each foot that comes down, and a tone for each hand that draws.
import { html, nothing } from "lit";
import type { Motion } from "../engine/protocol";
import { feetOf, floorOf } from "../scene/stance";
import { eachFrame } from "../ui/browser";
import { View } from "../ui/view";
import { loadPerforming, performingWords } from "../words/sections";
import type { WordsStore } from "../words/words";
import type { Playback } from "../stage/playback";
import type { StageStore } from "../stage/stage-store";

/** A foot is up above the one height, and down below the other; metres over the ground. */
const [UP, DOWN] = [0.07, 0.03];
/** The tone of the lowest place of a hand in hertz, and the octaves above it. */
const [LOWEST, OCTAVES] = [196, 2];
/** The tones of a click on the left and on the right, hertz, and its seconds. */
const CLICKS = [440, 330];
const CLICK = 0.06;
const LOUD = 0.1;
/** A tone changes within these seconds. It ends when no picture of the page has been drawn for a while. */
const [SOON, AWHILE] = [0.03, 0.3];

class Sound {
  readonly #context = new AudioContext();
  /** What is heard, for a moving picture. */
  readonly recorded = new MediaStreamAudioDestinationNode(this.#context);
  readonly #hands: { tone: OscillatorNode; volume: GainNode }[] = [];
  readonly #isUp: boolean[] = [];

  /** A tone on the left or on the right, at first silent. */
  #tone(side: number, frequency: number): { tone: OscillatorNode; volume: GainNode } {
    const tone = new OscillatorNode(this.#context, { type: "triangle", frequency });
    const volume = new GainNode(this.#context, { gain: 0 });
    const place = new StereoPannerNode(this.#context, { pan: side === 0 ? -0.5 : 0.5 });
    tone.connect(volume).connect(place).connect(this.#context.destination);
    place.connect(this.recorded);
    tone.start();
    return { tone, volume };
  }

  #click(side: number): void {
    const now = this.#context.currentTime;
    const { tone, volume } = this.#tone(side, CLICKS[side] ?? LOWEST);
    volume.gain.setValueAtTime(2 * LOUD, now).exponentialRampToValueAtTime(LOUD / 100, now + CLICK);
    tone.stop(now + CLICK);
  }

  /** Plays the height of each foot over the ground in metres, and of each hand from 0 to 1. */
  play(feet: readonly number[], hands: readonly number[]): void {
    const now = this.#context.currentTime;
    feet.forEach((height, foot) => {
      if (this.#isUp[foot] && height < DOWN) this.#click(foot % 2);
      this.#isUp[foot] = height > (this.#isUp[foot] ? DOWN : UP);
    });
    hands.forEach((height, hand) => {
      this.#hands[hand] ??= this.#tone(hand, LOWEST);
      const { tone, volume } = this.#hands[hand];
      tone.frequency.setTargetAtTime(LOWEST * 2 ** (OCTAVES * height), now, SOON);
      volume.gain.cancelScheduledValues(now).setTargetAtTime(LOUD, now, SOON);
      volume.gain.setTargetAtTime(0, now + AWHILE, SOON);
    });
  }

  end(): void {
    void this.#context.close();
  }
}

export class SoundView extends View {
  static override properties = { on: { state: true }, ready: { state: true } };
  /** With a figure that is heard. */
  declare app: { words: WordsStore; stage?: StageStore; playback?: Playback };
  /** The height of each hand, 0 to 1. */
  declare hands?: () => readonly number[];
  declare on: boolean;
  declare ready: boolean;
  /** What is heard; null while the sound is off. */
  recorded: MediaStream | null = null;
  #stop = () => {};
  /** The motion whose feet these are. */
  #ground: { motion: Motion; floor: number; feet: number[] } | null = null;

  constructor() {
    super();
    [this.on, this.ready] = [false, false];
  }

  protected override stores() {
    return [];
  }

  protected override arrived(): void {
    void loadPerforming(this.app.words).then(() => {
      this.ready = true;
    });
    this.whenLeaving(() => this.#turn(false));
  }

  #turn(on: boolean): void {
    this.#stop();
    this.on = on;
    if (!on) return;
    const sound = new Sound();
    this.recorded = sound.recorded.stream;
    const stop = eachFrame(() => sound.play(this.#feet(), this.hands?.() ?? []));
    this.#stop = () => {
      stop();
      sound.end();
      this.recorded = null;
      this.#stop = () => {};
    };
  }

  #feet(): number[] {
    const { content } = this.app.stage ?? {};
    const { pose, playing } = this.app.playback ?? {};
    if (!content || !pose || !playing) return [];
    const { motion, live, figure } = content;
    // The first frames of a live motion show too little.
    if (!this.#ground || (!live && this.#ground.motion !== motion)) {
      const floor = floorOf(motion);
      const isEnd = (node: number) => figure.nodes.every(({ parent }) => parent !== node);
      this.#ground = { motion, floor, feet: feetOf(motion, floor).filter(isEnd) };
    }
    const { floor, feet } = this.#ground;
    return feet.map((node) => pose[3 * node + 1]! - floor);
  }

  protected override render() {
    if (!this.ready) return nothing;
    const { sound, soundMeaning } = performingWords();
    const pressed = this.on ? "true" : "false";
    return html`<button class="chip" data-testid="sound" aria-pressed=${pressed} title=${soundMeaning} @click=${() => this.#turn(!this.on)}>${sound}</button>`;
  }
}
customElements.define("pg-sound", SoundView);
