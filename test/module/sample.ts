// What a game in TypeScript does with the engine, and every public class once: tsc --strict has to accept it.
import {
	Agent,
	AgentFilter,
	type AgentFilterInit,
	AgentPredicate,
	AgentQueries,
	ArgumentError,
	AxisAlignedBoxFitter,
	BaseCollider,
	BaseShapeChoice,
	BinCollider,
	BlockError,
	BoundingStructure,
	BoundingStructuresLibrary,
	Box,
	boxBox,
	BreedInterests,
	BuiltInModel,
	ByteArray,
	Capsule,
	capsuleBox,
	capsuleCapsule,
	CapsuleFitter,
	CastHit,
	CentredRitterSphereFitter,
	ColladaAnimations,
	ColladaModel,
	Collider,
	Collision,
	CollisionBlocks,
	CollisionLines,
	type CollisionRecord,
	CollisionRecorder,
	CollisionStatistics,
	CollisionSystem,
	CombinationCollider,
	Contact,
	ConvexHull,
	CookedModel,
	Cylinder,
	CylinderFitter,
	DetectionBlocks,
	EventDispatcher,
	finish,
	Fit,
	FitSession,
	FitSettings,
	FitStorage,
	FitStore,
	Fitter,
	FrameTimes,
	GltfAnimations,
	GltfModel,
	GreatLand,
	HierarchicalCollider,
	HierarchiesLibrary,
	HierarchyNode,
	Hull,
	HullFitter,
	IEventDispatcher,
	IllegalOperationError,
	intersects,
	ListenerOptions,
	Matrix3D,
	MinimalCapsuleFitter,
	MinimalSphereFitter,
	Model,
	type ModelAnimations,
	ModelError,
	ModelEvent,
	ModelLoader,
	ModelLoaderEvents,
	ModelReceiver,
	ModelShape,
	ModelMaker,
	ModelTransform,
	NaiveSphereFitter,
	ObjModel,
	OrientedBoxFitter,
	Picture,
	Placement,
	Point,
	PointTaker,
	RayHit,
	type RecordedCollisions,
	RitterSphereFitter,
	ShapeChoice,
	SharedFitStorage,
	SourceFrame,
	ShapeHit,
	Sphere,
	sphereBox,
	sphereCapsule,
	sphereSphere,
	Steps,
	StepSequence,
	StlModel,
	StructureBlocks,
	Terrain,
	TerrainBlocks,
	TerrainSurface,
	TightestFitCollider,
	Tolerances,
	TraitBlocks,
	TreeCollider,
	Trigonometry,
	Vector3D,
	Wireframes,
	ZAlignedBoxFitter,
	WorldBounds,
	ContactBlocks,
	WalkBlocks,
	Footing,
	WalkOptions,
	AgentPlaces,
	AgentRays,
	AgentMotions,
	LevelCollider,
	LevelShapes,
	SeenAgents,
} from "starlogo-collision";

/** What went on, line by line. */
/** Shapes of a game's own: every agent has a bubble. */
class Bubbles extends ShapeChoice {
	override bind(shape: ModelShape): void {
		shape.setStructure(new Sphere(new Vector3D(0, 0, 0.5), 1));
	}
}

export const log: string[] = [];

/** Runs a game of three frames. */
export function play(bearText: string): number {
	const greatLand = new GreatLand();
	greatLand.orientedBoxDegIncrement = 30;
	greatLand.addModel(BuiltInModel.sphere());
	greatLand.addModel(BuiltInModel.capsule(0.25, 1.75, "walker"));
	greatLand.addModel(BuiltInModel.box(4, 0.5, 3, "wall"));
	greatLand.addModel(new ObjModel("bear", bearText));
	const receiver: ModelReceiver = greatLand;
	receiver.expectNoMore("none", "there is no file");
	finish(receiver.receive(new Model("triangle", new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]), new Uint16Array([0, 1, 2]))));

	const turned = new ObjModel("bear", bearText, ModelTransform.fromText("rotate 90 0 270\nscale 2"), Model.VOLUME);
	const frame: SourceFrame = turned.source;
	log.push(`${frame.unit} ${frame.offset.x} ${frame.matrix.rawData[15]}`);

	const bear = new Agent("bear", "bears");
	const ball = new Agent("sphere", "paintballs");
	ball.size = 0.2;
	ball.heading = 30;
	const systems: CollisionSystem[] = [
		new BinCollider(greatLand),
		new TightestFitCollider(greatLand),
		new HierarchicalCollider(greatLand),
		new CombinationCollider(greatLand),
	];
	let calls = 0;
	for (const system of systems) {
		const recorder: BaseCollider = new CollisionRecorder(system);
		const observer: BaseCollider = new CollisionRecorder(recorder);
		const collision = new Collision(observer);
		collision.onCollision("bears", Collision.ANY_BREED, (collider: Agent, collidee: Agent) => {
			calls++;
			collider.color = collidee.color;
		});
		ball.moveTo(0.4, 0, 0.5);
		collision.update([bear, ball]);
		const statistics: CollisionStatistics = collision.statistics;
		log.push(`${statistics.agents} agents, ${statistics.collisions} collisions`);
		const times: FrameTimes = (observer as CollisionRecorder).frameTimes;
		const record: CollisionRecord = (observer as CollisionRecorder).toObject();
		const all: RecordedCollisions[] = [record, ...record.breeds];
		const recorded: number = record.frames + all.reduce((sum: number, { mean, histogram }) => sum + mean + histogram.length, 0);
		if (times.frames !== 1 || collision.lastAgents.length !== 2 || !(recorded > 0)) log.push("not measured");
	}
	passThrough(greatLand);
	useBlocks(greatLand, [bear, ball]);
	ask(greatLand, [bear, ball]);
	const shapes: BaseShapeChoice = new Bubbles(greatLand);
	const collider: Collider = new Collider(shapes);
	const precise: TreeCollider = new HierarchicalCollider(greatLand);
	precise.exact = true;
	const root: HierarchyNode = greatLand.hierarchies.root("bear");
	log.push(`${collider.areColliding(bear, ball)}, ${precise.areColliding(bear, ball)}, ${root.vertexCount} vertices`);
	return calls;
}

// Who is where.
function ask(greatLand: GreatLand, agents: Agent[]): void {
	const collision = new Collision(new TightestFitCollider(greatLand));
	const bounds: WorldBounds = new WorldBounds(-50.5, -50.5, -Infinity, 50.5, 50.5, Infinity);
	collision.bounds = bounds;
	collision.onCollision("bears", Collision.EDGE, (bear, edge, contact) => log.push(`${bear} at ${edge === bounds.agent}, ${contact.normal}, ${contact.approachSpeed}`));
	const queries = new AgentQueries(collision);
	const filter: AgentFilter = AgentFilter.ofBreeds("paintballs");
	filter.accepts = (agent: Agent) => agent.size < 1;
	const choice: AgentPredicate = filter;
	const same: AgentFilterInit = filter;
	collision.filter = choice;
	queries.update(agents);
	queries.moved(agents[1]);
	const nearest: Agent | null = queries.nearest(agents[0], Infinity, filter);
	const near: Agent[] = queries.near(agents[0], 3, null, []);
	const touching: Agent[] = queries.touching(agents[0]);
	const nearestTwo: Agent[] = queries.nearestOf(agents[0], 2, 9, same);
	const overlapping: Agent[] = queries.overlapping(new Sphere(new Vector3D(0, 0, 1), 2));
	const origin = new Vector3D(0, 0, 0);
	const first: Agent | null = queries.nearestToPoint(origin, 9);
	const nearIt: Agent[] = queries.nearPoint(origin, 9, filter);
	const inFront: Agent[] = queries.inCone(agents[0], 9, 90);
	log.push(`${first}, ${nearIt.length} of ${queries.countNearPoint(origin, 9)}, ${inFront.length} of ${queries.countNear(agents[0], 9)}`);
	const touches: boolean = queries.touchesAny(agents[0], filter);
	if (queries.touchesEdge(agents[0], bounds)) log.push("at an edge");
	log.push(`${nearest}, ${nearestTwo.length} nearest, ${near.length} near, ${touching.length} touching, ${touches}, ${overlapping.length} overlapping`);
	const [eye, ahead] = [new Vector3D(-9, 0, 0.5), new Vector3D(1, 0, 0)];
	const hit: RayHit | null = queries.cast(eye, ahead, Infinity, filter, new RayHit());
	const hits: RayHit[] = queries.castAll(eye, ahead);
	const seen: SeenAgents = new SeenAgents(collision);
	seen.update(agents);
	const [places, motions]: [AgentPlaces, AgentMotions] = [new AgentPlaces(seen), new AgentMotions(seen)];
	if (places.nearest(agents[0], Infinity, filter) !== nearest || motions.moveUntilTouch(agents[0], 0, 0, 0) !== 1) log.push("other answers");
	const level = new LevelShapes();
	level.exact = true;
	for (const { shape } of agents) level.addStructure(shape, greatLand.boundingStructures.tightestFit(shape));
	level.addModel(BuiltInModel.box(4, 0.5, 3, "wall"));
	const seenInLevel = new SeenAgents(level);
	seenInLevel.update(agents);
	if (new AgentRays(seenInLevel).castAll(eye, ahead).length > hits.length) log.push("other hits");
	if (new LevelCollider(level).findCollisions(agents).length % 2 !== 0) log.push("half a pair");
	log.push(`${hit?.agent} at ${hit?.distance}, ${hits.length} hits, ${queries.canSee(agents[0], agents[1])}`);
	const bump: ShapeHit | null = queries.castShape(new Sphere(eye, 0.5), 20, 0, 0, filter, new ShapeHit());
	const bumps: ShapeHit[] = queries.castAgentAll(agents[0], 0, 0, 9, null, []);
	const met: CastHit | null = hit ?? bump;
	if (met !== hit) log.push("another hit");
	log.push(`${bump?.agent} at ${bump?.time}, ${bumps.length} bumps, ${queries.castAgent(agents[0], 0, 0, 9)}, ${queries.castShapeAll(new Sphere(eye, 1), 9, 0, 0).length}`);
	const [above, below]: [Point, PointTaker] = [{ x: 0, y: 0, z: 9 }, { x: 0, y: 0, z: 0 }];
	log.push(`${queries.overlapsAgent(agents[0], 0, 0, 9)}, ${queries.distanceToPoint(agents[0], above, below)} to ${below.z}`);
	const stride: WalkOptions = new WalkOptions();
	stride.slopeDegrees = 60;
	const footing: Footing = queries.walk(agents[0], 1, 0, { stepHeight: 0.5, filter }, new Footing());
	log.push(`${footing.stands} on ${footing.on}, ${footing.normal}, ${queries.walk(agents[0], 0, 1, stride).part}`);
	const blocks = new DetectionBlocks(new CollisionBlocks(greatLand, agents));
	blocks.update();
	const [bear, ball] = agents;
	log.push(`${blocks.countWithin(bear, "paintballs", 3)} within 3, ${blocks.countWith(bear, Collision.ANY_BREED, "size", 0.2)} of size 0.2`);
	const nearestBall: Agent | null = blocks.nearestWithin(bear, "paintballs", 9) ?? blocks.nearestWith(bear, "paintballs", "size", 0.2);
	log.push(`${nearestBall}, ${blocks.isTouching(bear, "paintballs")}, ${blocks.canSee(bear, ball)}, ${blocks.distanceTo(bear, ball)}`);
	const [onBear, onBall] = [new Vector3D(), new Vector3D()];
	log.push(`${queries.distance(bear, ball, onBear, onBall)}, ${onBear}, ${onBall}`);
	const contact = new Contact();
	const free: number = queries.moveUntilTouch(ball, 0, 0, -9, null, contact);
	log.push(`${free} free, ${contact.time}, ${queries.slide(ball, 1, 0, -1)} slid`);
}

// What a program of blocks calls.
function useBlocks(greatLand: GreatLand, agents: Agent[]): void {
	const collisions = new CollisionBlocks(greatLand, agents);
	const structures = new StructureBlocks(collisions);
	new TraitBlocks(agents).collideAs("bears", Agent.BOX);
	structures.show("bears", true);
	log.push(`${new CollisionLines(greatLand).linesOf(agents[0], new BinCollider(greatLand), []).length / 6} lines of a sphere`);
	const picture: Picture = { width: 2, height: 3, data: new Uint8Array(24) };
	if (Terrain.fromPicture(picture, 1).rows !== 3) log.push("another picture");
	if (Trigonometry.arctangent(1, -1) !== 135 || Trigonometry.sine(90) !== Trigonometry.cosine(0)) log.push("another turn");
	const ground: Terrain = collisions.collision.terrain = new Terrain(9, 9, 1, -4, -4);
	const detection = new DetectionBlocks(collisions);
	detection.update();
	const groundBlocks = new TerrainBlocks(collisions, detection);
	groundBlocks.buildMound(agents[0], 3, 1);
	const onMound: boolean = groundBlocks.isTouchingGround(agents[0]) && !groundBlocks.isTouchingEdge(agents[0]) && groundBlocks.terrainHeight(agents[0]) > 0;
	const walking = new WalkBlocks(detection);
	walking.setSolid("bears", true);
	const speed: number = walking.jump(agents[0], 1, walking.fall(agents[0], 0));
	const below: Agent | null = walking.standsOn(agents[0]);
	log.push(`solid: ${walking.solidBreeds}, ${speed >= 0}, ${below?.breed ?? "in the air"}, ${new ContactBlocks(collisions).sideHit(agents[0], agents[1])}`);
	walking.setSolid("bears", false);
	log.push(`on a mound: ${onMound}, of ${Wireframes.ofTerrain(ground, -2, -2, 2, 2).length / 6} lines`);
	const surface = new TerrainSurface(ground, -2, -2);
	log.push(`${surface.update()}, ${surface.vertices.length / 3} vertices, ${surface.normals.length / 3} normals, ${surface.triangles.length / 3} triangles`);
	collisions.whenTouchingStarts("bears", "paintballs", () => log.push(`${structures.lines().length / 6} lines`));
	collisions.collision.update(agents);
	try {
		collisions.useCollisionSystem("guesses");
	} catch (error) {
		log.push(error instanceof BlockError ? error.message : "not a BlockError");
	}
}

// A ball that is faster than a bear is wide.
function passThrough(greatLand: GreatLand): void {
	const bear = new Agent("bear", "bears");
	const ball = new Agent("sphere", "paintballs");
	ball.sweeps = true;
	ball.jumpTo(-10, 0, 0);
	const system = new TightestFitCollider(greatLand);
	const collision = new Collision(system);
	let touch = "";
	collision.onCollisionStart("paintballs", "bears", (collider: Agent, collidee: Agent, contact: Contact) => {
		touch = `${contact.time < 0.5} ${contact.normal.x < 0} ${contact.depth} ${contact.point.x < 0}`;
	});
	collision.onCollisionEnd("paintballs", "bears", () => log.push("gone"));
	collision.update([bear, ball]);
	ball.moveTo(10, 0, 0);
	collision.update([bear, ball]);
	collision.update([bear, ball]);
	const contacts: BaseCollider = system;
	ball.moveTo(0, 0, 0);
	log.push(touch, String(contacts.contactOf(ball, bear).depth > 0));
	const filter: AgentFilter = AgentFilter.ofBreeds("bears");
	const choice: AgentPredicate = filter;
	collision.filter = choice;
	const queries = new AgentQueries(system);
	queries.update([bear, ball]);
	const frame: SourceFrame = BuiltInModel.cube().source;
	log.push(`${queries.countNear(bear, 5)} near, ${frame}, ${new ModelTransform()}`);
	const hit = new RayHit();
	log.push(`${filter.breeds}, ${hit.agent} at ${hit.distance}`);
}

/** Fits every kind of structure. */
export function fitAll(vertices: Float64Array): number[] {
	const boxFitter: OrientedBoxFitter = new OrientedBoxFitter(30);
	const alongIt: CylinderFitter = new CylinderFitter(boxFitter);
	const fitters: Fitter[] = [
		new NaiveSphereFitter(), new RitterSphereFitter(), new CentredRitterSphereFitter(), new MinimalSphereFitter(),
		new AxisAlignedBoxFitter(), new ZAlignedBoxFitter(10), boxFitter,
		new CapsuleFitter(boxFitter), new MinimalCapsuleFitter(), alongIt, new HullFitter(12),
	];
	const library = new BoundingStructuresLibrary();
	library.add("cloud", vertices);
	const hierarchies = new HierarchiesLibrary();
	hierarchies.add("cloud", vertices);
	const hull = new ConvexHull(vertices);
	log.push(`${library.tightestFit("cloud").volume}, ${hierarchies.has("cloud")}, ${hull.dimension}`);
	const session = new FitSession(vertices);
	const fit: Fit = new NaiveSphereFitter().fitting(session);
	const work: Steps = new StepSequence().add(fit).slices(7, 3, (first: number, end: number) => log.push(`${first} to ${end}`)).begin(() => null);
	finish(work);
	return fitters.map((fitter) => fitter.fit(vertices).volume);
}

/** Tests pairs of structures. */
export function testPairs(): boolean[] {
	const terrain: Terrain = new Terrain(3, 3, 2, -2, -2);
	terrain.setHeights(0, 0, 2, 1, [1, 2]);
	terrain.raiseMound(0, 0, 3, 1);
	const onGround: boolean = terrain.heightAt(0, 0) > 0 && terrain.normalAt(0, 0) !== null && terrain.agent.breed === Collision.TERRAIN;
	const sphere = new Sphere(new Vector3D(0, 0, 0), 1);
	const capsule = new Capsule(new Vector3D(0.5, 0, 0), new Vector3D(3, 0, 0), 0.5);
	const box = new Box(new Vector3D(0, 0, 0), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
	const tip = new Hull([0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]);
	log.push(`${tip.corners.length}, ${tip.faces.length}, ${tip.center}`);
	const moved: BoundingStructure = box.clone();
	const matrix = new Matrix3D();
	matrix.appendRotation(45, Vector3D.Z_AXIS);
	moved.rotate(matrix);
	const cylinder: Cylinder = new Cylinder(new Vector3D(0, 0, 0), new Vector3D(0, 0, 1), 0.5);
	log.push(`${Wireframes.ofStructure(box).length / 6} lines, ${Wireframes.ofTriangles([0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, 2]).length / 6}`);
	log.push(`${cylinder.volume} about ${cylinder.radius}, ${Tolerances.TOUCHING}, ${new Placement().size}`);
	return [
		sphereSphere(sphere, sphere), sphereCapsule(sphere, capsule), sphereBox(sphere, box), capsuleCapsule(capsule, capsule),
		capsuleBox(capsule, box), boxBox(box, box), intersects(sphere, moved),
	];
}

/** Loads models while the game runs. */
export function load(base: string, bytes: Uint8Array): Promise<string[]> {
	const greatLand = new GreatLand();
	const loader = new ModelLoader(greatLand, 8);
	const dispatcher: EventDispatcher & IEventDispatcher = loader;
	const loaded: string[] = [];
	loader.addEventListener(ModelEvent.LOADED, (event: ModelEvent) => loaded.push(event.model.name));
	loader.addEventListener("error", (event: ModelLoaderEvents["error"]) => loaded.push(event.text));
	loader.addEventListener("progress", (event) => log.push(`${event.bytesLoaded} of ${event.bytesTotal}`));
	const once: ListenerOptions = { once: true };
	loader.addEventListener("progress", (event: ModelLoaderEvents["progress"]) => log.push(`first: ${event.bytesTotal}`), once);
	loader.load("bear", `${base}/bear.obj`);
	loader.load("dragon", `${base}/dragon.dae`);
	loader.load("nothing", `${base}/nothing.obj`);
	loader.loadBytes("person", bytes);
	const maker: ModelMaker = { name: "cube", progress: 1, model: BuiltInModel.cube(), step: () => false };
	loader.loadFrom(maker);
	return new Promise((resolve) => dispatcher.addEventListener("complete", () => resolve(loaded.sort())));
}

/** Keeps what was computed, in a place of one's own; how many bytes a model's take, and what comes back. */
export function keep(): string[] {
	const kept = new Map<string, ByteArray>();
	const storage: FitStorage = {
		read: (name) => (kept.has(name) ? new ByteArray(kept.get(name)!.toUint8Array()) : null),
		write: (name, bytes: ByteArray) => kept.set(name, new ByteArray(bytes.toUint8Array())).size > 0,
		remove: (name) => void kept.delete(name),
	};
	const model = BuiltInModel.cylinder();
	const greatLand = new GreatLand();
	greatLand.fitStore = new FitStore(100000, storage);
	greatLand.addModel(model);
	const entry: ByteArray | null = greatLand.fitStore.read(model, new FitSettings(greatLand.boundingStructures, greatLand.hierarchies));
	const cooked: CookedModel = CookedModel.fromBytes("cylinder", greatLand.cook(model, "z"));
	finish(new GreatLand().receive(cooked));
	const bytes: Uint8Array = greatLand.cook(model);
	// there is none in Node
	const here: FitStorage = new SharedFitStorage();
	return [String(bytes.length), String(entry !== null && entry.length > 0), String(here.read("nothing"))];
}

/** Files of all formats have the same animations. */
function animationsOf(name: string, file: string | Uint8Array): ModelAnimations {
	return typeof file === "string" ? new ColladaAnimations(name, file) : ColladaAnimations.fromBytes(name, file);
}

/** What goes wrong is said by name. */
export function refuse(): string[] {
	const errors: string[] = [];
	const attempts: (() => unknown)[] = [
		() => new Agent(""),
		() => new ObjModel("broken", "v 1 2"),
		() => new ColladaModel("broken", "<COLLADA>"),
		() => ColladaModel.fromBytes("broken", new ByteArray(new Uint8Array([1, 2, 3]))),
		() => { throw new IllegalOperationError("at this moment"); },
		() => new BreedInterests(),
		() => GltfModel.fromBytes("broken", new Uint8Array([123, 125]), null, Model.VOLUME),
		() => StlModel.fromBytes("broken", new ArrayBuffer(3)),
		...[-1, 1.5, NaN, 4294967296].map((index) => () => new Model("broken", [0, 0, 0, 1, 0, 0, 0, 1, 0], [0, 1, index])),
		() => new HierarchiesLibrary().add("broken", [0, 0, 0, 1, 0, 0, 0, 1, 0], new Float32Array([0, 1, 1.5])),
		() => new Model("broken", [0, 0, 0], [0, 0, 1]),
		() => new GltfAnimations("broken", new Uint8Array([123, 125])).verticesAt(0, 0.5),
		() => animationsOf("broken", "<COLLADA>").verticesAt(0, 0.5),
	];
	for (const attempt of attempts) {
		try {
			attempt();
		} catch (error) {
			const known = error instanceof ArgumentError || error instanceof ModelError || error instanceof IllegalOperationError;
			errors.push(`${known ? "" : "unknown: "}${error}`);
		}
	}
	return errors;
}
