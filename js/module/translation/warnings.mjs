/**
 * The statements by which the module's members warn while a game is developed. The functions that they call are in
 * ../../standins/module/warnings.
 */

/** What a method or a setting calls after its checks. addModel looks at its object's properties, because settings are often made just before. */
const WARNINGS = new Map([
	...sameFor(["GreatLand.addModel", "GreatLand.addLevel", "queries.LevelShapes.addModel"], [
		"$warnOfUnknownProperties(this, true);",
		"$warnOfReplaced(this, model);",
	]),
	["GreatLand.modelOf", ["$warnOfModelName(this, name);"]],
	...["sphere", "cube", "cylinder"].map((name) => [`models.BuiltInModel.${name}`, [`$warnOfLength("${name}", arguments);`]]),
	["queries.LevelShapes.addStructure", ["$warnOfUnknownProperties(this, true);"]],
	["collision.Collision.update", [
		"$warnOfTime(\"Collision.update\", arguments);",
		"$warnOfNewAgents(this, agents);",
		"$warnOfSilence(this, agents);",
		"$warnOfShots(this, agents);",
		"$warnOfLaterProperties(this, agents);",
	]],
	...sameFor(["collision.Collision.onCollision", "collision.Collision.onCollisionStart", "collision.Collision.onCollisionEnd"], [
		"$warnOfAddition(this, breed, otherBreed);",
	]),
	["agents.Agent.moveTo", ["$warnOfPlace(this, x, y, z, false);"]],
	["agents.Agent.jumpTo", ["$warnOfPlace(this, x, y, z, true);", "$warnOfJumps(this, x, y, z);", "$warnOfJump(this, x, y);"]],
	["collision.Collision.snapshot", ["$warnOfSnapshot(this, withTraits);"]],
	["collision.Collision.restore", ["$refuseNoAgent(\"Collision.restore\", agents);", "$warnOfRestore(this, bytes, agents);"]],
	["collision.Collision.removeHandler", ["$warnOfRemoval(this, breed, otherBreed, handler);"]],
	["queries.AgentFilter.accepts", ["$warnOfAccepts(value);"]],
	["queries.AgentQueries.update", [
		"$warnOfTime(\"AgentQueries.update\", arguments);",
		"$refuseNoAgent(\"AgentQueries.update\", agents);",
		"$warnOfLaterProperties(this, agents);",
	]],
	["queries.SeenAgents.update", ["$warnOfNoFrames(this);", "$warnOfStale(this, agents, null);"]],
	["queries.SeenAgents.refresh", ["$warnOfStale(this, null, agent);"]],
	...sameFor(["queries.AgentQueries.walk", "queries.AgentMotions.walk"], [
		"$warnOfFall(agent, dx, dy);",
		"$warnOfWalk(this.$_moves._seen, agent, out ??= new Footing());",
	]),
	...["AgentQueries", "AgentRays"].flatMap((name) => ["cast", "castAll"].map((method) => [`queries.${name}.${method}`, [
		`$refuseNoRay("${name}.${method}", origin, direction);`,
	]])),
].map(([name, statements]) => [`starlogo.${name}`, statements]));

/** Classes whose settings are set after the constructor. */
const SET_AFTER = /^starlogo\.(?:GreatLand|collision\.(?:Collision|Contact)|queries\.(?:Footing|LevelShapes|RayHit|ShapeHit))$/;

/** Classes whose methods with a filter are questions about a SeenAgents. */
const ASKING = /^starlogo\.queries\.Agent(?:Motions|Places|Queries|Rays)$/;

/** What a class of questions sees, if it keeps no SeenAgents itself. */
const SEEN_BY = { "starlogo.queries.AgentMotions": "this.$_moves._seen" };

/** The numbers of a question that may be negative: all others are refused then. */
const COORDINATES = /^d?[xyz]$/;

/** The angles that an agent is turned by. */
const ANGLES = /^starlogo\.agents\.Agent\.(?:heading|pitch|roll)$/;

/** What a member says after its checks, about what is allowed and probably a mistake. */
export function warningsOf(qname, name, kind, parameters) {
	if (kind === "constructor") return warningsOfConstructor(qname, name, parameters);
	if (kind === "set" && ANGLES.test(`${qname}.${name}`)) return [`$warnOfAngle(this, "${name}", value);`];
	if (kind !== "method") return [];
	const isQuestion = ASKING.test(qname) && parameters.some(({ type }) => /^(?:AgentFilter|WalkOptions)$/.test(type));
	const ofAngle = parameters.some((each) => each.name === "degrees") ? [`$warnOfDegrees("${name}", degrees);`] : [];
	return [...isQuestion ? warningsOfQuestion(qname, name, parameters) : [], ...ofAngle, ...warningsOfMember(qname, name)];
}

function warningsOfQuestion(qname, name, parameters) {
	const numbers = parameters.filter((each) => /^(?:Number|int)$/.test(each.type) && !COORDINATES.test(each.name)).map((each) => each.name);
	const call = `${qname.split(".").at(-1)}.${name}`;
	return [`$warnOfStale(${SEEN_BY[qname] ?? "this.$_seen"}, null, null);`, ...numbers.map((number) => `$refuseNegative("${call}: ${number}", ${number});`)];
}

/** What a method, or a setting that gets another value, says then. */
export function warningsOfMember(qname, name) {
	return WARNINGS.get(`${qname}.${name}`) ?? [];
}

/** A subclass of Agent may pass all that it gets on to `super()`, so only an Agent itself is warned of. */
function warningsOfConstructor(qname, name, { length }) {
	const isCollider = /\.collision\.\w+Collider$/.test(qname) && length > 0;
	if (isCollider || SET_AFTER.test(qname)) return [`$warnOfMore("${name}", arguments, ${length});`];
	const isAgent = qname === "starlogo.agents.Agent";
	return isAgent ? [`if (arguments.length > ${length} && new.target === Agent) $warnOfMore("Agent", arguments, ${length});`] : [];
}

/** The same statements for several members. */
function sameFor(names, statements) {
	return names.map((name) => [name, statements]);
}
