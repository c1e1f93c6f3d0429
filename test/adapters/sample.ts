// What a game in TypeScript does with the adapter to three.js: tsc --strict has to accept it.
import * as THREE from "three";
import { Agent, AgentQueries, BinCollider, Collision, GreatLand, Model, RayHit, TightestFitCollider, Vector3D } from "starlogo-collision";
import { bindInstance, faceOf, levelFromObject, modelFromObject, TerrainGeometry, terrainFromMesh, ThreeAgentBinding, ThreeWireframe, toEngine, toScene } from "starlogo-collision/three";
import type { BindingOptions, LevelOptions, ModelOptions, TerrainOptions, Up, WireframeOptions } from "starlogo-collision/three";

const up: Up = "z";
const reading: ModelOptions = { up, scaling: Model.AS_GIVEN };
const binding: BindingOptions = { up, modelUp: "y" };
const drawing: WireframeOptions = { up, color: "red" };

const scene = new THREE.Scene();
const mesh = new THREE.Mesh(new THREE.BoxGeometry());
const trees = new THREE.InstancedMesh(new THREE.ConeGeometry(), new THREE.MeshBasicMaterial(), 3);
const greatLand = new GreatLand();
const box: Model = modelFromObject("box", mesh);
const tree = modelFromObject("tree", trees.geometry, reading);
greatLand.addModel(box);
greatLand.addModel(tree);

const agents = [new Agent("box", "boxes"), new Agent("tree", "trees")];
const bindings: ThreeAgentBinding[] = [new ThreeAgentBinding(agents[0], mesh, box), bindInstance(agents[1], trees, 0, tree, binding), new ThreeAgentBinding(agents[0], mesh, null, binding)];
bindings.pop();
const wireframe = new ThreeWireframe(drawing);
scene.add(mesh, trees, wireframe, new ThreeWireframe());
const structure = greatLand.boundingStructures.tightestFit("box");
const root = greatLand.hierarchies.root("box");
wireframe.showStructure(structure, agents[0]).showStructure(structure).showLevel(root, 3, agents[0]).showLines([0, 0, 0, 1, 1, 1]).showLines(new Float32Array(6), agents[1]);
wireframe.showRay(new Vector3D(), new Vector3D(1), 10).showRay(new Vector3D(), new Vector3D(1), 10, new RayHit());
wireframe.material.color.set(0xff0000);

const collision = new Collision(new TightestFitCollider(greatLand));
collision.collisionSystem = new BinCollider(greatLand);
for (const each of bindings) {
	const object: THREE.Object3D = each.object;
	const agent: Agent = each.agent;
	object.position.x += agent.size;
	each.updateAgent();
	each.updateObject();
}
wireframe.clearLines().update();
wireframe.dispose();

/** How far the first agent is. */
export const place: [number, number, number] = [agents[0].x, agents[0].y, agents[0].z];
const ground: TerrainOptions = { up };
const surface: TerrainGeometry = new TerrainGeometry(terrainFromMesh(mesh, 3, 3, 1, 0, 0, ground), ground);
const followed: boolean = new TerrainGeometry(terrainFromMesh(mesh.geometry, 3, 3)).update();
scene.add(new THREE.Mesh(surface).translateX(followed ? surface.terrain.columns : 0));

const level: LevelOptions = { up };
greatLand.addModel(levelFromObject("level", scene, level));
const camera = new THREE.PerspectiveCamera();
const queries = new AgentQueries(collision);
const hit: RayHit | null = queries.cast(toEngine(camera.position), toEngine(camera.getWorldDirection(new THREE.Vector3())));
const mark: THREE.Vector3 = toScene(hit === null ? new Vector3D() : hit.point);
toEngine(mark, mark);
// what a game writes with the compilers of some years, which infer more from the wanted type
const orNull: THREE.Vector3 | null = toScene(mark);
const placeOf = (found: RayHit | null): THREE.Vector3 | null => found && toScene(found.point);
const eye: Vector3D | null = toEngine(camera.position);
const written: THREE.Vector3 = toScene(eye, placeOf(hit) ?? orNull ?? mark);
scene.position.copy(written);
toScene(toEngine(mark), mesh.position).applyMatrix4(scene.matrix);

// what is drawn at a hit
const face = faceOf(tree, hit?.triangle ?? -1);
if (face) face.object.material = new THREE.MeshBasicMaterial({ name: `${face.faceIndex} ${face.instanceId ?? ""}` });
new Blob([collision.snapshot()]);
