/** Draws the game, and passes the keys on. */
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { BuiltInModel, GreatLand } from "starlogo-collision";
import { bindInstance, levelFromObject, toScene } from "starlogo-collision/three";
import { Game, wander } from "./game.js";
import { Shadows, chequer, personShape } from "./looks.js";

const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true }); // the sky is the page's
renderer.shadowMap.enabled = true;
renderer.shadowMap.autoUpdate = false; // the level and the sun stand still
document.body.prepend(renderer.domElement);
const scene = new THREE.Scene();
scene.fog = new THREE.Fog(0xd3e7f5, 25, 75);
const sun = new THREE.DirectionalLight(0xfff3dd, 2.2);
sun.position.set(-10, 34, 34);
sun.castShadow = true;
sun.shadow.mapSize.set(2048, 2048);
Object.assign(sun.shadow.camera, { left: -36, right: 36, top: 36, bottom: -36, far: 110 });
sun.shadow.normalBias = 0.06;
scene.add(sun, new THREE.HemisphereLight(0xdcebff, 0xa9b08c, 2.5));
const camera = new THREE.PerspectiveCamera(50, 1, 0.05, 120);
const fit = () => {
	renderer.setSize(innerWidth, innerHeight);
	camera.aspect = innerWidth / innerHeight;
	camera.fov = camera.aspect < 1 ? 75 : 50; // a phone's keys do not cover the player
	camera.updateProjectionMatrix();
};
addEventListener("resize", fit);
fit();

const { scene: land } = await new GLTFLoader().loadAsync("level.glb");
land.traverse((part) => {
	part.castShadow = part.receiveShadow = true;
});
chequer(land);
scene.add(land);
const greatLand = new GreatLand();
greatLand.addModel(BuiltInModel.sphere());
greatLand.addModel(BuiltInModel.capsule(0.3, 1.8, "person")); // its place is where its feet are
greatLand.addLevel(levelFromObject("level", land));
const game = new Game(greatLand);

const { walkers } = game;
const people = new THREE.InstancedMesh(personShape(), new THREE.MeshStandardMaterial({ vertexColors: true }), walkers.length);
const bindings = walkers.map((walker, i) => bindInstance(walker, people, i));
walkers.forEach(({ color }, i) => people.setColorAt(i, new THREE.Color(color)));
const balls = new THREE.InstancedMesh(new THREE.SphereGeometry(0.1, 12, 8), new THREE.MeshStandardMaterial({ color: 0xffc21a }), 20);
people.frustumCulled = balls.frustumCulled = false;
const shadows = new Shadows(walkers.length).rotateX(-Math.PI / 2); // they have z up
scene.add(people, balls, shadows);

const keys = new Set();
const taps = new Set(); // keys that count once
const press = (code) => {
	keys.add(code);
	taps.add(code);
};
addEventListener("keydown", ({ code, repeat }) => repeat || press(code));
addEventListener("keyup", ({ code }) => keys.delete(code));
addEventListener("blur", () => keys.clear());
renderer.domElement.addEventListener("pointerdown", () => taps.add("KeyF"));
for (const button of document.querySelectorAll("button")) { // a phone's keys
	button.addEventListener("pointerdown", () => press(button.value));
	for (const type of ["pointerup", "pointercancel", "pointerleave"]) button.addEventListener(type, () => keys.delete(button.value));
	button.addEventListener("contextmenu", (event) => event.preventDefault());
}
const tapped = (code) => taps.delete(code);
const between = (less, more) => (keys.has(more) ? 1 : 0) - (keys.has(less) ? 1 : 0);

const past = []; // what was saved every tenth of a second, for a minute
let saved = null;
let [frame, engineMs] = [0, 0];
/** Until a key is pressed the player goes round by itself. */
let isLed = false;
const wish = () => (isLed
	? { turn: between("ArrowLeft", "ArrowRight"), walk: between("ArrowDown", "ArrowUp"), jumps: keys.has("Space"), shoots: tapped("KeyF") }
	: wander(frame));
const count = (number, one) => `${number} ${one}${number === 1 ? "" : "s"}`;

renderer.shadowMap.needsUpdate = true;
renderer.setAnimationLoop(() => {
	frame++;
	isLed ||= keys.size > 0;
	if (frame % 6 === 0 && !keys.has("KeyR")) past.splice(0, Math.max(0, past.push(game.save()) - 600));
	if (tapped("KeyS")) saved = game.save();
	if (tapped("KeyL") && saved) game.goBackTo(saved); // nothing is there before the first S
	const start = performance.now();
	if (!keys.has("KeyR")) game.step(wish());
	else if (frame % 3 === 0 && past.length > 0) game.goBackTo(past.pop());
	const view = game.cameraPlace();
	engineMs += 0.05 * (performance.now() - start - engineMs);

	for (const binding of bindings) binding.updateObject();
	shadows.follow(game);
	game.bullets.forEach(({ x, y, z }, i) => balls.setMatrixAt(i, new THREE.Matrix4().setPosition(toScene({ x, y, z: z + 0.1 }))));
	balls.count = game.bullets.length;
	balls.instanceMatrix.needsUpdate = true;
	toScene(view.camera, camera.position);
	camera.lookAt(toScene(view.aim));
	renderer.render(scene, camera);
	document.querySelector("output").textContent = `${engineMs.toFixed(2)} ms a frame for ${walkers.length} walkers, ${count(game.bullets.length, "bullet")} and the camera; `
		+ `${count(game.shots, "shot")}, ${count(game.hits, "hit")}${saved ? "; saved" : ""}`;
});
