/** The examples with three.js, as they are in a release, in headless Chromium with software GL; three.js comes from where npm put it. */
import assert from "node:assert/strict";
import { existsSync } from "node:fs";
import path from "node:path";
import { test } from "node:test";
import { launch, saysItWaits } from "../../build/headless/browsers.mjs";
import { serve } from "../../build/headless/server.mjs";
import { root } from "./peers.mjs";

const CDN = /^https:\/\/cdn\.jsdelivr\.net\/npm\/three@0\.(\d+)\.\d+\/(.*)$/;

/** An example's page, until its line says what a pattern matches after so many frames; whether it draws in many colours, and says nothing on the console. */
async function play(name, frames, pattern, ask = () => null) {
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
		await page.addInitScript(() => {
			globalThis.seen = 0; // frames of the page
			const next = globalThis.requestAnimationFrame.bind(globalThis);
			globalThis.requestAnimationFrame = (show) => next((now) => {
				globalThis.seen++;
				show(now);
			});
		});
		await page.goto(`${server.url}examples/${name}/`);
		const rarely = { polling: 50 }; // and not by frames, which are counted
		await page.waitForFunction((wanted) => globalThis.seen >= wanted, frames, rarely);
		await page.evaluate(() => document.querySelector("output").replaceChildren());
		await page.waitForFunction((source) => new RegExp(source).test(document.querySelector("output").textContent), pattern.source, rarely);
		await ask(page);
		const colours = await page.evaluate(async () => {
			const canvas = document.querySelector("canvas");
			const bitmap = await new Promise((resolve) => {
				requestAnimationFrame(async () => resolve(await createImageBitmap(canvas)));
			});
			const context = new OffscreenCanvas(bitmap.width, bitmap.height).getContext("2d");
			context.drawImage(bitmap, 0, 0);
			return new Set(new Uint32Array(context.getImageData(0, 0, bitmap.width, bitmap.height).data.buffer)).size;
		});
		await page.screenshot({ path: path.join(root, `bin/generated/adapters/${name}.png`) });
		assert.deepEqual(said, []);
		assert.ok(colours > 500, `${colours} colours`);
	} finally {
		await browser.close();
		server.close();
	}
}

test("the example's models collide, turn away and are drawn", () => play("three", 25, /^A (?:bear|seagull) turns away from a (?:bear|seagull|tree)$/));

const figures = /^[\d.]+ ms a frame for 41 walkers, \d+ bullets? and the camera; \d+ shots?, \d+ hits?$/;

test("the level's game goes on by itself, and going back to what was saved gives the same game again", () => play("level", 20, figures, async (page) => {
	const { first, again, moved } = await page.evaluate(async () => {
		const { Game } = await import("./game.js");
		const { BuiltInModel, GltfModel, GreatLand, Model } = await import("starlogo-collision");
		const greatLand = new GreatLand();
		greatLand.addModel(BuiltInModel.capsule(0.3, 1.8, "person"));
		greatLand.addModel(BuiltInModel.sphere());
		greatLand.addModel(GltfModel.fromBytes("level", await (await fetch("level.glb")).arrayBuffer(), null, Model.AS_GIVEN));
		const game = new Game(greatLand);
		const go = (from, to) => {
			for (let i = from; i < to; i++) game.step({ turn: Math.sin(i / 9), walk: 1, jumps: i % 20 === 0, shoots: i % 7 === 0 });
			return game.agents.map(({ x, y, z, heading }) => [x, y, z, heading].join(" "));
		};
		const before = go(0, 60);
		const saved = game.save();
		const first = go(60, 100);
		game.goBackTo(saved);
		return { first, again: go(60, 100), moved: first.filter((place, i) => place !== before[i]).length };
	});
	assert.deepEqual(again, first);
	assert.ok(moved > 30, `${moved} moved`);
}));
