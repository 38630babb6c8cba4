// A drape under way: its states, phases and figures.

export const drape = {
  solver: {
    paper: 'The method of the paper, to compare with. It may let cloth through; crossings are counted.',
    how: 'How it is draped',
    solver: 'Solver',
    next: 'It counts from the next drape on.',
    toile: 'Nothing goes through anything.',
  },
  speedHere: 'The speed of the cloth is drawn here as it calms down.',
  speedOf: 'Speed of the cloth',
  speedNow: (speed: string) => `Speed of the cloth, now ${speed}`,
  dashed: 'dashed: at rest',
  facts: {
    drape: 'Drape',
    version: 'Version',
    revision: 'Project revision',
    running: 'Running time',
    particles: 'Particles',
    triangles: 'Triangles',
  },
  pins: {
    title: 'Pins',
    one: (n: number) => `Pin ${n}`,
    height: (height: string) => `at a height of ${height}`,
    remove: (n: number) => `Remove pin ${n}`,
  },
  starting: 'Starting',
  states: {
    queued: 'Queued',
    running: 'Running',
    paused: 'Paused',
    succeeded: 'Done',
    failed: 'Failed',
    cancelled: 'Cancelled',
  },
  phases: {
    queued: 'Waiting for a worker',
    mesh: 'Meshing the pieces',
    place: 'Placing the pieces',
    dress: 'Putting the garment on',
    sew: 'Sewing',
    drape: 'Draping',
    move: 'Moving the body',
    check: 'Checking',
    stills: 'Taking the stills',
  },
};
