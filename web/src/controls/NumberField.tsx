// A number that can be typed: taken with Enter or when the field is left, given up with Escape.

import { useSignal } from '@preact/signals';

export interface NumberFieldProps {
  label: string;
  value: number;
  unit: string;
  digits?: number;
  disabled?: boolean;
  take(value: number): void;
}

export function NumberField({ label, value, unit, digits = 1, disabled = false, take }: NumberFieldProps) {
  const typed = useSignal<string | null>(null);
  const shown = typed.value ?? value.toFixed(digits);
  const wrong = !Number.isFinite(parse(shown));
  const done = (): void => {
    const number = parse(shown);
    const changed = typed.value !== null && Number.isFinite(number) && number.toFixed(digits) !== value.toFixed(digits);
    typed.value = null;
    if (changed) take(number);
  };
  return (
    <label class="number-field">
      <span>{label}</span>
      <input
        inputMode="decimal"
        value={shown}
        disabled={disabled}
        aria-invalid={wrong}
        onInput={(event) => (typed.value = event.currentTarget.value)}
        onBlur={done}
        onFocus={(event) => event.currentTarget.select()}
        onKeyDown={(event) => {
          if (event.key === 'Enter') done();
          if (event.key === 'Escape') {
            typed.value = null;
            event.currentTarget.blur();
          }
        }}
      />
      <em>{unit}</em>
    </label>
  );
}

/** "12.5" and "12,5" are the same; anything else is no number. */
function parse(text: string): number {
  const plain = text.trim().replace(',', '.');
  return /^[-+]?(\d+\.?\d*|\.\d+)$/.test(plain) ? Number(plain) : Number.NaN;
}
