/** The StarLogo Nova client's pages in headless Chromium; all hosts but the loopback are blocked. */
import { launchOwn } from "../../build/headless/browsers.mjs";
import { readFileSync } from "node:fs";
import { join } from "node:path";
import { fileURLToPath } from "node:url";
import { serve } from "../../build/headless/server.mjs";
import { NOVA } from "./nova-real.mjs";

/** The classic script. */
export const script = fileURLToPath(new URL("../../bin/module/nova.js", import.meta.url));

/** A browser and a server. */
export async function begin() {
	const server = await serve(null, { "": NOVA });
	const browser = await launchOwn(["--js-flags=--expose-gc"]);
	return {
		/**
		 * Opens a project, with nova.js; it does not tick by itself. The captured pages draw in two dimensions; in three if that is asked for.
		 * `said` has the errors that the page tells.
		 */
		async open(project, { isSolid = false } = {}) {
			const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
			const said = [];
			page.on("pageerror", (error) => said.push(String(error.stack ?? error)));
			page.on("console", (message) => message.type() === "error" && !/^Failed to load resource/.test(message.text()) && said.push(message.text()));
			await page.route((url) => url.origin !== new URL(server.url).origin && !/^(data|blob):/.test(url.href), (route) => route.abort());
			if (isSolid) await page.route("**/en/index.html", (route) => route.fulfill({ body: solid(project), contentType: "text/html" }));
			await page.goto(`${server.url}${project}/en/index.html`, { waitUntil: "commit" });
			await page.waitForFunction(() => globalThis.viewport && globalThis.Execution?.AgentController.getBreedIDs().length > 2
				&& slnova.ToggleButtonWidget && WidgetManager.getWidgetsByType(slnova.ToggleButtonWidget).length > 0);
			await page.evaluate(() => {
				slnova.ChartWidget.prototype.addData = () => {};
				viewport.setExecRate(0);
			});
			await page.addScriptTag({ path: script });
			await page.evaluate(`globalThis.setUp = ${setUp}`);
			return { page, said };
		},
		async close() {
			await browser.close();
			server.close();
		},
	};
}

/** A project's page with the client's other view, which the capture has beside the one that it loads. */
function solid(project) {
	const given = readFileSync(join(NOVA, project, "en/index.html"), "utf8");
	const page = given.replace('render_mode = "2d"', 'render_mode = "3d"')
		.replace(/<script [^>]*\/Terrain\.js"><\/script>/, (script) => ["Terrain", "ModelManager", "Viewport"].map((name) => script.replace("Terrain", name)).join(""));
	if (!/ModelManager\.js.*Viewport\.js/.test(page) || page.includes('render_mode = "2d"')) throw new Error(`${project}'s page is not as it was`);
	return page;
}

/**
 * In a page: begins anew and pushes the button that sets the project up, from the same seed; `tick(count)` then runs it, by its other button. Of
 * models that are asked for, all are loaded when it ends.
 */
async function setUp(change = () => {}) {
	const { State } = Common;
	sb.WebLogoDemo.resetAll();
	Helper.Utils.randomSeed = 42;
	Execution.Agent.idBase = 1;
	State.clock = 0;
	// which knows agents by their ids for ever
	DataStructures.CollisionPair.existingPairs.clear();
	change();
	const name = (type, pattern) => WidgetManager.getWidgetsByType(type).map((widget) => widget.getName()).find((text) => pattern.test(text));
	const toggle = name(slnova.ToggleButtonWidget, /./);
	globalThis.tick = (count = 1) => {
		for (let i = 0; i < count; i++) {
			State.toggledButtons.add(toggle);
			Execution.Engine.tick();
		}
		viewport.needsUpdate = true;
	};
	globalThis.alive = () => Execution.AgentController.data.slice(1, Execution.AgentController.numAgents).filter((agent) => !agent.isDead);
	globalThis.loaded = async () => {
		const installation = Execution.Collisions[Symbol.for("starlogo-collision.nova")];
		if (!installation) return;
		Execution.Collisions.getCollisions();
		while (installation.pendingCount > 0) await new Promise((resolve) => setTimeout(resolve, 20));
	};
	State.pushedButtons.add(name(slnova.PushButtonWidget, /setup/i));
	Execution.Engine.tick();
	if (alive().length === 0) tick();
	await loaded();
}
