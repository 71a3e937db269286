// The material of the ground: grain, pebbles and patches over the whole site, and a line at each metre.

import {
  DataTexture,
  LinearFilter,
  LinearMipmapLinearFilter,
  MeshLambertMaterial,
  RedFormat,
  RepeatWrapping,
  UnsignedByteType,
} from 'three';

const SIZE = 512; // texels, across GRAIN_M of ground: 3 mm each
const GRAIN_M = 1.5;
const PATCH_M = 19; // the same texture, wide: no square of it repeats its neighbour
const PEBBLES = 420;

/** @type {DataTexture | null} */
let made = null;

/** Numbers from 0 to 1, the same in each browser. @param {number} seed */
function randoms(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Smooth noise that repeats after SIZE. @param {Float32Array} into @param {number} cells @param {number} weight @param {() => number} random */
function addNoise(into, cells, weight, random) {
  const lattice = Float32Array.from({ length: cells * cells }, () => random() - 0.5);
  const at = (/** @type {number} */ x, /** @type {number} */ y) => lattice[(y % cells) * cells + (x % cells)];
  const step = cells / SIZE;
  for (let row = 0; row < SIZE; ++row) {
    const y = Math.floor(row * step),
      v = smooth(row * step - y);
    for (let column = 0; column < SIZE; ++column) {
      const x = Math.floor(column * step),
        u = smooth(column * step - x);
      const low = at(x, y) + u * (at(x + 1, y) - at(x, y)),
        high = at(x, y + 1) + u * (at(x + 1, y + 1) - at(x, y + 1));
      into[row * SIZE + column] += weight * (low + v * (high - low));
    }
  }
}

/** @param {number} t */
function smooth(t) {
  return t * t * (3 - 2 * t);
}

/** Bright on one side, dark on the other, as the sun has them. @param {Float32Array} into @param {() => number} random */
function addPebbles(into, random) {
  for (let i = 0; i < PEBBLES; ++i) {
    const x0 = random() * SIZE,
      y0 = random() * SIZE,
      radius = 1.2 + 4 * random() ** 4,
      shade = 0.5 * (random() - 0.5);
    const reach = Math.ceil(radius + 1);
    for (let dy = -reach; dy <= reach; ++dy) {
      for (let dx = -reach; dx <= reach; ++dx) {
        const share = Math.min(1, Math.max(0, radius - Math.hypot(dx, dy)));
        if (share === 0) continue;
        const column = (Math.floor(x0) + dx + SIZE) % SIZE,
          row = (Math.floor(y0) + dy + SIZE) % SIZE;
        into[row * SIZE + column] += share * (shade + (0.35 * (dx + dy)) / radius);
      }
    }
  }
}

/** Grain as one channel about the middle of its range. */
function grainTexture() {
  if (made) return made;
  const random = randoms(20130506);
  const tones = new Float32Array(SIZE * SIZE);
  for (const [cells, weight] of [
    [4, 0.3],
    [8, 0.3],
    [16, 0.28],
    [32, 0.24],
    [64, 0.22],
    [128, 0.24],
    [256, 0.34],
    [512, 0.3],
  ])
    addNoise(tones, cells, weight, random);
  addPebbles(tones, random);
  const bytes = Uint8Array.from(tones, (t) => Math.max(0, Math.min(255, 127.5 + 127.5 * t)));
  made = new DataTexture(bytes, SIZE, SIZE, RedFormat, UnsignedByteType);
  made.wrapS = made.wrapT = RepeatWrapping;
  made.magFilter = LinearFilter;
  made.minFilter = LinearMipmapLinearFilter;
  made.generateMipmaps = true;
  made.needsUpdate = true;
  return made;
}

/**
 * @param {number[]} colour of the soil, linear
 * @param {number} sharpness texels that are averaged along a flat view: more is slower
 */
export function soilMaterial(colour, sharpness) {
  const material = new MeshLambertMaterial({ vertexColors: true });
  material.color.setRGB(colour[0], colour[1], colour[2]);
  const soil = grainTexture();
  soil.anisotropy = sharpness;
  material.onBeforeCompile = (shader) => {
    shader.uniforms.soil = { value: soil };
    shader.vertexShader = shader.vertexShader
      .replace('#include <common>', '#include <common>\nvarying vec2 vSite;')
      .replace(
        '#include <project_vertex>',
        '#include <project_vertex>\nvSite = (modelMatrix * vec4(transformed, 1.0)).xy;',
      );
    shader.fragmentShader = shader.fragmentShader
      .replace('#include <common>', '#include <common>\nvarying vec2 vSite;\nuniform sampler2D soil;')
      .replace('#include <color_fragment>', `#include <color_fragment>\n${TONE}`);
  };
  return material;
}

const TONE = `
  float grain = texture2D(soil, vSite / ${GRAIN_M.toFixed(1)}).r - 0.5;
  float patches = texture2D(soil, vSite / ${PATCH_M.toFixed(1)} + 0.31).r - 0.5;
  vec2 width = fwidth(vSite);
  vec2 off = abs(fract(vSite - 0.5) - 0.5) / max(width, vec2(1e-5));
  float metre = (1.0 - min(min(off.x, off.y), 1.0)) * clamp(1.0 - 4.0 * max(width.x, width.y), 0.0, 1.0);
  diffuseColor.rgb *= (1.0 + 0.75 * grain) * (1.0 + 0.5 * patches) * (1.0 - 0.14 * metre);
`;
