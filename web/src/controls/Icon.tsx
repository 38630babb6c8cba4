// The page's own line icons, 16 units square.

const kPaths = {
  plus: 'M8 3v10M3 8h10',
  play: 'M5 3.2v9.6l8-4.8z',
  step: 'M4 3.2v9.6l6-4.8zM12 3.5v9',
  pause: 'M5.5 3.5v9M10.5 3.5v9',
  stop: 'M4.5 4.5h7v7h-7z',
  list: 'M2.5 4h11M2.5 8h11M2.5 12h11',
  file: 'M4 1.8h5l3.2 3.2v9.2H4zM9 1.8V5h3.2',
  check: 'M3 8.5l3.2 3.2L13 4.5',
  cross: 'M4 4l8 8M12 4l-8 8',
  alert: 'M8 2.2L14.4 13.5H1.6zM8 6.5v3.2M8 11.4v.4',
  down: 'M8 2.5v8M4.6 7.3L8 10.7l3.4-3.4M3 13.5h10',
  camera: 'M2 5h2.6l1.2-1.8h4.4L11.4 5H14v8H2zM8 11a2.3 2.3 0 1 0 0-4.6A2.3 2.3 0 0 0 8 11z',
  help: 'M5.8 6a2.3 2.3 0 1 1 3.3 2.1c-.8.4-1.1.9-1.1 1.7M8 11.8v.4',
  sliders: 'M2.5 5h5.2M11.3 5h2.2M2.5 11h2.2M8.3 11h5.2M9.5 6.8a1.8 1.8 0 1 0 0-3.6 1.8 1.8 0 0 0 0 3.6zM6.5 12.8a1.8 1.8 0 1 0 0-3.6 1.8 1.8 0 0 0 0 3.6z',
  share: 'M10.5 5.2L5.6 7.4M5.6 8.7l4.9 2.2M12 6.4a1.9 1.9 0 1 0 0-3.8 1.9 1.9 0 0 0 0 3.8zM4 10a1.9 1.9 0 1 0 0-3.8A1.9 1.9 0 0 0 4 10zM12 13.6a1.9 1.9 0 1 0 0-3.8 1.9 1.9 0 0 0 0 3.8z',
  copy: 'M5.5 5.5h8v8h-8zM10.5 5.5v-3h-8v8h3',
  grid: 'M2.5 2.5h4.5V7H2.5zM9 2.5h4.5V7H9zM2.5 9h4.5v4.5H2.5zM9 9h4.5v4.5H9z',
  gauge: 'M2.6 12.5a6.2 6.2 0 1 1 10.8 0M8 9.6l2.9-3.4M8 10.6a1 1 0 1 0 0-2 1 1 0 0 0 0 2z',
  leave: 'M6.5 2.5h-4v11h4M6.5 8h7.5M11 5l3 3-3 3',
  shirt: 'M5.5 2.5L2 5l1.5 2.5L5 6.8V13.5h6V6.8l1.5.7L14 5l-3.5-2.5c-.6 1.4-4.4 1.4-5 0z',
} as const;

export type IconName = keyof typeof kPaths;

export function Icon({ name }: { name: IconName }) {
  return (
    <svg class={`icon icon-${name}`} viewBox="0 0 16 16" width="16" height="16" aria-hidden="true">
      <path d={kPaths[name]} />
    </svg>
  );
}
