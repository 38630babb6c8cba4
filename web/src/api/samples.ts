// The samples that come with the page: the folders of samples/ with their files, each a project document and what it names.

/** A garment to start from. */
export interface Sample {
  /** Its folder. */
  id: string;
  title: string;
  /** Address of a picture of its drape. */
  picture: string;
  /** Its files: name → address. */
  files: ReadonlyMap<string, string>;
}

const addresses = import.meta.glob<string>('../../../samples/*/*.{json,dxf,obj,jpg}', {
  query: '?url',
  import: 'default',
  eager: true,
});
const titles = import.meta.glob<string>('../../../samples/*/project.json', { import: 'name', eager: true });

const kPicture = 'picture.jpg';

/** Folder and name of a file of samples/. */
const parted = (path: string): [folder: string, name: string] => path.split('/').slice(-2) as [string, string];

export const samples: readonly Sample[] = Object.entries(titles).map(([path, title]) => {
  const [id] = parted(path);
  const own = Object.entries(addresses).filter(([file]) => parted(file)[0] === id);
  const files = new Map(own.map(([file, url]) => [parted(file)[1], url]));
  const picture = files.get(kPicture) ?? '';
  files.delete(kPicture);
  return { id, title, picture, files };
});

/** The bytes of a sample's files, under their names. @throws when one cannot be fetched. */
export async function fetchSample({ files }: Sample): Promise<{ name: string; blob: Blob }[]> {
  return Promise.all(
    [...files].map(async ([name, url]) => {
      const answer = await fetch(url);
      if (!answer.ok) throw new Error(`${name} did not come: ${answer.status}`);
      return { name, blob: await answer.blob() };
    }),
  );
}
