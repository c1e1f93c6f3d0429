/** Colours of worlds. What a colour means is the same in every view, and a sign says it too. */

/**
 * What is said of agents, of pairs and of what stands around them. "hit" is a touch that is found, "wrong" a false collision or what one system alone finds, "missed" a
 * touch that is not found or that another system alone finds, "none" what touches nothing. They differ in brightness as well, for who sees no red or green.
 */
export const VERDICTS = { hit: 0xd62f5a, wrong: 0xffb000, missed: 0x6a3df0, none: 0x8c98a9 };

/** What an engine tests, a level of its trees, how far it is to something, a ray, and the agent that is looked at: by day and by night. */
export const LINES = {
	tested: { light: 0x1667c9, dark: 0x5ea4ff }, level: { light: 0x0a2f73, dark: 0xb8d6ff }, distance: { light: 0x0b7a5f, dark: 0x4fd8b0 }, ray: { light: 0x1c2430, dark: 0xf2f5fa },
	chosen: { light: 0x1c2430, dark: 0x1c2430 },
};

/** Agents that nothing is said of: the first one, and others. */
export const AGENTS = { first: 0x9db6dc, other: 0xb9d3c4 };

/** Two agents that touch, apart from each other. */
export const TOUCHING = [0xb81f49, 0xe9708f];

const css = (colour) => `#${colour.toString(16).padStart(6, "0")}`;

/** Lets style sheets have the colours: --hit, --wrong and so on, --tested, --tested-dark and so on. */
export function lendColours({ style }) {
	for (const [name, colour] of Object.entries(VERDICTS)) style.setProperty(`--${name}`, css(colour));
	for (const [name, { light, dark }] of Object.entries(LINES)) {
		style.setProperty(`--${name}-light`, css(light));
		style.setProperty(`--${name}-dark`, css(dark));
	}
}

/** An agent's colour that leaves its model the colours it has. */
export const OWN_COLOURS = -1;

/** Of the outlines of agents. */
export const INK = 0x14202a;

/** Ground and sky, so light that outlines stand out from them three to one, by day and at dusk. */
export const LANDS = {
	light: { zenith: 0x6fb3ea, horizon: 0xdff1fb, field: ["#a5de7d", "#95d46c"], around: ["#8fcb74", "#86c36b"], edge: 0xf7fbe9, ambient: 1.9, sun: 2.3 },
	dark: { zenith: 0x6f78ad, horizon: 0xc98f6d, field: ["#7fae6d", "#73a262"], around: ["#6a9660", "#638e59"], edge: 0xe9e3c6, ambient: 1.5, sun: 1.9 },
};
