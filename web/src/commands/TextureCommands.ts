// Pictures on pieces: uploaded, put on, turned and taken away. Each is a step of the project's history.

import type { Api } from '../api/Api';
import { loadPicture, type LoadPicture } from '../api/pictures';
import type { Asset, Piece, Project, Texture } from '../api/types';
import { loading, valueOf, type AppState } from '../state/AppState';
import { assetsShown, kMostEdits, nameInProject, textureEdits, type TextureEdit } from '../state/texture';
import { notify, notifyError } from './notices';
import { t } from '../texts/language';

export type TextureApi = Pick<Api, 'uploadAsset' | 'images' | 'edit' | 'assetUrl'>;

/** Width of one repeat of a picture that is new, mm. */
const kFirstScale = 100;

export class TextureCommands {
  /** What was sent last: the pieces of that revision may still be on their way. */
  private sent_: { revision: number; textures: ReadonlyMap<string, Texture | null> } = { revision: 0, textures: new Map() };

  constructor(
    private readonly state_: AppState,
    private readonly api_: TextureApi,
    /** Changes the project after the changes that are under way. */
    private readonly change_: (ask: (project: Project) => Promise<Project>) => Promise<void>,
    private readonly load_: LoadPicture = loadPicture,
  ) {}

  /** As they are in this revision; without ids all. */
  private pieces(project: Project, ids?: readonly string[]): Piece[] {
    const { revision, textures } = this.sent_;
    const all = valueOf(this.state_.pieces.value ?? loading)?.pieces ?? [];
    const now = revision === project.revision ? textures : new Map<string, Texture | null>();
    return all
      .filter((piece) => ids?.includes(piece.id) ?? true)
      .map((piece) => (now.has(piece.id) ? { ...piece, texture: now.get(piece.id)! } : piece));
  }

  /** Those of the pieces, as they are now and as the shown drape has them. */
  private get wanted(): string[] {
    const { pieces, seenPieces, project } = this.state_;
    const all = [pieces.value, seenPieces.value].flatMap((some) => valueOf<{ pieces: readonly Pick<Piece, 'texture'>[] }>(some ?? loading)?.pieces ?? []);
    return assetsShown(all, project.value);
  }

  /** Loads the pictures that the shown pieces have, and lets go of others. */
  async follow(): Promise<void> {
    const { pictures } = this.state_;
    const wanted = this.wanted;
    const kept = [...pictures.value].filter(([id]) => wanted.includes(id));
    if (kept.length < pictures.value.size) pictures.value = new Map(kept);
    await Promise.all(wanted.filter((id) => !pictures.value.has(id)).map((id) => this.load(id)));
  }

  private async load(asset: string): Promise<void> {
    const { pictures } = this.state_;
    try {
      const picture = await this.load_(this.api_.assetUrl(asset));
      if (this.wanted.includes(asset)) pictures.value = new Map([...pictures.value, [asset, picture]]);
    } catch {
      notify(this.state_, { tone: 'bad', text: t.messages.pictureLost, where: asset });
    }
  }

  /** The pictures that were uploaded before, for choosing again. */
  async loadImages(): Promise<void> {
    try {
      this.state_.editing.images.value = await this.api_.images();
    } catch {
      // Uploading one works without them.
    }
  }

  /** Uploads a picture and puts it on the pieces. */
  async upload(ids: readonly string[], name: string, file: Blob): Promise<void> {
    const { images, uploading } = this.state_.editing;
    if (uploading.value) return;
    uploading.value = true;
    try {
      const asset = await this.api_.uploadAsset('image', name, file);
      images.value = [asset, ...images.value.filter((one) => one.id !== asset.id)];
      await this.putOn(ids, asset);
    } catch (error) {
      notifyError(this.state_, error);
    } finally {
      uploading.value = false;
    }
  }

  /** Puts a picture that is there on the pieces; where and how large they had another, it lies the same. */
  putOn(ids: readonly string[], asset: Pick<Asset, 'id' | 'name'>): Promise<void> {
    return this.change_(async (project) => {
      const image = nameInProject(project.files, asset.name, asset.id);
      const edits = textureEdits(this.pieces(project, ids), ({ texture }) =>
        texture ? { ...texture, image } : { image, scale_mm: kFirstScale, offset: [0, 0], angle: 0 },
      );
      return this.send(project, edits, { [image]: asset.id });
    });
  }

  /** Changes how the pictures lie. */
  lay(ids: readonly string[], part: Partial<Omit<Texture, 'image'>>): Promise<void> {
    return this.change_((project) =>
      this.send(
        project,
        textureEdits(this.pieces(project, ids), ({ texture }) => texture && { ...texture, ...part }),
      ),
    );
  }

  /** The same picture, lying the same, on every piece. */
  onAll(texture: Texture): Promise<void> {
    return this.change_((project) =>
      this.send(
        project,
        textureEdits(this.pieces(project), () => texture),
      ),
    );
  }

  takeOff(ids: readonly string[]): Promise<void> {
    return this.change_((project) =>
      this.send(
        project,
        textureEdits(this.pieces(project, ids), () => null),
      ),
    );
  }

  /** As few steps as the service allows; none when nothing changes. */
  private async send(
    project: Project,
    edits: readonly TextureEdit[],
    files: Record<string, string> = {},
  ): Promise<Project> {
    let now = project;
    for (let i = 0; i < edits.length; i += kMostEdits) {
      now = await this.api_.edit(now.id, now.revision, edits.slice(i, i + kMostEdits), files);
    }
    const before = this.sent_.revision === project.revision ? this.sent_.textures : [];
    const changed = edits.map(({ piece, texture }): [string, Texture | null] => [piece, texture ?? null]);
    this.sent_ = { revision: now.revision, textures: new Map([...before, ...changed]) };
    return now;
  }
}
