// Materials of cloth with a picture on it: one per picture and colour of cloth.

import { CanvasTexture, RepeatWrapping, SRGBColorSpace, Color, type Material, type MeshStandardMaterial } from 'three';
import { kPlainFinish, type Finish } from '../state/fabrics';
import type { Look } from '../state/texture';
import type { ClothMaterials } from './ClothMaterials';

/** Pixels a side at most; finer pictures are reduced. */
const kMostPixels = 2048;
const kAnisotropy = 8;

export class PrintMaterials {
  private readonly made_ = new Map<string, MeshStandardMaterial>();

  constructor(private readonly cloths_: ClothMaterials) {}

  of(look: Look, finish: Finish = kPlainFinish): Material {
    const key = `${look.asset} ${look.colour.join(' ')} ${finish.weave} ${finish.roughness}`;
    const known = this.made_.get(key);
    if (known) return known;
    const material = this.cloths_.plain(finish, textureOf(look));
    this.made_.set(key, material);
    return material;
  }

  /** Lets go of all others. */
  keep(used: readonly Material[]): void {
    for (const [key, material] of this.made_) if (!used.includes(material)) this.drop(key, material);
  }

  dispose(): void {
    for (const [key, material] of this.made_) this.drop(key, material);
  }

  private drop(key: string, material: MeshStandardMaterial): void {
    material.map?.dispose();
    material.dispose();
    this.made_.delete(key);
  }
}

/** The picture over the colour of its cloth, which shines through where it is not opaque. */
function textureOf({ picture, colour }: Look): CanvasTexture {
  const shrink = Math.min(1, kMostPixels / Math.max(picture.width, picture.height));
  const canvas = document.createElement('canvas');
  canvas.width = Math.max(1, Math.round(picture.width * shrink));
  canvas.height = Math.max(1, Math.round(picture.height * shrink));
  const pen = canvas.getContext('2d')!;
  pen.fillStyle = new Color().setRGB(...colour).getStyle();
  pen.fillRect(0, 0, canvas.width, canvas.height);
  pen.drawImage(picture.image, 0, 0, canvas.width, canvas.height);
  const texture = new CanvasTexture(canvas);
  texture.colorSpace = SRGBColorSpace;
  texture.wrapS = RepeatWrapping;
  texture.wrapT = RepeatWrapping;
  texture.anisotropy = kAnisotropy;
  return texture;
}
