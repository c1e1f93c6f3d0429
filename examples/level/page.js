/** Draws the game, and passes the keys on. */
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { BuiltInModel, GreatLand } from "starlogo-collision";
import { bindInstance, levelFromObject, modelFromObject, toScene } from "starlogo-collision/three";
import { Game, wander } from "./game.js";

const renderer = new THREE.WebGLRenderer({ antialias: true });
document.body.prepend(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(0xbcd7ee);
scene.fog = new THREE.Fog(0xbcd7ee, 30, 75);
const sun = new THREE.DirectionalLight(0xffffff, 2);
sun.position.set(3, 6, 2);
scene.add(sun, new THREE.HemisphereLight(0xffffff, 0x889977, 2));
const camera = new THREE.PerspectiveCamera(60, 1, 0.05, 120);
const fit = () => {
	renderer.setSize(innerWidth, innerHeight);
	camera.aspect = innerWidth / innerHeight;
	camera.updateProjectionMatrix();
};
addEventListener("resize", fit);
fit();

const { scene: land } = await new GLTFLoader().loadAsync("level.glb");
scene.add(land);
const personShape = new THREE.CapsuleGeometry(0.3, 1.2, 8, 16);
const greatLand = new GreatLand();
const person = modelFromObject("person", personShape);
greatLand.addModel(person);
greatLand.addModel(BuiltInModel.sphere());
greatLand.addModel(levelFromObject("level", land));
const game = new Game(greatLand);

const walkers = [game.player, ...game.enemies];
const people = new THREE.InstancedMesh(personShape, new THREE.MeshStandardMaterial(), walkers.length);
const bindings = walkers.map((walker, i) => bindInstance(walker, people, i, person));
walkers.forEach(({ color }, i) => people.setColorAt(i, new THREE.Color(color)));
const nose = new THREE.Mesh(new THREE.ConeGeometry(0.1, 0.4).rotateX(Math.PI / 2), new THREE.MeshStandardMaterial({ color: 0x143a66 }));
const balls = new THREE.InstancedMesh(new THREE.SphereGeometry(0.1, 12, 8), new THREE.MeshStandardMaterial({ color: 0xffc21a }), 20);
people.frustumCulled = balls.frustumCulled = false;
scene.add(people, balls, nose);

const keys = new Set();
const taps = new Set(); // keys that count once
addEventListener("keydown", ({ code, repeat }) => {
	keys.add(code);
	if (!repeat) taps.add(code);
});
addEventListener("keyup", ({ code }) => keys.delete(code));
addEventListener("blur", () => keys.clear());
renderer.domElement.addEventListener("pointerdown", () => taps.add("KeyF"));
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
	game.bullets.forEach(({ x, y, z }, i) => balls.setMatrixAt(i, new THREE.Matrix4().setPosition(toScene({ x, y, z: z + 0.1 }))));
	balls.count = game.bullets.length;
	balls.instanceMatrix.needsUpdate = true;
	toScene(view.camera, camera.position);
	camera.lookAt(toScene(view.eye));
	const { x, y, z } = game.player;
	toScene({ x, y, z: z + 1.5 }, nose.position);
	renderer.render(scene, camera);
	document.querySelector("output").textContent = `frame ${frame}: ${engineMs.toFixed(2)} ms for ${walkers.length} who walk, ${game.bullets.length} bullets and the camera; `
		+ `${game.shots} shots, ${game.hits} hits`;
});
