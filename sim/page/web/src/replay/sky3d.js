// The sky: haze at the horizon, blue above.

import { BackSide, Color, Float32BufferAttribute, Mesh, MeshBasicMaterial, SphereGeometry } from 'three';

const RADIUS_M = 900;
export const HORIZON = 0xdfe5ea;
const ZENITH = 0x7fa9d6;

/** A dome that is carried along with the camera. */
export function makeSky() {
  const geometry = new SphereGeometry(RADIUS_M, 24, 48);
  geometry.rotateX(Math.PI / 2); // its axis upright
  const { position } = geometry.attributes;
  const low = new Color(HORIZON),
    high = new Color(ZENITH);
  const colours = [];
  for (let i = 0; i < position.count; ++i) {
    const up = Math.max(0, position.getZ(i) / RADIUS_M);
    colours.push(...low.clone().lerp(high, up ** 0.6).toArray());
  }
  geometry.setAttribute('color', new Float32BufferAttribute(colours, 3));
  const sky = new Mesh(
    geometry,
    new MeshBasicMaterial({ vertexColors: true, side: BackSide, fog: false, depthWrite: false }),
  );
  sky.renderOrder = -1;
  sky.frustumCulled = false;
  return sky;
}
