import { describe, expect, it } from 'vitest';
import sampleDxf from '../../samples/skirt/skirt.dxf?raw';
import sampleProject from '../../samples/skirt/project.json?raw';
import { filesNamedBy, kLargestDocument, planIntake, type GivenFile } from '../src/state/intake';
import { meshFormats } from './samples';

const meshes = meshFormats.map(({ ending }) => ending);
const planOf = (files: GivenFile[]) => planIntake(files, meshes);
const file = (name: string, text: string): GivenFile => ({ name, blob: new Blob([text]) });
const project = () => file('project.json', sampleProject);
const dxf = () => file('skirt.dxf', sampleDxf);
const body = () => file('body.obj', 'v 0 0 0');

describe('files dropped on the page', () => {
  it('are a project when the document and everything it names are there', async () => {
    const plan = await planOf([body(), dxf(), project()]);
    expect(plan).toMatchObject({ ready: true, problems: [], unused: [], name: 'A-line skirt' });
    expect(plan.needed.map((need) => [need.name, need.kind, need.file !== null])).toEqual([
      ['skirt.dxf', 'dxf', true],
      ['body.obj', 'body', true],
    ]);
  });

  it('tell which files the document names and nobody gave', async () => {
    const plan = await planOf([project()]);
    expect(plan.ready).toBe(false);
    expect(plan.needed.filter((need) => !need.file).map((need) => need.name)).toEqual(['skirt.dxf', 'body.obj']);
  });

  it('fit names of another case and in folders, as the document has them', async () => {
    const document = JSON.stringify({ toile: 1, pieces: [{ from: { dxf: 'cut/Skirt.DXF' } }], bodies: [] });
    const plan = await planOf([file('p.json', document), dxf()]);
    expect(plan.ready).toBe(true);
    expect(plan.needed[0]).toMatchObject({ name: 'cut/Skirt.DXF', file: { name: 'skirt.dxf' } });
    expect(plan.name).toBe('p');
  });

  it('are a pattern to be read when no document came, with the body beside it', async () => {
    const plan = await planOf([dxf(), body()]);
    expect(plan.ready).toBe(false);
    expect(plan.loose).toMatchObject({ kind: 'dxf', file: { name: 'skirt.dxf' }, bodies: [{ name: 'body.obj' }] });
    expect(plan.unused).toEqual([]);
  });

  it('may be a specification, which is told from a project', async () => {
    const plan = await planOf([file('shirt.json', '{"pattern": {"panels": {}}}'), dxf()]);
    expect(plan.problems).toEqual([]);
    expect(plan.loose).toMatchObject({ kind: 'specification', file: { name: 'shirt.json' } });
    expect(plan.unused).toEqual(['skirt.dxf']);
  });

  it('may be given bit by bit, the last of a name counting', async () => {
    const plan = await planOf([file('project.json', '{'), dxf(), body(), project()]);
    expect(plan.ready).toBe(true);
  });

  it('are refused with a code and the file when they cannot be', async () => {
    const codes = async (...files: GivenFile[]) =>
      (await planOf(files)).problems.map((problem) => [problem.code, problem.where]);
    expect(await codes(file('a.json', '{"toile": 1,'))).toEqual([['json.malformed', 'a.json']]);
    expect(await codes(file('a.json', '[1]'))).toEqual([['project.format', 'a.json']]);
    expect(await codes(file('a.json', 'null'))).toEqual([['project.format', 'a.json']]);
    expect(await codes(file('notes.txt', 'x'))).toEqual([['file.kind', 'notes.txt']]);
    expect(await codes(project(), file('b.json', '{"toile":1}'))).toEqual([
      ['project.several', 'project.json, b.json'],
    ]);
    expect(await codes(file('a.json', ' '.repeat(kLargestDocument + 1)))).toEqual([['json.too_large', 'a.json']]);
  });

  it('may be any mesh that the service reads, in capitals too', async () => {
    const bodies = async (known: readonly string[] | null, ...names: string[]) => {
      const plan = await planIntake([dxf(), ...names.map((name) => file(name, 'x'))], known);
      return [plan.loose!.bodies.map((one) => one.name), plan.problems.length];
    };
    expect(await bodies(meshes, 'anna.3DS', 'chair.off')).toEqual([['anna.3DS', 'chair.off'], 0]);
    expect(await bodies(['.obj'], 'anna.3ds', 'chair.obj')).toEqual([['chair.obj'], 1]);
    // As long as nobody has told, whatever is nothing else may be one.
    expect(await bodies(null, 'anna.usd', 'check.png')).toEqual([['anna.usd'], 0]);
  });

  it('keep going where the document is of strange shape: the service says what is wrong', async () => {
    for (const odd of [{ pieces: 3 }, { pieces: [null, 4, { from: 'x' }] }, { bodies: { file: 'x' } }]) {
      expect(filesNamedBy(odd as Record<string, unknown>)).toEqual([]);
    }
  });

  it('that nobody needs are named', async () => {
    expect((await planOf([project(), dxf(), body(), file('more.dxf', '')])).unused).toEqual(['more.dxf']);
  });
});
