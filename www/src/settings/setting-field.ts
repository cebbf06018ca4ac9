// A field for a setting that is a number.
import type { TemplateResult } from "lit";
import { type NumberField, numberField, numberInput } from "./number-field";
import { type NumberSetting, SETTINGS } from "./settings";
import type { SettingsStore } from "./settings-store";

type Rows = typeof SETTINGS;
export type NumberName = {
  [Name in keyof Rows]: Rows[Name] extends NumberSetting ? Name : never;
}[keyof Rows];

type Bound = Pick<NumberField, "limits" | "value" | "change">;

/** Connects a field with its setting. */
function bind(settings: SettingsStore, name: NumberName): Bound {
  return {
    limits: SETTINGS[name],
    value: settings.values[name],
    change(value) {
      settings.change({ [name]: value });
      return settings.values[name];
    },
  };
}

export function settingField(
  settings: SettingsStore,
  name: NumberName,
  field: Omit<NumberField, keyof Bound>,
): TemplateResult {
  return numberField({ ...field, ...bind(settings, name) });
}

/** The field without a label. */
export function settingInput(
  settings: SettingsStore,
  name: NumberName,
  field: { id: string; testId: string; disabled: boolean },
): TemplateResult {
  return numberInput({ ...field, ...bind(settings, name) });
}
