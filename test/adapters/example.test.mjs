/** The example with three.js, as it is in a release, in headless Chromium with software GL; three.js comes from where npm put it. */
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { launch, saysItWaits } from "../headless/browsers.mjs";
import { serve } from "../headless/server.mjs";
import { root } from "./peers.mjs";

const CDN = /^https:\/\/cdn\.jsdelivr\.net\/npm\/three@0\.(\d+)\.\d+\/(.*)$/;

test("the example's models collide, turn away and are drawn", async () => {
	const server = await serve(null, { "/module": path.join(root, "bin/module"), "/examples": path.join(root, "examples") });
	const browser = await launch();
	try {
		const page = await browser.newPage({ viewport: { width: 480, height: 300 } });
		const said = [];
		page.on("console", (message) => saysItWaits(message.text()) || said.push(message.text()));
		page.on("pageerror", (error) => said.push(String(error)));
		await page.route(CDN, (route) => {
			const [, release, file] = CDN.exec(route.request().url());
			const where = path.join(root, "js/adapters/three/node_modules", `three-r${release}`, file);
			assert.ok(existsSync(where), `${where}: the example and the tests have the same release`);
			return route.fulfill({ path: where, headers: { "access-control-allow-origin": "*" } });
		});
		await page.goto(`${server.url}examples/three/`);
		const turns = /^frame (\d+): a (?:bear|seagull) turns away from a \w+$/;
		await page.waitForFunction((text) => new RegExp(text).exec(document.querySelector("output").textContent)?.[1] >= 25, turns.source);
		const colours = await page.evaluate(async () => {
			const canvas = document.querySelector("canvas");
			const bitmap = await new Promise((resolve) => {
				requestAnimationFrame(async () => resolve(await createImageBitmap(canvas)));
			});
			const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
			context.drawImage(bitmap, 0, 0);
			return new Set(new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer)).size;
		});
		await page.screenshot({ path: path.join(root, "bin/generated/adapters/example.png") });
		assert.deepEqual(said, []);
		assert.ok(colours > 500, `${colours} colours`);
	} finally {
		await browser.close();
		server.close();
	}
});
