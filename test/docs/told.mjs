#!/usr/bin/env node
/**
 * Prints its input, with the page and the line there in place of those of files that are made of samples.
 *
 *   node test/docs/told.mjs
 */
import { readFileSync } from 'node:fs';
import { withPagesNamed } from './samples.mjs';

process.stdout.write(withPagesNamed(readFileSync(0, 'utf8')));
