import assert from 'node:assert/strict';
import { test } from 'node:test';
import { boxesIn, faultsOf } from './boxes.mjs';

/** A function as swfdump prints it, in short. */
function dumpOf(header, body) {
	return `    function ${header}\n    maxStack:4 localCount:3 initScopeDepth:4 maxScopeDepth:5\n${body}\n    0 Extras\n    0 Traits Entries\n\n`;
}

// (x < 0 ? -x : x) - half
const TERNARY = `        debugfile     \t"/project/src;starlogo/bounding;Box.as"
        debugline     \t31
        getlocal1     \t
        ifnlt         \tL0

        getlocal1     \t
        negate        \t
        coerce_a      \t
        jump          \tL10
    L0: getlocal1     \t
        coerce_a      \t
   L10:debugline     \t32
        getlocal2     \t
        subtract      \t`;

const MOST_OF_THREE = `        debugline     \t7
        callproperty  \t:max (2)
        debugline     \t8
   L12:callproperty  \t:max (3)`;

const PLACE = 'starlogo.bounding:Box:::place(starlogo.geometry:Placement, starlogo.bounding:BoundingStructure)::void';

test('a ternary inside an expression is found, with its function and line', () => {
	const boxes = boxesIn(dumpOf(PLACE, TERNARY));
	assert.deepEqual([...boxes], [['starlogo.bounding.Box.place', [31, 31]]]);
	assert.deepEqual(faultsOf(boxes, {}), ['starlogo.bounding.Box.place may box Numbers in lines 31: 2 times']);
});

test('Math.max of three is found, of two it is not', () => {
	const boxes = boxesIn(dumpOf('script0::starlogo.intersection:boxBox(starlogo.bounding:Box, starlogo.bounding:Box)::Boolean', MOST_OF_THREE));
	assert.deepEqual([...boxes], [['starlogo.intersection.boxBox', [8]]]);
});

// center(Sphere(structure)).x + Sphere(structure).radius + Capsule(structure).length()
const CASTS = `        debugline     \t60
        findpropstrict\tstarlogo.bounding:Sphere
        getlocal1     \t
        callproperty  \tstarlogo.bounding:Sphere (1)
        callproperty  \tprivate:center (1)
        getproperty   \t:x
        debugline     \t61
        findpropstrict\tstarlogo.bounding:Sphere
        getlocal1     \t
        callproperty  \tstarlogo.bounding:Sphere (1)
        debugline     \t62
        getproperty   \t:radius
        add           \t
        debugline     \t63
        callproperty  \tstarlogo.bounding:Capsule (1)
        callproperty  \t:length (0)
        add           \t
        debugline     \t64
        callproperty  \tstarlogo.bounding:Capsule (1)
        coerce        \tstarlogo.bounding:Capsule
        setlocal2     \t
        getlocal2     \t
        getproperty   \t:radius`;

test('a member of a cast is found, of what a function returns and of a typed local it is not', () => {
	const boxes = boxesIn(dumpOf(PLACE, CASTS));
	assert.deepEqual([...boxes], [['starlogo.bounding.Box.place', [62, 63]]]);
});

test('methods, private ones, those of a namespace and accessors are known by their names', () => {
	const names = ['private:search(:int)::void', 'starlogo.engine:find()::void', ':statistics()::int'].map((member) =>
		dumpOf(`starlogo.collision:CollisionSearch::${member}`, ''));
	names.push(dumpOf('get starlogo.agents:Agent:::id()::int', ''));
	assert.deepEqual([...boxesIn(names.join('')).keys()], ['search', 'find', 'statistics'].map((name) =>
		`starlogo.collision.CollisionSearch.${name}`).concat('starlogo.agents.Agent.id'));
});

test('what runs once may box', () => {
	const once = ['starlogo.hierarchy:BoxTreeBuilder::private:divide()::void', 'starlogo.models:ObjReader:::read()::void',
		'starlogo.bounding:Box::starlogo.bounding:Box$cinit():', 'script0::script0$init():'];
	assert.equal(boxesIn(once.map((header) => dumpOf(header, TERNARY)).join('')).size, 0);
});

test('what is allowed must be there', () => {
	const boxes = boxesIn(dumpOf(PLACE, TERNARY));
	assert.deepEqual(faultsOf(boxes, { 'starlogo.bounding.Box.place': { count: 2 } }), []);
	assert.match(faultsOf(boxes, { 'starlogo.bounding.Box.place': { count: 3 } }).join(), /is allowed 3, and has 2/);
	assert.match(faultsOf(boxes, { 'starlogo.bounding.Box.place': { count: 1 } }).join(), /2 times/);
});
