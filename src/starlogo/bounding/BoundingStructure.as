// This room has the structures that enclose models. A structure has its numbers in public fields. place() writes it, transformed by a placement,
// into another one of its kind. setShape() describes it to the room convex, and the room intersection compares two of them. Read this file first,
// then Sphere, and then Hull with its HullTopology.
package starlogo.bounding
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import flash.utils.getQualifiedClassName;
    import starlogo.convex.ConvexShape;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * A simple solid that encloses a model. The collision systems test it instead of the model (thesis §3.3). The pair tests take
     * a Sphere, a Capsule, a Box, a Hull, and a convex subclass of your own, which has the kind HULL. They refuse the kind OTHER: a Cylinder, which
     * is fitted but never collided, and any other subclass of your own.
     *
     * <p>A structure includes its surface: two structures that only touch collide, here and everywhere in the engine.</p>
     *
     * <p>A structure is in the space of its model or, once it is placed, in the world. Lengths are in patches. Scaling, rotating and
     * translating are about the origin of that space. They change the structure and return it, so that calls can be chained. Call
     * <code>clone()</code> first to keep the original. A call that throws changes nothing.</p>
     *
     * <p>Numbers that are written to fields are not checked. With a negative length or NaN the tests of two structures may answer anything, and
     * <code>clone()</code> throws.</p>
     */
    public class BoundingStructure
    {
        /** The kind of a Sphere. */
        public static const SPHERE:int = 0;

        /** The kind of a Capsule. */
        public static const CAPSULE:int = 1;

        /** The kind of a Box. */
        public static const BOX:int = 2;

        /** The kind of a Hull, and of any other convex structure that has no tests of its own. */
        public static const HULL:int = 3;

        /** The kind of a structure that no test of the engine takes: a Cylinder, or a structure of your own that does not have the kind HULL. */
        public static const OTHER:int = 4;

        /**
         * The number of kinds that are collided. Their numbers are 0 and up.
         *
         * @private
         */
        engine static const KIND_COUNT:int = 4;

        /**
         * The names of the kinds that are collided, by their numbers.
         *
         * @private
         */
        engine static const NAMES:Vector.<String> = new <String>["sphere", "capsule", "box", "hull"];

        private static var sBox:Vector.<Number> = new Vector.<Number>(6, true);

        // The limits of coordinates and lengths. The tests of pairs multiply four of them. Contacts multiply six, so they need lengths from 1e-53 to
        // 1e50, and those of a game are.
        private static const LARGEST:Number = 1e70;
        private static const SMALLEST:Number = 1e-70;

        /** The kind of this structure: SPHERE, CAPSULE, BOX, HULL or OTHER. Read only. */
        public var kind:int;

        /**
         * For subclasses only.
         *
         * @param kind HULL for a convex structure that describes itself to the tests. Any other number becomes OTHER: the engine's own classes alone
         *     have the first three kinds
         */
        public function BoundingStructure(kind:int)
        {
            this.kind = kind == HULL ? HULL : OTHER;
        }

        /** A description of the structure and its place, for messages. */
        public function toString():String
        {
            return "a structure of class " + getQualifiedClassName(this).replace("::", ".");
        }

        /** The volume in cubic patches. 0 for a structure that is a rectangle, a segment or a point. */
        public function get volume():Number
        {
            throw new IllegalOperationError(this + " does not implement volume");
        }

        /**
         * Scales the structure uniformly about the origin.
         *
         * @param factor from 1e-140 to 1e140
         * @return this structure
         * @throws RangeError if the factor is not in that range, or if the result is beyond the limits of structures
         */
        public function scale(factor:Number):BoundingStructure
        {
            // a factor beyond these would make 0 or Infinity of a size
            if (!(factor >= SMALLEST / LARGEST && factor <= LARGEST / SMALLEST))
            {
                throw new RangeError("a scale factor must be from 1e-140 to 1e140: " + factor);
            }
            var scaling:Placement = new Placement();
            scaling.size = factor;
            return placeWithin(scaling);
        }

        /**
         * Rotates the structure about the origin. The result is as precise as the matrix, which has single precision in Flash Player. A
         * box's axes stay perpendicular unit vectors in double precision.
         *
         * @param rotation must only rotate; a reflection is accepted too
         * @return this structure
         * @throws ArgumentError if the matrix is null, scales, shears, projects or translates
         */
        public function rotate(rotation:Matrix3D):BoundingStructure
        {
            requireGiven("the rotation", rotation);
            var m:Vector.<Number> = rotation.rawData;
            var isAffine:Boolean = m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1;
            var isCentred:Boolean = m[12] == 0 && m[13] == 0 && m[14] == 0;
            var placement:Placement = new Placement();
            placement.setRows(new <Number>[m[0], m[4], m[8], m[1], m[5], m[9], m[2], m[6], m[10]], 0);
            if (!isAffine || !isCentred || !placement.isOrthonormal)
            {
                throw new ArgumentError("a rotation must rotate about the origin and do nothing else: " + m);
            }
            return placeWithin(placement);
        }

        /**
         * Moves the structure.
         *
         * @param offset in patches
         * @return this structure
         * @throws ArgumentError if the offset is null
         * @throws RangeError if a component is not finite, or if the result is beyond the limits of structures
         */
        public function translate(offset:Vector3D):BoundingStructure
        {
            checkVector(offset, "an offset");
            var moving:Placement = new Placement();
            moving.x = offset.x;
            moving.y = offset.y;
            moving.z = offset.z;
            return placeWithin(moving);
        }

        // Cloning the result checks it.
        private function placeWithin(placement:Placement):BoundingStructure
        {
            place(placement).clone();
            return place(placement, this);
        }

        /**
         * Whether a point is inside of the structure or on its surface. Points outside by at most Tolerances.CONTAINMENT of the structure's
         * size count as inside, so that rounding never excludes vertices that a fit enclosed.
         *
         * @param point in the structure's space
         */
        public function contains(point:Vector3D):Boolean
        {
            throw new IllegalOperationError(this + " does not implement contains");
        }

        /**
         * Returns a copy that shares nothing with this structure. It checks the structure as its constructor checks its arguments.
         *
         * @throws ArgumentError if a field was set to a value that the constructor refuses
         * @throws RangeError as the constructor
         */
        public function clone():BoundingStructure
        {
            throw new IllegalOperationError(this + " does not implement clone");
        }

        /**
         * Transforms this structure by an agent's placement: scales, rotates, then translates it (thesis §3.5). It uses double precision
         * throughout. Allocates nothing if <code>out</code> is given.
         *
         * @param placement the model's placement; its numbers are not checked. It mirrors only if <code>rotate()</code> was given a reflection
         * @param out a structure of the same class, which receives the result; may be this structure
         * @return out. A new structure if out is null, or if both have the kind HULL and are of different classes
         * @throws ArgumentError if out is of another kind
         */
        public function place(placement:Placement, out:BoundingStructure = null):BoundingStructure
        {
            throw new IllegalOperationError(this + " does not implement place");
        }

        /**
         * Returns a new structure for the result of <code>place()</code>, which was given no structure of this class.
         *
         * @param out what it was given: null, or of another class of the kind HULL
         * @throws ArgumentError if out is anything else
         */
        protected final function newFor(out:BoundingStructure):BoundingStructure
        {
            if (out != null && (out.kind != HULL || kind != HULL))
            {
                throw new ArgumentError("out must be null or of the same kind as " + this + ": " + out);
            }
            return clone();
        }

        /**
         * Enlarges the structure by a margin on all sides.
         *
         * @param by a length, not negative
         * @private
         */
        engine function widen(by:Number):void
        {
            throw new IllegalOperationError(this + " does not implement widen");
        }

        /**
         * Enlarges a fitted structure by the distance at which surfaces still count as touching (Tolerances.SURFACES). So if the surfaces of
         * two models touch, their structures touch too. This holds for flat and thin structures as well. A sphere is not enlarged: its
         * radius is never small compared with the model, so the tests' own tolerance is enough.
         *
         * @private
         */
        engine function widenForSurfaces():void
        {
        }

        /**
         * Writes the extents along the axes of the structure's space: minX, maxX, minY, maxY, minZ, maxZ. They are the tightest ones,
         * enlarged by a rounding error (Tolerances.ROUNDING). So the extents of structures that touch always touch or overlap. Allocates
         * nothing.
         *
         * @param out receives six numbers
         * @param offset the index of the first, 0 or more
         */
        public function extentsInto(out:Vector.<Number>, offset:int = 0):void
        {
            findPlacedBox(Placement.IDENTITY, sBox);
            for (var axis:int = 0; axis < 3; axis++)
            {
                out[int(offset + 2 * axis)] = sBox[axis] - sBox[int(axis + 3)];
                out[int(offset + 2 * axis + 1)] = sBox[axis] + sBox[int(axis + 3)];
            }
        }

        /**
         * Writes the box around this structure after a placement: its middle relative to the placement's position, and half of its
         * lengths. They stay the same while an agent only moves. Allocates nothing.
         *
         * @param placement the model's placement; its position is ignored
         * @param out receives six numbers: x, y, z of the middle, and half the lengths along x, y, z. These are enlarged by the rounding error that
         *     extentsInto adds, without the part for the position. Those of a sphere are its radius itself, because SpherePairTests reads it there
         * @private
         */
        engine function findPlacedBox(placement:Placement, out:Vector.<Number>):void
        {
            throw new IllegalOperationError(this + " does not implement findPlacedBox");
        }

        /**
         * Sets a shape to this structure, for the package convex. Every structure that is collided implements it. The shape may keep the
         * structure's own lists of points, faces and edges.
         *
         * @private
         */
        engine function setShape(out:ConvexShape):void
        {
            throw new IllegalOperationError(this + " does not implement setShape");
        }

        /**
         * The half-spaces whose intersection is this structure without its radius, if it is a Hull; null for all others. Each has four numbers: an
         * outward unit normal, and how far its plane is from the centre along the normal.
         *
         * @private
         */
        engine function get halfSpaces():Vector.<Number>
        {
            return null;
        }

        /**
         * Whether this structure comes after another one of the same kind: by their places, or in the same place by their other numbers. Tests of two
         * structures take them in this order, so they give the same answer for (a, b) and (b, a), rounding included. Those of the kind HULL have no order
         * here, because the package convex puts its shapes in an order itself.
         *
         * @private
         */
        engine function isAfter(other:BoundingStructure):Boolean
        {
            return false;
        }

        /**
         * All numbers of the structure, in a list of their own.
         *
         * @private
         */
        engine function toNumbers():Vector.<Number>
        {
            throw new IllegalOperationError(this + " does not implement toNumbers");
        }

        /**
         * Sets all numbers of the structure, in the order of <code>toNumbers()</code>. They are not checked; <code>clone()</code> checks them.
         *
         * @private
         */
        engine function setFromNumbers(numbers:Vector.<Number>):void
        {
            throw new IllegalOperationError(this + " does not implement setFromNumbers");
        }

        /**
         * Checks a vector.
         *
         * @param vector the argument
         * @param what its name in the message
         * @return the vector
         * @throws ArgumentError if it is null
         * @throws RangeError if a component is not finite, or beyond the limits of structures
         */
        protected static function checkVector(vector:Vector3D, what:String):Vector3D
        {
            requireGiven(what, vector);
            // The comparison is false for NaN too.
            if (!(Math.max(Math.max(Math.abs(vector.x), Math.abs(vector.y)), Math.abs(vector.z)) <= LARGEST))
            {
                throw new RangeError(what + " must be finite, and within " + LARGEST + " of the origin: " + vector);
            }
            return vector;
        }

        /**
         * Checks a radius or half-extent.
         *
         * @param length the argument
         * @param what its name in the message
         * @return the length
         * @throws RangeError if it is negative, not finite, or beyond the limits of structures
         */
        protected static function checkLength(length:Number, what:String):Number
        {
            if (!(length >= 0 && length <= LARGEST))
            {
                throw new RangeError(what + " must be finite and not negative, at most " + LARGEST + ", not " + length);
            }
            return length;
        }

        /**
         * Checks the largest of a structure's lengths. Structures without extent are allowed.
         *
         * @param size the largest length, checked already
         * @param what the structure's name in the message
         * @throws RangeError if it is beyond the limits of structures
         */
        protected static function checkSize(size:Number, what:String):void
        {
            if (size > 0 && size < SMALLEST)
            {
                throw new RangeError(what + " must have a size of 0, or of at least " + SMALLEST + ", not " + size);
            }
        }

        /** @private Checks the ends of an axis and the radius around it, as the methods above do. The last argument is the structure's name in the messages. */
        internal static function checkAxis(start:Vector3D, end:Vector3D, radius:Number, what:String):void
        {
            checkLength(radius, "the radius of " + what);
            checkVector(start, "the start of " + what);
            checkVector(end, "the end of " + what);
            var along:Number = Math.max(Math.abs(end.x - start.x), Math.max(Math.abs(end.y - start.y), Math.abs(end.z - start.z)));
            checkSize(Math.max(radius, along), what);
        }

        // Placement's own methods are not public, because the ES module checks the arguments of all that is, and these are called for each pair.

        /**
         * Transforms a point by a placement, for structures of your own.
         *
         * @param point in the model's space
         * @param placement the model's placement
         * @param out receives the point in the world; may be the point itself
         */
        protected static function placePoint(point:Vector3D, placement:Placement, out:Vector3D):void
        {
            placement.place(point, out);
        }

        /**
         * Rotates a vector by the rotation of a placement, for structures of your own.
         *
         * @param vector in the model's space
         * @param placement the model's placement
         * @param out receives the vector in the world; may be the vector itself
         */
        protected static function turnInto(vector:Vector3D, placement:Placement, out:Vector3D):void
        {
            placement.rotate(vector, out);
        }

        /**
         * The distance up to which a point outside of the structure still counts as inside.
         *
         * @param extent the largest one from the middle
         * @param at a point of the structure
         */
        protected static function slack(extent:Number, at:Vector3D):Number
        {
            return Tolerances.CONTAINMENT * extent + rounding(extent, at);
        }

        /**
         * The rounding error of a position.
         *
         * @param extent the largest one from the middle
         * @param at a point of the structure
         */
        protected static function rounding(extent:Number, at:Vector3D):Number
        {
            return Tolerances.ROUNDING * (extent + Math.abs(at.x) + Math.abs(at.y) + Math.abs(at.z));
        }

        /** Writes the extent between two coordinates, in either order, enlarged by a length on both sides. */
        protected static function writeExtent(from:Number, to:Number, margin:Number, out:Vector.<Number>, offset:int):void
        {
            out[offset] = Math.min(from, to) - margin;
            out[int(offset + 1)] = Math.max(from, to) + margin;
        }
    }
}
