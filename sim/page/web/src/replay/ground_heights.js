// Heights of the ground over time: the grid at the start, then the cells that changed.

const STEP_M = 0.0001; // metres a step of the stored heights

export class GroundHeights {
  /** @param {any} ground @param {import('../payload.js').Blobs} blobs */
  constructor(ground, blobs) {
    this.columns = ground.columns;
    this.rows = ground.rows;
    this.x0 = ground.x0_m;
    this.y0 = ground.y0_m;
    this.cell = ground.cell_m;
    const count = this.columns * this.rows;
    const stored = ground.heights ? blobs.i16(ground.heights) : new Int16Array(count);
    if (stored.length !== count) throw new Error('the ground of the data is damaged');
    this.first = Float32Array.from(stored, (v) => v * STEP_M);
    this.now = this.first.slice();
    this.changes = (ground.changes ?? []).map((/** @type {any} */ change) => ({
      sample: change.sample,
      cells: blobs.u32(change.cells),
      heights: blobs.i16(change.heights),
    }));
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
        if (cells[i] >= this.now.length) continue;
        this.now[cells[i]] = heights[i] * STEP_M;
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
