import type { BufferGeometry, ColorRepresentation, InstancedMesh, LineBasicMaterial, LineSegments, Mesh, Object3D, Vector3 } from "three";
import type { Agent, BoundingStructure, Contact, HierarchyNode, Model, Point, PointTaker, RayHit, Scaling, Terrain, Vector3D } from "starlogo-collision";

/** The axis that points up. With y up, a scene's (x, y, z) is the engine's (x, -z, y). With z up, both have the same axes. */
export type Up = "y" | "z";

/**
 * A point or direction of a scene with y up, in the engine's axes: (x, y, z) becomes (x, -z, y). In a scene with z up nothing has to be done.
 *
 * @param vector the point or direction, for example a camera's position
 * @param out takes the result; it may be the argument itself. Without it, a new Vector3D does
 * @returns out
 * @throws ArgumentError if x, y or z is missing or no number
 */
export function toEngine(vector: Point, out?: null): Vector3D;
/** The same, written to `out`. */
export function toEngine<P extends PointTaker>(vector: Point, out: P): P;

/**
 * A point or direction of the engine, in the axes of a scene with y up: (x, y, z) becomes (x, z, -y). In a scene with z up nothing has to be
 * done.
 *
 * @param vector the point or direction, for example a hit's normal
 * @param out takes the result; it may be the argument itself. Without it, a new Vector3 does
 * @returns out
 * @throws ArgumentError if x, y or z is missing or no number
 */
export function toScene(vector: Point, out?: null): Vector3;
/** The same, written to `out`. */
export function toScene<P extends PointTaker>(vector: Point, out: P): P;

/** Options of modelFromObject. */
export interface ModelOptions {
    /** The up axis of the source. The default is "y", as in three.js and glTF. */
    up?: Up | undefined;
    /**
     * How the model is scaled. Model.FOOTPRINT, the default, makes it one unit wide, with its lowest point at the origin. Model.AS_GIVEN keeps
     * the unit and the origin of the source: the middle, for most geometries of three.js.
     */
    scaling?: Scaling | undefined;
}

/** Options of what stands in the land. */
export interface LevelOptions {
    /** The up axis of the land. The default is "y". */
    up?: Up | undefined;
}

/** Options of a terrain's geometry, and of terrainFromMesh. */
export type TerrainOptions = LevelOptions;

/** The up axes for a binding. */
export interface BindingOptions extends LevelOptions {
    /** The up axis of the model's source. The default is the axis that modelFromObject was given, otherwise the land's. */
    modelUp?: Up | undefined;
}

/** Options of a binding to an object or an instance. */
export interface ObjectBindingOptions extends BindingOptions {
    /** The index of the instance in an InstancedMesh. No other object takes one. */
    index?: number | null | undefined;
}

/** Options of a wireframe. */
export interface WireframeOptions extends LevelOptions {
    /** The lines' colour: 0xrrggbb, or any colour that three.js accepts. The default is 0xffcc00. */
    color?: ColorRepresentation | undefined;
}

/**
 * Makes a model from a three.js object or geometry. It is one patch wide, unless `scaling` says otherwise: for a level take levelFromObject.
 *
 * For an object, all meshes count: also its children's, visible or not. They count in the present pose of their bones and morph targets,
 * with all instances of an InstancedMesh or a BatchedMesh, visible or not, and with the finest level of an LOD. The children's transforms count,
 * including mirrors. The object's own transform does not count, because it places the object in the world: see ThreeAgentBinding. Draw ranges count. If a mesh has
 * several materials, the groups with a material count. Lines, points, sprites and meshes scaled to 0 are left out.
 *
 * Hits tell the mesh and the material of a triangle: see `faceOf`, `Model.meshNames` and `Model.materialNames`. A mesh has its own name, or its
 * geometry's if it has none. A name may be "", as in three.js. All instances of an InstancedMesh or a BatchedMesh are one mesh. A source that
 * is a geometry has neither meshes nor materials.
 *
 * Vertices at equal positions become one. Vertices that no triangle uses are left out. Triangles are counter-clockwise seen from outside,
 * as in three.js.
 *
 * @param name what agents call the shape, not empty
 * @param source an object or a geometry; only its world matrices are updated
 * @param options the up axis, and the scaling
 * @throws ModelError if the source is neither or has no triangles, if a triangle uses a missing vertex, if a coordinate is not finite, or
 * if the name is empty
 * @throws ArgumentError if the name is no string, or if up is neither "y" nor "z"
 */
export function modelFromObject(name: string, source: Object3D | BufferGeometry, options?: ModelOptions): Model;

/**
 * Makes a model of a level: of an object that stands still in the land, and of everything below it. All meshes become one model, and one unit
 * of the land is a patch. An agent of this shape that is at the origin, with size 1 and not turned, collides where the level is drawn. It
 * has no binding: what moves has a model of modelFromObject.
 *
 * The object's parent must be the land: the object's own transform counts here. Otherwise the same meshes count as in modelFromObject.
 *
 * @param name what the level's agent calls the shape, not empty
 * @param object an object or a geometry; only its world matrices are updated
 * @param options the up axis
 * @throws ModelError as modelFromObject
 * @throws ArgumentError as modelFromObject
 */
export function levelFromObject(name: string, object: Object3D | BufferGeometry, options?: LevelOptions): Model;

/** What three.js draws at a triangle of a model, by the names of a Raycaster's intersection. */
export interface DrawnFace {
    /** The mesh: of instances, their InstancedMesh or BatchedMesh. */
    object: Mesh;
    /** The index of the face in the mesh's geometry. */
    faceIndex: number;
    /** The index of the instance: of a BatchedMesh what three.js calls batchId. Null if the mesh has no instances. */
    instanceId: number | null;
}

/**
 * What three.js draws where a hit is: `faceOf(levelModel, hit.triangle)`. The model keeps the meshes that it was made of. Their geometries may have
 * changed since.
 *
 * @param model a model that modelFromObject or levelFromObject has made of an object
 * @param triangle the number of the triangle, as a hit has it
 * @returns the face; null for the triangle -1 of a hit of a structure
 * @throws ArgumentError if the model was made of a geometry or in another way
 * @throws RangeError if the model has no such triangle
 */
export function faceOf(model: Model, triangle: number): DrawnFace | null;

/**
 * Keeps an agent and its three.js object in the same place: position, rotation and size. So the player sees what collides.
 *
 * The object's parent must be the land: one unit per patch, y up or z up. If the object is the source of a model or contains it, pass that
 * model. It gives the object's origin and size. Without a model, the object must be drawn normalised, like the agent's model.
 *
 * Call `updateObject()` each frame if the agent leads, or `updateAgent()` if the object leads. Both compare the two sides, and do nothing
 * if nothing has changed. If an object's `matrixAutoUpdate` is false, its matrix is read. An object with a `pivot`, which three.js would turn it
 * around, is refused.
 */
export class ThreeAgentBinding<BoundAgent extends Agent = Agent> {
    /**
     * Creates a binding. It changes neither side.
     *
     * @param agent the agent
     * @param object its object
     * @param model the agent's model, if the object is its source or has the same geometry; null if the object is drawn normalised
     * @param options the up axes
     * @throws ArgumentError if an argument is of the wrong kind, if the object has a pivot, or if the model is mirrored or stretched in its source, is
     * of levelFromObject and its object is not at the origin, or is of all instances of the InstancedMesh
     * @throws RangeError if the InstancedMesh has no such instance
     */
    constructor(agent: BoundAgent, object: Object3D, model?: Model | null, options?: ObjectBindingOptions);

    /** The agent. */
    get agent(): BoundAgent;

    /** The agent's object. For an instance, its InstancedMesh. */
    get object(): Object3D;

    /** Gives the object the agent's place, size and rotation. */
    updateObject(): void;

    /**
     * Gives the agent the object's place, size and rotation. If the agent already has the rotation or the size, up to rounding, its heading, pitch
     * and roll or its size stay. If the object has not changed since the last update of either side, the agent gets exactly the place, the size and the
     * rotation that it had then. The three angles may be others of the same rotation: 5 for a heading of 725.
     *
     * @throws ArgumentError if the object is mirrored, not uniformly scaled or sheared, or one of its numbers is not finite; the agent is then
     * unchanged
     * @throws RangeError if the agent can't have that size or place; the agent is then unchanged
     */
    updateAgent(): void;

    /**
     * Gives the model the pose of the object: the places that its bones, morph targets and children's transforms give to the vertices now. Call
     * it before the frame's `update()`, after the AnimationMixer's. All agents with the model have the pose: see `Model.pose`. Only its tree has it: an
     * agent that collides as a structure keeps the first pose, so set `hierarchical` in a CombinationCollider.
     *
     * The model must be one of `modelFromObject`, and the object its source or a clone of it, with the same meshes. Vertices that were at equal
     * positions when the model was made stay one. The source's own meshes may have another order by now; those of a clone have the same, and none of them is
     * the source's. If it throws, the model is unchanged.
     *
     * @throws ArgumentError if the binding has no model or is one of an instance, if the model was made in another way or of other meshes, or if
     * a coordinate is not finite
     */
    updateModel(): void;
}

/**
 * Binds an agent to an instance of an InstancedMesh. The mesh itself is the land, so its own transform moves all instances.
 *
 * The instances' matrices have single precision. When an instance moves, the mesh's bounding sphere and box are reset. three.js computes
 * them again when it needs them.
 *
 * @param agent the agent
 * @param mesh the mesh
 * @param index the index of the instance, from 0
 * @param model the model of the mesh's geometry; null if that is normalised
 * @param options the up axes
 * @throws ArgumentError as ThreeAgentBinding's constructor
 * @throws RangeError if there is no such instance
 */
export function bindInstance<BoundAgent extends Agent>(
    agent: BoundAgent, mesh: InstancedMesh, index: number, model?: Model | null, options?: BindingOptions
): ThreeAgentBinding<BoundAgent>;

/**
 * Draws structures, levels of hierarchies, contacts and rays as lines, all in one LineSegments, so three.js draws them in one call. Its
 * parent must be the land. Lines of an agent move with it when you call `update()`. Other lines are in the world.
 */
export class ThreeWireframe extends LineSegments<BufferGeometry, LineBasicMaterial> {
    /**
     * Creates a wireframe without lines.
     *
     * @param options the colour, and the up axis
     */
    constructor(options?: WireframeOptions);

    /**
     * Shows a structure, in addition to the lines already shown.
     *
     * @param structure in the space of the agent's model, as in a library; without an agent, in the world
     * @param agent the agent that it belongs to
     * @returns this
     */
    showStructure(structure: BoundingStructure, agent?: Agent | null): this;

    /**
     * Shows the structures that a collider reaches if it visits this many levels of a hierarchy.
     *
     * @param root the hierarchy's root
     * @param level from 1
     * @param agent the agent that it belongs to
     * @returns this
     * @throws RangeError if the level is less than 1
     */
    showLevel(root: HierarchyNode, level: number, agent?: Agent | null): this;

    /**
     * Shows a contact as it is now: a cross at its point, and a line along its normal, as long as its depth.
     *
     * @param contact the contact that a handler was given
     * @returns this
     * @throws ArgumentError if it is no contact
     */
    showContact(contact: Contact): this;

    /**
     * Shows a ray.
     *
     * @param origin its beginning, in the world, z up
     * @param direction of any length
     * @param reach its length in patches if it hits nothing; the default is 1
     * @param hit the hit: it is shown as a cross and a normal
     * @returns this
     * @throws ArgumentError if an argument is of the wrong kind or not finite, or if the direction is 0
     */
    showRay(origin: Point, direction: Point, reach?: number, hit?: RayHit | null): this;

    /**
     * Shows lines, as Wireframes has them.
     *
     * @param lines six numbers each, z up; copied
     * @param agent the lines are in the space of its model; without an agent, in the world
     * @returns this
     * @throws ArgumentError if the numbers are no multiple of six, or one is not finite; if the agent is none
     */
    showLines(lines: ArrayLike<number>, agent?: Agent | null): this;

    /**
     * Removes all lines.
     *
     * @returns this
     */
    clearLines(): this;

    /** Moves the lines to their agents. If no agent has changed, it does nothing. */
    update(): void;

    /**
     * Takes over another wireframe's lines, as `clone()` does. The two share no geometry, because each moves its own lines.
     *
     * @returns this
     */
    copy(source: this, recursive?: boolean): this;

    /** Frees the renderer's data. */
    dispose(): void;
}

/**
 * The surface of a terrain: slopes, or blocks with walls between them. The mesh's parent must be the land, and the mesh must not be moved in
 * it. Slopes have smooth normals, and blocks have flat ones. Where the grid ends, walls go down to its lowest height.
 */
export class TerrainGeometry extends BufferGeometry {
    /**
     * Creates the geometry with the present heights.
     *
     * @param terrain the terrain
     * @param options the up axis
     * @throws ArgumentError if the first argument is no Terrain, or up is neither "y" nor "z"
     */
    constructor(terrain: Terrain, options?: TerrainOptions);

    /** The terrain. */
    get terrain(): Terrain;

    /** Becomes a geometry of another one's terrain, in the same axes. */
    copy(source: this): this;

    /**
     * Follows the terrain: its heights, and whether it is blocks. If nothing has changed, it does nothing.
     *
     * @returns whether something has changed
     */
    update(): boolean;
}

/**
 * Makes a terrain with the heights of an object or a geometry. Each height is that of the highest triangle above or below its place. Where
 * there is no triangle, the height is the least that was found, or 0 if none was. Triangles with coordinates that are not finite do not
 * count.
 *
 * The object's parent must be the land: the object's own transform counts here. Otherwise the same meshes count as in modelFromObject.
 *
 * @param source an object or a geometry; only its world matrices are updated
 * @param columns how many heights there are along x, at least 2
 * @param rows how many heights there are along y, at least 2
 * @param cellWidth how far neighbours are apart; the default is 1
 * @param x where the first height is, in the engine's axes; the default is 0
 * @param y where the first height is; the default is 0
 * @param options the up axis
 * @throws ModelError as modelFromObject, but a source without triangles gives flat ground
 * @throws ArgumentError if up is neither "y" nor "z"
 * @throws RangeError as Terrain's constructor, or if a height is too large
 */
export function terrainFromMesh(
    source: Object3D | BufferGeometry, columns: number, rows: number, cellWidth?: number, x?: number, y?: number, options?: TerrainOptions
): Terrain;
