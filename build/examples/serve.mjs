#!/usr/bin/env node
/**
 * Serves the examples on loopback, and prints the address.
 *
 *   node build/examples/serve.mjs [PORT]
 */
import { serveExamples } from './site.mjs';

const { url } = await serveExamples(Number(process.argv[2] ?? 0));
console.log(`the examples are at ${url} (stop with Ctrl+C)`);
