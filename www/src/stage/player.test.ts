import { describe, expect, it } from "vitest";
import { Player } from "./player";

function playing(): Player {
  const player = new Player();
  player.load(100, 1 / 30, 90);
  player.play();
  return player;
}

describe("the clock", () => {
  it("moves on in seconds, at its speed", () => {
    const player = playing();
    player.speed = 0.5;
    player.advance(1);
    expect(player.frame).toBeCloseTo(15);
  });

  it("loops at the end of the loop, and returns the number of laps", () => {
    const player = playing();
    player.frame = 89;
    expect(player.advance(0.1)).toBe(1);
    expect(player.frame).toBeCloseTo(2);
  });

  it("plays on from a frame after the end of the loop", () => {
    const player = playing();
    player.scrub(95);
    expect(player.advance(1 / 30)).toBe(0);
    expect(player.frame).toBeCloseTo(96);
  });

  it("stops at the end without a loop, and starts again", () => {
    const player = playing();
    player.loops = false;
    player.advance(60);
    expect([player.frame, player.playing]).toEqual([99, false]);
    player.play();
    expect(player.frame).toBe(0);
  });

  it("steps by whole frames around the ends", () => {
    const player = playing();
    player.frame = 10.4;
    player.step(1);
    expect(player.frame).toBe(11);
    player.step(-1);
    expect(player.frame).toBe(10);
    player.frame = 0;
    player.step(-1);
    expect(player.frame).toBe(99);
  });

  it("keeps its frame when the motion is replaced", () => {
    const player = playing();
    player.frame = 42.5;
    player.load(300, 1 / 30, 280);
    expect(player.frame).toBe(42.5);
    player.load(20, 1 / 30, 19);
    expect(player.frame).toBe(0);
  });

  it("stands still with one frame", () => {
    const player = playing();
    player.load(1, 1 / 30, 0);
    player.frame = 0;
    expect(player.advance(1)).toBe(0);
    expect(player.frame).toBe(0);
  });
});
