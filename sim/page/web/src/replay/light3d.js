// Sun and sky of the replay in three dimensions.

import { AmbientLight, DirectionalLight, HemisphereLight } from 'three';

/** @param {import('three').Scene} scene @param {import('./tracks.js').Tracks} tracks */
export function addLight(scene, tracks) {
  const sun = new DirectionalLight(0xfff4e2, 2.6);
  const [x, y, z] = tracks.scene.sun_W ?? [0.4, -0.5, 0.8];
  sun.position.set(x, y, Math.max(0.25, z)).multiplyScalar(20);
  castShadows(sun, tracks.extent());
  const sky = new HemisphereLight(0xcfdcec, 0x8d7d68, 1.3);
  sky.position.set(0, 0, 1); // the world's z is up
  scene.add(sun, sun.target, sky, new AmbientLight(0xffffff, 0.25));
}

/** The sun's shadows cover all that moves. @param {DirectionalLight} sun @param {number[]} extent */
function castShadows(sun, [x0, y0, x1, y1]) {
  const reach = Math.hypot(x1 - x0, y1 - y0) / 2 + 1.5;
  sun.target.position.set((x0 + x1) / 2, (y0 + y1) / 2, 0);
  sun.position.add(sun.target.position);
  sun.castShadow = true;
  sun.shadow.mapSize.set(2048, 2048);
  sun.shadow.normalBias = 0.01;
  Object.assign(sun.shadow.camera, {
    left: -reach,
    right: reach,
    top: reach,
    bottom: -reach,
    near: 1,
    far: 40,
  });
}
