/** Shows one of the SWFs beside, which the address names: index.html?FirstCollision. The Flash player is Ruffle. */
"use strict";

const output = element("output", { textContent: "loading the Flash player" });
output.setAttribute("aria-live", "off");

/** The SWFs call this in every frame. */
globalThis.said = (text, frame) => {
	output.textContent = text;
	document.documentElement.dataset.frame = frame;
};

async function showSwf(name) {
	const source = await (await fetch(`${name}.as`)).text();
	const [, title, sentence] = /\/\*\* (.*?): (.*) \*\//.exec(source);
	document.title = title;
	document.querySelector("p").textContent = sentence;
	buildPage("../");
	showCode(source, `${name}.as`);
	const player = globalThis.RufflePlayer.newest().createPlayer();
	const pause = element("button", { textContent: "Pause", onclick() {
		const isPaused = pause.textContent === "Play";
		if (isPaused) player.ruffle().play();
		else player.ruffle().pause();
		pause.textContent = isPaused ? "Pause" : "Play";
	} });
	document.querySelector(".picture").replaceChildren(player, element("div", { className: "bar" }, output, pause));
	await player.ruffle().load({
		url: `${name}.swf`, parameters: { frames: new URLSearchParams(location.search).get("frames") ?? "0" }, allowScriptAccess: true,
		autoplay: "on", unmuteOverlay: "hidden", splashScreen: false, contextMenu: "off", letterbox: "off", logLevel: "error",
	});
}

if (location.protocol === "file:") buildPage("../");
else showSwf(nameHere());
