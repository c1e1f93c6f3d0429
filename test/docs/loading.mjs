/** For docs/loading.md: what the loader's listeners hear. */
import assert from 'node:assert/strict';
import { serve } from '../../build/headless/server.mjs';
import { engine } from './engine.mjs';

const assets = new URL('../../assets/', import.meta.url);

/** Its addresses are relative, as in a page; in Node a server of the assets makes them absolute. */
const server = await serve(null, { '/assets': assets.pathname });
const { fetch } = globalThis;
globalThis.fetch = (address, ...rest) => fetch(new URL(address, server.url), ...rest);

const loaded = [];
let finish;
const isComplete = new Promise((resolve) => {
	finish = resolve;
});
export const greatLand = new engine.GreatLand();
export const addAgents = ({ model }) => loaded.push(model.name);
export const showError = ({ text }) => assert.fail(text);
export const hideProgress = () => finish();

/** Whether the samples have done what the page says. */
export async function check() {
	await isComplete;
	globalThis.fetch = fetch;
	server.close();
	assert.deepEqual(loaded, ['bear', 'dragon']);
}
