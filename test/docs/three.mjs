/** For docs/three.md: what it names and does not show. */
import assert from 'node:assert/strict';
import { createRequire } from 'node:module';
import { adapter } from './engine.mjs';

const THREE = createRequire(new URL('../../js/module/package.json', import.meta.url))('three');

export const AnimationMixer = THREE.AnimationMixer;
export const BoxGeometry = THREE.BoxGeometry;
export const DoubleSide = THREE.DoubleSide;
export const Group = THREE.Group;
export const Mesh = THREE.Mesh;
export const MeshStandardMaterial = THREE.MeshStandardMaterial;
export const heroMesh = new THREE.Mesh(new THREE.CapsuleGeometry(0.3, 1.2).translate(0, 0.9, 0));
export const hills = new THREE.Mesh(new THREE.PlaneGeometry(80, 80).rotateX(-Math.PI / 2));
export const Raycaster = THREE.Raycaster;
export const Vector2 = THREE.Vector2;
export const Vector3 = THREE.Vector3;
export const SphereGeometry = THREE.SphereGeometry;
export const scene = new THREE.Scene();
export const levelScene = new THREE.Mesh(new THREE.BoxGeometry(40, 1, 40).translate(0, -0.5, 0));
export const camera = new THREE.PerspectiveCamera();
camera.position.set(3, 6, 4);
camera.lookAt(5, 0, 7);
export const mark = new THREE.Object3D();
export const canvas = Object.assign(new EventTarget(), { clientWidth: 800, clientHeight: 600 });
export const gltf = { scene: new THREE.Group() };
const body = new THREE.Mesh(new THREE.CapsuleGeometry(3, 10));
body.position.y = 8;
gltf.scene.add(body);

const skin = new THREE.BoxGeometry(1, 2, 1).translate(0, 1, 0);
const corners = skin.attributes.position.count;
skin.setAttribute('skinIndex', new THREE.Uint16BufferAttribute(new Uint16Array(4 * corners), 4));
skin.setAttribute('skinWeight', new THREE.Float32BufferAttribute(Array.from({ length: 4 * corners }, (_, i) => (i % 4 === 0 ? 1 : 0)), 4));
const skinned = new THREE.SkinnedMesh(skin);
const bone = new THREE.Bone();
skinned.add(bone);
skinned.bind(new THREE.Skeleton([bone]));
/** A figure with one bone, which moves all of it. */
export const figure = new THREE.Group().add(skinned);

/** Whether the samples have done what the page says. */
export async function check({ frame, bear, other, drawn, collision, wireframe, standing, terrain, ground, hit, drawnFace, level, crate, crateMesh, heroGroup, coin, coinMesh, greatLand, placeCamera, openRoom, closedRoom, enemy, moveEnemy, queries, pickedAt }) {
	let calls = 0;
	collision.onCollision('bears', 'bears', () => calls++);
	bear.heading = 90;
	frame();
	assert.equal(calls, 2);
	assert.equal(drawn.position.x, 0.5);
	assert.ok(Math.abs(drawn.scale.x - 1 / 6) < 1e-6 && Math.abs(gltf.scene.rotation.y - Math.PI / 2) < 1e-6);
	assert.ok(wireframe.geometry.drawRange.count > 100);
	standing.updateObject();
	assert.ok(Math.abs(drawn.rotation.x - Math.PI / 2) < 1e-6);
	assert.equal(other.x, 0.5);
	assert.equal(hit.agent, level);
	assert.equal(drawnFace.object, levelScene);
	assert.ok(mark.position.distanceTo(new THREE.Vector3(5, 0, 7)) < 1e-9);
	assert.ok(crateMesh.position.distanceTo(new THREE.Vector3(0, 0.9, 0)) < 1e-9 && crateMesh.scale.x === 1 && crate.size === 1);
	assert.ok(heroGroup.position.distanceTo(new THREE.Vector3(5, 0, -2)) < 1e-9 && Math.abs(heroGroup.scale.x - 1) < 1e-9);
	const { min, max } = new THREE.Box3().setFromObject(coinMesh);
	assert.ok(min.distanceTo(new THREE.Vector3(coin.x - 0.25, coin.z, -coin.y - 0.25)) < 1e-6);
	assert.ok(max.distanceTo(new THREE.Vector3(coin.x + 0.25, coin.z + 0.5, -coin.y + 0.25)) < 1e-6);
	assert.equal(Math.min(...greatLand.modelOf('crate').vertices), -1);
	placeCamera();
	assert.ok(camera.position.distanceTo(heroGroup.position.clone().add(new THREE.Vector3(-5, 3.1, 0))) < 1e-9, 'nothing is in its way');
	heroGroup.rotation.z = 0.7;
	placeCamera();
	assert.ok(Math.abs(camera.position.y - 0.25) < 1e-6, 'it rests on the ground');
	heroGroup.rotation.z = 0;
	placeCamera();
	assert.ok(camera.position.y > 0.25 && camera.position.y < 3.1, 'it goes back slowly');
	for (const [room, triangles] of [[openRoom, 10], [closedRoom, 72]]) assert.equal(adapter.levelFromObject('room', room).triangles.length, 3 * triangles);
	collision.terrain = null;
	queries.update([coin, crate, level]);
	camera.position.set(3, 8, 6);
	camera.lookAt(3, 0.25, -2);
	camera.updateMatrixWorld();
	assert.equal(pickedAt(400, 300).agent, coin);
	canvas.dispatchEvent(Object.assign(new Event('pointerdown'), { offsetX: 400, offsetY: 300 }));
	assert.ok(Math.abs(mark.position.distanceTo(new THREE.Vector3(3, 0.25, -2)) - 0.25) < 1e-6, 'on the surface of the coin');
	assert.equal(coin.color, 0xff8000);
	const below = pickedAt(400, 400);
	assert.ok(below.agent === level && Math.abs(below.point.x - 3) < 1e-9 && below.point.y < 1.5);
	assert.equal(pickedAt(400, -3000), null);
	collision.terrain = terrain;
	assert.equal(collision.terrain, terrain);
	bone.position.y = 100;
	moveEnemy(0.5);
	queries.update([enemy]);
	assert.ok(Math.abs(queries.cast({ x: -5, y: 0, z: 101 }, { x: 1, y: 0, z: 0 }).distance - 5) < 1e-6, 'the pose of the bone, and the step of the agent');
	assert.equal(figure.position.x, 0.5);
	assert.ok(terrain.heightAt(3, 4) > 1.99 && Math.abs(ground.boundingBox.max.y - terrain.heightAt(3, 4)) < 1e-6);
}
