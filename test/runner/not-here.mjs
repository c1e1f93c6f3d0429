/**
 * The test classes, and tests, that can't run on the ES module, and why. Those of test/standins that compare
 * with Flash's own classes are left out too.
 */
const ON_THE_STAGE = "the monitor draws on Flash's stage";
const FLEXUNIT = "it tests how FlexUnit's runner is filtered";
const COLLECTED = "V8 collects garbage while a test runs, and boxes numbers until it has optimised a function";
const E4X = "it reads describeType's XML";
const HINTS = "in JavaScript an error tells the nearest name: input.test.mjs";
const ANY_NUMBER = "in JavaScript a function takes any number of arguments";

export const NOT_HERE = new Map([
	["starlogo.diagnostics.CollisionMonitorTest", ON_THE_STAGE],
	["starlogo.collision.AllocationTest", COLLECTED],
	["starlogo.queries.QueriesAllocationTest", COLLECTED],
	["starlogo.collision.CollisionStatisticsTest.copiesAndResetsEveryNumber", E4X],
	["starlogo.collision.CollisionHandlersTest.handlersThatFlashCouldNotCallAreRefused", ANY_NUMBER],
	["starlogo.data.HintOfNameTest", HINTS],
	["support.TestFilterTest", FLEXUNIT],
]);
