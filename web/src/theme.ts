// Dark or light: as VS Code says in its panel, else as the system.

const system = window.matchMedia('(prefers-color-scheme: dark)');

export function isDark(): boolean {
  const { classList } = document.body;
  if (classList.contains('vscode-light') || classList.contains('vscode-high-contrast-light')) {
    return false;
  }
  return classList.contains('vscode-dark') || classList.contains('vscode-high-contrast') || system.matches;
}

/** Gives the styles the theme now, and after each change, before `changed` is called. */
export function followTheme(changed: () => void): void {
  const set = (): boolean => {
    const theme = isDark() ? 'dark' : 'light';
    const before = document.documentElement.dataset['theme'];
    document.documentElement.dataset['theme'] = theme;
    return before !== theme;
  };
  const look = (): void => {
    if (set()) {
      changed();
    }
  };
  set();
  system.addEventListener('change', look);
  new MutationObserver(look).observe(document.body, { attributes: true, attributeFilter: ['class'] });
}
