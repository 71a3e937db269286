// The ground in three dimensions: its grid with ruts that grow, and a plane around it.

import { BufferAttribute, BufferGeometry, Group, Mesh, MeshLambertMaterial, CircleGeometry } from 'three';
import { GroundHeights } from './ground_heights.js';

const SAND = [0.72, 0.62, 0.48]; // linear
const DEEPEST_M = 0.035; // ruts this deep are darkest

/** @param {any} ground @param {import('../payload.js').Blobs} blobs @param {number[]} extent */
export function makeGround(ground, blobs, extent) {
  const group = new Group();
  const plain = new Mesh(new CircleGeometry(60, 48), new MeshLambertMaterial());
  plain.material.color.setRGB(SAND[0], SAND[1], SAND[2]);
  plain.position.set((extent[0] + extent[2]) / 2, (extent[1] + extent[3]) / 2, 0);
  plain.receiveShadow = true;
  group.add(plain);
  if (!ground) return { group, goTo: () => {}, at: () => 0 };
  const heights = new GroundHeights(ground, blobs);
  const surface = new Surface(heights);
  plain.position.z = heights.first.reduce((low, z) => Math.min(low, z), Infinity) - 0.03;
  group.add(surface.mesh);
  return {
    group,
    goTo: (/** @type {number} */ sample) => surface.goTo(sample),
    at: (/** @type {number} */ x, /** @type {number} */ y) => heights.at(x, y),
  };
}

class Surface {
  /** @param {GroundHeights} heights */
  constructor(heights) {
    this.heights = heights;
    const { columns, rows, x0, y0, cell } = heights;
    const count = columns * rows;
    this.positions = new Float32Array(3 * count);
    this.normals = new Float32Array(3 * count);
    this.colours = new Float32Array(3 * count);
    for (let i = 0; i < count; ++i) {
      this.positions[3 * i] = x0 + (i % columns) * cell;
      this.positions[3 * i + 1] = y0 + Math.floor(i / columns) * cell;
    }
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(this.positions, 3));
    geometry.setAttribute('normal', new BufferAttribute(this.normals, 3));
    geometry.setAttribute('color', new BufferAttribute(this.colours, 3));
    geometry.setIndex(new BufferAttribute(gridTriangles(columns, rows), 1));
    this.mesh = new Mesh(geometry, new MeshLambertMaterial({ vertexColors: true }));
    this.mesh.receiveShadow = true;
    this.mesh.frustumCulled = false;
    for (let i = 0; i < count; ++i) this.refresh(i);
  }

  /** @param {number} sample */
  goTo(sample) {
    const changed = this.heights.goTo(sample);
    if (changed.size === 0) return;
    const { columns } = this.heights;
    const touched = new Set();
    for (const cell of changed) for (const step of [0, 1, -1, columns, -columns]) touched.add(cell + step);
    for (const vertex of touched) this.refresh(vertex);
    for (const name of ['position', 'normal', 'color'])
      this.mesh.geometry.attributes[name].needsUpdate = true;
  }

  /** Height, slope and colour of one vertex. @param {number} i */
  refresh(i) {
    const { columns, rows, cell, now, first } = this.heights;
    if (i < 0 || i >= now.length) return;
    const column = i % columns,
      row = (i - column) / columns;
    const left = column > 0 ? now[i - 1] : now[i],
      right = column < columns - 1 ? now[i + 1] : now[i];
    const below = row > 0 ? now[i - columns] : now[i],
      above = row < rows - 1 ? now[i + columns] : now[i];
    const nx = (left - right) / (2 * cell),
      ny = (below - above) / (2 * cell);
    const size = Math.hypot(nx, ny, 1);
    this.positions[3 * i + 2] = now[i];
    this.normals.set([nx / size, ny / size, 1 / size], 3 * i);
    const depth = Math.min(1, Math.max(-0.4, (first[i] - now[i]) / DEEPEST_M));
    const shade = (1 - 0.6 * depth) * this.scaleLine(column, row);
    this.colours.set([SAND[0] * shade, SAND[1] * shade, SAND[2] * shade], 3 * i);
  }

  /** A slightly darker line at each metre. @param {number} column @param {number} row */
  scaleLine(column, row) {
    const { x0, y0, cell } = this.heights;
    const off = (/** @type {number} */ v) => Math.abs(v - Math.round(v));
    return off(x0 + column * cell) < cell / 2 || off(y0 + row * cell) < cell / 2 ? 0.9 : 1;
  }
}

/** @param {number} columns @param {number} rows */
function gridTriangles(columns, rows) {
  const index = new Uint32Array(6 * (columns - 1) * (rows - 1));
  let n = 0;
  for (let row = 0; row + 1 < rows; ++row) {
    for (let column = 0; column + 1 < columns; ++column) {
      const a = row * columns + column,
        b = a + 1,
        c = a + columns,
        d = c + 1;
      index[n++] = a;
      index[n++] = b;
      index[n++] = d;
      index[n++] = a;
      index[n++] = d;
      index[n++] = c;
    }
  }
  return index;
}
