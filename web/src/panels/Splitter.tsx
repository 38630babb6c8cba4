// The bar between the 3D view and the pattern: drag it, or move it with the arrow keys.

import { useSignal } from '@preact/signals';
import { useEffect, useRef } from 'preact/hooks';
import { keep, kept } from '../texts/kept';
import { t } from '../texts/language';

const kLeast = 280;
const kMost = 760;
const kFirst = 400;
const kStep = 24;
export function Splitter() {
  const bar = useRef<HTMLDivElement>(null);
  const width = useSignal(Number(kept('side')) || kFirst);
  const set = (wanted: number): void => {
    width.value = Math.round(Math.min(kMost, Math.max(kLeast, wanted)));
    keep('side', String(width.value));
  };
  useEffect(() => bar.current?.parentElement?.style.setProperty('--side', `${width.value}px`), [width.value]);
  const drag = (event: PointerEvent): void => {
    if (event.buttons !== 1) return;
    set(bar.current!.parentElement!.getBoundingClientRect().right - event.clientX);
  };
  const keys = (event: KeyboardEvent): void => {
    const step = event.key === 'ArrowLeft' ? kStep : event.key === 'ArrowRight' ? -kStep : 0;
    if (step === 0) return;
    event.preventDefault();
    set(width.value + step);
  };
  return (
    <div
      ref={bar}
      class="splitter"
      role="separator"
      aria-orientation="vertical"
      aria-label={t.frame.splitter}
      tabIndex={0}
      aria-valuenow={width.value}
      aria-valuemin={kLeast}
      aria-valuemax={kMost}
      onKeyDown={keys}
      onPointerDown={(event) => event.currentTarget.setPointerCapture(event.pointerId)}
      onPointerMove={drag}
    />
  );
}
