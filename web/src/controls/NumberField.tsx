// A number that can be typed: taken with Enter or when the field is left, given up with Escape.

import { useSignal } from '@preact/signals';
import { fixed, typed as numberOf } from '../texts/numbers';
import { mmOf, patternDigits, patternSign, shownMm } from '../texts/units';

export interface NumberFieldProps {
  label: string;
  /** In the unit named; mm where it is a length. */
  value: number;
  unit?: string;
  /** A length of the pattern: shown and typed in the unit that was chosen, given and taken in mm. */
  length?: boolean;
  /** Of a length: those of millimetres. */
  digits?: number;
  disabled?: boolean;
  take(value: number): void;
}

export function NumberField(props: NumberFieldProps) {
  const { label, disabled = false, take } = props;
  const { value, digits, unit, back } = props.length ? ofLength(props) : ofFigure(props);
  const typed = useSignal<string | null>(null);
  const shown = typed.value ?? fixed(value, digits);
  const wrong = !Number.isFinite(numberOf(shown));
  const done = (): void => {
    const number = numberOf(shown);
    const changed = typed.value !== null && Number.isFinite(number) && fixed(number, digits) !== fixed(value, digits);
    typed.value = null;
    if (changed) take(back(number));
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

interface Figure {
  value: number;
  digits: number;
  unit: string;
  /** From what is shown to what is kept. */
  back(shown: number): number;
}

const ofFigure = ({ value, digits = 1, unit = '' }: NumberFieldProps): Figure => ({ value, digits, unit, back: (shown) => shown });

const ofLength = ({ value, digits = 1 }: NumberFieldProps): Figure => ({
  value: shownMm(value),
  digits: patternDigits(digits),
  unit: patternSign(),
  back: mmOf,
});
