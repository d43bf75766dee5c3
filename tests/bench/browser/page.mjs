// SPDX-License-Identifier: Apache-2.0
// Four exported landscapes, each in its quarter, as a page of three.js draws them that takes some care. What is planted
// more than once is instanced, by squares of the ground: those outside the view are left out, and farther ones are drawn
// by the coarser levels that were exported beside the finest ("NAME_mid", "NAME_far"), where any were. The ground is tiles
// of two levels.
// Lambert's law, fog, one sun; no shadows, textures or multisampling.
import * as THREE from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';

const square_m = 48;
const mid_m = 30, far_m = 150;  // from the nearest of a square or tile
const tile_cells = 32, coarse_cells = 4, coarse_from_m = 150;
const tell = (what, told) => fetch(`/told/${what}`, { method: 'POST', body: JSON.stringify(told) });

// Of something at some place the mesh for each distance, nearest first: [{ from_m, mesh }].
class Levels {
  constructor(sphere, levels) {
    this.sphere = sphere;
    this.levels = levels;
  }
  choose(eye) {
    const distance_m = this.sphere.distanceToPoint(eye);
    const shown = this.levels.findLast(({ from_m }) => distance_m >= from_m) ?? this.levels[0];
    for (const level of this.levels) if (level.mesh) level.mesh.visible = level === shown;
  }
}

const lambert = ({ color, side }) => new THREE.MeshLambertMaterial({ color, side });

// The ground's triangles, whose vertices lie row by row, as tiles.
function tiles_of(ground) {
  const side = Math.sqrt(ground.geometry.attributes.position.count);
  const material = lambert(ground.material);
  const tile = (row, column, step) => {
    const geometry = new THREE.BufferGeometry();
    for (const name of ['position', 'normal']) geometry.setAttribute(name, ground.geometry.attributes[name]);
    const indices = [];
    for (let y = row; y < Math.min(row + tile_cells, side - 1); y += step)
      for (let x = column; x < Math.min(column + tile_cells, side - 1); x += step) {
        const a = y * side + x, below = a + step * side;
        indices.push(a, below, a + step, a + step, below, below + step);
      }
    geometry.setIndex(indices);
    const { position } = ground.geometry.attributes;
    geometry.boundingSphere = new THREE.Sphere().setFromPoints(
      indices.map((i) => new THREE.Vector3().fromBufferAttribute(position, i)));
    return new THREE.Mesh(geometry, material);
  };
  const all = [];
  for (let row = 0; row < side - 1; row += tile_cells)
    for (let column = 0; column < side - 1; column += tile_cells) {
      const mesh = tile(row, column, 1);
      all.push(new Levels(mesh.geometry.boundingSphere,
                          [{ from_m: 0, mesh }, { from_m: coarse_from_m, mesh: tile(row, column, coarse_cells) }]));
    }
  return all;
}

// Nodes of one part in one square.
function instanced(geometry, material, nodes) {
  const mesh = new THREE.InstancedMesh(geometry, material, nodes.length);
  nodes.forEach((node, i) => mesh.setMatrixAt(i, node.matrixWorld));
  mesh.computeBoundingSphere();
  return mesh;
}

function plants_of(nodes) {
  const groups = new Map();
  const afar = new Map();
  const place = new THREE.Vector3();
  for (const node of nodes) {
    const name = node.material.name;
    if (/_(mid|far)$/.test(name)) { afar.set(name, node.geometry); continue; }
    place.setFromMatrixPosition(node.matrixWorld);
    const key = [name, Math.floor(place.x / square_m), Math.floor(place.z / square_m)].join();
    groups.set(key, [...groups.get(key) ?? [], node]);
  }
  const materials = new Map();
  return [...groups.values()].map((group) => {
    const [{ geometry, material }] = group;
    if (!materials.has(material.name)) materials.set(material.name, lambert(material));
    const level = (from_m, of) => ({ from_m, mesh: of && instanced(of, materials.get(material.name), group) });
    const mid = afar.get(`${material.name}_mid`);
    const levels = [level(0, geometry)];
    if (mid) levels.push(level(mid_m, mid));
    if (afar.size > 0) levels.push(level(far_m, afar.get(`${material.name}_far`) ?? mid));
    return new Levels(levels[0].mesh.boundingSphere, levels);
  });
}

async function scene_of(place) {
  const exported = await new GLTFLoader().loadAsync(`/scenes/${place}.glb`);
  exported.scene.updateMatrixWorld(true);
  const nodes = [];
  exported.scene.traverse((node) => { if (node.isMesh) nodes.push(node); });
  const ground = nodes.find((node) => node.material.name === 'land');
  const scene = new THREE.Scene();
  scene.background = new THREE.Color(0x9db8d8);
  scene.fog = new THREE.Fog(0x9db8d8, 100, 4000);
  const sun = new THREE.DirectionalLight(0xfff4e0, 2.5);
  sun.position.set(0.36, 0.8, 0.48);
  scene.add(sun, new THREE.HemisphereLight(0xbfd4ff, 0x554433, 1));
  const levels = [...tiles_of(ground), ...plants_of(nodes.filter((node) => node !== ground))];
  for (const { levels: meshes } of levels) for (const { mesh } of meshes) if (mesh) scene.add(mesh);
  scene.traverse((node) => { node.matrixAutoUpdate = false; });
  return { scene, levels };
}

function draw(renderer, scenes, camera, cameras, { width, height }) {
  scenes.forEach(({ scene, levels }, i) => {
    const quarter = [(i % 2) * width / 2, i < 2 ? height / 2 : 0, width / 2, height / 2];
    renderer.setViewport(...quarter);
    renderer.setScissor(...quarter);
    const { eye_m, target_m, vertical_fov_deg } = cameras[i];
    camera.fov = vertical_fov_deg;
    camera.position.set(...eye_m);
    camera.lookAt(...target_m);
    camera.updateProjectionMatrix();
    for (const one of levels) one.choose(camera.position);
    renderer.render(scene, camera);
  });
  const gl = renderer.getContext();
  gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));  // waits until all of it is drawn
}

const next_frame = () => new Promise(requestAnimationFrame);

async function show() {
  const { size, frames } = await (await fetch('/views.json')).json();
  const canvas = document.querySelector('canvas');
  const renderer = new THREE.WebGLRenderer({ canvas, antialias: false });
  renderer.setPixelRatio(1);
  renderer.setSize(size.width, size.height);
  renderer.setScissorTest(true);
  renderer.info.autoReset = false;
  const gl = renderer.getContext();
  const names = gl.getExtension('WEBGL_debug_renderer_info');
  const scenes = await Promise.all([0, 1, 2, 3].map(scene_of));
  const camera = new THREE.PerspectiveCamera(42, size.width / size.height, 0.5, 12000);
  draw(renderer, scenes, camera, frames[0], size);
  await tell('first', { built_ms: performance.now(), renderer: gl.getParameter(names.UNMASKED_RENDERER_WEBGL) });
  const frame_ms = [];
  for (const cameras of frames) {
    await next_frame();
    renderer.info.reset();
    const begun_ms = performance.now();
    draw(renderer, scenes, camera, cameras, size);
    frame_ms.push(performance.now() - begun_ms);
  }
  draw(renderer, scenes, camera, frames[0], size);
  await tell('frames', { frame_ms, triangles: renderer.info.render.triangles / 2, picture: canvas.toDataURL() });
}

show().catch((error) => tell('failed', { why: String(error) }));
