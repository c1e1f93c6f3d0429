/** glTF models that collide: bears and seagulls turn away from whatever their triangles touch. */
import * as THREE from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";
import { Agent, Collision, GreatLand, HierarchicalCollider } from "starlogo-collision";
import { modelFromObject, ThreeAgentBinding, ThreeWireframe } from "starlogo-collision/three";

const renderer = new THREE.WebGLRenderer({ antialias: true, alpha: true }); // the sky is the page's
renderer.shadowMap.enabled = true;
document.body.append(renderer.domElement);
const sun = new THREE.DirectionalLight(0xfff1d8, 2.4).translateX(-8).translateY(20).translateZ(6);
sun.castShadow = true;
sun.shadow.mapSize.set(1024, 1024);
sun.shadow.normalBias = 0.05;
Object.assign(sun.shadow.camera, { left: -16, right: 16, top: 16, bottom: -16, far: 50 });
const ground = new THREE.Mesh(new THREE.CircleGeometry(15, 64).rotateX(-Math.PI / 2), new THREE.MeshLambertMaterial({ color: 0x8cc46a }));
ground.receiveShadow = true;
const scene = new THREE.Scene().add(sun, new THREE.HemisphereLight(0xe6f2ff, 0x6f8555, 2), ground);
const camera = new THREE.PerspectiveCamera(45, 1).rotateX(-0.59);
const fit = () => {
	renderer.setSize(innerWidth, innerHeight);
	camera.aspect = innerWidth / innerHeight;
	const isNarrow = camera.aspect < 1.2; // a phone shows all of it, too
	camera.position.set(0, 12, 18).multiplyScalar(isNarrow ? 1.5 : 1);
	camera.fov = isNarrow ? 70 : 45;
	camera.updateProjectionMatrix();
};
addEventListener("resize", fit);
fit();

const greatLand = new GreatLand();
const collision = new Collision(Object.assign(new HierarchicalCollider(greatLand), { exact: true }));
const [bindings, touches] = [[], new ThreeWireframe({ color: 0xd01818 })];
for (const [shape, breed, size, height] of [["tree", "trees", 2, 0], ["bear", "walkers", 1, 0], ["seagull", "walkers", 2, 1]]) {
	const { scene: drawn } = await new GLTFLoader().loadAsync(`${shape}.glb`);
	drawn.traverse((part) => {
		part.castShadow = true;
	});
	const model = modelFromObject(shape, drawn);
	greatLand.addModel(model);
	for (let i = 8; i > 0; i--) {
		const agent = Object.assign(new Agent(shape, breed), { size, heading: bindings.length * 137 });
		agent.moveTo(9 * Math.cos(bindings.length * 2.4), 9 * Math.sin(bindings.length * 1.7), height);
		bindings.push(new ThreeAgentBinding(agent, drawn.clone(), model));
	}
}
const agents = bindings.map(({ agent }) => agent);
scene.add(touches, ...bindings.map(({ object }) => object));

const headingTo = (x, y) => THREE.MathUtils.radToDeg(Math.atan2(y, x));
collision.onCollision("walkers", Collision.ANY_BREED, (walker, other, contact) => {
	walker.moveTo(walker.x + contact.normal.x * contact.depth, walker.y + contact.normal.y * contact.depth, walker.z);
	walker.heading = headingTo(contact.normal.x, contact.normal.y) + 30;
	touches.showContact(contact);
	document.querySelector("output").textContent = `A ${walker.shape} turns away from a ${other.shape}`;
});
renderer.setAnimationLoop(() => {
	touches.clearLines();
	for (const walker of agents.filter(({ breed }) => breed === "walkers")) {
		if (Math.hypot(walker.x, walker.y) > 11) walker.heading = headingTo(-walker.x, -walker.y);
		const angle = THREE.MathUtils.degToRad(walker.heading);
		walker.moveTo(walker.x + 0.04 * Math.cos(angle), walker.y + 0.04 * Math.sin(angle), walker.z);
	}
	collision.update(agents);
	for (const binding of bindings) binding.updateObject();
	renderer.render(scene, camera);
});
