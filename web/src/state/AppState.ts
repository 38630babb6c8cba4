// Everything the page knows, as signals. Commands write it, views read it; nothing here talks to the service.

import { computed, signal, type ReadonlySignal, type Signal } from '@preact/signals';
import type { ApiError } from '../api/http';
import type { BodyMesh } from '../api/body';
import type { StreamConnection } from '../api/JobStream';
import type { MapFile } from '../api/maps';
import type { Picture } from '../api/pictures';
import type { EditStep, Fabric, Job, Pieces, Progress, Project, Report, SeenPieces, Session } from '../api/types';
import type { ClothMap, MapKind } from './clothMaps';
import { missingMaps, type MissingMaps } from './keptMaps';
import type { AdminView } from './admin';
import { ComparisonState } from './comparison';
import { DressingState, type Marks } from './dressing';
import { EditingState, keepsTheShape } from './editing';
import { finishesOf, type Finish } from './fabrics';
import { HandsState } from './hands';
import type { ImportDraft } from './importDraft';
import type { IntakePlan } from './intake';
import { hasBegun, isActive, jobAtHome, newestJobOf, withProgress } from './jobs';
import { LiveCloth } from './LiveCloth';
import type { Route } from './routes';
import { SectionState } from './SectionState';
import { stepText, withSewn, type Known } from './steps';
import { SweepState } from './sweeps';
import type { Sewn } from './seamNames';
import { seamParts, type SeamPart } from './seamView';
import { isOfPrints, looksOf, type Look } from './texture';
import { standsAs, VersionState } from './versions';

/** Something that is fetched. */
export type Loaded<T> = { state: 'loading' } | { state: 'ready'; value: T } | { state: 'failed'; error: ApiError };

export const loading = { state: 'loading' } as const;
export const ready = <T>(value: T): Loaded<T> => ({ state: 'ready', value });
export const valueOf = <T>(loaded: Loaded<T>): T | null => (loaded.state === 'ready' ? loaded.value : null);

/** Whether the service answers. */
export type Link = { state: 'ok' } | { state: 'lost'; since: number; attempt: number; retryAt: number };

/** A line at the edge of the page that goes away by itself, or after a click. */
export interface Notice {
  id: number;
  tone: 'info' | 'good' | 'bad';
  text: string;
  code?: string;
  where?: string;
}

/** A figure over the course of a drape. */
export interface Sample {
  t: number;
  speed: number;
}

/** The dialog in which files become a project. */
export interface Intake {
  files: { name: string; blob: Blob }[];
  plan: IntakePlan | null;
  busy: string;
  error: ApiError | null;
}

export type View = 'front' | 'back' | 'side' | 'three-quarter';
export type Tab = 'pattern' | 'body' | 'arrange' | 'drape' | 'result';

/** Where somebody looks from; metres, degrees from top to bottom, width over height. */
export interface Viewpoint {
  eye: [number, number, number];
  target: [number, number, number];
  angle: number;
  aspect: number;
}

export class AppState {
  readonly route: Signal<Route> = signal({ name: 'home' });
  readonly projects: Signal<Loaded<Project[]>> = signal(loading);
  readonly jobs: Signal<Loaded<Job[]>> = signal(loading);
  readonly link: Signal<Link> = signal({ state: 'ok' });
  /** The service lets in only who is known, and nobody is. */
  readonly shut: Signal<boolean> = signal(false);
  readonly session: Signal<Session | null> = signal(null);

  // Of the job that is shown.
  readonly watched: Signal<string | null> = signal(null);
  readonly stream: Signal<StreamConnection> = signal({ state: 'closed' });
  readonly progress: Signal<Progress | null> = signal(null);
  readonly history: Signal<Sample[]> = signal([]);
  readonly body: Signal<Loaded<BodyMesh> | null> = signal(null);
  readonly report: Signal<Loaded<Report> | null> = signal(null);
  /** Its pieces as it drapes them: the project's may be of other fabrics by now. */
  readonly seenPieces: Signal<Loaded<SeenPieces> | null> = signal(null);
  readonly cloth = new LiveCloth();
  /** Whether there is cloth to show. */
  readonly covered: Signal<boolean> = signal(false);

  // Of the project that is shown.
  readonly pieces: Signal<Loaded<Pieces> | null> = signal(null);
  /** Of the pieces, by the id of their file, as they come. */
  readonly pictures: Signal<ReadonlyMap<string, Picture>> = signal(new Map());
  readonly selected: Signal<string | null> = signal(null);
  readonly hovered: Signal<string | null> = signal(null);
  readonly editing = new EditingState();
  readonly dressing = new DressingState();
  readonly hands = new HandsState();
  readonly section = new SectionState();
  /** Of the two drapes that stand side by side. */
  readonly comparison = new ComparisonState();
  readonly sweeps = new SweepState();
  readonly versions = new VersionState();
  /** Of the service, while the address shows it. */
  readonly admin: Signal<Loaded<AdminView>> = signal(loading);

  readonly notices: Signal<Notice[]> = signal([]);
  readonly intake: Signal<Intake | null> = signal(null);
  readonly importing: Signal<ImportDraft | null> = signal(null);
  readonly submitting: Signal<boolean> = signal(false);
  /** The sample that a project is being made of, by its id; empty: none. */
  readonly sampling: Signal<string> = signal('');
  readonly helpShown: Signal<boolean> = signal(false);
  /** Where the tour has come; null: there is none. */
  readonly tourStop: Signal<number | null> = signal(null);
  /** The dialog in which links to the shown drape are made. */
  readonly sharing: Signal<boolean> = signal(false);
  readonly railShown: Signal<boolean> = signal((globalThis.innerWidth ?? 1440) > 860);
  readonly tab: Signal<Tab> = signal('pattern');
  /** Written by a command, read by the 3D view; `turn` rises so that the same view can be asked for again. */
  readonly view: Signal<{ view: View; turn: number }> = signal({ view: 'three-quarter', turn: 0 });
  /** Tells from where the 3D view is seen now; null while there is none. */
  readonly lookingFrom: Signal<(() => Viewpoint) | null> = signal(null);
  readonly bodyShown: Signal<boolean> = signal(true);
  readonly meshShown: Signal<boolean> = signal(false);
  /** What the cloth is coloured by; null: as it looks. */
  readonly mapKind: Signal<MapKind | null> = signal(null);
  /** What ended drapes have left of maps, by their ids, as it is wanted. */
  readonly mapFiles: Signal<ReadonlyMap<string, MapFile>> = signal(new Map());
  /** Which maps of the drape that is shown are not to be had. */
  readonly missingMaps: ReadonlySignal<MissingMaps> = computed(() => {
    const body = valueOf(this.body.value ?? loading);
    return missingMaps(this.job.value, body !== null && body.indices.length === 0);
  });
  /** Of the newest moment that was measured. */
  readonly clothMap: Signal<ClothMap | null> = signal(null);
  /** The map's value under the pointer; NaN: none. */
  readonly pointedValue: Signal<number> = signal(NaN);
  readonly now: Signal<number> = signal(Date.now());

  readonly allJobs: ReadonlySignal<Job[]> = computed(() => valueOf(this.jobs.value) ?? []);

  readonly atHome: ReadonlySignal<boolean> = computed(() => this.route.value.name === 'home');

  /** A project is open, with or without a drape. */
  readonly atWork: ReadonlySignal<boolean> = computed(
    () => ['project', 'job'].includes(this.route.value.name) && this.project.value !== null,
  );

  /** The job on the page: the route's, the newest of the route's project, or the one to be seen at the first page. */
  readonly job: ReadonlySignal<Job | null> = computed(() => {
    const route = this.route.value;
    const found =
      route.name === 'job'
        ? (this.allJobs.value.find((job) => job.id === route.id) ?? null)
        : route.name === 'project'
          ? newestJobOf(this.allJobs.value, route.id)
          : route.name === 'home'
            ? jobAtHome(this.allJobs.value)
            : null;
    return found && withProgress(found, this.watched.value === found.id ? this.progress.value : null);
  });

  readonly projectId: ReadonlySignal<string | null> = computed(() => {
    const route = this.route.value;
    return route.name === 'project' ? route.id : (this.job.value?.project_id || null);
  });

  readonly project: ReadonlySignal<Project | null> = computed(
    () => valueOf(this.projects.value)?.find((project) => project.id === this.projectId.value) ?? null,
  );

  /** What there is of the pattern. */
  readonly sewn: ReadonlySignal<Sewn> = computed(() => valueOf(this.pieces.value ?? loading) ?? { pieces: [], seams: [] });

  /** Pictures on pieces, by the piece's id. */
  readonly looks: ReadonlySignal<ReadonlyMap<string, Look>> = computed(() =>
    looksOf(this.sewn.value.pieces, this.project.value, this.pictures.value),
  );


  /** Whether the 3D view shows what a drape would begin with, not what it came to. */
  readonly beforeDrape: ReadonlySignal<boolean> = computed(() => {
    if (this.projectId.value === null || this.atHome.value) return false;
    const job = this.job.value;
    if (job === null || ['body', 'arrange'].includes(this.tab.value)) return true;
    // What failed or was cancelled early has no cloth to show: its pieces stand where it began.
    return (job.state === 'failed' || job.state === 'cancelled') && !this.covered.value && !job.results?.['final.obj'];
  });

  /** Of the drape that is shown; null before one, and until it is known. */
  private readonly draped_: ReadonlySignal<SeenPieces | null> = computed(() =>
    this.beforeDrape.value ? null : valueOf(this.seenPieces.value ?? loading),
  );

  /** Since the newest drape nothing but pictures on pieces was changed. */
  private readonly onlyPrinted_: ReadonlySignal<boolean> = computed(() => {
    const { job, project, allJobs, editing } = this;
    if (!job.value || newestJobOf(allJobs.value, job.value.project_id)?.id !== job.value.id) return false;
    const created = job.value.created_ms;
    const steps = editing.history.value.filter((step) => step.created_ms > created && !step.undone);
    return steps.length > 0 && project.value !== null && steps.every(({ edits }) => edits.every(isOfPrints));
  });

  /** Pictures on the cloth of the 3D view: those of its drape. What is laid on the newest one is seen on it at once. */
  readonly clothLooks: ReadonlySignal<ReadonlyMap<string, Look>> = computed(() => {
    const draped = this.draped_.value;
    if (!draped || this.onlyPrinted_.value) return this.looks.value;
    return looksOf(draped.pieces, this.project.value, this.pictures.value);
  });

  /** How light plays on that cloth. */
  readonly finishes: ReadonlySignal<ReadonlyMap<string, Finish>> = computed(() => {
    const draped = this.draped_.value;
    const fabrics: readonly Fabric[] = draped?.fabrics ?? this.editing.fabrics.value;
    return finishesOf((draped ?? this.sewn.value).pieces, fabrics);
  });

  /** The newest word of the cloth that is shown comes from its drape, and the way there is open. */
  private readonly live_: ReadonlySignal<boolean> = computed(() => {
    const job = this.job.value;
    if (!job || this.atHome.value || this.beforeDrape.value || !this.covered.value) return false;
    return hasBegun(job) && this.stream.value.state === 'open';
  });

  /** Whether hands reach that cloth. */
  readonly touchable: ReadonlySignal<boolean> = computed(
    () => this.live_.value && this.job.value?.progress?.phase !== 'stills',
  );

  /** Whether there is a drape's cloth to cut through. */
  readonly cuttable: ReadonlySignal<boolean> = computed(
    () => this.covered.value && !this.beforeDrape.value && this.atWork.value,
  );

  /** The project was edited since the shown drape, which is still under way, was begun. */
  readonly outdated: ReadonlySignal<boolean> = computed(() => {
    const job = this.job.value;
    const project = this.project.value;
    return job !== null && project !== null && isActive(job.state) && project.revision > job.project_revision;
  });

  /** And its cloth, which hangs, may go on hanging after all that was edited. */
  readonly goesOnWarm: ReadonlySignal<boolean> = computed(() => {
    const job = this.job.value;
    const hangs = ['drape', 'stills'].includes(job?.progress?.phase ?? '');
    if (!job || !this.outdated.value || !this.live_.value || !hangs) return false;
    const steps = this.editing.history.value.filter((step) => step.created_ms > job.created_ms);
    return steps.length > 0 && steps.every(({ edits }) => edits.every(keepsTheShape));
  });

  private readonly stepsSince_: ReadonlySignal<readonly EditStep[] | null> = computed(() => {
    const job = this.job.value;
    const project = this.project.value;
    if (!job || !project || isActive(job.state) || project.revision <= job.project_revision) return null;
    if (standsAs(this.versions, project.revision, job.id)) return null;
    const isNewer = (step: EditStep): boolean => step.created_ms > job.created_ms;
    const [newer, before] = [true, false].map((is) => this.editing.history.value.filter((step) => isNewer(step) === is));
    const steps = newer!.filter((step) => !step.undone);
    // All that was done has been undone, and no more than that: it is as it was draped.
    if (newer!.length > 0 && steps.length === 0 && !before!.some((step) => step.undone)) return null;
    return steps;
  });

  /** What the steps of the history are about. */
  readonly known: ReadonlySignal<Known> = computed(() => {
    const { fabrics, history, seamsSeen } = this.editing;
    return withSewn({ pieces: this.sewn.value.pieces, seams: seamsSeen.value, fabrics: fabrics.value }, history.value);
  });

  /** What was done to the project after its drape had begun, newest first; null while the drape is as new as the project. */
  readonly since: ReadonlySignal<readonly string[] | null> = computed(
    () => this.stepsSince_.value?.map((step) => stepText(step.edits, this.known.value)) ?? null,
  );

  /** The job from whose end the next drape goes on; null where it begins from the pieces. */
  readonly goesOnFrom: ReadonlySignal<string | null> = computed(() => {
    const job = this.job.value;
    const steps = this.stepsSince_.value;
    const report = valueOf(this.report.value ?? loading);
    if (!job?.results['final.hung'] || job.reason_code !== 'settled' || !steps?.length || !report) return null;
    const hangs = report.worn === undefined || report.worn === 'yes';
    return hangs && steps.every(({ edits }) => edits.every(keepsTheShape)) ? job.id : null;
  });

  /** The seam that is lit, one that is proposed too, as its parts lie on the pieces. */
  readonly litParts: ReadonlySignal<readonly SeamPart[]> = computed(() => {
    const id = this.editing.litSeam.value ?? this.editing.seam.value;
    const pattern = valueOf(this.pieces.value ?? loading);
    const seam = this.editing.litProposal.value ?? (id === null ? undefined : pattern?.seams.find((one) => one.id === id));
    return pattern && seam ? seamParts(pattern.pieces, seam) : [];
  });

  readonly shownBody: ReadonlySignal<BodyMesh | null> = computed(() =>
    this.beforeDrape.value ? this.dressing.mesh.value : valueOf(this.body.value ?? loading),
  );

  /** Tape and landmarks belong to the body's panel, boxes to both. */
  readonly shownMarks: ReadonlySignal<Marks> = computed(() => {
    const { tape, landmarks, boxes } = this.dressing.marks.value;
    const body = this.tab.value === 'body';
    return { tape: body && tape, landmarks: body && landmarks, boxes: boxes && (body || this.tab.value === 'arrange') };
  });

  readonly anyActive: ReadonlySignal<boolean> = computed(() => this.allJobs.value.some((job) => isActive(job.state)));

  constructor() {
    this.cloth.listen(() => (this.covered.value = this.cloth.positions !== null));
  }

  /** Shows the section, and the panel that it stands in; or puts it away. */
  turnToSection(): void {
    const { shown } = this.section;
    shown.value = !shown.value;
    if (!shown.value || ['drape', 'result'].includes(this.tab.value)) return;
    this.tab.value = this.job.value && isActive(this.job.value.state) ? 'drape' : 'result';
  }

  /** Shows the pieces, and keeps the seams for when they are gone. */
  putPieces(loaded: Pieces): void {
    const { seamsSeen } = this.editing;
    this.pieces.value = ready(loaded);
    seamsSeen.value = new Map([...seamsSeen.value, ...loaded.seams.map((seam) => [seam.id, seam] as const)]);
  }

  /** Puts one job's newest row into the list. */
  putJob(job: Job): void {
    const rest = this.allJobs.value.filter((other) => other.id !== job.id);
    const before = this.allJobs.value.find((other) => other.id === job.id);
    const jobs = [...rest, { ...before, ...job }].sort((a, b) => b.created_ms - a.created_ms || (a.id < b.id ? 1 : -1));
    this.jobs.value = ready(jobs);
  }
}
