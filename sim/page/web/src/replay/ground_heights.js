// Heights of the ground over time: the grid at the start, then the cells that changed.

import { readChannel } from '../channels.js';

export class GroundHeights {
  /** @param {any} ground @param {import('../payload.js').Blobs} blobs */
  constructor(ground, blobs) {
    this.columns = ground.columns;
    this.rows = ground.rows;
    this.x0 = ground.x0_m;
    this.y0 = ground.y0_m;
    this.cell = ground.cell_m;
    const count = this.columns * this.rows;
    this.first = ground.heights
      ? Float32Array.from(readChannel(blobs, ground.heights, count))
      : new Float32Array(count);
    this.now = this.first.slice();
    this.changes = (ground.changes ?? []).map((/** @type {any} */ change) => {
      const cells = readChannel(blobs, change.cells);
      return { sample: change.sample, cells, heights: readChannel(blobs, change.heights, cells.length) };
    });
    this.applied = 0;
  }

  /**
   * Brings the heights to a sample. Answers the vertices that changed since the last call.
   * @param {number} sample
   * @returns {Set<number>}
   */
  goTo(sample) {
    const changed = new Set();
    let wanted = 0;
    while (wanted < this.changes.length && this.changes[wanted].sample <= sample) ++wanted;
    if (wanted < this.applied) {
      for (let i = 0; i < this.applied; ++i) for (const cell of this.changes[i].cells) changed.add(cell);
      for (const cell of changed) this.now[cell] = this.first[cell];
      this.applied = 0;
    }
    for (; this.applied < wanted; ++this.applied) {
      const { cells, heights } = this.changes[this.applied];
      for (let i = 0; i < cells.length; ++i) {
        if (!(cells[i] >= 0 && cells[i] < this.now.length)) continue;
        this.now[cells[i]] = heights[i];
        changed.add(cells[i]);
      }
    }
    return changed;
  }

  /** Height at a point, of the nearest vertex. @param {number} x @param {number} y */
  at(x, y) {
    const column = Math.min(this.columns - 1, Math.max(0, Math.round((x - this.x0) / this.cell)));
    const row = Math.min(this.rows - 1, Math.max(0, Math.round((y - this.y0) / this.cell)));
    return this.now[row * this.columns + column];
  }
}
