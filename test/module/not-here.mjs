/** The test classes, and tests, that can't run on the ES module, and why. */
export const NOT_HERE = new Map([
]);
