// What the browser keeps from one visit to the next. It may refuse to: then it lasts for this one.

export function kept(name: string): string | null {
  try {
    return localStorage.getItem(`toile.${name}`);
  } catch {
    return null;
  }
}

export function keep(name: string, value: string): void {
  try {
    localStorage.setItem(`toile.${name}`, value);
  } catch {
    // See above.
  }
}
