// A board of marks as an image: white plate, black discs, white bars, tags, holes.

/** @param {any} board @returns {HTMLCanvasElement} */
export function paintBoard(board) {
  const scale = 1024 / Math.max(board.width_m, board.height_m);
  const canvas = document.createElement('canvas');
  canvas.width = Math.round(board.width_m * scale);
  canvas.height = Math.round(board.height_m * scale);
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  context.scale(scale, scale);
  context.translate(board.width_m / 2, board.height_m / 2); // x right, y down, as in B
  context.fillStyle = '#f2f2ee';
  context.fillRect(-board.width_m / 2, -board.height_m / 2, board.width_m, board.height_m);
  for (const disc of board.discs ?? []) paintDisc(context, disc);
  for (const tag of board.tags ?? []) paintTag(context, tag);
  context.globalCompositeOperation = 'destination-out';
  for (const hole of board.holes ?? []) circle(context, hole);
  return canvas;
}

/** @param {CanvasRenderingContext2D} context @param {any} disc */
function paintDisc(context, disc) {
  context.fillStyle = '#161616';
  circle(context, disc);
  if (!disc.bar) return;
  context.save();
  context.translate(disc.x, disc.y);
  context.rotate(-disc.bar.turn); // counter-clockwise for the beholder, where y points down
  context.fillStyle = '#f2f2ee';
  context.fillRect(-disc.bar.length / 2, -disc.bar.width / 2, disc.bar.length, disc.bar.width);
  context.restore();
}

/** @param {CanvasRenderingContext2D} context @param {any} tag */
function paintTag(context, tag) {
  const { cell, across } = tag;
  context.save();
  context.translate(tag.x, tag.y);
  context.rotate(-tag.turn);
  context.fillStyle = '#161616';
  for (let i = 0; i < across * across; ++i) {
    if (tag.black[i] !== '1') continue;
    const column = i % across;
    const row = (i - column) / across;
    context.fillRect((column - across / 2) * cell, (row - across / 2) * cell, cell, cell);
  }
  context.restore();
}

/** @param {CanvasRenderingContext2D} context @param {{x: number, y: number, radius: number}} at */
function circle(context, at) {
  context.beginPath();
  context.arc(at.x, at.y, at.radius, 0, 2 * Math.PI);
  context.fill();
}
