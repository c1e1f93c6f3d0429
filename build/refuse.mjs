/** Ends a script that was given wrong arguments, and says what is wrong. */
export function refuse(problem) {
	console.error(problem);
	process.exit(64);
}
