/** The StarLogo Nova client's pages in headless Chromium; all hosts but the loopback are blocked. */
import { chromium } from "playwright-core";
import { fileURLToPath } from "node:url";
import { serve } from "../headless/server.mjs";
import { NOVA } from "./nova-real.mjs";

const script = fileURLToPath(new URL("../../bin/module/nova.js", import.meta.url));
const ARGUMENTS = ["--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-dev-shm-usage", "--disable-background-networking", "--no-first-run"];

/** A browser and a server. */
export async function begin() {
	const server = await serve(null, { "": NOVA });
	const browser = await chromium.launch({ executablePath: process.env.CHROME || "/usr/bin/chromium", args: ARGUMENTS });
	return {
		/** Opens a project, with nova.js; it does not tick by itself. `said` has the errors that the page tells. */
		async open(project) {
			const page = await browser.newPage({ viewport: { width: 1280, height: 900 } });
			const said = [];
			page.on("pageerror", (error) => said.push(String(error.stack ?? error)));
			await page.route((url) => url.origin !== new URL(server.url).origin && !/^(data|blob):/.test(url.href), (route) => route.abort());
			await page.goto(`${server.url}${project}/en/index.html`, { waitUntil: "commit" });
			await page.waitForFunction(() => globalThis.viewport && globalThis.Execution?.AgentController.getBreedIDs().length > 2
				&& slnova.ToggleButtonWidget && WidgetManager.getWidgetsByType(slnova.ToggleButtonWidget).length > 0, null, { timeout: 60000 });
			await page.evaluate(() => {
				slnova.ChartWidget.prototype.addData = () => {};
				viewport.setExecRate(0);
			});
			await page.addScriptTag({ path: script });
			return { page, said };
		},
		async close() {
			await browser.close();
			server.close();
		},
	};
}
