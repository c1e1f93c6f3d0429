/** Angles that are probably in radians. The engine's are in degrees. */
import { $rounded, $warn } from "./warn.mjs";

/** So many angles are looked at before one that begins again at the other end of a turn counts. */
const $MANY_ANGLES = 30;

/** The angles of agents: how many are still to be looked at, and of those that were, how many they are, the least and the most. */
let $anglesToSee = 20000;
const $anglesSeen = { count: 0, least: 0, most: 0 };

/**
 * Warns of an agent's angle that is probably in radians. It looks at the first angles alone, and no further once one is of more than a
 * turn. It is short, so V8 makes it a part of the setter, which then makes no object of the Number. $lookAtAngle is too long for that:
 * with it, the setter would be too long for its own callers.
 */
export function $warnOfAngle(agent, name, value) {
	if ($anglesToSee > 0) $lookAtAngle(agent, name, value);
}

/**
 * An angle is probably in radians if it is a part of π; or if it begins again at the other end of a turn, and none was farther yet.
 */
function $lookAtAngle(agent, name, value) {
	const before = agent[name];
	if (value === 0 || before === value) return;
	$anglesSeen.count++;
	$anglesSeen.least = Math.min($anglesSeen.least, value);
	$anglesSeen.most = Math.max($anglesSeen.most, value);
	const areWithinTurn = $anglesSeen.most - $anglesSeen.least < 6.2832;
	const areOfATurn = areWithinTurn && ($anglesSeen.most < 3.1416 || $anglesSeen.least >= 0);
	const isPart = $isPartOfTurn(value);
	const beginsAgain = areOfATurn && $anglesSeen.count > $MANY_ANGLES && Math.abs(value - before) > 4.7 && !Number.isInteger(value);
	$anglesToSee = areOfATurn ? $anglesToSee - 1 : 0;
	if (!isPart && !beginsAgain) return;
	$anglesToSee = 0;
	const why = isPart ? "a part of π"
		: `and was ${$rounded(before)}; all angles were between ${$rounded($anglesSeen.least)} and ${$rounded($anglesSeen.most)}`;
	$warn(`${name} of ${agent} is ${$rounded(value)}, ${why}. Angles are in degrees: if this is in radians, `
		+ `take ${name} = angle * 180 / Math.PI, here ${$rounded($inDegrees(value))}`);
}

/** Warns of a slope that is probably in radians. */
export function $warnOfUnits(options) {
	const degrees = options?.slopeDegrees;
	if (!(degrees > 0 && degrees < 1.6)) return;
	$warn(`slopeDegrees is ${degrees}, so ground that is steeper than this many degrees is a wall. `
		+ `If these are radians, take ${Math.round($inDegrees(degrees))}`);
}

/** Warns of a call's angle that is probably in radians. A cone of one degree or two may be meant, so only parts of π count. */
export function $warnOfDegrees(call, degrees) {
	if (degrees === 0 || !$isPartOfTurn(degrees)) return;
	$warn(`${call}() takes an angle in degrees. ${$rounded(degrees)} is a part of π: if this is in radians, `
		+ `take degrees = angle * 180 / Math.PI, here ${$rounded($inDegrees(degrees))}`, `degrees of ${call}`);
}

function $inDegrees(radians) {
	return radians * 180 / Math.PI;
}

/** Whether an angle is some twelfths of π, one turn at most, to the last digits: no angle in degrees is. */
function $isPartOfTurn(angle) {
	const twelfths = Math.abs(angle) * 12 / Math.PI;
	return twelfths < 24.5 && Math.abs(twelfths - Math.round(twelfths)) < 1e-12;
}
