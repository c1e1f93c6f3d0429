package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Touching;

    /**
     * Finds the triangles of the ground near the boxes of a model's tree. Those near a box that comes to few cells are found once, and kept for the boxes
     * inside of it.
     */
    internal final class NearTriangles
    {
        // How many rounded terms are compared with one another: three of each axis, and a limit. Each may be off by Tolerances.ROUNDING of the lengths,
        // and those of a triangle by its margin.
        private static const ROUNDED_TERMS:Number = 10;

        /** What is looked for. Set the ground, the origin, the motion and the limits before boxes begin. Then only the limits may be narrowed. */
        public var search:GroundSearch = new GroundSearch();

        /** The triangle that <code>next()</code> has found. Read only. */
        public var triangle:GroundTriangle = null;

        private var _source:GroundTriangles = new GroundTriangles();

        // A limit: only triangles count behind whose planes the box reaches at least this deep.
        private var _leastDepth:Number = 0;

        // The triangles so far, and the next of them. If they are not kept, the first one is overwritten. The list grows during the first searches,
        // up to the triangles of few cells, and its records are used again: later frames allocate nothing.
        private var _found:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _count:int = 0;
        private var _next:int = 0;
        private var _areKept:Boolean = false;

        // Whether the source has still to begin, because many questions need no triangle; and whether it may have more.
        private var _mustBegin:Boolean = false;
        private var _mayHaveMore:Boolean = false;

        // How many boxes were left when the triangles that are kept were looked for.
        private var _boxesLeft:int = 0;

        // By how much the box is larger with all of its motion, and where its middle then is, relative to the box.
        private var _moved:GroundBox = new GroundBox();

        // The least and the greatest corner of the box with all of its motion.
        private var _least:Vector3D = new Vector3D();
        private var _greatest:Vector3D = new Vector3D();

        /** Ends all searches. */
        public function stop():void
        {
            _areKept = _mustBegin = _mayHaveMore = false;
            _count = _next = 0;
            _leastDepth = 0;
            _source.stop();
        }

        /** From now on only triangles count behind whose planes the boxes reach at least this deep, until the searches end. */
        public function leaveOutShallower(depth:Number):void
        {
            _leastDepth = depth;
        }

        /**
         * Begins with a box.
         *
         * @param shape the shape that is tested, if it is in the box; null for none
         * @param boxesLeft how many boxes come after this one and those inside of it
         */
        public function begin(box:GroundBox, shape:ConvexShape, boxesLeft:int):void
        {
            _next = 0;
            if (!_areKept || boxesLeft < _boxesLeft)
            {
                _areKept = false;
                _mustBegin = _mayHaveMore = true;
                _count = 0;
                _boxesLeft = boxesLeft;
                search.box.copyFrom(box);
                search.shape = shape;
                measureMotion();
            }
            var halfX:Number = box.halfX + _moved.halfX;
            var halfY:Number = box.halfY + _moved.halfY;
            var halfZ:Number = box.halfZ + _moved.halfZ;
            _least.x = box.x + _moved.x - halfX;
            _least.y = box.y + _moved.y - halfY;
            _least.z = box.z + _moved.z - halfZ;
            _greatest.x = box.x + _moved.x + halfX;
            _greatest.y = box.y + _moved.y + halfY;
            _greatest.z = box.z + _moved.z + halfZ;
        }

        private function measureMotion():void
        {
            var box:GroundBox = search.box;
            var motion:RelativeMotion = search.motion;
            var grid:HeightGrid = search.grid;
            var toFirst:Number = Math.abs(grid.x - search.origin.x) + Math.abs(grid.y - search.origin.y);
            var slack:Number = ROUNDED_TERMS * Tolerances.ROUNDING * (Math.abs(box.x) + Math.abs(box.y) + Math.abs(box.z) + Math.abs(motion.x) + Math.abs(motion.y)
                    + Math.abs(motion.z) + box.halfX + box.halfY + box.halfZ + grid.cellWidth + toFirst);
            _moved.x = motion.latest * motion.x / 2;
            _moved.y = motion.latest * motion.y / 2;
            _moved.z = motion.latest * motion.z / 2;
            _moved.halfX = Math.abs(_moved.x) + slack;
            _moved.halfY = Math.abs(_moved.y) + slack;
            _moved.halfZ = Math.abs(_moved.z) + slack;
        }

        /**
         * Goes on to the next triangle near the box: the box comes near the triangle's own box, and is not all in front of its plane. Returns false if
         * there is none.
         */
        public function next():Boolean
        {
            var far:Number = search.maxDistance;
            var front:Number = far - _leastDepth;
            var minX:Number = _least.x - far;
            var minY:Number = _least.y - far;
            var minZ:Number = _least.z - far;
            var maxX:Number = _greatest.x + far;
            var maxY:Number = _greatest.y + far;
            var maxZ:Number = _greatest.z + far;
            while (_next < _count || _mayHaveMore && findMore())
            {
                var near:GroundTriangle = _found[_next];
                _next++;
                if (minZ > near.maxZ || maxZ < near.minZ || minX > near.maxX || maxX < near.minX || minY > near.maxY || maxY < near.minY)
                {
                    continue;
                }
                // the corner of the box that is farthest behind the plane
                var normal:Vector3D = near.plane.normal;
                var x:Number = normal.x > 0 ? _least.x : _greatest.x;
                var y:Number = normal.y > 0 ? _least.y : _greatest.y;
                var z:Number = normal.z > 0 ? _least.z : _greatest.z;
                // a flat triangle has no plane
                if (!(normal.x * x + normal.y * y + normal.z * z - near.plane.greatest > front + ROUNDED_TERMS * near.margin))
                {
                    triangle = near;
                    return true;
                }
            }
            return false;
        }

        // Finds one more triangle, and sets what only tests of the model need: its margin and its plane. Returns false if there is none.
        private function findMore():Boolean
        {
            if (_mustBegin)
            {
                _mustBegin = false;
                _source.begin(search);
                _areKept = _source.comesToFewCells;
            }
            else if (!_areKept)
            {
                _count = _next = 0;
            }
            if (_count == _found.length)
            {
                _found.push(new GroundTriangle());
            }
            var found:GroundTriangle = _found[_count];
            if (!_source.next(found))
            {
                _mayHaveMore = false;
                return false;
            }
            found.margin = Touching.marginOfSurface(found.radius);
            found.plane.setTriangle(found.corners, 0);
            widen(found);
            _count++;
            return true;
        }

        // Makes the box around a triangle larger. V8 would make an object of a Number that is passed.
        private static function widen(found:GroundTriangle):void
        {
            var by:Number = ROUNDED_TERMS * found.margin;
            found.minX -= by;
            found.maxX += by;
            found.minY -= by;
            found.maxY += by;
            found.minZ -= by;
            found.maxZ += by;
        }
    }
}
