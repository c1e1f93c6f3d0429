import type { BufferGeometry, InstancedMesh, LineBasicMaterial, LineSegments, Object3D } from "three";
import type { Agent, BoundingStructure, Contact, HierarchyNode, Model, Point, RayHit, Scaling } from "starlogo-collision";

/** The axis that points up. With y up, three.js's (x, y, z) is the engine's (x, -z, y); with z up, both have the same axes. */
export type Up = "y" | "z";

/** How modelFromObject reads. */
export interface ModelOptions {
    /** The axis of the source that is up: "y" unless told, as three.js and glTF have it. */
    up?: Up;
    /** How the model is scaled: Model.FOOTPRINT (unless told), Model.VOLUME or Model.AS_GIVEN. */
    scaling?: Scaling;
}

/** Which way is up for a binding. */
export interface BindingOptions {
    /** The axis of the land that is up: "y" unless told. */
    up?: Up;
    /** The axis that is up in what the model was made of; what modelFromObject was told, and otherwise the same as of the land. */
    modelUp?: Up;
}

/** Options of a binding to an instance. */
export interface ObjectBindingOptions extends BindingOptions {
    /** Which instance of an InstancedMesh is bound. */
    index?: number | null;
}

/** Options of a wireframe. */
export interface WireframeOptions {
    /** Of the lines: 0xrrggbb, or what else three.js takes for a colour. 0xffcc00 unless told. */
    color?: number | string;
    /** The axis of the land that is up: "y" unless told. */
    up?: Up;
}

/**
 * A model of what three.js draws.
 *
 * Of an object all meshes count, those of its children too, visible or not: in the pose that bones and morph targets give them, all instances
 * of an InstancedMesh, the finest level of an LOD. The children's transforms count, mirrors too; the object's own does not: it says
 * where the object is in the world, which is the concern of a ThreeAgentBinding. Draw ranges count, and of a mesh with several materials the
 * groups that have one. What is scaled to nothing, lines, points and sprites are left out.
 *
 * Vertices at equal positions are one; those that no triangle uses are left out. Triangles are counter-clockwise seen from outside, in
 * three.js's order.
 *
 * @param name what agents call the shape, not empty
 * @param source an object or a geometry, left as it is, but that its world matrices are brought up to date
 * @param options which axis is up, and the scaling
 * @throws ModelError if the source is neither or has no triangles, a triangle names no vertex, a coordinate is not finite, the name is
 *     empty, or a mesh is a BatchedMesh
 * @throws ArgumentError if up is neither "y" nor "z"
 */
export function modelFromObject(name: string, source: Object3D | BufferGeometry, options?: ModelOptions): Model;

/**
 * Keeps an agent and what three.js draws for it in the same place: position, rotation and size. What is drawn is then what collides.
 *
 * The object's parent is the land: one unit a patch, y up or z up. If the object is, or has, the source of a model, that model says where
 * and how large it is; without one, the object is taken to be drawn as the model is, normalised.
 *
 * Call `updateObject()` each frame when the agent leads, `updateAgent()` when the object does. Either compares both sides, and does nothing
 * when nothing has changed. An object whose `matrixAutoUpdate` is false is read by its matrix.
 */
export class ThreeAgentBinding<A extends Agent = Agent> {
    /**
     * Changes neither.
     *
     * @param agent the agent
     * @param object what is drawn for it
     * @param model what the agent's model was made of, the object being its source or an object of the same geometry; null if the object
     *     is drawn normalised
     * @param options which axes are up
     * @throws ArgumentError if one of them is not what it has to be, or the model is mirrored or stretched in its source
     * @throws RangeError if the InstancedMesh has no such instance
     */
    constructor(agent: A, object: Object3D, model?: Model | null, options?: ObjectBindingOptions);

    /** The agent. */
    get agent(): A;

    /** What is drawn for the agent; the InstancedMesh of an instance. */
    get object(): Object3D;

    /** Puts the object where the agent is, as large, turned the same way. */
    updateObject(): void;

    /**
     * Gives the agent the object's place, size and rotation. A rotation that the agent has already, up to rounding, leaves heading, pitch and
     * roll as they are.
     *
     * @throws ArgumentError if the object is mirrored, unevenly scaled or sheared, or a number of it is not finite; the agent is then as
     *     it was
     * @throws RangeError if the agent can't be so large, so small or so far away; it is then as it was
     */
    updateAgent(): void;
}

/**
 * Binds an agent to an instance of an InstancedMesh. The mesh itself is the land: its own transform moves all.
 *
 * The instances' matrices are of single precision. Bounding sphere and box of the mesh are forgotten when an instance moves; three.js
 * computes them again when it needs them.
 *
 * @param agent the agent
 * @param mesh the mesh
 * @param index which instance, from 0
 * @param model of the mesh's geometry; null if that is normalised
 * @param options which axes are up
 * @throws ArgumentError as ThreeAgentBinding's constructor does
 * @throws RangeError if there is no such instance
 */
export function bindInstance<A extends Agent>(agent: A, mesh: InstancedMesh, index: number, model?: Model | null, options?: BindingOptions): ThreeAgentBinding<A>;

/**
 * Lines for structures, levels of hierarchies, contacts and rays, all in one LineSegments, which three.js draws at once. Its parent is the
 * land. What is shown with an agent moves with it, by `update()`; what is shown without is in the world.
 */
export class ThreeWireframe extends LineSegments<BufferGeometry, LineBasicMaterial> {
    /**
     * A wireframe without lines.
     *
     * @param options the colour, and which axis is up
     */
    constructor(options?: WireframeOptions);

    /**
     * Shows a structure, beside what is shown already.
     *
     * @param structure in the model's space of the agent, as a library has it; without an agent, in the world
     * @param agent whose it is
     * @returns this
     */
    showStructure(structure: BoundingStructure, agent?: Agent | null): this;

    /**
     * Shows what a collider looks at last when it visits so many levels of a hierarchy.
     *
     * @param root the hierarchy's root
     * @param level from 1
     * @param agent whose it is
     * @returns this
     * @throws RangeError if the level is less than 1
     */
    showLevel(root: HierarchyNode, level: number, agent?: Agent | null): this;

    /**
     * Shows a contact as it is now: a cross at its point, and a line along its normal, as long as it is deep.
     *
     * @param contact which a handler was given
     * @returns this
     */
    showContact(contact: Contact): this;

    /**
     * Shows a ray.
     *
     * @param origin where it begins, in the world, z up
     * @param direction of any length
     * @param reach how far it goes, in patches, if it hits nothing; 1 unless told
     * @param hit what it meets: a cross there, and the normal
     * @returns this
     * @throws ArgumentError if the direction is 0 or not finite
     */
    showRay(origin: Point, direction: Point, reach?: number, hit?: RayHit | null): this;

    /**
     * Shows lines, as Wireframes has them.
     *
     * @param lines six numbers each, z up, which are copied
     * @param agent in whose model's space they are; without one, they are in the world
     * @returns this
     * @throws ArgumentError if they are not six each
     */
    showLines(lines: ArrayLike<number>, agent?: Agent | null): this;

    /**
     * Shows nothing more.
     *
     * @returns this
     */
    clearLines(): this;

    /** Moves lines to their agents; does nothing where those have not changed. */
    update(): void;

    /** Frees what the renderer keeps of it. */
    dispose(): void;
}
