import { describe, expect, it } from 'vitest';
import type { Api } from '../src/api/Api';
import type { Edit, EditStep, Texture } from '../src/api/types';
import { Commands } from '../src/commands/Commands';
import { EditQueue } from '../src/commands/EditQueue';
import { TextureCommands } from '../src/commands/TextureCommands';
import { byMaterial } from '../src/scene/surface';
import { AppState, ready } from '../src/state/AppState';
import { filesNamedBy, planIntake } from '../src/state/intake';
import {
  commonTexture,
  fillRepeats,
  looksOf,
  nameInProject,
  patternTransform,
  pictureFrame,
  repeatsAt,
  textureEdits,
} from '../src/state/texture';
import { fakeApi, jobOf, projectOf, seenOf, squareOf } from './fakes';

const kChecks: Texture = { image: 'checks.png', scale_mm: 40, offset: [0, 0], angle: 0 };
const picture = { url: 'assets/a_1', width: 200, height: 100, image: null as unknown as CanvasImageSource };
const near = (a: readonly number[], b: readonly number[]): void =>
  a.forEach((value, i) => expect(value).toBeCloseTo(b[i]!, 9));

describe('a picture on a flat piece', () => {
  it('repeats every width across and every height up', () => {
    const frame = pictureFrame([0, 1], { ...kChecks, offset: [10, 20] }, 2);
    near(repeatsAt(frame, [10, 20]), [0, 0]);
    near(repeatsAt(frame, [50, 20]), [1, 0]);
    near(repeatsAt(frame, [10, 40]), [0, 1]);
  });

  it('turns with the grain and by its angle, counter-clockwise', () => {
    near(repeatsAt(pictureFrame([1, 0], kChecks, 1), [40, 0]), [0, 1]);
    near(repeatsAt(pictureFrame([0, 1], { ...kChecks, angle: 90 }, 1), [-40, 0]), [0, 1]);
    near(repeatsAt(pictureFrame(null, kChecks, 1), [0, 40]), [0, 1]);
  });

  it('gives texture coordinates to its own vertices alone', () => {
    const out = new Float32Array(6).fill(7);
    fillRepeats(pictureFrame([0, 1], kChecks, 1), new Float32Array([9, 9, 0.04, 0.08, 9, 9]), 1, 1, out);
    near([...out], [7, 7, 1, 2, 7, 7].map(Math.fround));
  });

  it('lies in the drawing as on the cloth, where y counts down', () => {
    expect(patternTransform([0, 1], kChecks)).toBe('translate(0 0) rotate(0)');
    expect(patternTransform([0, 1], { ...kChecks, offset: [3, 4], angle: 30 })).toBe('translate(3 -4) rotate(-30)');
    expect(patternTransform([1, 0], kChecks)).toBe('translate(0 0) rotate(90)');
  });

  it('shows once its file is loaded', () => {
    const pieces = [{ ...squareOf('a', 0, 0, 100), texture: kChecks }, squareOf('b', 0, 0, 100)];
    const project = projectOf({ files: { 'checks.png': 'a_1' } });
    expect(looksOf(pieces, project, new Map()).size).toBe(0);
    const looks = looksOf(pieces, project, new Map([['a_1', picture]]));
    expect([...looks.keys()]).toEqual(['a']);
    near(repeatsAt(looks.get('a')!.frame, [0, 20]), [0, 1]); // twice as wide as high
  });
});

describe('the names of pictures', () => {
  it('are those that the project has, or free ones', () => {
    expect(nameInProject({}, 'a.png', 'a_1')).toBe('a.png');
    expect(nameInProject({ 'cloth/x.png': 'a_1' }, 'a.png', 'a_1')).toBe('cloth/x.png');
    expect(nameInProject({ 'a.png': 'a_2', 'a-2.png': 'a_3' }, 'a.png', 'a_1')).toBe('a-3.png');
  });

  it('are found in a document beside those of patterns and bodies', async () => {
    const document = { toile: 1, pieces: [{ from: { dxf: 'a.dxf' }, texture: { image: 'cloth/a.PNG' } }], bodies: [] };
    expect(filesNamedBy(document)).toEqual([
      { name: 'a.dxf', kind: 'dxf' },
      { name: 'cloth/a.PNG', kind: 'image' },
    ]);
    const files = ['p.json', 'a.dxf', 'a.png'].map((name) => ({ name, blob: new Blob([JSON.stringify(document)]) }));
    const plan = await planIntake(files, null);
    expect(plan.problems).toEqual([]);
    expect(plan.ready).toBe(true);
    expect(plan.needed[1]!.file!.name).toBe('a.png');
  });
});

describe('edits of pictures', () => {
  it('leave out pieces that have it already', () => {
    const a = { ...squareOf('a', 0, 0, 9), texture: { ...kChecks } };
    const b = squareOf('b', 0, 0, 9);
    expect(textureEdits([a, b], () => kChecks)).toEqual([{ edit: 'set_texture', piece: 'b', texture: kChecks }]);
    expect(textureEdits([a, b], () => null)).toEqual([{ edit: 'set_texture', piece: 'a' }]);
    expect(commonTexture([a, b])).toBe('mixed');
    expect(commonTexture([a, { ...b, texture: { ...kChecks } }])).toEqual(kChecks);
    expect(commonTexture([])).toBeNull();
  });
});

function begin(more: Partial<Api> = {}) {
  const state = new AppState();
  const sent: { revision: number; edits: Edit[]; files: Record<string, string> }[] = [];
  const loaded: string[] = [];
  const api = fakeApi({
    edit: async (id, revision, edits, files = {}) => {
      sent.push({ revision, edits, files });
      return projectOf({ id, revision: revision + 1, files });
    },
    ...more,
  });
  state.projects.value = ready([projectOf()]);
  state.jobs.value = ready([]);
  state.route.value = { name: 'project', id: 'p_1' };
  state.pieces.value = ready({ pieces: [squareOf('a', 0, 0, 100), squareOf('b', 200, 0, 100)], seams: [] });
  const edits = new EditQueue(state, api, () => undefined);
  const load = async (url: string) => {
    loaded.push(url);
    return { ...picture, url };
  };
  const textures = new TextureCommands(state, api, (ask) => edits.change(ask), load);
  return { state, api, sent, loaded, textures };
}

describe('putting a picture on', () => {
  it('uploads it and sends it with the edit', async () => {
    const { textures, sent, state } = begin();
    await textures.upload(['a'], 'checks.png', new Blob(['x']));
    expect(sent).toEqual([
      {
        revision: 1,
        edits: [{ edit: 'set_texture', piece: 'a', texture: { ...kChecks, scale_mm: 100 } }],
        files: { 'checks.png': 'a_checks.png' },
      },
    ]);
    expect(state.editing.images.value.map((image) => image.name)).toEqual(['checks.png']);
    expect(state.editing.uploading.value).toBe(false);
  });

  it('keeps what was changed just before, though the pieces have not come yet', async () => {
    const { textures, sent } = begin();
    await textures.putOn(['a'], { id: 'a_1', name: 'checks.png' });
    await Promise.all([textures.lay(['a'], { scale_mm: 40 }), textures.lay(['a'], { angle: 45 })]);
    expect(sent[2]!.edits).toEqual([{ edit: 'set_texture', piece: 'a', texture: { ...kChecks, angle: 45 } }]);
    await textures.onAll({ ...kChecks, angle: 45 });
    expect(sent[3]!.edits).toMatchObject([{ edit: 'set_texture', piece: 'b' }]);
    await textures.takeOff(['a', 'b']);
    expect(sent[4]!.edits).toEqual([
      { edit: 'set_texture', piece: 'a' },
      { edit: 'set_texture', piece: 'b' },
    ]);
    await textures.takeOff(['a', 'b']);
    expect(sent.length).toBe(5);
  });

  it('says why a file is no picture', async () => {
    const { textures, sent, state } = begin({ uploadAsset: () => Promise.reject(new Error('neither')) });
    await textures.upload(['a'], 'a.gif', new Blob(['x']));
    expect(sent).toEqual([]);
    expect(state.notices.value.length).toBe(1);
    expect(state.editing.uploading.value).toBe(false);
  });
});

describe('a picture that is dropped alone', () => {
  const drop = async (selected: string | null, names: string[]): Promise<{ pieces: unknown[]; asked: boolean }> => {
    const { state, sent, api } = begin();
    state.selected.value = selected;
    const around = { go: () => undefined, save: () => undefined, newKey: () => '', anew: () => undefined, say: () => undefined, follow: () => undefined };
    const nothing = (): void => undefined;
    const commands = new Commands(state, api, around, nothing, nothing);
    await commands.intake.addFiles(names.map((name) => ({ name, blob: new Blob(['x']) })));
    return { pieces: sent.flatMap(({ edits }) => edits.map((edit) => 'piece' in edit && edit.piece)), asked: state.intake.value !== null };
  };

  it('lies on the selected piece, or on all', async () => {
    expect(await drop('b', ['a.PNG'])).toEqual({ pieces: ['b'], asked: false });
    expect(await drop(null, ['a.jpg'])).toEqual({ pieces: ['a', 'b'], asked: false });
  });

  it('with others begins a project', async () => {
    expect(await drop('b', ['a.png', 'a.dxf'])).toEqual({ pieces: [], asked: true });
  });
});

describe('the pictures of the shown pieces', () => {
  it('are loaded once and let go with the project', async () => {
    const { state, textures, loaded } = begin();
    state.projects.value = ready([projectOf({ files: { 'checks.png': 'a_1' } })]);
    const pieces = ['a', 'b'].map((id) => ({ ...squareOf(id, 0, 0, 9), texture: kChecks }));
    state.pieces.value = ready({ pieces, seams: [] });
    await textures.follow();
    await textures.follow();
    expect(loaded).toEqual(['assets/a_1']);
    expect([...state.looks.value.keys()]).toEqual(['a', 'b']);
    state.pieces.value = null;
    await textures.follow();
    expect(state.pictures.value.size).toBe(0);
  });
});

describe('the pictures on the cloth of an ended drape', () => {
  const step = (edit: string, created_ms: number): EditStep => ({ number: 1, undone: false, created_ms, edits: [{ edit } as Edit] });
  const scales = (state: AppState): number[] => [...state.clothLooks.value.values()].map(({ texture }) => texture.scale_mm);

  it('are those that it was draped with, but for what is laid on the newest one', async () => {
    const { state, textures, loaded } = begin();
    const wide = { ...kChecks, image: 'wide.png', scale_mm: 300 };
    state.projects.value = ready([projectOf({ revision: 2, files: { 'checks.png': 'a_1', 'wide.png': 'a_2' } })]);
    state.pieces.value = ready({ pieces: [{ ...squareOf('a', 0, 0, 9), texture: wide }], seams: [] });
    const drape = jobOf({ state: 'succeeded', created_ms: 5 });
    state.jobs.value = ready([drape]);
    state.route.value = { name: 'job', id: drape.id };
    state.seenPieces.value = ready({ pieces: [seenOf('a', { texture: kChecks })], fabrics: [] });
    await textures.follow();
    expect(loaded).toEqual(['assets/a_2', 'assets/a_1']);
    state.editing.history.value = [step('set_texture', 6)];
    expect(scales(state)).toEqual([300]);
    state.editing.history.value = [step('set_fabric', 7), step('set_texture', 6)];
    expect(scales(state)).toEqual([kChecks.scale_mm]);
    state.editing.history.value = [step('set_texture', 6)];
    state.jobs.value = ready([jobOf({ id: 'j_later', created_ms: 7 }), drape]);
    expect(scales(state)).toEqual([kChecks.scale_mm]);
    state.seenPieces.value = null;
    expect(scales(state)).toEqual([300]);
  });
});

describe('triangles by material', () => {
  it('are the same triangles, put together', () => {
    const triangles = new Uint32Array([0, 1, 2, 3, 4, 5, 1, 2, 0]);
    const { index, groups } = byMaterial(triangles, new Uint16Array([1, 1, 1, 0, 0, 0]), 3);
    expect([...index]).toEqual([3, 4, 5, 0, 1, 2, 1, 2, 0]);
    expect(groups).toEqual([
      { start: 0, count: 3, material: 0 },
      { start: 3, count: 6, material: 1 },
    ]);
  });
});
