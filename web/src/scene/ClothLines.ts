// What is drawn upon the cloth in lines: its mesh, its seams on maps, the threads that pull them together, and what is
// selected. All of it draws from the surface's own positions.

import {
  BufferAttribute,
  BufferGeometry,
  LineBasicMaterial,
  LineSegments,
  Points,
  PointsMaterial,
  type Color,
  type Group,
} from 'three';
import type { ClothTopology, TopologyPiece } from '../api/frames';
import type { SeamPart } from '../state/seamView';
import { allEdges, rimEdges, seamEdges, verticesAlong } from './surface';

/** Sewn pairs further apart than this still have their threads drawn, m. */
const kThreadGap = 0.0015;

/** What there is once a topology is known. */
interface Drawn {
  topology: ClothTopology;
  rim: Uint32Array;
  seams: LineSegments;
  threads: LineSegments;
  wires: LineSegments;
  rimOfPiece: LineSegments;
  litSeam: Points;
}

export class ClothLines {
  private drawn_: Drawn | null = null;
  private wiresShown_ = false;
  private seamsShown_ = false;
  /** Upon maps; cloth has its seams as ridges. */
  private readonly seamMaterial_ = new LineBasicMaterial({ color: 0x585858, vertexColors: true, transparent: true, opacity: 0.45 });
  private readonly wireMaterial_ = new LineBasicMaterial({ color: 0x000000, transparent: true, opacity: 0.22 });
  private readonly threadMaterial_: LineBasicMaterial;
  private readonly rimMaterial_: LineBasicMaterial;
  private readonly litMaterial_: PointsMaterial;

  constructor(
    private readonly group_: Group,
    private readonly thread_: Color,
    selected: Color,
  ) {
    this.threadMaterial_ = new LineBasicMaterial({ color: thread_, transparent: true, opacity: 0.9 });
    this.rimMaterial_ = new LineBasicMaterial({ color: selected, depthTest: false, transparent: true });
    this.litMaterial_ = new PointsMaterial({ color: selected, size: 6, sizeAttenuation: false, depthTest: false });
  }

  /** Draws lines upon this surface, until it is cleared. */
  set(topology: ClothTopology, surface: BufferGeometry): void {
    const { vertexCount, triangles, sewn } = topology;
    const rim = rimEdges(triangles, vertexCount);
    this.drawn_ = {
      topology,
      rim,
      seams: this.addLines(surface, seamEdges(rim, sewn), this.seamMaterial_, 1),
      threads: this.addLines(surface, sewn, this.threadMaterial_, 2),
      wires: this.addLines(surface, allEdges(triangles, vertexCount), this.wireMaterial_, 1),
      rimOfPiece: this.addLines(surface, new Uint32Array(0), this.rimMaterial_, 3),
      litSeam: this.addLitSeam(surface),
    };
    this.drawn_.seams.visible = this.seamsShown_;
    this.drawn_.wires.visible = this.wiresShown_;
  }

  /** The group is emptied by whoever owns it. */
  clear(): void {
    if (!this.drawn_) return;
    const { seams, threads, wires, rimOfPiece, litSeam } = this.drawn_;
    for (const lines of [seams, threads, wires, rimOfPiece, litSeam]) lines.geometry.dispose();
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
    const { litSeam, topology, rim } = this.drawn_;
    const vertices = verticesAlong(parts, topology, rim);
    litSeam.geometry.setIndex(new BufferAttribute(new Uint32Array(vertices), 1));
    litSeam.visible = vertices.length > 0;
  }

  outlinePiece(piece: TopologyPiece | undefined): void {
    if (!this.drawn_) return;
    const { rim, rimOfPiece } = this.drawn_;
    const inside = (v: number): boolean => !!piece && v >= piece.firstVertex && v < piece.firstVertex + piece.vertexCount;
    const edges: number[] = [];
    for (let i = 0; i < rim.length; i += 2) if (inside(rim[i]!)) edges.push(rim[i]!, rim[i + 1]!);
    rimOfPiece.geometry.setIndex(new BufferAttribute(new Uint32Array(edges), 1));
    rimOfPiece.visible = edges.length > 0;
  }

  dispose(): void {
    this.clear();
    for (const material of [
      this.seamMaterial_,
      this.wireMaterial_,
      this.threadMaterial_,
      this.rimMaterial_,
      this.litMaterial_,
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

  private addLitSeam(surface: BufferGeometry): Points {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', surface.getAttribute('position'));
    const points = new Points(geometry, this.litMaterial_);
    points.renderOrder = 4;
    points.frustumCulled = false;
    this.group_.add(points);
    return points;
  }
}
