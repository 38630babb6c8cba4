// The body in the scene: matte, quiet, so that the cloth is what one looks at.

import { BufferAttribute, BufferGeometry, Mesh, MeshStandardMaterial } from 'three';
import type { BodyMesh } from '../api/body';
import { shareNormals, vertexNormals } from './surface';

export class BodyObject {
  readonly mesh: Mesh<BufferGeometry, MeshStandardMaterial>;

  constructor(colour: number) {
    this.mesh = new Mesh(
      new BufferGeometry(),
      new MeshStandardMaterial({
        color: colour,
        roughness: 0.82,
        // Cloth lies a millimetre away: the body is drawn a little further back, so that none of it shines through.
        polygonOffset: true,
        polygonOffsetFactor: 2,
        polygonOffsetUnits: 300,
      }),
    );
    this.mesh.castShadow = true;
    this.mesh.receiveShadow = true;
    this.mesh.visible = false;
  }

  set(body: BodyMesh | null): void {
    this.mesh.geometry.dispose();
    this.mesh.geometry = new BufferGeometry();
    this.mesh.visible = body !== null;
    if (!body) return;
    const normals = new Float32Array(body.positions.length);
    vertexNormals(body.positions, body.indices, normals);
    shareNormals(body.positions, { start: new Uint32Array([0]), members: new Uint32Array(0) }, normals);
    this.mesh.geometry.setAttribute('position', new BufferAttribute(body.positions, 3));
    this.mesh.geometry.setAttribute('normal', new BufferAttribute(normals, 3));
    this.mesh.geometry.setIndex(new BufferAttribute(body.indices, 1));
  }

  dispose(): void {
    this.mesh.geometry.dispose();
    this.mesh.material.dispose();
  }
}
