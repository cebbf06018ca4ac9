// A field for a setting that is a number.
import type { TemplateResult } from "lit";
import { type NumberField, numberField, numberInput } from "./number-field";
import { FEWEST_POINTS, type NumberSetting, SETTINGS } from "./settings";
import type { SettingsStore } from "./settings-store";

type Rows = typeof SETTINGS;
export type NumberName = {
  [Name in keyof Rows]: Rows[Name] extends NumberSetting ? Name : never;
}[keyof Rows];

type Bound = Pick<NumberField, "limits" | "value" | "change">;

/** Connects a field with its setting. `usual` stands for 0 in a field for inducing points. */
function bind(settings: SettingsStore, name: NumberName, usual?: number): Bound {
  const row: NumberSetting = SETTINGS[name];
  const stands = usual ?? ("usual" in row ? Number(row.usual) : undefined);
  const shown = () => settings.values[name] || (stands ?? 0);
  return {
    limits: stands === undefined ? row : { ...row, min: FEWEST_POINTS },
    value: shown(),
    change(value) {
      const kept = stands === undefined ? value : value === stands ? 0 : Math.max(FEWEST_POINTS, value);
      settings.change({ [name]: kept });
      return shown();
    },
  };
}

export function settingField(
  settings: SettingsStore,
  name: NumberName,
  field: Omit<NumberField, keyof Bound>,
  usual?: number,
): TemplateResult {
  return numberField({ ...field, ...bind(settings, name, usual) });
}

/** The field without a label. */
export function settingInput(
  settings: SettingsStore,
  name: NumberName,
  field: { id: string; testId: string; disabled: boolean },
): TemplateResult {
  return numberInput({ ...field, ...bind(settings, name) });
}
