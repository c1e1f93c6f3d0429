/** Writes a program of blocks as a page that plays it and draws it with three.js: the program's module, and what draws its agents. */
import { texts } from "../../shared/language.js";
import { BUILT_IN, PACKAGE } from "../../shared/names.js";
import { javascriptOf, shapesOf } from "./javascript.js";

const THREE = "0.180.0";
const text = JSON.stringify;

/** Draws the game. */
const SHOW = `// what draws it

const KEYS = { ArrowUp: "up", ArrowDown: "down", ArrowLeft: "left", ArrowRight: "right", " ": "space", w: "w", a: "a", s: "s", d: "d" };

/** A model's triangles in its own colours. */
function geometryOf({ name, vertices, triangles }) {
	const indexed = new THREE.BufferGeometry().setAttribute("position", new THREE.Float32BufferAttribute(vertices, 3));
	if (triangles) indexed.setIndex(Array.from(triangles));
	const geometry = triangles ? indexed.toNonIndexed() : indexed;
	const colours = [];
	const paint = (count, colour) => {
		const { r, g, b } = new THREE.Color(colour);
		for (let i = 0; i < 3 * count; i++) colours.push(r, g, b);
	};
	for (const [count, colour] of coats[name] ?? []) paint(count, colour);
	paint(geometry.getAttribute("position").count / 3 - colours.length / 9, 0xa9b3c1);
	geometry.setAttribute("color", new THREE.Float32BufferAttribute(colours, 3));
	geometry.computeVertexNormals();
	return geometry;
}

document.querySelector(".needs").remove(); // all that it needs is there
const renderer = new THREE.WebGLRenderer({ antialias: true });
document.body.append(renderer.domElement);
const scene = new THREE.Scene();
scene.background = new THREE.Color(game.ground === "space" ? 0x0b1020 : 0xcfe8f7);
scene.add(new THREE.HemisphereLight(0xffffff, 0x999080, 2.2));
const sun = new THREE.DirectionalLight(0xffffff, 1.6);
sun.position.set(4, -6, 9);
/*ground*/
scene.add(sun, ground);
const camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1000);
camera.up.set(0, 0, 1);
const controls = new OrbitControls(camera, renderer.domElement);
const geometries = new Map(models.map((model) => [model.name, geometryOf(model)]));
const own = new THREE.MeshLambertMaterial({ vertexColors: true, flatShading: true });
const paints = new Map();
const meshes = new Map();

/** The material of a colour; -1 stands for the model's own colours. */
function materialOf(colour) {
	if (colour === -1) return own;
	if (!paints.has(colour)) paints.set(colour, new THREE.MeshLambertMaterial({ color: colour, flatShading: true }));
	return paints.get(colour);
}

/** Puts a mesh wherever the engine has an agent. */
function draw() {
	for (const agent of agents) {
		if (!meshes.has(agent)) {
			const mesh = new THREE.Mesh(geometries.get(agent.shape), own);
			mesh.matrixAutoUpdate = false;
			mesh.userData.agent = agent;
			meshes.set(agent, mesh);
			scene.add(mesh);
		}
		const mesh = meshes.get(agent);
		mesh.geometry = geometries.get(agent.shape);
		mesh.material = materialOf(agent.color);
		mesh.matrix.fromArray(agent.transform.rawData);
		mesh.matrixWorldNeedsUpdate = true;
	}
	for (const [agent, mesh] of meshes) if (!agent.isAlive) {
		scene.remove(mesh);
		meshes.delete(agent);
	}
	const said = agents.filter((each) => each.said).map((each) => each.said);
	document.querySelector("p").textContent = [game.ended?.text ?? game.goal, game.score === null ? null : \`★ \${game.score}\`, ...said].filter(Boolean).join("   ");
	renderer.render(scene, camera);
}

/** Looks at all agents, from the south and from above. */
function look() {
	const box = new THREE.Box3().setFromPoints(agents.map(({ x, y, z }) => new THREE.Vector3(x, y, z)));
	if (box.isEmpty()) return;
	box.getCenter(controls.target);
	const far = Math.max(5, box.getSize(new THREE.Vector3()).length());
	camera.position.copy(controls.target).add(new THREE.Vector3(0, -0.8 * far, 0.6 * far));
}

/** The camera goes along with the agent that the keys move. */
function follow(before) {
	const hero = agents.find(({ breed }) => breed === HERO);
	if (!hero || !before) return hero && [hero.x, hero.y, hero.z];
	const way = new THREE.Vector3(hero.x - before[0], hero.y - before[1], hero.z - before[2]);
	controls.target.add(way);
	camera.position.add(way);
	return [hero.x, hero.y, hero.z];
}

function fit() {
	renderer.setSize(innerWidth, innerHeight);
	camera.aspect = innerWidth / innerHeight;
	camera.updateProjectionMatrix();
}

const caster = new THREE.Raycaster();
/** Points a ray at a place of the window. */
function aim({ clientX, clientY }) {
	caster.setFromCamera(new THREE.Vector2((2 * clientX) / innerWidth - 1, 1 - (2 * clientY) / innerHeight), camera);
	return caster;
}

addEventListener("resize", fit);
addEventListener("keydown", (event) => {
	const key = KEYS[event.key];
	if (!key) return;
	event.preventDefault();
	press(key);
});
addEventListener("keyup", (event) => release(KEYS[event.key]));
renderer.domElement.addEventListener("click", (event) => {
	const [hit] = aim(event).intersectObjects([...meshes.values()]);
	if (hit) click(hit.object.userData.agent);
});
/*mouse*/
// in the browser's console: game, agents
Object.assign(globalThis, { game, agents });
step();
fit();
look();
let place = follow(null);
let [last, due] = [performance.now(), 0];
renderer.setAnimationLoop((now) => {
	due = Math.min(8, due + (60 * (now - last)) / 1000);
	for (last = now; due >= 1 && !game.ended; due--) step();
	place = follow(place);
	controls.update();
	draw();
});
`;

/** The ground: that of the engine, or a flat one. */
const GROUND = {
	flat: `const ground = new THREE.Mesh(new THREE.PlaneGeometry(101, 101), new THREE.MeshLambertMaterial({ color: game.ground === "meadow" ? 0x8fce6a : game.ground === "sea" ? 0xd9c58a : 0x1a2340 }));
ground.position.z = -0.01;`,
	terrain: `const surface = new TerrainGeometry(terrain, { up: "z" });
const ground = new THREE.Mesh(surface, new THREE.MeshLambertMaterial({ color: 0x8fce6a, flatShading: true, side: THREE.DoubleSide }));
ground.onBeforeRender = () => surface.update();`,
};

const MOUSE = `renderer.domElement.addEventListener("pointermove", (event) => {
	const at = aim(event).ray.intersectPlane(new THREE.Plane(new THREE.Vector3(0, 0, 1)), new THREE.Vector3());
	if (at) Object.assign(mouse, { x: at.x, y: at.y });
});
renderer.domElement.addEventListener("pointerdown", () => {
	mouse.isDown = true;
});
addEventListener("pointerup", () => {
	mouse.isDown = false;
});
`;

const marked = (words) => words.replaceAll("&", "&amp;").replaceAll("<", "&lt;").replaceAll(/-(?=-)/g, "- ");

/** The breed of the first script that a key starts. */
const heroOf = (program) => (program.blocks?.blocks ?? []).find(({ type }) => type === "starlogo_key")?.fields.BREED ?? null;

/**
 * Writes the page.
 *
 * @param {object} program in Blockly's notation
 * @param {string} title the program's title
 * @param {Map} models by their names
 * @param {string} file the file's name without its ending
 */
export function pageOf(program, title, models, file) {
	const shapes = shapesOf(program).filter((name) => models.has(name));
	const module = javascriptOf(program, title, models, file, "").split("\n").slice(2).join("\n");
	const hasTerrain = /^const terrain = /m.test(module);
	const builtIn = shapes.filter((name) => BUILT_IN.includes(name));
	const coats = shapes.filter((name) => models.get(name).colours).map((name) => `\n\t${text(name)}: ${text(models.get(name).colours)},`);
	const all = [...builtIn.map((name) => `BuiltInModel.${name}()`), ...(shapes.length > builtIn.length ? ["...brought"] : [])];
	const script = [
		"import * as THREE from \"three\";",
		"import { OrbitControls } from \"three/addons/controls/OrbitControls.js\";",
		...(hasTerrain ? ["import { TerrainGeometry } from \"starlogo-collision/three\";"] : []),
		// the drawing's names for the models
		module.replace("for (const model of models()) greatLand.addModel(model);", "const brought = modelsOfGame();\nfor (const model of brought) greatLand.addModel(model);").replace("\nfunction models() {", "\nfunction modelsOfGame() {"),
		`const models = [${all.join(", ")}];`,
		"/** The colours of the models' triangles in their order: pairs of a count and a colour. */",
		`const coats = {${coats.join("")}\n};`,
		"/** The breed that the camera follows. */",
		`const HERO = ${text(heroOf(program))};`, "",
		SHOW.replace("/*ground*/", () => GROUND[hasTerrain ? "terrain" : "flat"]).replace("/*mouse*/\n", () => (/^export const mouse/m.test(module) ? MOUSE : "")),
	].join("\n").replaceAll(/<(?=\/script)/gi, "\\x3c").replaceAll("<!--", "\\x3c!--");
	const needs = texts.play.javascript.needs(`npm install three@${THREE} ${PACKAGE}`, `http://localhost:8080/${encodeURIComponent(file)}.html`);
	return `<!doctype html>
<html lang="${texts.code}">
<!-- “${marked(title.replaceAll(/\s+/g, " "))}”: a program of blocks as a page that three.js draws. Its models are in it. -->
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>${marked(title)}</title>
<style>
html, body { height: 100%; margin: 0; overflow: hidden; }
canvas { display: block; }
p { position: fixed; top: 0; left: 0; margin: 8px; padding: 4px 12px; border-radius: 8px; background: #101824c7; color: #fff; font: 16px system-ui, sans-serif; white-space: pre-wrap; }
p:empty { display: none; }
p.needs { animation: appear 0s 1s both; }
@keyframes appear { from { visibility: hidden; } }
</style>
<script type="importmap">
{ "imports": {
	"starlogo-collision": "./node_modules/starlogo-collision/starlogo-collision.min.js",
	"starlogo-collision/three": "./node_modules/starlogo-collision/three/index.js",
	"three": "./node_modules/three/build/three.module.js",
	"three/addons/": "./node_modules/three/examples/jsm/"
} }
</script>
</head>
<body>
<p class="needs">${marked(needs)}</p>
<p role="status"></p>
<script type="module">
${script}</script>
</body>
</html>
`;
}
