// Parts of what came of a drape, for its owner and for who looks at it by a link.

import { Icon } from '../controls/Icon';
import { useModal } from '../controls/Sheet';
import type { Download, ReportLine } from '../state/report';
import { bytes } from '../state/words';
import { t } from '../texts/language';

const stillNames = (): Record<string, string> => ({
  'three-quarter.png': t.report.stills.threeQuarter,
  'front.png': t.report.stills.front,
  'back.png': t.report.stills.back,
  'side.png': t.report.stills.side,
});

/** Of the pictures in a row, pixels; a click shows the whole one. */
const kStillWidth = 320;

export const stillName = (name: string): string => stillNames()[name] ?? name;

interface StillsProps {
  names: readonly string[];
  urlOf(name: string, width?: number): string;
  enlarge(name: string): void;
}

export function Stills({ names, urlOf, enlarge }: StillsProps) {
  return (
    <ul class="stills">
      {names.map((name) => (
        <li key={name}>
          <button onClick={() => enlarge(name)} aria-label={t.report.enlarge(stillName(name))}>
            <img src={urlOf(name, kStillWidth)} alt="" decoding="async" />
            <span>{stillName(name)}</span>
          </button>
        </li>
      ))}
    </ul>
  );
}

/** A file to take along; it is saved under the drape's name. */
export function FileLink({ file, url, of, tip }: { file: Download; url: string; of: string; tip?: string }) {
  return (
    <li>
      <a href={url} download={`${of} ${file.name}`} title={tip}>
        <Icon name="down" />
        <span>
          <b>{file.title}</b>
          {file.hint && <small>{file.hint}</small>}
        </span>
        <em>{bytes(file.bytes)}</em>
      </a>
    </li>
  );
}

/** A report in words. */
export function Lines({ lines }: { lines: readonly ReportLine[] }) {
  return (
    <ul class="report">
      {lines.map((line) => (
        <li key={line.label} class={`verdict-${line.verdict}`}>
          <Icon name={line.verdict === 'warn' ? 'alert' : 'check'} />
          <div>
            <p>
              <span>{line.label}</span>
              <b>{line.value}</b>
            </p>
            <small>{line.sentence}</small>
          </div>
        </li>
      ))}
    </ul>
  );
}

export function Enlarged({ url, name, close }: { url: string; name: string; close: () => void }) {
  const { leave, ...modal } = useModal(close);
  return (
    <dialog class="enlarged" {...modal} onClick={leave} aria-label={t.report.still(name)}>
      <img src={url} alt={t.report.viewOf(name)} />
      <button class="tool" aria-label={t.common.close} onClick={leave}>
        <Icon name="cross" />
      </button>
    </dialog>
  );
}
