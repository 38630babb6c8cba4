// What is drawn upon the cloth in lines: its mesh, its seams on maps, the threads that pull them together, and what is
// selected. All of it draws from the surface's own positions.

import {
  BufferAttribute,
  BufferGeometry,
  GreaterDepth,
  LineBasicMaterial,
  LineSegments,
  Points,
  PointsMaterial,
  type Color,
  type Group,
  type Material,
} from 'three';
import type { ClothTopology, TopologyPiece } from '../api/frames';
import type { SeamPart } from '../state/seamView';
import { allEdges, rimEdges, seamEdges, verticesAlong } from './surface';

/** Sewn pairs further apart than this still have their threads drawn, m. */
const kThreadGap = 0.0015;
/** How much is seen of a line that lies behind something. */
const kFaint = 0.16;

/** What there is once a topology is known. */
interface Drawn {
  topology: ClothTopology;
  rim: Uint32Array;
  seams: LineSegments;
  threads: LineSegments;
  wires: LineSegments;
  rimOfPiece: LineSegments;
  /** What lies behind body or cloth is faint. */
  rimBehind: LineSegments;
  litSeam: Points;
  litBehind: Points;
}

/** m, towards the eye: what is drawn upon cloth is not to be hidden by that cloth, only by what lies before it. */
const kNearer = 0.012;

/** Seen where it lies, in front of what is no nearer than that; or, behind, only where it is hidden. */
function upon<M extends Material>(material: M, behind: boolean): M {
  material.transparent = true;
  material.depthWrite = false;
  if (behind) [material.depthFunc, material.opacity] = [GreaterDepth, kFaint];
  material.onBeforeCompile = (shader) => {
    const nearer = `gl_Position = projectionMatrix * vec4(mvPosition.xyz * (1.0 - ${kNearer} / length(mvPosition.xyz)), 1.0);`;
    shader.vertexShader = shader.vertexShader.replace('#include <project_vertex>', `#include <project_vertex>\n${nearer}`);
  };
  return material;
}

export class ClothLines {
  private drawn_: Drawn | null = null;
  private wiresShown_ = false;
  private seamsShown_ = false;
  /** Upon maps; cloth has its seams as ridges. */
  private readonly seamMaterial_ = new LineBasicMaterial({ color: 0x585858, vertexColors: true, transparent: true, opacity: 0.45 });
  private readonly wireMaterial_ = new LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.22 });
  private readonly threadMaterial_: LineBasicMaterial;
  private readonly rimMaterials_: readonly LineBasicMaterial[];
  private readonly litMaterials_: readonly PointsMaterial[];

  constructor(
    private readonly group_: Group,
    private readonly thread_: Color,
    selected: Color,
  ) {
    this.threadMaterial_ = new LineBasicMaterial({ color: thread_, transparent: true, opacity: 0.9 });
    this.rimMaterials_ = [false, true].map((behind) => upon(new LineBasicMaterial({ color: selected }), behind));
    this.litMaterials_ = [false, true].map((behind) => upon(new PointsMaterial({ color: selected, size: 6, sizeAttenuation: false }), behind));
  }

  /** Draws lines upon this surface, until it is cleared. */
  set(topology: ClothTopology, surface: BufferGeometry): void {
    const { vertexCount, triangles, sewn } = topology;
    const rim = rimEdges(triangles, vertexCount);
    const [rimMaterial, rimBehind] = this.rimMaterials_;
    const [litMaterial, litBehind] = this.litMaterials_;
    this.drawn_ = {
      topology,
      rim,
      seams: this.addLines(surface, seamEdges(rim, sewn), this.seamMaterial_, 1),
      threads: this.addLines(surface, sewn, this.threadMaterial_, 2),
      wires: this.addLines(surface, allEdges(triangles, vertexCount), this.wireMaterial_, 1),
      rimOfPiece: this.addLines(surface, new Uint32Array(0), rimMaterial!, 3),
      rimBehind: this.addLines(surface, new Uint32Array(0), rimBehind!, 3),
      litSeam: this.addPoints(surface, litMaterial!),
      litBehind: this.addPoints(surface, litBehind!),
    };
    this.drawn_.seams.visible = this.seamsShown_;
    this.drawn_.wires.visible = this.wiresShown_;
  }

  /** The group is emptied by whoever owns it. */
  clear(): void {
    if (!this.drawn_) return;
    const { topology: _, rim: __, ...drawn } = this.drawn_;
    for (const lines of Object.values(drawn)) lines.geometry.dispose();
    this.drawn_ = null;
  }

  /** So that the shader of lines is made before the first frame needs it. */
  standIn(surface: BufferGeometry): LineSegments {
    return new LineSegments(surface, this.seamMaterial_);
  }

  showSeams(shown: boolean): void {
    this.seamsShown_ = shown;
    if (this.drawn_) this.drawn_.seams.visible = shown;
  }

  showWires(shown: boolean): void {
    this.wiresShown_ = shown;
    if (this.drawn_) this.drawn_.wires.visible = shown;
  }

  /** m, the widest gap: threads that close it are drawn. */
  setGap(gap: number): void {
    if (this.drawn_) this.drawn_.threads.visible = gap > kThreadGap;
  }

  /** In this colour, or in the usual one. */
  colourThreads(colour: Color | null): void {
    this.threadMaterial_.color.copy(colour ?? this.thread_);
  }

  outlineSeam(parts: readonly SeamPart[]): void {
    if (!this.drawn_) return;
    const { litSeam, litBehind, topology, rim } = this.drawn_;
    showOnly([litSeam, litBehind], verticesAlong(parts, topology, rim));
  }

  outlinePiece(piece: TopologyPiece | undefined): void {
    if (!this.drawn_) return;
    const { rim, rimOfPiece, rimBehind } = this.drawn_;
    const inside = (v: number): boolean => !!piece && v >= piece.firstVertex && v < piece.firstVertex + piece.vertexCount;
    const edges: number[] = [];
    for (let i = 0; i < rim.length; i += 2) if (inside(rim[i]!)) edges.push(rim[i]!, rim[i + 1]!);
    showOnly([rimOfPiece, rimBehind], edges);
  }

  dispose(): void {
    this.clear();
    for (const material of [
      this.seamMaterial_,
      this.wireMaterial_,
      this.threadMaterial_,
      ...this.rimMaterials_,
      ...this.litMaterials_,
    ])
      material.dispose();
  }

  private addLines(
    surface: BufferGeometry,
    index: Uint32Array,
    material: LineBasicMaterial,
    order: number,
  ): LineSegments {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', surface.getAttribute('position'));
    geometry.setIndex(new BufferAttribute(index, 1));
    const lines = new LineSegments(geometry, material);
    lines.renderOrder = order;
    lines.frustumCulled = false;
    this.group_.add(lines);
    return lines;
  }

  private addPoints(surface: BufferGeometry, material: PointsMaterial): Points {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', surface.getAttribute('position'));
    const points = new Points(geometry, material);
    points.renderOrder = 4;
    points.frustumCulled = false;
    this.group_.add(points);
    return points;
  }
}

/** Draws these vertices of the surface, by each of the two. */
function showOnly(both: readonly (LineSegments | Points)[], vertices: readonly number[]): void {
  for (const one of both) {
    one.geometry.setIndex(new BufferAttribute(new Uint32Array(vertices), 1));
    one.visible = vertices.length > 0;
  }
}
