// Materials of cloth as light plays on it: one for each finish, all of one program.

import { DoubleSide, MeshStandardMaterial, Vector2, type Material, type Texture } from 'three';
import { kPlainFinish, type Finish, type Weave } from '../state/fabrics';
import { kSeamFragment, kSeamFragmentHead, kSeamVertex, kSeamVertexHead } from './seamShader';
import { threadNormals, weaveTexture } from './weave';

/** How much darker cloth is on its wrong side, which lies away from the light. */
const kInside = 0.74;
const kThreads = 0.5;

/** Fibres catch the light where cloth is seen at a slant; the inside of a garment is darker; seams stand up. */
function madeUp(material: MeshStandardMaterial, sheen: number): MeshStandardMaterial {
  material.onBeforeCompile = (shader) => {
    shader.uniforms.sheen = { value: sheen };
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', `#include <common>${kSeamVertexHead}`)
      .replace('#include <begin_vertex>', `#include <begin_vertex>${kSeamVertex}`);
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', `#include <common>\nuniform float sheen;${kSeamFragmentHead}`)
      .replace('#include <normal_fragment_maps>', `#include <normal_fragment_maps>${kSeamFragment}`)
      .replace(
        '#include <opaque_fragment>',
        `float slant = 1.0 - saturate(dot(normal, normalize(vViewPosition)));
        outgoingLight += diffuseColor.rgb * (sheen * slant * slant * slant);
        if (!gl_FrontFacing) outgoingLight *= ${kInside};
        #include <opaque_fragment>`,
      );
  };
  return material;
}

export class ClothMaterials {
  private readonly weave_ = weaveTexture();
  private readonly threads_ = new Map<Weave, Texture>();
  private fine_ = true;
  /** All materials that are there, with the threads that they have when they are fine. */
  private readonly finely_ = new Map<MeshStandardMaterial, Texture>();
  private readonly made_ = new Map<string, MeshStandardMaterial>();

  of(finish: Finish = kPlainFinish): MeshStandardMaterial {
    const { weave, roughness, sheen } = finish;
    const key = `${weave} ${roughness} ${sheen}`;
    const known = this.made_.get(key);
    if (known) return known;
    const made = this.plain(finish, this.weave_);
    this.made_.set(key, made);
    return made;
  }

  /** With a picture in the place of the weave's own shades; whoever asks lets go of it. */
  plain({ weave, roughness, sheen }: Finish, map: Texture): MeshStandardMaterial {
    const material = new MeshStandardMaterial({
      side: DoubleSide,
      vertexColors: true,
      roughness,
      metalness: 0,
      map,
      normalScale: new Vector2(kThreads, kThreads),
      polygonOffset: true,
      polygonOffsetFactor: 0.25,
      polygonOffsetUnits: 1,
    });
    this.finely_.set(material, this.threads(weave));
    material.addEventListener('dispose', () => this.finely_.delete(material));
    this.dress(material);
    return madeUp(material, sheen);
  }

  /** With threads that stand up, or smooth, which is drawn faster. */
  setFine(fine: boolean): void {
    if (fine === this.fine_) return;
    this.fine_ = fine;
    for (const material of this.finely_.keys()) this.dress(material);
  }

  private dress(material: MeshStandardMaterial): void {
    material.normalMap = this.fine_ ? this.finely_.get(material)! : null;
    material.needsUpdate = true;
  }

  /** Lets go of all but these and the plain one. */
  keep(used: readonly Material[]): void {
    for (const [key, material] of this.made_) {
      if (used.includes(material) || material === this.of()) continue;
      material.dispose();
      this.made_.delete(key);
    }
  }

  dispose(): void {
    for (const material of this.made_.values()) material.dispose();
    for (const texture of this.threads_.values()) texture.dispose();
    this.weave_.dispose();
  }

  private threads(weave: Weave): Texture {
    const known = this.threads_.get(weave);
    if (known) return known;
    const made = threadNormals(weave);
    this.threads_.set(weave, made);
    return made;
  }
}
