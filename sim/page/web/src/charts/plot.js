// The parts of Observable Plot that the page uses, so that the bundle holds no others.
export {
  axisX,
  axisY,
  barX,
  dot,
  frame,
  gridX,
  gridY,
  plot,
  pointer,
  rectY,
  ruleX,
  ruleY,
  text,
  tickX,
  tip,
  vector,
} from '@observablehq/plot';
