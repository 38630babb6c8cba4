// Named states of a project.

export const versions = {
  title: 'Versions',
  nameOf: 'Name of this state',
  keep: 'Keep',
  current: 'as it is now',
  restore: 'Go back',
  restoreIt: (name: string) => `Go back to ${name}`,
  restoreTip: 'The project becomes what it was; Ctrl Z leads back',
  the: (name: string) => `the version ${name}`,
};
