// The first page, and files on their way to become a project.

import { grammar } from '../grammar';

const { number } = grammar('en');

export const intake = {
  start: 'Start',
  seeIt: 'See your pattern on a body',
  lead: 'Toile reads a flat pattern, sews its pieces together, stands them around a body and lets the cloth hang. You watch it fall, change what does not fit, and take home pictures, a 3D model and the figures.',
  dropPattern: 'Drop a DXF pattern here, or choose it',
  orSample: 'Or start from a sample',
  goOn: 'Go on with',
  sampleTip: 'Makes a project of it and drapes it',
  dropToMake: 'Drop to make a project',
  dropWhat: 'a pattern (DXF, GarmentCode), or project.json with its files; a picture alone goes on the cloth',
  takes: 'A pattern (DXF, GarmentCode JSON), a body (OBJ, glTF, …), or a project.json with its files',
  leaving: 'Escape once more closes it; nothing of this is kept.',
  newFrom: (file: string) => `New project from ${file}`,
  dropHere: 'Drop files here, or choose them',
  addMore: 'Add more files',
  create: 'Create',
  createAndDrape: 'Create and drape',
  roles: {
    project: 'Project',
    pattern: 'Pattern',
    body: 'Body',
    image: 'Picture',
    unused: 'Not used',
  },
  besides: 'It lies beside project.json where that was saved. Drop it here too.',
  complete: 'Everything is there.',
  thePattern: 'the pattern',
  theBody: 'the body',
  alsoNeeds: (n: number) => n === 1 ? 'also needs this file:' : `also needs these ${number(n)} files:`,
  problems: {
    documentSize: 'A project document has at most 4 MiB.',
    format: 'This JSON file is neither a Toile project (it has no key "toile") nor a GarmentCode specification.',
    json: (why: string) => `Not valid JSON: ${why}`,
    fileSize: 'Files have at most 64 MiB.',
    kind: 'Neither a project (.json), a pattern (.dxf, .json), a body (.obj, .glb, …) nor a picture (.png, .jpg).',
    several: 'One project at a time: leave one document away.',
  },
};
