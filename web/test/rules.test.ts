import { describe, expect, it } from 'vitest';

/** Which folder may import from which; a file of src itself, main, from all. */
const kAllowed: Record<string, string[]> = {
  texts: ['texts'],
  api: ['api'],
  state: ['state', 'api', 'texts'],
  commands: ['commands', 'state', 'api', 'texts'],
  workers: ['workers', 'api'],
  controls: ['controls', 'texts'],
  tools: ['tools', 'controls', 'commands', 'state', 'api', 'texts'],
  pattern: ['pattern', 'tools', 'commands', 'state', 'api', 'texts'],
  scene: ['scene', 'tools', 'commands', 'state', 'api', 'texts'],
  panels: ['panels', 'tools', 'controls', 'commands', 'state', 'api', 'texts'],
};

/** Files that alone take what lies outside of the page: the codec, and the shader that the stills draw seams by. */
const kDoors: readonly [string, string][] = [
  ['api/frames.ts', '/proto/ts/'],
  ['scene/seamShader.ts', '/server/render/glsl/seams.glsl'],
];

const files = import.meta.glob<string>('../src/**/*.{ts,tsx}', { query: '?raw', import: 'default', eager: true });

const tests = import.meta.glob<string>('./*.{ts,tsx}', { query: '?raw', import: 'default', eager: true });

const panelTests = import.meta.glob<string>('./panels/*.tsx', { query: '?raw', import: 'default', eager: true });

/** Folder of src that an import in `file` leads to; null for packages. */
function target(file: string, path: string): string | null {
  if (!path.startsWith('.')) return null;
  return new URL(path, `http://here/${file.replace('../', 'web/')}`).pathname.replace('/web/src/', '');
}

describe('the rooms of the page', () => {
  it('import only what stands below them', () => {
    const wrong: string[] = [];
    for (const [file, text] of Object.entries(files)) {
      const room = /^\.\.\/src\/(\w+)\//.exec(file)?.[1];
      if (!room) continue;
      for (const [, path] of text.matchAll(/(?:from|import)\s*\(?\s*'([^']+)'/g)) {
        const to = target(file, path!);
        if (to === null || kDoors.some(([door, beyond]) => file.endsWith(door) && to.startsWith(beyond))) continue;
        if (!kAllowed[room]?.includes(to.split('/')[0]!)) wrong.push(`${file} imports ${path}`);
      }
    }
    expect(wrong).toEqual([]);
    expect(Object.keys(files).length).toBeGreaterThan(30);
  });

  it('export no value that nobody takes', () => {
    const all = Object.entries({ ...files, ...tests, ...panelTests });
    const unused = Object.entries(files).flatMap(([file, text]) =>
      [...text.matchAll(/^export (?:async )?(?:const|function|class) (\w+)/gm)]
        .map(([, name]) => name!)
        .filter((name) => !all.some(([other, code]) => other !== file && new RegExp(`\\b${name}\\b`).test(code)))
        .map((name) => `${file}: ${name}`),
    );
    expect(unused).toEqual([]);
  });

  it('have each panel drawn by a test', () => {
    const drawn = Object.values(panelTests).join('\n');
    const panels = Object.keys(files).filter((file) => file.startsWith('../src/panels/'));
    expect(panels.filter((file) => !drawn.includes(`'../${file.replace('.tsx', "'")}`))).toEqual([]);
    expect(panels.length).toBeGreaterThan(20);
  });

  it('fetch three.js only with the 3D view', () => {
    const users = Object.entries(files)
      .filter(([, text]) => /from 'three/.test(text))
      .map(([file]) => file);
    expect(users.every((file) => file.startsWith('../src/scene/'))).toBe(true);
    const eager = Object.entries(files)
      .filter(([, text]) => /^import (?!type)[^;]*from '\.[^']*\/SceneView'/m.test(text))
      .map(([file]) => file);
    expect(eager).toEqual([]);
  });
});
