// The ground in three dimensions: its grid with ruts that grow, and level ground from there to the horizon.

import { BufferAttribute, BufferGeometry, CircleGeometry, Group, Mesh } from 'three';
import { GroundHeights } from './ground_heights.js';
import { soilMaterial } from './soil_material.js';

const SAND = [0.72, 0.62, 0.48]; // linear
const DEEPEST_M = 0.035; // ruts this deep are darkest
const HORIZON_M = 800;
const RINGS_M = [1.5, 6, 30, HORIZON_M]; // from the grid's edge outwards

/**
 * @param {any} ground @param {import('../payload.js').Blobs} blobs @param {number[]} extent
 * @param {{colour?: number[], sharpness: number}} look
 */
export function makeGround(ground, blobs, extent, look) {
  const group = new Group();
  const material = soilMaterial(shown(look.colour), look.sharpness);
  if (!ground) {
    const plain = new Mesh(whitened(new CircleGeometry(HORIZON_M, 64)), material);
    plain.position.set((extent[0] + extent[2]) / 2, (extent[1] + extent[3]) / 2, 0);
    plain.receiveShadow = true;
    group.add(plain);
    return { group, goTo: () => {}, at: () => 0 };
  }
  const heights = new GroundHeights(ground, blobs);
  const surface = new Surface(heights, material);
  const around = new Mesh(surroundings(heights), material);
  around.receiveShadow = true;
  around.frustumCulled = false;
  group.add(surface.mesh, around);
  return {
    group,
    goTo: (/** @type {number} */ sample) => surface.goTo(sample),
    at: (/** @type {number} */ x, /** @type {number} */ y) => heights.at(x, y),
  };
}

/** A soil's colour as bright as a page's image needs it; its hue stays. @param {number[] | undefined} colour */
function shown(colour) {
  if (!colour) return SAND;
  const bright = 0.2126 * colour[0] + 0.7152 * colour[1] + 0.0722 * colour[2];
  const gain = bright > 0 ? Math.min(0.55 / bright, 1.9) : 1;
  return colour.map((c) => Math.min(0.9, c * gain));
}

/** With white at each vertex, as the material's colours of vertices need it. @param {any} geometry */
function whitened(geometry) {
  const count = geometry.attributes.position.count;
  return geometry.setAttribute('color', new BufferAttribute(new Float32Array(3 * count).fill(1), 3));
}

/**
 * Rings from the edge of the grid, at its heights, out to the horizon, level: no edge is visible.
 * @param {GroundHeights} heights
 */
function surroundings({ columns, rows, x0, y0, cell, first }) {
  const edge = [];
  for (let c = 0; c < columns; ++c) edge.push([c, 0]);
  for (let r = 1; r < rows; ++r) edge.push([columns - 1, r]);
  for (let c = columns - 2; c >= 0; --c) edge.push([c, rows - 1]);
  for (let r = rows - 2; r > 0; --r) edge.push([0, r]);
  const half_x = ((columns - 1) * cell) / 2,
    half_y = ((rows - 1) * cell) / 2;
  const level = edge.reduce((sum, [c, r]) => sum + first[r * columns + c], 0) / edge.length;
  const positions = [],
    index = [];
  for (const out of [0, ...RINGS_M]) {
    for (const [c, r] of edge) {
      const x = c * cell - half_x,
        y = r * cell - half_y;
      positions.push(x0 + half_x + x * (1 + out / half_x), y0 + half_y + y * (1 + out / half_y));
      positions.push(out === 0 ? first[r * columns + c] : level);
    }
  }
  for (let ring = 0; ring < RINGS_M.length; ++ring) {
    for (let i = 0; i < edge.length; ++i) {
      const a = ring * edge.length + i,
        b = ring * edge.length + ((i + 1) % edge.length);
      index.push(a, a + edge.length, b + edge.length, a, b + edge.length, b);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute('position', new BufferAttribute(Float32Array.from(positions), 3));
  const normals = new Float32Array(positions.length);
  for (let i = 2; i < normals.length; i += 3) normals[i] = 1;
  geometry.setAttribute('normal', new BufferAttribute(normals, 3));
  geometry.setIndex(index);
  return whitened(geometry);
}

class Surface {
  /** @param {GroundHeights} heights @param {any} material */
  constructor(heights, material) {
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
    this.mesh = new Mesh(geometry, material);
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

  /** Height, slope and shade of one vertex. @param {number} i */
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
    const shade = 1 - 0.6 * depth;
    this.colours.set([shade, shade, shade], 3 * i);
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
