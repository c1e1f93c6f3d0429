/** What is taken wherever numbers are listed. */
export type Numbers = readonly number[] | Float32Array | Float64Array | Int8Array | Int16Array | Int32Array | Uint8Array | Uint16Array | Uint32Array;

/** What is taken for a file's bytes. */
export type Bytes = ByteArray | ArrayBuffer | ArrayBufferView;

/** Bytes that a Blob, a file or postMessage takes: they have a buffer of their own. */
export type OwnBytes = ReturnType<Uint8ArrayConstructor["from"]>;

/** What is taken for a point or a direction: a Vector3D, three.js's Vector3, a literal. It is read at the call. */
export interface Point {
	readonly x: number;
	readonly y: number;
	readonly z: number;
}

/** What takes a point that a question finds: its x, y and z are written. */
export interface PointTaker {
	x: number;
	y: number;
	z: number;
}

/** What a call returns that takes a point: what took it, or without that a new Vector3D. */
export type Taken<Taker> = Taker extends PointTaker ? Taker : Vector3D;

/** What is taken for a picture: the platform's ImageData, or the same numbers from elsewhere. */
export interface Picture {
	readonly width: number;
	readonly height: number;
	/** Red, green, blue and alpha of each pixel, from 0 to 255, row by row from the top. */
	readonly data: ArrayLike<number>;
}

/** Which axis of a file points up, or what turns it otherwise. */
export type UpAxis = "x" | "y" | "z" | ModelTransform;

/** How a model is scaled. */
export type Scaling = typeof Model.FOOTPRINT | typeof Model.VOLUME | typeof Model.AS_GIVEN;

/** A type, where the compiler must not infer it. */
export type NoInfer<Type> = [Type][Type extends unknown ? 0 : never];

/** A list that a question fills with agents of a class. A list of only some of them is refused: it would hold the others too. */
export type Filled<FoundAgent> = (NoInfer<FoundAgent>[] & { push: (...agents: NoInfer<FoundAgent>[]) => number }) | never[];

/**
 * What is taken for a handler of collisions. The third type is what it gets for a contact: a handler of ends gets null, and one of both a
 * `Contact | null`.
 */
export type Handler<ColliderAgent extends Agent = Agent, CollideeAgent extends Agent = Agent, Met extends Contact | null = Contact> = (
	collider: ColliderAgent, collidee: CollideeAgent, contact: Met
) => void;

/**
 * What is taken for an AgentFilter: one, or a literal with some of its properties. The second type is the class of an `accepts` that is a type guard, the
 * third one the names in `breeds`, the last one those in `exceptBreeds`.
 */
export interface AgentFilterInit<
	GameAgent extends Agent = Agent, FoundAgent extends GameAgent = GameAgent, Name extends string = string, ExceptName extends string = string
> {
	/** Only agents of these breeds count. If the list is empty, no agent counts. */
	breeds?: readonly Name[] | null | undefined;
	/** Agents of these breeds do not count. */
	exceptBreeds?: readonly ExceptName[] | null | undefined;
	/** These agents do not count. Null among them is nobody. */
	except?: readonly (Agent | null | undefined)[] | null | undefined;
	/** Returns true if an agent counts. It is called last, for as few agents as the answer needs: see {@link AgentFilter.accepts}. */
	accepts?: ((agent: GameAgent) => agent is FoundAgent) | { accept(agent: GameAgent): boolean }["accept"] | null | undefined;
}

/** What is taken for WalkOptions: an object of this class, or a literal with some of its properties. */
export type WalkOptionsInit<GameAgent extends Agent = Agent, Name extends string = string, ExceptName extends string = string> = {
	[Key in keyof WalkOptions]?: (Key extends "filter" ? AgentFilterInit<GameAgent, GameAgent, Name, ExceptName> | null : WalkOptions[Key]) | undefined;
};

/** The agents of a game, for their class or for the classes of its breeds: `{ heroes: Hero; coins: Coin }`. Of `object` nothing is known. */
export type AgentsOf<Breeds> = Breeds extends Agent ? Breeds : [keyof Breeds] extends [never] ? Agent : Extract<Breeds[keyof Breeds], Agent>;

/** The names that handlers take for breeds: those that have classes and the engine's own, or any if it is not known which there are. */
export type BreedOf<Breeds> = Breeds extends Agent ? string : (keyof Breeds & string) | "*" | "*terrain" | "*edge";

/** The agents of a breed, or of any breed. Those of the ground and of the edges of the world are of no class of the game's. */
export type AgentOf<Breeds, Name> = Name extends "*terrain" | "*edge" ? Agent : Breeds extends Agent ? Breeds
	: Name extends keyof Breeds ? Extract<Breeds[Name], Agent> : Name extends "*" ? AgentsOf<Breeds> : Agent;

/** A name in a filter's `breeds` or `exceptBreeds`. A name that the compiler knows has to be one of the game's breeds, if their classes are known. */
export type NamedBreed<Breeds, Name extends string> = string extends Name ? Name : [Name] extends [BreedOf<Breeds>] ? Name : BreedOf<Breeds>;

/** What a question finds: agents of a class, and if the compiler knows the names in the filter's `breeds` or `exceptBreeds`, only those that it leaves. */
export type Found<FoundAgent, Breeds, Name, ExceptName> = string extends Name ? NotExcepted<FoundAgent, Breeds, ExceptName> : Extract<FoundAgent, AgentOf<Breeds, Name>>;

/** Agents without those of some breeds. If there is a plain Agent among them, as the ground's is, it may be any, so nothing is left out. */
export type NotExcepted<FoundAgent, Breeds, ExceptName> = string extends ExceptName ? FoundAgent
	: Agent extends FoundAgent | AgentsOf<Breeds> ? FoundAgent : Extract<FoundAgent, AgentOf<Breeds, Exclude<keyof Breeds, ExceptName>>>;

/** An agent of the game, or the ground's, which is a plain Agent: `terrain.agent`. If the game has classes, `instanceof` tells them apart. */
export type OrGround<GameAgent extends Agent = Agent> = GameAgent | Agent;

/** What is called with an event, which may be of a class of its own. */
export type Listener = { listen(event: Event): void }["listen"];

/** How to listen: as to the platform's own events. */
export interface ListenerOptions {
	/** Whether the listener is called but once. */
	once?: boolean | undefined;
	/** Taken, and of no effect: events have no phases here. */
	capture?: boolean | undefined;
	/** Listening ends when it is aborted. */
	signal?: { readonly aborted: boolean; addEventListener(type: "abort", listener: () => void, options?: { once?: boolean }): void } | undefined;
}

/** An argument is not what it has to be. */
export class ArgumentError extends Error {
	constructor(message?: string);
}

/** Bytes with a place to read and write at, as far as loading models needs them. */
export class ByteArray {
	/** @param source bytes to begin with, which are copied */
	constructor(source?: Bytes | null);
	/** The order of a number's bytes: "bigEndian" or "littleEndian". */
	endian: "bigEndian" | "littleEndian";
	/** Where the next byte is read or written. */
	position: number;
	/** How many bytes there are. */
	length: number;
	/** The bytes, copied. */
	toUint8Array(): OwnBytes;
}

/** What a CollisionRecorder has recorded of the collisions of two breeds, or of all. */
export interface RecordedCollisions {
	/** The collisions in all frames. */
	collisions: number;
	/** The mean of all frames. */
	mean: number;
	/** The most collisions of a frame. */
	most: number;
	/** How many frames had how many collisions. */
	histogram: { collisions: number; frames: number }[];
}

/** What a CollisionRecorder has recorded, as an object for JSON. */
export interface CollisionRecord extends RecordedCollisions {
	/** How many frames there were. */
	frames: number;
	/** The collisions of each pair of breeds. */
	breeds: (RecordedCollisions & { breeds: [string, string] })[];
}
