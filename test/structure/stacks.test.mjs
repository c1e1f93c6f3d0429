import assert from 'node:assert/strict';
import { test } from 'node:test';
import { stacksIn } from './stacks.mjs';

/** A function as swfdump prints it, in short. */
function dumpOf(most, body) {
	return `    function game:Link::restore()::void\n    maxStack:${most} localCount:5 initScopeDepth:3 maxScopeDepth:4\n${body}\n    0 Extras\n    0 Traits Entries\n\n`;
}

// var link = links[i]; link.revision = link.platform.revision
const TWO_COPIES = `        getlocal1     \t
        getlocal3     \t
        getproperty   \tprivate,game,http://adobe.com/AS3/2006/builtin,game:Link:null
        coerce        \tgame:Link
        dup           \t
        dup           \t
        setlocal      \t4
        getproperty   \t:platform
        getproperty   \tgame:revision
        setproperty   \t:revision
        returnvoid    \t`;

// list.push(isFirst ? 1 : other.sum(2, 3)), and a list of three
const ARMS = `        getlocal1     \t
        getlocal2     \t
        iffalse       \tL0

        pushbyte      \t1
        jump          \tL1

    L0: getlocal3     \t
        pushbyte      \t2
        pushbyte      \t3
        callproperty  \t:sum (2)
    L1: callpropvoid  \t:push (1)
        pushbyte      \t1
        pushbyte      \t2
        pushbyte      \t3
        newarray      \t[3]
        pop           \t
        returnvoid    \t`;

test('a function that keeps more values on its stack than it says is found', () => {
	const { count, faults } = stacksIn(dumpOf(2, TWO_COPIES));
	assert.equal(count, 1);
	assert.match(faults.join(), /^game:Link::restore\(\)::void keeps 3 values on its stack, and says 2/);
	assert.deepEqual(stacksIn(dumpOf(3, TWO_COPIES)).faults, []);
});

test('each arm of a condition begins with what is there before it', () => {
	assert.deepEqual(stacksIn(dumpOf(4, ARMS)).faults, []);
	assert.match(stacksIn(dumpOf(3, ARMS)).faults.join(), /keeps 4 values/);
});

// catch (error:Error) { note(error, 1); }, where the machine puts the error on the stack
const CATCH = `        jump          \tL0

        getlocal0     \t
        pushscope     \t
        newcatch      \t0
        dup           \t
        setlocal      \t4
        dup           \t
        pushscope     \t
        swap          \t
        setslot       \t1
        popscope      \t
    L0: returnvoid    \t`;

// replace("\n", ""), replace("\r", "")
const LINE_ENDS = `        getlocal1     \t
        pushstring    \t"
"        pushstring    \t""
        callpropvoid  \t:replace (2)
        getlocal1     \t
        pushstring    \t"\r"
        pushstring    \t""
        callpropvoid  \t:replace (2)
        returnvoid    \t`;

test('what is caught is on the stack', () => {
	assert.deepEqual(stacksIn(dumpOf(3, CATCH)).faults, []);
	assert.match(stacksIn(dumpOf(2, CATCH)).faults.join(), /keeps 3 values/);
});

// try { begin(); } finally { end(); }, where what goes on after the finally stands before it
const FINALLY = `        getlocal0     \t
        callpropvoid  \t:begin (0)
        pushbyte      \t-1
        jump          \tL1

    L2: label         \t
        pop           \t
    L3: label         \t
        getlocal0     \t
        pushbyte      \t1
        pushbyte      \t2
        callpropvoid  \t:note (2)
        returnvoid    \t
    L1: getlocal0     \t
        callpropvoid  \t:end (0)
        lookupswitch  \tdefault:L4 maxcase:0 L3
    L4: returnvoid    \t`;

test('what goes on after a finally begins with what is there after it', () => {
	assert.deepEqual(stacksIn(dumpOf(3, FINALLY)).faults, []);
	assert.match(stacksIn(dumpOf(2, FINALLY)).faults.join(), /keeps 3 values/);
});

test('texts may have line ends', () => {
	assert.deepEqual(stacksIn(dumpOf(3, LINE_ENDS)).faults, []);
	assert.match(stacksIn(dumpOf(2, LINE_ENDS)).faults.join(), /keeps 3 values/);
});

test('an instruction that is not known is an error, not passed over', () => {
	assert.throws(() => stacksIn(dumpOf(4, '        callnative    \t3')), /does not know the instruction callnative/);
});
