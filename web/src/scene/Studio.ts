// Light, ground and air of the 3D view: one large soft key light with a shadow, a sky, a rim, a floor with a 10 cm grid
// that fades into the background.

import {
  Color,
  DirectionalLight,
  Group,
  HemisphereLight,
  Mesh,
  PlaneGeometry,
  ShaderMaterial,
  ShadowMaterial,
  Vector3,
  Vector4,
} from 'three';
import type { Footprint } from './framing';

export interface StudioColours {
  /** Behind everything, upper and lower edge. */
  air: [string, string];
  grid: string;
  shadow: number;
  dark: boolean;
}

const kFloor = 12;

export class Studio {
  readonly group = new Group();
  private readonly key_ = new DirectionalLight(0xfff6ec, 2.3);
  private readonly fill_ = new DirectionalLight(0xdfe8ff, 0.55);
  private readonly rim_ = new DirectionalLight(0xffffff, 0.9);
  private readonly sky_ = new HemisphereLight(0xffffff, 0xa39c94, 1.75);
  private readonly grid_: Mesh<PlaneGeometry, ShaderMaterial>;
  private readonly floor_: Mesh<PlaneGeometry, ShadowMaterial>;

  /** `slow`: drawn by the processor. */
  constructor(slow: boolean) {
    this.grid_ = new Mesh(new PlaneGeometry(kFloor, kFloor), gridMaterial());
    this.floor_ = new Mesh(new PlaneGeometry(kFloor, kFloor), new ShadowMaterial({ opacity: 0.3 }));
    for (const plane of [this.grid_, this.floor_]) plane.rotateX(-Math.PI / 2);
    this.floor_.receiveShadow = true;
    this.floor_.position.y = 0.0005;
    this.setUpShadow(slow);
    this.group.add(this.key_, this.key_.target, this.fill_, this.rim_, this.sky_, this.grid_, this.floor_);
  }

  paint(colours: StudioColours): void {
    this.grid_.material.uniforms.colour!.value = new Color(colours.grid);
    this.floor_.material.opacity = colours.shadow;
    this.sky_.intensity = colours.dark ? 1.3 : 1.75;
    this.key_.intensity = colours.dark ? 2.1 : 2.3;
  }

  /** Darkens the ground where a body stands on it; null: nobody does. */
  standOn(feet: readonly Footprint[]): void {
    const shown = this.grid_.material.uniforms.feet!.value as Vector4[];
    shown.forEach((foot, i) => {
      const { x = 0, z = 0, across = 0, along = 0 } = feet[i] ?? {};
      foot.set(x, z, across, along);
    });
  }

  /** Lights stand fixed to the viewer, so that every side is seen in good light; they turn with the eye's heading only. */
  face(eye: Vector3, target: Vector3): void {
    const heading = Math.atan2(eye.x - target.x, eye.z - target.z);
    const place = (light: DirectionalLight, right: number, up: number, front: number): void => {
      const s = Math.sin(heading);
      const c = Math.cos(heading);
      light.position.set(
        target.x + 3 * (right * c + front * s),
        target.y + 3 * up,
        target.z + 3 * (front * c - right * s),
      );
      light.target.position.copy(target);
      light.target.updateMatrixWorld();
    };
    place(this.key_, -0.75, 1.55, 0.85);
    place(this.fill_, 0.9, 0.25, 0.7);
    place(this.rim_, 0.7, 0.6, -0.9);
  }

  dispose(): void {
    for (const plane of [this.grid_, this.floor_]) {
      plane.geometry.dispose();
      plane.material.dispose();
    }
    this.key_.shadow.dispose();
  }

  private setUpShadow(slow: boolean): void {
    this.key_.castShadow = true;
    const { shadow } = this.key_;
    shadow.mapSize.setScalar(1024);
    shadow.camera.left = -1.3;
    shadow.camera.bottom = -1.3;
    shadow.camera.right = 1.3;
    shadow.camera.top = 1.3;
    shadow.camera.near = 0.5;
    shadow.camera.far = 9;
    // Softer than this, the few taps of the cheap map show as dots.
    shadow.radius = slow ? 2.5 : 6;
    shadow.blurSamples = 10;
    shadow.bias = -0.0006;
    shadow.normalBias = slow ? 0.03 : 0.02;
  }
}

/** Lines every 10 cm, stronger every metre, one pixel wide at any distance, gone at the floor's rim. */
function gridMaterial(): ShaderMaterial {
  return new ShaderMaterial({
    transparent: true,
    depthWrite: false,
    uniforms: { colour: { value: new Color('#888') }, feet: { value: [new Vector4(), new Vector4()] } },
    vertexShader: `
      varying vec2 place;
      void main() {
        place = position.xy;
        gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
      }`,
    fragmentShader: `
      varying vec2 place;
      uniform vec3 colour;
      // Middle and half widths of what stands on the ground, m; a width of 0: nothing.
      uniform vec4 feet[2];
      float contact(vec4 foot) {
        if (foot.z <= 0.0) return 0.0;
        vec2 away = (vec2(place.x, -place.y) - foot.xy) / (foot.zw + 0.045);
        return exp(-1.6 * dot(away, away));
      }
      float lines(float every) {
        vec2 cell = place / every;
        vec2 near = abs(fract(cell - 0.5) - 0.5) / max(fwidth(cell), 1e-6);
        vec2 calm = 1.0 - smoothstep(0.25, 0.6, fwidth(cell));
        return max((1.0 - min(near.x, 1.0)) * calm.x, (1.0 - min(near.y, 1.0)) * calm.y);
      }
      void main() {
        float fade = 1.0 - smoothstep(0.4, 2.4, length(place));
        float strength = max(0.08 * lines(0.1), 0.2 * lines(1.0)) * fade;
        float under = max(contact(feet[0]), contact(feet[1]));
        gl_FragColor = vec4(mix(colour, vec3(0.0), under), max(strength, 0.34 * under));
      }`,
  });
}
