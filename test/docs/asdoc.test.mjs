/** What is looked for in the pages that asdoc writes, and that the ASDoc is as asdoc needs it. */
import assert from 'node:assert/strict';
import { test } from 'node:test';
import { read, sourcesBelow } from '../structure/sources.mjs';
import { brokenIn, engineMembersIn, repaired, undescribedIn, withDefaults } from './asdoc.mjs';

const member = (name, description) => `<a href="#${name}()" class="signatureLink">${name}</a>()</div><div class="summaryTableDescription">${description}</div>`;
const listed = (name, description) => `<td class="summaryTableSecondCol"><a href="${name}.html" onclick="x">${name}</a></td><td class="summaryTableLastCol">${description}&nbsp;</td>`;

test('names without a description are found', () => {
	assert.deepEqual(undescribedIn(member('fit', ' Fits. ') + member('begin', '') + member('clone', '[override] ') + member('size', '[read-only] ') + member('mass', '[read-only] The mass.') + listed('Box', ' A box.') + listed('Ring', '')), ['begin', 'clone', 'size', 'Ring']);
});

test('links that lead nowhere are found, and two of asdoc put right', () => {
	const html = '<a href="../starlogo:GreatLand.html">a</a><a href="all-index-Symbols.html" onclick="x">b</a><a href="c.html#d">e</a><a href="https://f">g</a>';
	assert.deepEqual(brokenIn(html, (to) => to === 'c.html'), ['../starlogo:GreatLand.html', 'all-index-Symbols.html']);
	assert.deepEqual(brokenIn(repaired(html), (to) => ['c.html', '../starlogo/GreatLand.html'].includes(to)), []);
});

test('members of the namespace engine are found, and superclasses without a page go', () => {
	const code = (text) => `<code>${text}</code>`;
	assert.deepEqual(engineMembersIn(code('override engine function findNarrowPhase():NarrowPhase') + code('engine static const EDGES:int') + code('public function find():void')), ['findNarrowPhase', 'EDGES']);
	const arrow = '<img src="inherit-arrow.gif" class="inheritArrow">';
	assert.equal(repaired(`Bin ${arrow} <a href="B.html">B</a> ${arrow} starlogo.collision.QuerySource</td>`), `Bin ${arrow} <a href="B.html">B</a></td>`);
});

test('no page has a member that only the engine\'s packages share, or its own package: asdoc shows them as public', () => {
	const isPrivate = (source) => /@private(?:(?!\*\/)[^])*\*\/\s*public (?:final |dynamic )*(?:class|interface)/.test(source) || /internal (?:final )?class/.test(source);
	const shown = (source) => [...source.matchAll(/(\/\*\*(?:(?!\*\/)[^])*\*\/\s*)?^ *((?:override |static |final )*(?:engine|internal) (?:static |final )*(?:function|var|const) [^\n]*)/gm)]
		.filter(([, comment = '']) => !comment.includes('@private')).map(([, , code]) => code);
	assert.deepEqual(sourcesBelow('src/starlogo').flatMap((file) => (isPrivate(read(file)) ? [] : shown(read(file)).map((code) => `${file}: ${code}`))), []);
});

test('no page says when it was written', () => {
	assert.equal(repaired('<center><br/>Fri Nov 20 2026, 03:05 PM Z  </center><!--<br/>Fri Nov 20 2026, 03:05 PM Z  -->'), '<center>  </center><!--  -->');
});

test('defaults of parameters are those of the source', () => {
	const source = 'public function near(radius:Number = Infinity, as:String = "box", out:Hit = null):void {} public static function far(radius:Number):void {}';
	const page = (first, at, as) => `<a href="#near()">near</a>(radius:Number${first}, as:String = ${as}, out:<a href="Hit.html">Hit</a> = null):void <a name="near()"></a><a name="near(Number,String,Hit)"></a>`
		+ `<code> public function near(radius:Number${first}, as:String = ${as}, out:Hit = null):void</code><span class="label">radius</span>:Number</code> (default = <code>${at}</code>)`
		+ `<span class="label">as</span>:String</code> (default = <code>${as}</code>)<a name="far(Number)"></a><code> public static function far(radius:Number)</code><span class="label">radius</span>:Number</code>`
		+ `<code>public static const BOX:String = ${as}</code>`;
	assert.equal(withDefaults(page('', 'NaN', 'box'), source), page(' = Infinity', 'Infinity', '"box"'));
});

test('no ASDoc has an asterisk in its text: asdoc takes it for the margin, and drops it and what follows', () => {
	const comments = (file) => [...read(file).matchAll(/\/\*\*[^]*?\*\//g)].map(([comment]) => comment.slice(3, -2).replace(/^ *\*/gm, ''));
	const files = sourcesBelow('src/starlogo');
	assert.ok(files.flatMap(comments).length > 1000, 'there are some');
	assert.deepEqual(files.filter((file) => comments(file).some((comment) => comment.includes('*'))), []);
});
