/** Stands in for flash.utils.ByteArray. It has the members that the engine and its tests use. */

const DEFAULT_ROOM = 64;

/** Bytes, with a position for reading and writing. */
export class ByteArray {
	static get name() {
		return "ByteArray";
	}

	#bytes;
	#view;
	#length;

	#isLittle = false;

	/** The index of the next byte to read or write. */
	position = 0;

	/** @param source the first bytes, which are copied: a ByteArray, an ArrayBuffer or a view of one */
	constructor(source = null) {
		const given = source === null ? new Uint8Array() : toBytes(source);
		this.#length = given.length;
		this.#take(given.slice());
	}

	/** A ByteArray with the bytes of a ByteArray, an ArrayBuffer or a view of one. */
	static from(source) {
		return source == null || source instanceof ByteArray ? source : new ByteArray(source);
	}

	/** The byte order of numbers: "bigEndian" or "littleEndian". */
	get endian() {
		return this.#isLittle ? "littleEndian" : "bigEndian";
	}

	set endian(value) {
		this.#isLittle = value === "littleEndian";
	}

	get length() {
		return this.#length;
	}

	set length(value) {
		this.#reserve(value);
		if (value < this.#length) this.#bytes.fill(0, value, this.#length);
		this.#length = value;
		this.position = Math.min(this.position, value);
	}

	get bytesAvailable() {
		return Math.max(0, this.#length - this.position);
	}

	/** A byte; undefined after the last one. */
	byteAt(index) {
		return index < this.#length ? this.#bytes[index] : undefined;
	}

	/** Sets a byte. The array grows if necessary. */
	setByte(index, value) {
		if (index >= this.#length) this.length = index + 1;
		this.#bytes[index] = value;
	}

	clear() {
		this.length = 0;
	}

	readBoolean() {
		return this.readUnsignedByte() !== 0;
	}

	readByte() {
		return this.#view.getInt8(this.#advance(1));
	}

	readUnsignedByte() {
		return this.#bytes[this.#advance(1)];
	}

	readUnsignedShort() {
		return this.#view.getUint16(this.#advance(2), this.#isLittle);
	}

	readInt() {
		return this.#view.getInt32(this.#advance(4), this.#isLittle);
	}

	readUnsignedInt() {
		return this.#view.getUint32(this.#advance(4), this.#isLittle);
	}

	readFloat() {
		return this.#view.getFloat32(this.#advance(4), this.#isLittle);
	}

	readDouble() {
		return this.#view.getFloat64(this.#advance(8), this.#isLittle);
	}

	/** Reads text in UTF-8. A byte order mark at the beginning is skipped, and the text ends at a zero. */
	readUTFBytes(length) {
		const start = this.#advance(length);
		const text = new TextDecoder().decode(this.#bytes.subarray(start, start + length));
		const end = text.indexOf("\0");
		return end < 0 ? text : text.slice(0, end);
	}

	writeBoolean(value) {
		this.writeByte(value ? 1 : 0);
	}

	writeByte(value) {
		const at = this.#extend(1);
		this.#bytes[at] = value;
	}

	writeShort(value) {
		const at = this.#extend(2);
		this.#view.setInt16(at, value, this.#isLittle);
	}

	writeInt(value) {
		const at = this.#extend(4);
		this.#view.setInt32(at, value, this.#isLittle);
	}

	writeUnsignedInt(value) {
		const at = this.#extend(4);
		this.#view.setUint32(at, value, this.#isLittle);
	}

	writeFloat(value) {
		const at = this.#extend(4);
		this.#view.setFloat32(at, value, this.#isLittle);
	}

	writeDouble(value) {
		const at = this.#extend(8);
		this.#view.setFloat64(at, value, this.#isLittle);
	}

	writeUTFBytes(text) {
		this.#write(new TextEncoder().encode(text));
	}

	/** Writes bytes of another ByteArray. If length is 0, all bytes from offset on. */
	writeBytes(source, offset = 0, length = 0) {
		const count = length === 0 ? source.length - offset : length;
		if (offset + count > source.length) throw new RangeError("Error #2006: The supplied index is out of bounds.");
		this.#write(source.#bytes.slice(offset, offset + count));
	}

	/** A copy of the bytes. */
	toUint8Array() {
		return this.#bytes.slice(0, this.#length);
	}

	/** The bytes as text. */
	toString() {
		return new TextDecoder().decode(this.toUint8Array());
	}

	#take(bytes) {
		this.#bytes = bytes;
		this.#view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
	}

	#reserve(length) {
		if (length <= this.#bytes.length) return;
		const roomy = new Uint8Array(Math.max(DEFAULT_ROOM, length, 2 * this.#bytes.length));
		roomy.set(this.#bytes.subarray(0, this.#length));
		this.#take(roomy);
	}

	#advance(count) {
		const at = this.position;
		if (at + count > this.#length) throw new EOFError();
		this.position = at + count;
		return at;
	}

	#extend(count) {
		const at = this.position;
		if (at + count > this.#length) this.length = at + count;
		this.position = at + count;
		return at;
	}

	#write(bytes) {
		const at = this.#extend(bytes.length);
		this.#bytes.set(bytes, at);
	}
}

/** Thrown if too few bytes are left. */
export class EOFError extends Error {
	constructor(message = "Error #2030: End of file was encountered.") {
		super(message);
		this.name = "EOFError";
	}
}

function toBytes(source) {
	if (source instanceof ByteArray) return source.toUint8Array();
	return ArrayBuffer.isView(source) ? new Uint8Array(source.buffer, source.byteOffset, source.byteLength) : new Uint8Array(source);
}
