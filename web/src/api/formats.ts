// Files by the endings of their names: ".obj". What meshes may be the service tells (BodyTables.formats), by the table that
// its reader goes by.

/** Pictures that lie on cloth. */
export const kPictureEndings: readonly string[] = ['.png', '.jpg', '.jpeg'];

/** Whether a file's name has one of these endings, in capitals or not. */
export const hasEnding = (name: string, endings: readonly string[]): boolean =>
  endings.some((ending) => name.toLowerCase().endsWith(ending));

/** What a file input accepts; undefined, and so everything, where the meshes are not known. */
export const acceptOf = (meshes: readonly string[] | null, ...others: readonly string[]): string | undefined =>
  meshes ? [...others, ...meshes].join(',') : undefined;
