// What a pattern file holds, before it becomes a project: its pieces with their sizes, unit and size to overrule, seams to
// accept, a body, and what became of every entity.

import { useSignal, type Signal } from '@preact/signals';
import type { ComponentType } from 'preact';
import { useEffect } from 'preact/hooks';
import type { ApiError } from '../api/http';
import { useCommands } from '../commands/context';
import type { Import, Unit } from '../api/types';
import { useAppState } from '../state/context';
import { presetTitle } from '../state/dressing';
import { seamsInReach, sureness, type BodyChoice, type ImportDraft, type PreviewProps } from '../state/importDraft';
import { percent } from '../state/words';
import { patternFigure, patternLength } from '../texts/units';
import { ImportLayers } from './ImportLayers';
import { ImportReport } from './ImportReport';
import { ImportSeams } from './ImportSeams';
import { t } from '../texts/language';
import { Said, Told } from '../texts/Message';

type Page = 'pieces' | 'layers' | 'seams' | 'report';

/** Draws the file's pieces; who puts the page together says with what. */
export interface PreviewSlot {
  Preview: ComponentType<PreviewProps>;
}

export function ImportPanel({ draft, Preview }: { draft: ImportDraft } & PreviewSlot) {
  const { report } = draft;
  const page = useSignal<Page>('pieces');
  if (report.state === 'loading') {
    return (
      <div class="import-wait" role="status">
        <span class="spinner" aria-hidden="true" />
        <p>
          {t.imports.reading} <b>{draft.source.file.name}</b>
          {t.imports.readingWhat}
        </p>
      </div>
    );
  }
  if (report.state === 'failed') return <Unread draft={draft} error={report.error} page={page} />;
  return <Read draft={draft} report={report.value} page={page} Preview={Preview} />;
}

/** Which page of what was read is shown; it stays while the file is read again. */
interface PageSlot {
  page: Signal<Page>;
}

/** Why nothing could be made of the file, with its layers, since those may be others than usual. */
function Unread({ draft, error, page }: { draft: ImportDraft; error: ApiError } & PageSlot) {
  const { detail, code, where } = error;
  const hasLayers = draft.fileLayers.length > 1;
  useEffect(() => {
    if (hasLayers) page.value = 'layers'; // who has said what one layer is goes on with the next
  }, [hasLayers, page]);
  return (
    <div class="import-unread">
      <div class="problem" role="alert">
        <div>
          <p>
            <Told code={code} detail={detail} />
          </p>
          <p class="code">{[code, where].filter(Boolean).join(' · ')}</p>
          {hasLayers && <p>{t.imports.layers.wayOut}</p>}
          {(draft.unit || draft.size) && <Again />}
        </div>
      </div>
      {hasLayers && <ImportLayers draft={draft} layers={draft.fileLayers} />}
    </div>
  );
}

function Again() {
  const { imports } = useCommands();
  return (
    <button class="link" onClick={() => void imports.takeUnit('').then(() => imports.takeSize(''))}>
      {t.imports.asFileSays}
    </button>
  );
}

interface Tab {
  page: Page;
  title: string;
}

function Tabs({ pages, page }: { pages: readonly Tab[] } & PageSlot) {
  const turn = (event: KeyboardEvent): void => {
    if (event.key !== 'ArrowLeft' && event.key !== 'ArrowRight') return;
    const step = event.key === 'ArrowRight' ? 1 : pages.length - 1;
    page.value = pages[(pages.findIndex((one) => one.page === page.value) + step) % pages.length]!.page;
    document.getElementById(`import-${page.value}`)?.focus();
  };
  return (
    <div class="tabs" role="tablist" aria-label={t.imports.holds} onKeyDown={turn}>
      {pages.map((one) => (
        <button
          key={one.page}
          role="tab"
          id={`import-${one.page}`}
          aria-selected={page.value === one.page}
          tabIndex={page.value === one.page ? 0 : -1}
          onClick={() => (page.value = one.page)}
        >
          {one.title}
        </button>
      ))}
    </div>
  );
}

function Read({ draft, report, page, Preview }: { draft: ImportDraft; report: Import } & PageSlot & PreviewSlot) {
  const lit = useSignal<string | null>(null);
  const piece = useSignal<string | null>(null);
  const seams = seamsInReach(report, draft.left);
  const chosen = seams.filter((seam) => draft.chosen.has(seam.id)).length;
  const pages: Tab[] = [
    { page: 'pieces', title: t.imports.pieceTab(report.pieces.length - draft.left.size) },
    ...(report.layers.length > 0
      ? [{ page: 'layers' as const, title: t.imports.layers.tab(report.layers.length) }]
      : []),
    { page: 'seams', title: t.imports.seamTab(chosen, seams.length) },
    {
      page: 'report',
      title:
        report.report.warnings.length > 0 ? t.imports.reportWarnings(report.report.warnings.length) : t.imports.reportTab,
    },
  ];
  return (
    <div class={`import${draft.rereading ? ' rereading' : ''}`} aria-busy={draft.rereading}>
      <Preview
        draft={draft}
        report={report}
        lit={lit.value}
        onLight={(seam) => (lit.value = seam)}
        piece={piece.value}
        onPiece={(name) => (piece.value = name)}
      />
      <div class="import-side">
        <Tabs pages={pages} page={page} />
        <div class="import-page" role="tabpanel" aria-labelledby={`import-${page.value}`} tabIndex={0}>
          {page.value === 'pieces' && (
            <>
              <UnitAndSize draft={draft} report={report} />
              <PieceRows draft={draft} report={report} lit={piece} />
            </>
          )}
          {page.value === 'layers' && <ImportLayers draft={draft} layers={report.layers} />}
          {page.value === 'seams' && (
            <ImportSeams
              draft={draft}
              report={report}
              onLight={(seam) => (lit.value = seam)}
              onPiece={(name) => (piece.value = name)}
            />
          )}
          {page.value === 'report' && <ImportReport report={report} />}
        </div>
        <NameAndBody draft={draft} />
      </div>
    </div>
  );
}

const kUnits: { unit: Unit; title: string }[] = [
  { unit: 'mm', title: 'mm' },
  { unit: 'cm', title: 'cm' },
  { unit: 'inch', title: 'inch' },
];

function UnitAndSize({ draft, report }: { draft: ImportDraft; report: Import }) {
  const { imports } = useCommands();
  const { unit } = report;
  const fixed = draft.source.kind === 'specification';
  return (
    <section class="import-unit" aria-label={t.imports.unitAndSize}>
      <div class="unit-row">
        <h3>{t.common.unit}</h3>
        <div class="choice" role="radiogroup" aria-label={t.common.unit}>
          {kUnits.map((one) => (
            <button
              key={one.unit}
              role="radio"
              aria-checked={unit.name === one.unit}
              disabled={fixed}
              onClick={() => void imports.takeUnit(one.unit)}
            >
              {one.title}
            </button>
          ))}
        </div>
        <span class={`sure${unit.confidence < 0.6 ? ' warn' : ''}`}>
          {draft.unit ? t.imports.asYouSay : `${sureness(unit.confidence)}, ${percent(unit.confidence, 0)}`}
        </span>
        {draft.unit && (
          <button class="link" onClick={() => void imports.takeUnit('')}>
            {t.imports.backToGuess}
          </button>
        )}
      </div>
      {unit.doubt && <UnitDoubt {...unit.doubt} />}
      <ul class="evidence">
        {unit.evidence.map((text, i) => (
          <li key={i}>
            <Said text={text} />
          </li>
        ))}
      </ul>
      {report.sizes.length > 1 && (
        <label class="select-field">
          <span>{t.common.size}</span>
          <select value={report.size} onChange={(event) => void imports.takeSize(event.currentTarget.value)}>
            {report.sizes.map((size) => (
              <option key={size} value={size}>
                {size}
                {size === report.sample_size ? ` ${t.imports.sampleSize}` : ''}
              </option>
            ))}
          </select>
        </label>
      )}
    </section>
  );
}

/** A unit that was asked for makes pieces that nobody wears. */
function UnitDoubt({ own, largest_mm, largest_own_mm }: NonNullable<Import['unit']['doubt']>) {
  const { imports } = useCommands();
  const told = kUnits.find((one) => one.title === own);
  return (
    <div class="problem unit-doubt" role="alert">
      <p>{t.imports.unitDoubt(patternLength(largest_mm, 0), own, patternLength(largest_own_mm, 0))}</p>
      {told && (
        <button class="plain" onClick={() => void imports.takeUnit(told.unit)}>
          {t.imports.takeUnit(own)}
        </button>
      )}
    </div>
  );
}

function PieceRows({ draft, report, lit }: { draft: ImportDraft; report: Import; lit: Signal<string | null> }) {
  const { imports } = useCommands();
  return (
    <ul class="import-pieces" aria-label={t.common.pieces}>
      {report.pieces.map((piece, i) => (
        <li
          key={`${piece.name} ${i}`}
          class={`${piece.fault ? 'faulty' : ''}${lit.value === piece.name ? ' lit' : ''}`}
          onPointerEnter={() => (lit.value = piece.name)}
          onPointerLeave={() => (lit.value = null)}
          onFocusIn={() => (lit.value = piece.name)}
          onFocusOut={() => (lit.value = null)}
        >
          <label>
            <input
              type="checkbox"
              checked={!draft.left.has(piece.name)}
              disabled={piece.fault !== undefined}
              onChange={(event) => imports.takePiece(piece.name, event.currentTarget.checked)}
            />
            <b>{piece.name}</b>
            {piece.width_mm !== undefined && piece.height_mm !== undefined && (
              <span>
                {patternFigure(piece.width_mm, 0)} × {patternLength(piece.height_mm, 0)}
              </span>
            )}
            <small>{remarks(piece).join(' · ')}</small>
          </label>
          {piece.fault && (
            <p class="hint bad">
              <Told code={piece.fault.code} detail={piece.fault.message} /> <span class="code">{piece.fault.code}</span>
            </p>
          )}
        </li>
      ))}
    </ul>
  );
}

function remarks(piece: Import['pieces'][number]): string[] {
  const said: string[] = [];
  if (piece.quantity > 1) said.push(`${piece.quantity} ×${piece.mirrored > 0 ? t.imports.mirrored(piece.mirrored) : ''}`);
  if (piece.unfolded) said.push(t.imports.unfolded);
  if (piece.outline === 'cut') said.push(t.imports.cutLine);
  if (piece.edges) said.push(t.imports.edgeCount(piece.edges));
  if (piece.notches) said.push(t.imports.notchCount(piece.notches));
  if (piece.material) said.push(piece.material);
  return said;
}

const bodyKey = (body: BodyChoice): string =>
  body.kind === 'mannequin' ? `mannequin ${body.preset}` : body.kind === 'asset' ? `asset ${body.id}` : 'file';

function NameAndBody({ draft }: { draft: ImportDraft }) {
  const { imports } = useCommands();
  const state = useAppState();
  const files = draft.source.bodies;
  const take = (key: string): void => {
    const [kind, id = ''] = key.split(' ');
    if (kind === 'mannequin') imports.takeBody({ kind: 'mannequin', preset: id });
    const asset = draft.bodies.find((one) => one.id === id);
    if (kind === 'asset' && asset) imports.takeBody({ kind: 'asset', id, name: asset.name });
    const file = files[files.length - 1];
    if (kind === 'file' && file) imports.takeBody({ kind: 'file', file });
  };
  const busy = state.intake.value?.busy !== '';
  const isSuggested = !draft.bodyTaken;
  return (
    <div class="import-make">
      <label class="text-field">
        <span>{t.common.name}</span>
        <input
          value={draft.name}
          maxLength={200}
          disabled={busy}
          onInput={(event) => imports.takeName(event.currentTarget.value)}
        />
      </label>
      <label class="select-field">
        <span>{t.common.body}</span>
        <select value={bodyKey(draft.body)} disabled={busy} onChange={(event) => take(event.currentTarget.value)}>
          <option value="mannequin ">{t.imports.noSize}</option>
          {draft.presets.map((preset) => (
            <option key={preset.id} value={`mannequin ${preset.id}`}>
              {t.imports.mannequin(presetTitle(preset.id))}
              {isSuggested && bodyKey(draft.body) === `mannequin ${preset.id}` ? t.imports.asFile : ''}
            </option>
          ))}
          {files.length > 0 && <option value="file">{t.imports.dropped(files[files.length - 1]!.name)}</option>}
          {draft.bodies.map((body) => (
            <option key={body.id} value={`asset ${body.id}`}>
              {body.name}
            </option>
          ))}
        </select>
      </label>
    </div>
  );
}
