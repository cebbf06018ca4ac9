import { expect, it, vi } from "vitest";
import { Lazy } from "./lazy";

it("loads once, at the first use, and again after a failure", async () => {
  const load = vi
    .fn<() => Promise<number>>()
    .mockRejectedValueOnce(new Error("offline"))
    .mockResolvedValue(3);
  const lazy = new Lazy(load);
  expect(load).not.toHaveBeenCalled();
  await expect(lazy.get()).rejects.toThrow("offline");
  expect(await Promise.all([lazy.get(), lazy.get()])).toEqual([3, 3]);
  expect(load).toHaveBeenCalledTimes(2);
});
