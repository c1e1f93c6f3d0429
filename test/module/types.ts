// What the types of the package say, and what they refuse: tsc --strict has to accept all of it, and to find an error where one is expected.
import {
	Agent, AgentFilter, AgentPlaces, AgentPredicate, AgentQueries, BinCollider, BoundingStructure, BuiltInModel, ByteArray, Collision, CollisionBlocks, Contact, Footing, GltfModel, GreatLand, HierarchicalCollider, Model, ModelEvent,
	ModelLoader, ModelTransform, ObjModel, RayHit, SeenAgents, Sphere, Terrain, TightestFitCollider, TraitBlocks, Vector3D, WalkOptions,
} from "starlogo-collision";
import type { AgentFilterInit, BaseCollider, Box, CollisionSystem, CollisionStatistics, Handler, Matrix3D, ModelLoaderEvents, Placement, Numbers, ShapeHit, WalkOptionsInit } from "starlogo-collision";

/** Fails unless the two are the same. */
type Same<X, Y> = (<T>() => T extends X ? 1 : 2) extends <T>() => T extends Y ? 1 : 2 ? true : false;
const is = <_T extends true>(): void => {};

class Hero extends Agent {
	life = 3;
}

const land = new GreatLand();
const heroes: readonly Hero[] = [new Hero("cube"), new Hero("cube", "heroes")];

// a game's own agents
const bins = new BinCollider();
const found = bins.findCollisions(heroes);
is<Same<typeof found, Hero[]>>();
const system: CollisionSystem = new TightestFitCollider(land);
is<Same<ReturnType<typeof system.findCollisions<Hero>>, Hero[]>>();
const collision = new Collision<Hero>(bins);
collision.onCollision("heroes", Collision.ANY_BREED, (collider, collidee, contact) => {
	is<Same<typeof collider, Hero>>();
	is<Same<typeof collidee, Hero>>();
	is<Same<typeof contact, Contact>>();
	collider.life -= contact.depth;
});
collision.onCollision("heroes", "heroes", (collider) => collider.life--);
collision.onCollisionStart("heroes", "heroes", (a: Hero, b: Hero, contact: Contact) => a.moveTo(b.x, contact.point.y, 0));
collision.update(heroes);
const plain = new Collision(bins);
plain.onCollision("a", "b", (a, b, contact: Contact) => a.jumpTo(b.x, b.y, contact.time));
plain.update([new Agent("cube"), new Hero("cube")]);
// @ts-expect-error other agents than the game's
collision.update([new Agent("cube")]);
// @ts-expect-error no property of an Agent
plain.onCollision("a", "b", (a) => a.life);
// @ts-expect-error there is no contact at the end: it is null
collision.onCollisionEnd("a", "b", (a: Hero, b, contact) => contact.depth + a.life + b.life);
// @ts-expect-error the same, said
collision.onCollisionEnd("a", "b", (a, b, contact: Contact) => a.moveTo(b.x, contact.depth, 0));
collision.onCollisionEnd("a", "b", (a, b) => a.life - b.life);
collision.onCollisionEnd("a", "b", (...all) => all.length);
// @ts-expect-error no function
collision.onCollision("a", "b", "handler");
// @ts-expect-error no array
collision.update(new Set(heroes));
// @ts-expect-error no collision system
new Collision({});
// @ts-expect-error this one needs models
new TightestFitCollider();
new BinCollider(null);

// numbers, Booleans, names
const agent = heroes[0]!;
// @ts-expect-error no number
agent.x = "3";
// @ts-expect-error no Boolean
agent.sweeps = "no";
// @ts-expect-error not to be set
agent.id = 3;
agent.collideAs = "sphere";
agent.collideAs = Agent.BOX;
// @ts-expect-error no such structure
agent.collideAs = "ball";
is<Same<typeof Agent.CAPSULE, "capsule">>();
new ObjModel("x", "v 0 0 0", "y");
// @ts-expect-error no such axis
new ObjModel("x", "v 0 0 0", "Y");
ObjModel.fromBytes("x", new Uint8Array(9), new ModelTransform(), Model.AS_GIVEN);
GltfModel.fromBytes("x", new ArrayBuffer(9), "y", "volume", { "x.bin": new ByteArray() });
// @ts-expect-error no such axis
GltfModel.fromBytes("x", new ArrayBuffer(9), 3);
// @ts-expect-error no such scaling
new Model("x", [0, 0, 0], null, "large");
const numbers: Numbers = [0, 0, 0, 1, 0, 0, 0, 1, 0] as const;
new Model("triangle", numbers, new Uint16Array([0, 1, 2]));
new Model("triangle", new Float32Array(9), null);
// @ts-expect-error a list of strings
new Model("triangle", ["0", "1"]);

// events
declare const abort: { signal: { aborted: boolean; addEventListener(type: string, listener: () => void): void } };
declare const blob: { size: number; arrayBuffer(): Promise<ArrayBuffer> };
declare const url: { href: string };
const loader = new ModelLoader(land);
loader.addEventListener("modelLoaded", (event) => {
	is<Same<typeof event, ModelEvent>>();
	event.model.name.trim();
}, { once: true, signal: abort.signal });
loader.addEventListener("error", (event) => event.text.trim());
loader.addEventListener("progress", (event) => event.bytesLoaded / event.bytesTotal);
loader.addEventListener("complete", () => {});
loader.addEventListener(ModelEvent.LOADED, (event) => event.model.name.trim());
const onError = (event: ModelLoaderEvents["error"]) => event.text.trim();
loader.addEventListener("error", onError);
loader.removeEventListener("error", onError);
// @ts-expect-error events have their names only
loader.addEventListener("modelloaded", () => {});
// @ts-expect-error there is no such event
loader.removeEventListener("loaded", () => {});
// @ts-expect-error any string is no event
loader.addEventListener("error" as string, () => {});
const awaited: Promise<Model> = loader.loadAsync("x", "x.obj", { upAxis: "y", scaling: Model.VOLUME, signal: abort.signal });
awaited.then((model) => model.name.trim());
// @ts-expect-error there is no such axis
loader.loadAsync("x", "x.obj", { upAxis: "w" });
// @ts-expect-error that event has no model
loader.addEventListener("complete", (event) => event.model);
// @ts-expect-error a Blob is no bytes
loader.loadBytes("x", blob);
// @ts-expect-error an address is a string
loader.load("x", url);

// null where it can come
const hit = new RayHit();
hit.agent.id;
// @ts-expect-error there may be none
new Footing().on.id;
const filter = new AgentFilter();
filter.breeds = ["a"];
filter.breeds = null;
filter.accepts = (agent) => agent.size > 1;
filter.accepts = (hero: Hero) => hero.life > 1;
filter.accepts = null;
// @ts-expect-error it says whether
filter.accepts = (agent) => agent.breed;
// literals serve as filters and options
const near: Hero[] = new AgentQueries(collision).near(agent, 3, { breeds: ["heroes"], except: [agent] });
new AgentQueries(plain).walk(near[0]!, 1, 0, { stepHeight: 0.3, filter: { exceptBreeds: ["coins"] } });
new AgentQueries(plain).near(agent, 3, { accepts: (hero: Hero) => hero.life > 1 });
// @ts-expect-error there is no such property
new AgentQueries(plain).near(agent, 3, { breed: ["heroes"] });
// @ts-expect-error a list
new AgentQueries(plain).near(agent, 3, { breeds: "heroes" });
class Gate extends Agent {
	// @ts-expect-error a field of a subclass would hide the engine's
	isOneWay = true;
	// @ts-expect-error the same
	color = 3;
}
new Gate("gate").isOneWay = false;
class Coin extends Agent {
	worth = 1;
}
// a handler says which of the game's agents its breeds are
const mixed = new Collision<Hero | Coin>(bins);
mixed.onCollision("heroes", "coins", (hero: Hero, coin: Coin) => (hero.life += coin.worth));
mixed.onCollisionStart("coins", "heroes", (coin: Coin, hero: Hero, contact) => (hero.life += coin.worth * contact.depth));
mixed.onCollisionEnd("heroes", "coins", (hero: Hero, coin: Coin) => (hero.life -= coin.worth));
mixed.onCollision("heroes", "coins", (hero: Hero, other) => (other instanceof Coin ? other.worth : hero.life));
mixed.onCollision("heroes", "coins", (hero: Agent) => hero.x);
// @ts-expect-error no agent of the game
mixed.onCollision("heroes", "coins", (hero: Hero, coin: Date) => 0);
// @ts-expect-error it may be of either class
mixed.onCollision("heroes", "coins", (hero) => hero.life);
// the ground and the edges are no agents of the game
mixed.onCollision("heroes", Collision.TERRAIN, (hero: Hero, ground) => (is<Same<typeof ground, Agent>>(), hero.life--));
collision.onCollisionStart(Collision.EDGE, "heroes", (edge, hero) => (is<Same<typeof edge, Agent>>(), hero.life--));
// a filter is for the game's own agents, and lists may be read only
const mixedQueries = new AgentQueries(mixed);
const breeds: readonly string[] = ["coins"];
const friends: readonly Coin[] = [];
mixedQueries.near(friends[0]!, 3, { breeds, except: friends, accepts: (other) => other instanceof Coin && other.worth > 1 });
new AgentQueries(collision).nearest(agent, 3, { accepts: (hero) => hero.life > 1 });
// a question may say which of them it finds
const beside = mixedQueries.near(friends[0]!, 3);
is<Same<typeof beside, (Hero | Coin)[]>>();
mixedQueries.near<Coin>(friends[0]!, 3, { breeds })[0]!.worth++;
const coin: Coin | null = mixedQueries.nearestToPoint<Coin>({ x: 0, y: 0, z: 0 }, 3, { breeds });
// @ts-expect-error where it is stored says nothing of what it finds
const noCoin: Coin | null = mixedQueries.nearestToPoint({ x: 0, y: 0, z: 0 }, 3, { breeds });
// nor does the list that it fills, which has to take all that it may find
const either: (Hero | Coin)[] = [coin!];
const stored = mixedQueries.near(friends[0]!, 3, { breeds }, either);
is<Same<typeof stored, (Hero | Coin)[]>>();
// what touches may be the ground, whose agent has no class of the game's
const touched = mixedQueries.touching(friends[0]!);
is<Same<typeof touched, (Hero | Coin | Agent)[]>>();
mixedQueries.touching(friends[0]!, { breeds }, []);
mixedQueries.overlapping(new Sphere(new Vector3D(), 1), null, touched)[0]!.size++;
// @ts-expect-error the ground may get among them
mixedQueries.touching(friends[0]!, { breeds }, either);
// @ts-expect-error the ground has no life
mixedQueries.touching(friends[0]!)[0]!.life;
mixedQueries.touching(friends[0]!, { accepts: (other) => other instanceof Coin && other.worth > 1 });
// @ts-expect-error it is asked about the ground too
mixedQueries.touching(friends[0]!, { accepts: (other) => other.life > 1 });
const onlyHeroes: Hero[] = [];
// @ts-expect-error a coin may get among the heroes
mixedQueries.near(friends[0]!, 3, null, onlyHeroes);
// @ts-expect-error the same, whatever breeds it names
mixedQueries.touching(friends[0]!, { breeds }, [coin!]);
mixedQueries.near<Hero>(friends[0]!, 3, { breeds: ["heroes"] }, onlyHeroes);
const coins = mixedQueries.touching<Coin>(friends[0]!, { breeds }, [coin!]);
is<Same<typeof coins, Coin[]>>();
// or its filter does, and nobody has to
const onlyCoins = { accepts: (agent: Agent): agent is Coin => agent instanceof Coin };
const guarded = mixedQueries.near(friends[0]!, 3, onlyCoins);
is<Same<typeof guarded, Coin[]>>();
const nearCoin = mixedQueries.nearest(friends[0]!, 3, { breeds, accepts: (agent): agent is Coin => agent instanceof Coin && agent.worth > 1 });
is<Same<typeof nearCoin, Coin | null>>();
const inferred = new AgentQueries(plain).near(agent, 3, { accepts: (other) => other instanceof Hero });
is<Same<typeof inferred, Hero[]>>();
const anyone: Agent[] = mixedQueries.near(friends[0]!, 3);
// @ts-expect-error no agent of the game
mixedQueries.near<Date>(friends[0]!, 3);
// @ts-expect-error a hero or a coin
mixedQueries.near(friends[0]!, 3)[0]!.worth;
mixedQueries.near(friends[0]!, 3, { breeds: undefined, accepts: undefined });
mixedQueries.walk(friends[0]!, 1, 0, { stepHeight: undefined, filter: { exceptBreeds: breeds } });
filter.breeds = breeds;
filter.except = friends;
const init: AgentFilterInit<Coin> = { accepts: (coin) => coin.worth > 1 };
const stride: WalkOptionsInit<Coin> = { filter: init, fall: 1 };
new AgentQueries<Coin>(bins).walk(friends[0]!, 1, 0, stride);
const seen: Model | null = land.modelOf("cube");
const walks = new AgentQueries(collision);
for (const footing of [new Footing(), null]) {
	is<Same<ReturnType<typeof walks.walk>, Footing>>();
	walks.walk(near[0]!, 1, 0, null, footing);
}
const walkOf = <A extends Agent>(asked: AgentQueries<A>, walker: A): Footing => asked.walk(walker, 1, 0, null, new Footing());
walkOf(walks, near[0]!).on?.breed;
// @ts-expect-error a walker may stand on any agent, and on the ground
new Footing<Hero>();
// @ts-expect-error the ground has no life
walks.walk(near[0]!, 1, 0).on?.life;
new AgentQueries(plain).walk(near[0]!, 1, 0, null, new Footing());
collision.removeHandler("heroes", "heroes", () => 0, "start");
// @ts-expect-error there is no such kind
collision.removeHandler("heroes", "heroes", () => 0, "begin");
// @ts-expect-error the kind of a structure stays
land.boundingStructures.tightestFit("cube").kind = 1;
// what questions find are the game's own agents
const questions = new AgentQueries(collision);
const met = questions.cast(new Vector3D(), new Vector3D(1, 0, 0), 9, filter, hit);
is<Same<typeof met, RayHit<Hero | Agent> | null>>();
// @ts-expect-error the ground has no life
if (met) met.agent.life--;
if (met?.agent instanceof Hero) met.agent.life--;
const isHero = (one: Agent): one is Hero => one instanceof Hero;
const metHero = questions.cast(new Vector3D(), new Vector3D(1, 0, 0), 9, { accepts: isHero });
is<Same<typeof metHero, RayHit<Hero> | null>>();
questions.castShapeAll<Hero>(new Sphere(new Vector3D(), 1), 1, 0, 0, { breeds: ["heroes"] })[0]!.agent.life--;
is<Same<RayHit["meshName"], string | null>>();
is<Same<RayHit<Hero>["agent"], Hero>>();
is<Same<RayHit["agent"], Agent>>();
const all = questions.castAll(new Vector3D(), new Vector3D(1, 0, 0), 9, null, [hit]);
is<Same<typeof all, RayHit<Hero | Agent>[]>>();
questions.castAll(new Vector3D(), new Vector3D(1, 0, 0), 9, null, null, true);
questions.castAll(new Vector3D(), new Vector3D(1, 0, 0), 9, null, null, { allSurfaces: true });
questions.cast(new Vector3D(), new Vector3D(1, 0, 0), 9, null, new RayHit<Hero>());
questions.cast({ x: 0, y: 0, z: 1 }, { x: 1, y: 0, z: 0 } as const, 9);
// @ts-expect-error a point has three numbers
questions.cast([0, 0, 1], { x: 1, y: 0, z: 0 });
const bump = questions.castAgent(new Hero("cube"), 1, 0, 0);
is<Same<typeof bump, ShapeHit<Hero | Agent> | null>>();
// @ts-expect-error no property of an Agent
new AgentQueries(plain).cast(new Vector3D(), new Vector3D(1, 0, 0))!.agent.life;
const nearest = questions.nearest(agent, 3, filter);
is<Same<typeof nearest, Hero | null>>();
new AgentQueries(new BinCollider());
// @ts-expect-error neither a Collision nor a collision system
new AgentQueries(land);
is<Same<typeof CollisionBlocks.systemNames, string[]>>();
land.fitStore = null;
// @ts-expect-error null is no model
land.addModel(null);
land.addModel(BuiltInModel.cube());
const exact = new HierarchicalCollider(land);
exact.exact = true;
exact.maxDepth = 4;
mixed.onCollision<Hero, Coin>("heroes", "coins", (hero, coin) => (hero.life += coin.worth));
const ofAny: Collision = mixed;
ofAny.onCollision(breeds[0]!, Collision.ANY_BREED, (a, b) => a.size - b.size);
// breeds that have classes
const typed = new Collision<{ heroes: Hero; coins: Coin }>(bins);
typed.onCollisionStart("heroes", "coins", (hero, coin, contact) => {
	is<Same<typeof hero, Hero>>();
	is<Same<typeof coin, Coin>>();
	is<Same<typeof contact, Contact>>();
});
function nearOf<K extends "heroes" | "coins">(breed: K) {
	return new AgentQueries(typed).near(near[0]!, 3, { breeds: [breed] });
}
is<Same<ReturnType<typeof nearOf<"coins">>, Coin[]>>();
typed.onCollision("coins", Collision.ANY_BREED, (coin, other) => (is<Same<typeof other, Hero | Coin>>(), coin.worth));
typed.onCollision("heroes", Collision.TERRAIN, (hero, ground) => (is<Same<typeof ground, Agent>>(), hero.life));
typed.onCollisionEnd("coins", "heroes", (coin, hero) => coin.worth + hero.life);
typed.onCollision("heroes", "coins", (hero: Agent, coin: Coin) => coin.worth);
typed.update([new Hero("cube"), new Coin("sphere")]);
const typedQueries = new AgentQueries(typed);
is<Same<typeof typedQueries, AgentQueries<{ heroes: Hero; coins: Coin }>>>();
// who asks need not be in the list
is<Same<ReturnType<typeof typedQueries.near>, (Hero | Coin)[]>>();
typedQueries.near(new Agent("probe"), 3, { except: [null, undefined, new Agent("probe")] });
// @ts-expect-error a breed is no agent
typedQueries.near(new Agent("probe"), 3, { except: ["coins"] });
// a filter's breeds say what a question finds, if the compiler knows them
const typedCoins = typedQueries.near(agent, 3, { breeds: ["coins"] });
is<Same<typeof typedCoins, Coin[]>>();
const eitherBreed = typedQueries.nearest(agent, 3, { breeds: ["coins", "heroes"] });
is<Same<typeof eitherBreed, Hero | Coin | null>>();
const coinHit = typedQueries.cast({ x: 0, y: 0, z: 1 }, { x: 1, y: 0, z: 0 }, 9, { breeds: ["coins"] });
is<Same<typeof coinHit, RayHit<Coin> | null>>();
const namesCoins = { breeds: ["coins"] } as const;
const listed: Coin[] = typedQueries.touching(agent, namesCoins, [coin!]);
const ofAnyName = typedQueries.near(agent, 3, { breeds });
is<Same<typeof ofAnyName, (Hero | Coin)[]>>();
typedQueries.near<Coin>(agent, 3, { breeds })[0]!.worth++;
typedQueries.near(listed[0]!, 3, { breeds: ["coins"], accepts: (one) => one.size > 1 })[0]!.worth++;
typedQueries.touching(agent, { breeds: [Collision.TERRAIN] })[0]!.size++;
// @ts-expect-error a coin has no life
typedQueries.near(agent, 3, { breeds: ["coins"] })[0]!.life;
// @ts-expect-error there is no such breed
typedQueries.near(agent, 3, { breeds: ["coin"] });
typedQueries.walk(agent, 1, 0, { filter: { breeds: ["coins"] } });
// @ts-expect-error no breed of the game
typedQueries.walk(agent, 1, 0, { filter: { breeds: ["coin"] } });
// @ts-expect-error there is no such breed
typedQueries.countNear(agent, 3, { breeds: ["coin"] });
// those that do not count are named alike. With a plain Agent in the game nothing is left out
const exceptCoins = typedQueries.near(agent, 3, { exceptBreeds: ["coins", Collision.TERRAIN] });
is<Same<typeof exceptCoins, Hero[]>>();
const nearestHero = typedQueries.nearest(agent, 3, { exceptBreeds: ["coins"] });
is<Same<typeof nearestHero, Hero | null>>();
const touchedExcept = typedQueries.touching(agent, { exceptBreeds: ["coins"] });
is<Same<typeof touchedExcept, (Hero | Coin | Agent)[]>>();
const exceptAny = typedQueries.near(agent, 3, { exceptBreeds: breeds });
is<Same<typeof exceptAny, (Hero | Coin)[]>>();
const withPlain = new AgentQueries(new Collision<{ heroes: Hero; levels: Agent }>(bins)).near(agent, 3, { exceptBreeds: ["levels"] });
is<Same<typeof withPlain, (Hero | Agent)[]>>();
const exceptHeroes = typedQueries.near(agent, 3, { breeds: ["coins"], exceptBreeds: ["heroes"] });
is<Same<typeof exceptHeroes, Coin[]>>();
// @ts-expect-error there is no such breed
typedQueries.near(agent, 3, { exceptBreeds: ["coin"] });
typedQueries.walk(agent, 1, 0, { filter: { exceptBreeds: ["coins"] } });
// @ts-expect-error no breed of the game
typedQueries.walk(agent, 1, 0, { filter: { exceptBreeds: ["coin"] } });
// @ts-expect-error a coin is no hero
typedQueries.near(agent, 3, { breeds: ["coins"] }, onlyHeroes);
const ofNoClasses: AgentQueries = typedQueries;
ofNoClasses.near(agent, 3, { breeds: ["coin"] });
const ofTheGame: AgentQueries<Hero | Coin> = typedQueries;
// a field for questions says the breeds, as one for the Collision does
class Game {
	queries: AgentQueries<{ heroes: Hero; coins: Coin }> = new AgentQueries(typed);
	seen: SeenAgents<{ heroes: Hero; coins: Coin }> = new SeenAgents(typed);
	places: AgentPlaces<{ heroes: Hero; coins: Coin }> = new AgentPlaces(this.seen);
}
const ofFields = [new Game().queries, new Game().places].map((asked) => asked.near(agent, 3, { breeds: ["coins"] }));
is<Same<typeof ofFields, Coin[][]>>();
// @ts-expect-error there is no such breed
new Game().queries.near(agent, 3, { breeds: ["coin"] });
const ofSome = new AgentPlaces(new SeenAgents(typed)).near(agent, 3, { breeds: ["coins"] });
is<Same<typeof ofSome, Coin[]>>();
const ofAnyBreed: Collision = typed;
ofAnyBreed.update(heroes);
typed.removeHandler("heroes", Collision.ANY_BREED, () => 0);
// @ts-expect-error there is no such breed
typed.removeHandler("heroes", "coin", () => 0);
// @ts-expect-error there is no such breed
typed.onCollision("heros", "coins", () => 0);
// @ts-expect-error the coin is no hero
typed.onCollision("heroes", "coins", (hero, coin: Hero) => 0);
// @ts-expect-error other agents than the game's
typed.update([new Agent("cube")]);
typed.onCollision("heroes", "coins", (hero: Hero, coin) => hero.life + coin.worth);
// @ts-expect-error no agent
new Collision<{ heroes: Date }>(bins);
interface Breeds {
	heroes: Hero;
}
new Collision<Breeds>(bins).onCollision("heroes", "heroes", (a, b) => a.life - b.life);
// a Collision that has no variable of its own
new AgentQueries(new Collision(bins)).update([agent, new Coin("sphere")]);
new AgentQueries(new Collision<Hero>(bins)).nearest(agent)!.life--;
const seenOf = new SeenAgents(new Collision<{ heroes: Hero; coins: Coin }>(bins));
const nearby = new AgentPlaces(seenOf).near(agent, 3);
is<Same<typeof nearby, (Hero | Coin)[]>>();
// a Collision's filter takes a literal, and options may change
typed.filter = { exceptBreeds: breeds, accepts: (either) => either instanceof Hero && either.life > 1 };
typed.filter = filter;
typed.filter = null;
// @ts-expect-error there is no such property
typed.filter = { breed: ["heroes"] };
stride.fall = 0.1;
init.breeds = breeds;
// lists of the engine are for reading, and a copy is the game's own
declare const model: Model;
// @ts-expect-error the model's own vertices
model.vertices.push(0);
// @ts-expect-error the list of the last update
typed.lastAgents.length = 0;
const present: (Hero | Coin)[] = [...typed.lastAgents];
typed.restore(typed.snapshot(), present);
// bytes that a Blob takes
declare function save(part: { readonly buffer: ArrayBuffer }): void;
save(typed.snapshot());
save(land.cook(model));
save(new ByteArray().toUint8Array());
declare const turn: { set(x: number, y: number, z: number, w: number): void };
turn.set(...agent.getQuaternion());
// a class that is there to be extended
class Nobody extends AgentPredicate {
	override admits(): boolean {
		return false;
	}
}
collision.filter = new Nobody();
// @ts-expect-error it is abstract
collision.filter = new AgentPredicate();
// settings may be given to a constructor
collision.filter = new AgentFilter({ exceptBreeds: ["coins"], accepts: (hero: Hero) => hero.life > 1 });
new AgentFilter(null);
// @ts-expect-error there is no such property
new AgentFilter({ breed: ["heroes"] });
new WalkOptions({ stepHeight: 0.3, filter: { breeds } }).stepHeight = 0.5;
// @ts-expect-error a number
new WalkOptions({ stepHeight: "0.3" });
declare const imageData: { width: number; height: number; data: Uint8ClampedArray };
Terrain.fromPicture(imageData, 3);
// @ts-expect-error an address is no picture
Terrain.fromPicture("hills.png", 3);
// @ts-expect-error neither an agent nor a breed
new TraitBlocks([]).setOneWay(3, true);
// a handler that is declared apart, of touches, of ends and of both
const pay: Handler<Hero, Coin> = (hero, coin, contact) => (hero.life += coin.worth * contact.depth);
typed.onCollisionStart("heroes", "coins", pay);
// @ts-expect-error it is for a contact, and an end has none
typed.onCollisionEnd("heroes", "coins", pay);
const leave: Handler<Hero, Coin, null> = (hero, coin) => (hero.life -= coin.worth);
typed.onCollisionEnd("heroes", "coins", leave);
const log: Handler<Hero, Coin, Contact | null> = (hero, coin, contact) => hero.life + coin.worth + (contact?.depth ?? 0);
typed.onCollision("heroes", "coins", log);
typed.onCollisionEnd("heroes", "coins", log);
// null where it can come, and nowhere else
is<Same<typeof model.materialNames, readonly (string | null)[] | null>>();
is<Same<typeof model.meshNames, readonly (string | null)[] | null>>();
is<Same<CollisionSystem["statistics"], CollisionStatistics>>();
is<Same<BaseCollider["statistics"], CollisionStatistics>>();
is<Same<Collision["breedsWithoutAgents"], string[]>>();
filter.except = [agent, null, undefined];
// structures stay of their class, and so does what takes a point
is<Same<ReturnType<Sphere["clone"]>, Sphere>>();
is<Same<ReturnType<ErrorEventClone>, ModelLoaderEvents["error"]>>();
type ErrorEventClone = ModelLoaderEvents["error"]["clone"];
declare const turning: Matrix3D;
declare const box: Box;
const wide: Sphere = new Sphere(new Vector3D(), 1).clone().translate({ x: 1, y: 0, z: 0 }).scale(2).rotate(turning);
wide.radius = box.rotate(turning).halfX;
declare const scenePoint: { x: number; y: number; z: number; isVector3: true };
const upwards = new Terrain(3, 3).normalAt(1, 1, scenePoint);
is<Same<typeof upwards, typeof scenePoint | null>>();
for (const normal of [new Terrain(3, 3).normalAt(1, 1), new Terrain(3, 3).normalAt(1, 1, null)]) is<Same<typeof normal, Vector3D | null>>();
// @ts-expect-error a new one is a Vector3D
const noScenePoint: typeof scenePoint | null = new Terrain(3, 3).normalAt(1, 1);
class Star extends BoundingStructure {
	override clone(): Star {
		return new Star(this.kind);
	}
	turned(point: Vector3D, placement: Placement): void {
		Star.turnInto(point, placement, point);
	}
}
// a saved game's traits
const { breed: savedBreed } = new Hero("cube").toJSON();
class Saved extends Agent {
	override toJSON(): { life: number } {
		return { life: 3 };
	}
}
JSON.stringify([savedBreed, new Saved("cube")]);
// a function for agents of any class says it twice: as breeds have it, and as agents are
function nearestOf<Member extends Agent>(asked: Member, members: readonly Member[]): Member | null {
	const queries = new AgentQueries(new Collision<Member, Member>(bins));
	queries.update(members);
	return queries.nearest(asked);
}
is<Same<ReturnType<typeof nearestOf<Hero>>, Hero | null>>();
