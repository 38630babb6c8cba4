// Files become a project: gathered in the dialog, or dropped, or of a sample; shown, and draped when asked to.

import type { Api } from '../api/Api';
import { fetchSample, type Sample } from '../api/samples';
import type { Project } from '../api/types';
import { loading, ready, valueOf, type AppState } from '../state/AppState';
import { isPicture, planIntake, type GivenFile, type IntakePlan } from '../state/intake';
import type { DressingCommands } from './DressingCommands';
import { ImportCommands, type ImportApi } from './ImportCommands';
import { asApiError, notify, notifyError } from './notices';
import type { TextureCommands } from './TextureCommands';
import { t } from '../texts/language';

/** What else is done with what comes. */
export interface IntakeWays {
  dressing: DressingCommands;
  textures: TextureCommands;
  open(project: Project): void;
  drape(): Promise<void>;
  save(name: string, text: string): void;
  refresh(): void;
}

export class IntakeCommands {
  /** Of a pattern that comes without a document. */
  readonly imports: ImportCommands;

  constructor(
    private readonly state_: AppState,
    private readonly api_: ImportApi & Pick<Api, 'createProject' | 'uploadAsset'>,
    private readonly ways_: IntakeWays,
  ) {
    this.imports = new ImportCommands(state_, api_, (project, drape) => this.made(project, drape), ways_.save);
  }

  /** Adds files to the dialog, which opens with the first ones. */
  async addFiles(files: GivenFile[]): Promise<void> {
    if (files.length === 0) return;
    const { intake } = this.state_;
    if (await this.tookPicture(files)) return;
    const replaced = (old: GivenFile): boolean =>
      files.some((file) => file.name.toLowerCase() === old.name.toLowerCase());
    const all = [...(intake.value?.files ?? []).filter((old) => !replaced(old)), ...files];
    intake.value = { files: all, plan: intake.value?.plan ?? null, busy: t.messages.reading, error: null };
    const plan = await this.planOf(all);
    if (intake.value?.files !== all) return;
    intake.value = { files: all, plan, busy: '', error: null };
    await this.imports.follow(plan.loose);
  }

  /** A picture that comes alone while pieces are shown lies on the selected one, or on all. */
  private async tookPicture(files: readonly GivenFile[]): Promise<boolean> {
    const { intake, pieces, selected } = this.state_;
    const [picture] = files;
    const shown = valueOf(pieces.value ?? loading)?.pieces ?? [];
    if (!picture || files.length > 1 || !isPicture(picture.name) || intake.value || shown.length === 0) return false;
    const chosen = shown.filter((piece) => piece.id === selected.value);
    const ids = (chosen.length > 0 ? chosen : shown).map((piece) => piece.id);
    await this.ways_.textures.upload(ids, picture.name, picture.blob);
    return true;
  }

  private async planOf(files: readonly GivenFile[]): Promise<IntakePlan> {
    await this.ways_.dressing.loadTables();
    return planIntake(files, this.state_.dressing.meshEndings.value);
  }

  open(): void {
    void this.ways_.dressing.loadTables();
    this.state_.intake.value ??= { files: [], plan: null, busy: '', error: null };
  }

  close(): void {
    this.state_.importing.value = null;
    this.state_.intake.value = null;
  }

  async removeFile(name: string): Promise<void> {
    const { intake } = this.state_;
    const files = (intake.value?.files ?? []).filter((file) => file.name !== name);
    const plan = files.length > 0 ? await this.planOf(files) : null;
    intake.value = { files, plan, busy: '', error: null };
    await this.imports.follow(plan?.loose ?? null);
  }

  /** Uploads the files, makes the project, shows it, and drapes it when asked to. */
  async createProject(thenDrape: boolean): Promise<void> {
    const { intake } = this.state_;
    const now = intake.value;
    if (!now?.plan?.ready || now.busy) return;
    const say = (busy: string): void => void (intake.value = { ...now, busy, error: null });
    try {
      await this.made(await this.upload(now.plan, say), thenDrape);
    } catch (error) {
      intake.value = { ...now, busy: '', error: asApiError(error) };
    }
    this.ways_.refresh();
  }

  /** A new project: shown, and draped when asked to. */
  private async made(project: Project, thenDrape: boolean): Promise<void> {
    const { projects, intake } = this.state_;
    projects.value = ready([project, ...(valueOf(projects.value) ?? [])]);
    intake.value = null;
    this.ways_.open(project);
    if (thenDrape) await this.ways_.drape();
    else notify(this.state_, { tone: 'good', text: t.messages.projectThere(project.name) });
    this.ways_.refresh();
  }

  private async upload(plan: IntakePlan, say: (busy: string) => void): Promise<Project> {
    const files: Record<string, string> = {};
    for (const { name, kind, file } of plan.needed) {
      say(t.messages.uploading(name));
      const asset = await this.api_.uploadAsset(kind, file!.name, file!.blob);
      files[name] = asset.id;
    }
    say(t.messages.makingProject);
    return this.api_.createProject(plan.document, files);
  }

  /** Makes a project of a sample and drapes it. */
  async startSample(sample: Sample): Promise<void> {
    const { sampling } = this.state_;
    if (sampling.value !== '') return;
    sampling.value = sample.id;
    try {
      const plan = await this.planOf(await fetchSample(sample));
      await this.made(await this.upload(plan, () => undefined), true);
    } catch (error) {
      notifyError(this.state_, error);
    } finally {
      sampling.value = '';
    }
  }
}
