// The pattern of the project as it is now, as files to take home: printed pages, a sheet for plotters, DXF.

import { useSignal } from '@preact/signals';
import { Icon } from '../controls/Icon';
import type { PatternUrls } from '../api/patternFiles';
import type { Paper } from '../api/types';
import { useAppState } from '../state/context';
import { t } from '../texts/language';

const kPapers: { paper: Paper; title: string }[] = [
  { paper: 'a4', title: 'A4' },
  { paper: 'a3', title: 'A3' },
  { paper: 'a0', title: 'A0' },
  { paper: 'letter', title: 'Letter' },
];

/** Nothing while no project is open. */
export function PatternFiles({ urls }: { urls: PatternUrls }) {
  const project = useAppState().project.value;
  const paper = useSignal<Paper>('a4');
  if (!project) return null;
  return (
    <section class="fabric" aria-label={t.pattern.files.takePattern}>
      <h3>{t.common.takeOut}</h3>
      <label class="select-field">
        <span>{t.pattern.files.paper}</span>
        <select value={paper.value} onChange={(event) => (paper.value = event.currentTarget.value as Paper)}>
          {kPapers.map((one) => (
            <option key={one.paper} value={one.paper}>
              {one.title}
            </option>
          ))}
        </select>
      </label>
      <ul class="downloads pattern-files">
        <FileRow format="PDF" hint={t.pattern.files.pdf} url={urls.patternPdfUrl(project.id, paper.value)} />
        <FileRow format="SVG" hint={t.pattern.files.svg} url={urls.patternSvgUrl(project.id)} />
        <FileRow format="DXF" hint={t.pattern.files.dxf} url={urls.patternDxfUrl(project.id)} />
      </ul>
      <p class="selection-facts">
        {t.pattern.files.words}
      </p>
    </section>
  );
}

/** It is saved under the project's name. */
function FileRow({ format, hint, url }: { format: string; hint: string; url: string }) {
  const name = useAppState().project.value?.name ?? t.pattern.files.name;
  return (
    <li>
      <a href={url} download={`${name}.${format.toLowerCase()}`}>
        <Icon name="down" />
        <span>
          <b>{format}</b>
          <small>{hint}</small>
        </span>
      </a>
    </li>
  );
}
