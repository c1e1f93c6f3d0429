/** glTF models that collide: bears and seagulls turn away from whatever their triangles touch. */
import * as THREE from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { Agent, Collision, GreatLand, HierarchicalCollider } from "starlogo-collision";
import { modelFromObject, ThreeAgentBinding, ThreeWireframe } from "starlogo-collision/three";

const renderer = new THREE.WebGLRenderer({ antialias: true });
renderer.setSize(innerWidth, innerHeight);
document.body.append(renderer.domElement);
const scene = new THREE.Scene().add(new THREE.HemisphereLight(0xffffff, 0x667755, 3), new THREE.GridHelper(24, 24, 0xaab5a0, 0xc5cebb));
scene.background = new THREE.Color(0xdfe8cf);
const camera = new THREE.PerspectiveCamera(45, innerWidth / innerHeight);
camera.position.set(0, 12, 18);
new OrbitControls(camera, renderer.domElement).update();

const greatLand = new GreatLand();
const exact = Object.assign(new HierarchicalCollider(greatLand), { exact: true });
const collision = new Collision(exact);
const [agents, bindings, touches] = [[], [], new ThreeWireframe({ color: 0xd01818 })];
scene.add(touches);
for (const [shape, breed, size] of [["tree", "trees", 2], ["bear", "walkers", 1], ["seagull", "walkers", 2]]) {
	const { scene: drawn } = await new GLTFLoader().loadAsync(`${shape}.glb`);
	const model = modelFromObject(shape, drawn);
	greatLand.addModel(model);
	for (let i = 0; i < 8; i++) {
		const agent = Object.assign(new Agent(shape, breed), { size, heading: agents.length * 137 });
		agent.moveTo(9 * Math.cos(agents.length * 2.4), 9 * Math.sin(agents.length * 1.7), shape === "seagull" ? 1 : 0);
		bindings.push(new ThreeAgentBinding(agent, drawn.clone(), model));
		agents.push(agent);
		scene.add(bindings.at(-1).object);
	}
}
collision.onCollision("walkers", Collision.ANY_BREED, (walker, other, { normal, depth }) => {
	walker.moveTo(walker.x + normal.x * depth, walker.y + normal.y * depth, walker.z);
	walker.heading = THREE.MathUtils.radToDeg(Math.atan2(normal.y, normal.x)) + 30;
	touches.showContact(exact.contactOf(walker, other));
});

let [frames, turns] = [0, 0];
renderer.setAnimationLoop(() => {
	touches.clearLines();
	for (const agent of agents.filter(({ breed }) => breed === "walkers")) {
		const angle = THREE.MathUtils.degToRad(agent.heading);
		if (Math.hypot(agent.x, agent.y) > 11) agent.heading = THREE.MathUtils.radToDeg(Math.atan2(-agent.y, -agent.x));
		agent.moveTo(agent.x + 0.04 * Math.cos(angle), agent.y + 0.04 * Math.sin(angle), agent.z);
	}
	collision.update(agents);
	for (const binding of bindings) binding.updateObject();
	renderer.render(scene, camera);
	turns += collision.statistics.handlerCalls;
	document.querySelector("output").textContent = `frame ${++frames}: ${turns} turns`;
});
