// What is being done, and short news.

export const messages = {
  wouldFail: 'Nothing has changed since this drape failed: it would fail again.',
  asDraped: 'Nothing is to be changed there: it is as it was draped.',
  reading: 'Reading the files',
  projectThere: (name: string) => `Project “${name}” is there. Space drapes it.`,
  uploading: (name: string) => `Uploading ${name}`,
  makingProject: 'Making the project',
  makingBody: 'Making the body',
  takingAway: (name: string) => `Taking ${name} away`,
  settingDistance: 'Setting the distance',
  measuring: (name: string) => `Measuring ${name}`,
  movingLandmark: 'Moving the landmark',
  puttingBack: 'Putting the landmark back',
  arranging: 'Arranging the pieces',
  placing: 'Placing the piece',
  standing: 'Standing the pieces around the body',
  inRows: (why: string) => `The pieces stand in rows: ${why}`,
  twoCorners: 'An outline keeps at least two corners.',
  changedElsewhere: 'Somebody else changed this project; here is the newest.',
  pictureLost: 'A picture of this project cannot be shown.',
};
