// The cloth in the scene: one mesh over all pieces, as it looks or coloured by a map, with lines upon it (ClothLines).

import {
  BufferAttribute,
  BufferGeometry,
  Color,
  DoubleSide,
  DynamicDrawUsage,
  Group,
  Mesh,
  MeshStandardMaterial,
  type Intersection,
  type Material,
} from 'three';
import type { ClothTopology, TopologyPiece } from '../api/frames';
import { bandOf, kBands, type ClothMap } from '../state/clothMaps';
import type { SeamPart } from '../state/seamView';
import { fillRepeats, type Look } from '../state/texture';
import { kPlainFinish, type Finish } from '../state/fabrics';
import { ClothLines } from './ClothLines';
import { ClothMaterials } from './ClothMaterials';
import { PrintMaterials } from './PrintMaterials';
import { byMaterial, shareNormals, vertexNormals, weldGroups, widestGap, type WeldGroups } from './surface';
import { seamLines, type SeamLines } from './seamLines';
import { kTileMetres } from './weave';

/** m; seams of thicker cloth are stitched down, this far beside them. */
const kStitchedDown = 0.00065;
const kBeside = 0.005;

const kBandColours = kBands.map((band) => new Color(band));
/** Of cloth of which the map can say nothing. */
const kUnknown = new Color('#999999');

export interface ClothColours {
  thread: Color;
  selected: Color;
  hovered: Color;
}

export class ClothObject {
  readonly group = new Group();
  /** m, the widest gap of the newest frame. */
  gap = 0;

  private topology_: ClothTopology | null = null;
  private welds_: WeldGroups | null = null;
  private geometry_ = new BufferGeometry();
  private seamLines_: SeamLines | null = null;
  private readonly cloths_ = new ClothMaterials();
  private finishes_: ReadonlyMap<string, Finish> = new Map();
  private mesh_: Mesh | null = null;
  private selected_: string | null = null;
  private hovered_: string | null = null;
  private map_: ClothMap | null = null;
  private readonly mapMaterial_ = new MeshStandardMaterial({ side: DoubleSide, vertexColors: true, roughness: 1 });
  private looks_: ReadonlyMap<string, Look> = new Map();
  private readonly prints_: PrintMaterials;
  private readonly lines_: ClothLines;
  private litParts_: readonly SeamPart[] = [];

  constructor(private readonly colours_: ClothColours) {
    this.prints_ = new PrintMaterials(this.cloths_);
    this.lines_ = new ClothLines(this.group, colours_.thread, colours_.selected);
    this.addStandIn();
  }

  get topology(): ClothTopology | null {
    return this.topology_;
  }

  setTopology(topology: ClothTopology | null): void {
    this.clear();
    this.topology_ = topology;
    if (!topology) return;
    this.welds_ = weldGroups(topology.sewn, topology.vertexCount);
    this.addSurface(topology);
    this.lines_.set(topology, this.geometry_);
    this.group.visible = false; // until the first positions are there
    this.paint();
  }

  /** Shows these positions; they are copied into the one buffer that all parts draw from. */
  setPositions(positions: Float32Array): void {
    if (!this.topology_ || !this.welds_ || positions.length !== 3 * this.topology_.vertexCount) return;
    const attribute = this.geometry_.getAttribute('position') as BufferAttribute;
    const normal = this.geometry_.getAttribute('normal') as BufferAttribute;
    (attribute.array as Float32Array).set(positions);
    attribute.needsUpdate = true;
    vertexNormals(positions, this.topology_.triangles, normal.array as Float32Array);
    shareNormals(positions, this.welds_, normal.array as Float32Array);
    normal.needsUpdate = true;
    this.geometry_.boundingSphere = null;
    this.gap = widestGap(positions, this.topology_.sewn);
    this.lines_.setGap(this.gap);
    this.group.visible = true;
  }

  get positions(): Float32Array | null {
    const attribute = this.geometry_.getAttribute('position') as BufferAttribute | undefined;
    return this.group.visible && attribute ? (attribute.array as Float32Array) : null;
  }

  highlight(selected: string | null, hovered: string | null): void {
    this.selected_ = selected;
    this.hovered_ = hovered;
    this.paint();
  }

  /** Pictures on pieces, by the pieces' ids. */
  setLooks(looks: ReadonlyMap<string, Look>): void {
    if (looks === this.looks_) return;
    this.looks_ = looks;
    this.dress();
    this.paint();
  }

  /** How light plays on pieces, by the pieces' ids. */
  setFinishes(finishes: ReadonlyMap<string, Finish>): void {
    if (finishes === this.finishes_) return;
    this.finishes_ = finishes;
    this.dress();
  }

  /** Colours by a map in place of cloth and pictures; null: as it looks. */
  setMap(map: ClothMap | null): void {
    if (map === this.map_) return;
    const turned = (map === null) !== (this.map_ === null);
    this.map_ = map;
    if (turned) this.dress();
    this.lines_.showSeams(map !== null);
    this.paint();
  }

  /** The map's value at a hit of the surface; NaN without a map. */
  valueAt(hit: Intersection): number {
    return this.map_?.values[hit.face?.a ?? -1] ?? NaN;
  }

  /** Draws the vertices along a seam's sides as a dotted line, faint where something lies before it. */
  lightSeam(parts: readonly SeamPart[]): void {
    this.litParts_ = parts;
    this.lines_.outlineSeam(parts);
  }

  /** In this colour, or in the usual one. */
  colourThreads(colour: Color | null): void {
    this.lines_.colourThreads(colour);
  }

  /** Whether its threads are drawn. */
  setFine(fine: boolean): void {
    this.cloths_.setFine(fine);
  }

  showWires(shown: boolean): void {
    this.lines_.showWires(shown);
  }

  get mesh(): Mesh | null {
    return this.mesh_;
  }

  /** The piece under a hit of the surface. */
  pieceAt(hit: Intersection): string | null {
    const vertex = hit.face?.a ?? -1;
    return (
      this.topology_?.pieces.find(
        (piece) => vertex >= piece.firstVertex && vertex < piece.firstVertex + piece.vertexCount,
      )?.id ?? null
    );
  }

  dispose(): void {
    this.clear();
    this.cloths_.dispose();
    this.prints_.dispose();
    this.lines_.dispose();
    this.mapMaterial_.dispose();
  }

  private clear(): void {
    this.group.clear();
    this.geometry_.dispose();
    this.lines_.clear();
    this.geometry_ = new BufferGeometry();
    this.mesh_ = null;
    this.seamLines_ = null;
    this.group.visible = false;
  }

  /** A triangle that is never seen: with it the shaders are made before the first frame needs them. */
  private addStandIn(): void {
    const names = [
      ['position', 3],
      ['normal', 3],
      ['color', 3],
      ['uv', 2],
      ['lineDistance', 4],
      ['lineAlong', 4],
      ['lineKind', 4],
      ['make', 3],
    ] as const;
    for (const [name, size] of names)
      this.geometry_.setAttribute(name, new BufferAttribute(new Float32Array(3 * size), size));
    const surface = new Mesh(this.geometry_, this.cloths_.of());
    surface.castShadow = true;
    surface.receiveShadow = true;
    this.group.add(surface, this.lines_.standIn(this.geometry_));
  }

  /** Gives each piece its weave or its picture: triangles in groups by their material. */
  private dress(): void {
    if (!this.topology_ || !this.mesh_) return;
    const { triangles, rest, pieces, vertexCount } = this.topology_;
    const uv = this.geometry_.getAttribute('uv') as BufferAttribute;
    const coordinates = uv.array as Float32Array;
    coordinates.set(rest.map((metres) => metres / kTileMetres));
    const materials: Material[] = [];
    const materialOf = new Uint16Array(vertexCount);
    this.makeUp(pieces);
    for (const { id, firstVertex, vertexCount: count } of pieces) {
      const look = this.looks_.get(id);
      const finish = this.finishes_.get(id);
      if (look) fillRepeats(look.frame, rest, firstVertex, count, coordinates);
      const material = look ? this.prints_.of(look, finish) : this.cloths_.of(finish);
      if (!materials.includes(material)) materials.push(material);
      materialOf.fill(materials.indexOf(material), firstVertex, firstVertex + count);
    }
    this.prints_.keep(materials);
    this.cloths_.keep(materials);
    uv.needsUpdate = true;
    const { index, groups } = byMaterial(triangles, materialOf, materials.length);
    this.geometry_.setIndex(new BufferAttribute(index, 1));
    this.geometry_.clearGroups();
    for (const { start, count, material } of groups) this.geometry_.addGroup(start, count, material);
    this.mesh_.material = this.map_ ? this.mapMaterial_ : materials;
  }

  /** Thickness, hems, and stitches beside the seams of thick cloth. */
  private makeUp(pieces: readonly TopologyPiece[]): void {
    const make = this.geometry_.getAttribute('make') as BufferAttribute;
    pieces.forEach(({ id, firstVertex, vertexCount }, p) => {
      const { thickness } = this.finishes_.get(id) ?? kPlainFinish;
      const beside = thickness >= kStitchedDown ? kBeside : 0;
      for (let v = firstVertex; v < firstVertex + vertexCount; ++v)
        make.setXYZ(v, thickness, this.seamLines_?.hems[p] ?? 0, beside);
    });
    make.needsUpdate = true;
  }

  private addSurface(topology: ClothTopology): void {
    const { vertexCount } = topology;
    const dynamic = (): BufferAttribute =>
      new BufferAttribute(new Float32Array(3 * vertexCount), 3).setUsage(DynamicDrawUsage);
    this.geometry_.setAttribute('position', dynamic());
    this.geometry_.setAttribute('normal', dynamic());
    this.geometry_.setAttribute('color', new BufferAttribute(new Float32Array(3 * vertexCount), 3));
    this.geometry_.setAttribute('uv', new BufferAttribute(new Float32Array(2 * vertexCount), 2));
    this.seamLines_ = seamLines(topology);
    const { distance, along, kind } = this.seamLines_;
    this.geometry_.setAttribute('lineDistance', new BufferAttribute(distance, 4));
    this.geometry_.setAttribute('lineAlong', new BufferAttribute(along, 4));
    this.geometry_.setAttribute('lineKind', new BufferAttribute(kind, 4));
    this.geometry_.setAttribute('make', new BufferAttribute(new Float32Array(3 * vertexCount), 3));
    this.mesh_ = new Mesh(this.geometry_, this.cloths_.of());
    this.dress();
    this.mesh_.castShadow = true;
    this.mesh_.receiveShadow = true;
    this.mesh_.frustumCulled = false;
    this.group.add(this.mesh_);
  }

  private paint(): void {
    if (!this.topology_) return;
    const attribute = this.geometry_.getAttribute('color') as BufferAttribute;
    const map = this.map_?.values.length === this.topology_.vertexCount ? this.map_ : null;
    for (const piece of this.topology_.pieces) {
      if (map) {
        this.paintMap(map, piece, attribute);
        continue;
      }
      const colour = this.looks_.has(piece.id) ? new Color(1, 1, 1) : new Color().setRGB(...piece.colour);
      if (piece.id === this.selected_) colour.lerp(this.colours_.selected, 0.24);
      else if (piece.id === this.hovered_) colour.lerp(this.colours_.hovered, 0.22);
      for (let v = 0; v < piece.vertexCount; ++v) attribute.setXYZ(piece.firstVertex + v, colour.r, colour.g, colour.b);
    }
    attribute.needsUpdate = true;
    this.lines_.outlinePiece(this.topology_.pieces.find((piece) => piece.id === this.selected_));
    this.lines_.outlineSeam(this.litParts_);
  }

  private paintMap(map: ClothMap, { firstVertex, vertexCount }: TopologyPiece, attribute: BufferAttribute): void {
    for (let v = firstVertex; v < firstVertex + vertexCount; ++v) {
      const value = map.values[v]!;
      const { r, g, b } = Number.isFinite(value) ? kBandColours[bandOf(map, value)]! : kUnknown;
      attribute.setXYZ(v, r, g, b);
    }
  }
}
