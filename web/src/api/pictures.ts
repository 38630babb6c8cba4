// Pictures on cloth, as a browser decodes them.

export interface Picture {
  url: string;
  /** Pixels as it is shown: turned as the camera says. */
  width: number;
  height: number;
  image: CanvasImageSource;
}

export type LoadPicture = (url: string) => Promise<Picture>;

/** Rejects when the browser cannot show it. */
export async function loadPicture(url: string): Promise<Picture> {
  const image = new Image();
  image.src = url;
  await image.decode();
  return { url, width: image.naturalWidth, height: image.naturalHeight, image };
}
