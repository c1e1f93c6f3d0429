#!/usr/bin/env node
/**
 * Serves the examples on loopback, and prints the address.
 *
 *   node build/examples/serve.mjs [PORT]
 */
import { refuse } from '../refuse.mjs';
import { serveExamples } from './site.mjs';

const port = process.argv[2] ?? '0';
if (!/^\d{1,5}$/.test(port) || port > 65535) refuse(`PORT must be a whole number up to 65535, not ${port}`);
const { url } = await serveExamples(Number(port));
console.log(`the examples are at ${url} (stop with Ctrl+C)`);
