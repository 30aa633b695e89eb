// The settings of the server: what goes into initializationOptions and answers workspace/configuration. No VS Code here.

/** The settings that the server knows, named as in the project file. */
export const SERVER_SETTINGS = [
  'language',
  'dialect',
  'channel-config',
  'macrocycles',
  'parameters',
  'block-skip',
  'optional-stop',
  'encoding',
  'lints',
  'limits.records',
] as const;

/** A JSON value. */
export type Json = null | boolean | number | string | readonly Json[] | { readonly [key: string]: Json };

/**
 * The object that the server takes: `limits.records` as `{"limits": {"records": …}}`, what is not set as null, which leaves
 * it to the project file. An empty text, list or table counts as not set.
 */
export function serverSettings(get: (name: string) => unknown): { [key: string]: Json } {
  const settings: { [key: string]: Json } = {};
  for (const name of SERVER_SETTINGS) {
    const value = set(get(name));
    const [table, key] = name.split('.');
    if (table !== undefined && key !== undefined) {
      settings[table] = { [key]: value };
    } else {
      settings[name] = value;
    }
  }
  return settings;
}

function set(value: unknown): Json {
  if (value === undefined || value === null || value === '') {
    return null;
  }
  if (typeof value === 'object' && Object.keys(value).length === 0) {
    return null;
  }
  // A proxy of the editor's settings becomes a plain value.
  return JSON.parse(JSON.stringify(value)) as Json;
}

/** The language of explanations: as set, else the editor's. */
export function language(setting: unknown, locale: string): 'en' | 'cs' {
  if (setting === 'en' || setting === 'cs') {
    return setting;
  }
  return /^cs\b/i.test(locale) ? 'cs' : 'en';
}
