#!/usr/bin/env node
/**
 * Serves the built playground on loopback, and prints the address.
 *
 *   node js/playground/serve.mjs FOLDER [PORT]
 */
import { serve } from "../../test/headless/server.mjs";

const [folder, port] = process.argv.slice(2);
const { url } = await serve(null, { "": folder }, { port: Number(port ?? 0) });
console.log(`the playground is at ${url} (stop with Ctrl+C)`);
