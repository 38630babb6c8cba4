// From a pattern file to a project: uploaded, read by the service, looked over by a person, made.

import type { Api } from '../api/Api';
import type { Asset, Import, Layer, LayerRole, Project, Unit } from '../api/types';
import { loading, ready, valueOf, type AppState } from '../state/AppState';
import { documentOf, namesPattern, presetNamed, projectNameOf, seamsInReach, type BodyChoice, type ImportDraft } from '../state/importDraft';
import type { LoosePattern } from '../state/intake';
import { sewnTogether, ticked, toWear } from '../state/seamView';
import { stem } from '../state/words';
import { asApiError, notify } from './notices';
import { t } from '../texts/language';
import { told } from '../texts/told';

export type ImportApi = Pick<
  Api,
  'uploadAsset' | 'importPattern' | 'layers' | 'bodies' | 'bodyPresets' | 'createProject' | 'arrange'
>;

export class ImportCommands {
  constructor(
    private readonly state_: AppState,
    private readonly api_: ImportApi,
    /** Shows the project. */
    private readonly made_: (project: Project, drape: boolean) => Promise<void>,
    private readonly save_: (name: string, text: string) => void,
  ) {}

  /** The files were looked at: another pattern begins anew, none ends what was begun. */
  async follow(source: LoosePattern | null): Promise<void> {
    const { importing } = this.state_;
    const now = importing.value;
    if (!source) return void (importing.value = null);
    if (now?.source.file.blob === source.file.blob) {
      const body = newestBody(source) ?? (now.body.kind === 'file' ? kMannequin : now.body);
      importing.value = { ...now, source, body, bodyTaken: now.bodyTaken || source.bodies.length > 0 };
      return;
    }
    importing.value = {
      source,
      asset: '',
      report: loading,
      unit: '',
      size: '',
      layers: {},
      fileLayers: [],
      rereading: false,
      left: new Set(),
      chosen: new Set(),
      body: newestBody(source) ?? kMannequin,
      bodyTaken: source.bodies.length > 0,
      name: projectNameOf(source.file.name),
      bodies: [],
      presets: [],
      error: null,
    };
    void this.loadBodies(source);
    await this.upload(source);
  }

  private change(source: LoosePattern, part: Partial<ImportDraft>): void {
    const { importing } = this.state_;
    if (importing.value?.source.file.blob === source.file.blob) importing.value = { ...importing.value, ...part };
  }

  private async loadBodies(source: LoosePattern): Promise<void> {
    try {
      const [bodies, presets] = await Promise.all([this.api_.bodies(), this.api_.bodyPresets()]);
      this.change(source, { bodies, presets });
      this.suggestBody(source);
    } catch {
      // A mannequin of usual measures is there without them.
    }
  }

  /** Until somebody chooses a body, it is of the size that the file names. */
  private suggestBody(source: LoosePattern): void {
    const draft = this.state_.importing.value;
    const report = draft && valueOf(draft.report);
    if (!draft || !report || draft.bodyTaken || draft.presets.length === 0) return;
    this.change(source, { body: { kind: 'mannequin', preset: presetNamed(report, draft.presets) } });
  }

  private async upload(source: LoosePattern): Promise<void> {
    try {
      const asset = await this.api_.uploadAsset(source.kind, source.file.name, source.file.blob);
      this.change(source, { asset: asset.id });
      await this.read(source);
    } catch (error) {
      this.change(source, { report: { state: 'failed', error: asApiError(error) } });
    }
  }

  private async read(source: LoosePattern): Promise<void> {
    const draft = this.state_.importing.value;
    if (!draft || draft.asset === '') return;
    const { asset, unit, size, layers } = draft;
    // Asked otherwise in the meantime, this answer is none.
    const isWanted = (): boolean => {
      const now = this.state_.importing.value;
      return now?.unit === unit && now.size === size && now.layers === layers;
    };
    this.change(source, { rereading: true, error: null });
    try {
      const report = await this.api_.importPattern(asset, unit, size, layers);
      if (!isWanted()) return;
      this.change(source, {
        report: ready(report),
        rereading: false,
        chosen: toWear(report.seams),
        left: faulty(report),
      });
      this.suggestBody(source);
    } catch (error) {
      const fileLayers = await this.layersOf(draft);
      if (!isWanted()) return;
      this.change(source, { report: { state: 'failed', error: asApiError(error) }, rereading: false, fileLayers });
    }
  }

  /** Where nothing can be made of a file, its layers may be others than usual. */
  private async layersOf({ source, asset, fileLayers }: ImportDraft): Promise<Layer[]> {
    if (source.kind !== 'dxf' || fileLayers.length > 0) return fileLayers;
    try {
      return await this.api_.layers(asset);
    } catch {
      return []; // the reading has said already what is wrong
    }
  }

  /** Empty: by the evidence. */
  takeUnit(unit: Unit | ''): Promise<void> {
    return this.readAgain({ unit });
  }

  takeSize(size: string): Promise<void> {
    return this.readAgain({ size });
  }

  /** Empty: as usual. */
  takeLayer(layer: string, role: LayerRole | ''): Promise<void> {
    const { [layer]: _, ...others } = this.state_.importing.value?.layers ?? {};
    return this.readAgain({ layers: role ? { ...others, [layer]: role } : others });
  }

  takeNoLayers(): Promise<void> {
    return this.readAgain({ layers: {} });
  }

  private async readAgain(part: Partial<ImportDraft>): Promise<void> {
    const source = this.state_.importing.value?.source;
    if (!source) return;
    this.change(source, part);
    await this.read(source);
  }

  takePiece(piece: string, on: boolean): void {
    const draft = this.state_.importing.value;
    if (!draft) return;
    const left = new Set(draft.left);
    if (on) left.delete(piece);
    else left.add(piece);
    this.change(draft.source, { left });
  }

  takeSeam(seam: string, on: boolean): void {
    const draft = this.state_.importing.value;
    const report = draft && valueOf(draft.report);
    if (report) this.change(draft.source, { chosen: ticked(report.seams, draft.chosen, seam, on) });
  }

  /** All of a confidence and above that can be sewn together. */
  takeSurest(least: number): void {
    const draft = this.state_.importing.value;
    const report = draft && valueOf(draft.report);
    if (report) this.change(draft.source, { chosen: sewnTogether(seamsInReach(report, draft.left), least) });
  }

  takeBody(body: BodyChoice): void {
    const draft = this.state_.importing.value;
    if (draft) this.change(draft.source, { body, bodyTaken: true });
  }

  takeName(name: string): void {
    const draft = this.state_.importing.value;
    if (draft) this.change(draft.source, { name });
  }

  saveReport(): void {
    const report = valueOf(this.state_.importing.value?.report ?? loading);
    if (!report) return;
    const { document: _, ...rest } = report;
    this.save_(`${stem(report.file)} import.json`, JSON.stringify(rest, null, 2) + '\n');
  }

  /** Makes the project and stands its pieces around the body. */
  async make(drape: boolean): Promise<void> {
    const { importing, intake } = this.state_;
    const draft = importing.value;
    const report = draft && valueOf(draft.report);
    if (!draft || !report || !intake.value || intake.value.busy) return;
    try {
      const made = await this.created(draft, report);
      if (!made) return;
      // A specification's pieces stand where it says, and those of a DXF nowhere yet.
      const fromDxf = draft.source.kind === 'dxf';
      const project = fromDxf ? await this.arranged(made) : made;
      importing.value = null;
      const stands = project.revision > made.revision || !fromDxf;
      await this.made_(project, drape && stands);
    } catch (error) {
      if (intake.value) intake.value = { ...intake.value, busy: '', error: asApiError(error) };
    }
  }

  /** What is being done, for the dialog. */
  private say(busy: string): void {
    const { intake } = this.state_;
    if (intake.value) intake.value = { ...intake.value, busy, error: null };
  }

  /** The project without places; null where no piece is left to make one of. */
  private async created(draft: ImportDraft, report: Import): Promise<Project | null> {
    const body = await this.bodyFile(draft);
    const document = documentOf(draft, report, body?.name ?? null);
    if (!document) return null;
    this.say(t.messages.makingProject);
    const files: Record<string, string> = {};
    if (namesPattern(document)) files[report.file] = report.asset;
    if (body) files[body.name] = body.id;
    return this.api_.createProject(document, files);
  }

  /** A garment that cannot be arranged yet is a project all the same; its pieces then stand in rows. */
  private async arranged(project: Project): Promise<Project> {
    this.say(t.messages.standing);
    try {
      return await this.api_.arrange(project.id, project.revision);
    } catch (error) {
      const { detail, code, where } = asApiError(error);
      notify(this.state_, { tone: 'info', text: t.messages.inRows(told(code, detail).text), code, where });
      return project;
    }
  }

  private async bodyFile(draft: ImportDraft): Promise<Pick<Asset, 'id' | 'name'> | null> {
    const { body } = draft;
    if (body.kind === 'mannequin') return null;
    if (body.kind === 'asset') return body;
    this.say(t.messages.uploading(body.file.name));
    return this.api_.uploadAsset('body', body.file.name, body.file.blob);
  }
}

const kMannequin: BodyChoice = { kind: 'mannequin', preset: '' };

function newestBody({ bodies }: LoosePattern): BodyChoice | null {
  const file = bodies[bodies.length - 1];
  return file ? { kind: 'file', file } : null;
}

const faulty = (report: Import): ReadonlySet<string> =>
  new Set(report.pieces.filter((piece) => piece.fault).map((piece) => piece.name));
