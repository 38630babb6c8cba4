// Lines that are some pixels wide, which lines of WebGL are not.

import { Color, Vector2 } from 'three';
import { LineMaterial } from 'three/examples/jsm/lines/LineMaterial.js';
import { LineSegments2 } from 'three/examples/jsm/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/examples/jsm/lines/LineSegmentsGeometry.js';

/** Lines of so many pixels, to be filled. */
export function fatLines(colour: string, pixels: number): LineSegments2 {
  const lines = new LineSegments2(
    new LineSegmentsGeometry(),
    new LineMaterial({ color: new Color(colour).getHex(), linewidth: pixels }),
  );
  lines.frustumCulled = false;
  lines.visible = false;
  return lines;
}

/** xyz of both ends of each line, one after the other. */
export function setSegments(lines: LineSegments2, points: number[]): void {
  lines.visible = points.length > 0;
  if (points.length === 0) return;
  lines.geometry.dispose();
  lines.geometry = new LineSegmentsGeometry().setPositions(points);
}

/** They are as wide as they are said in pixels of a picture of this size. */
export function fitLines(lines: LineSegments2, width: number, height: number): void {
  lines.material.resolution = new Vector2(width, height);
}

export function disposeLines(lines: LineSegments2): void {
  lines.geometry.dispose();
  lines.material.dispose();
}
