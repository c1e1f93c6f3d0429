package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the triangles of the ground near the boxes of a model's tree. Those near a box that comes to few cells are found once, and kept for the boxes
     * inside of it.
     */
    internal final class NearTriangles
    {
        // A box is so much larger than it was, for rounding: as a multiple of Tolerances.ROUNDING and of all lengths.
        private static const WIDER:Number = 10;

        /** What is looked for, all but the box. It is set before a search begins. */
        public var search:GroundSearch = new GroundSearch();

        /** The triangle that <code>next()</code> has found. Read only. */
        public var triangle:GroundTriangle = null;

        /** A limit: only triangles count behind whose planes the box reaches at least so deep. */
        public var leastDepth:Number = 0;

        private var _source:GroundTriangles = new GroundTriangles();

        // The triangles so far, and the next of them. If they are not kept, the first one is overwritten.
        private var _found:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _count:int = 0;
        private var _next:int = 0;
        private var _areKept:Boolean = false;

        // How many boxes were left when the triangles that are kept were looked for.
        private var _boxesLeft:int = 0;

        // The box with all of its motion, and a little larger.
        private var _around:GroundBox = new GroundBox();

        /** Ends all searches. */
        public function stop():void
        {
            _source.stop();
            _areKept = false;
            _count = _next = 0;
        }

        /**
         * Begins with a box.
         *
         * @param boxesLeft how many boxes come after this one and those inside of it
         */
        public function begin(box:GroundBox, boxesLeft:int):void
        {
            _next = 0;
            if (!_areKept || boxesLeft < _boxesLeft)
            {
                _count = 0;
                _boxesLeft = boxesLeft;
                search.box.copyFrom(box);
                _areKept = _source.begin(search);
            }
            takeAround(box);
        }

        /** Goes on to the next triangle near the box. Returns false if there is none. */
        public function next():Boolean
        {
            while (_next < _count || find())
            {
                triangle = _found[_next];
                _next++;
                if (isNear())
                {
                    return true;
                }
            }
            return false;
        }

        // Finds one more triangle, and its plane. Returns false if there is none.
        private function find():Boolean
        {
            if (!_areKept)
            {
                _count = _next = 0;
            }
            if (_count == _found.length)
            {
                _found.push(new GroundTriangle());
            }
            var found:GroundTriangle = _source.triangle = _found[_count];
            if (!_source.next())
            {
                return false;
            }
            found.plane.setTriangle(found.corners, 0);
            _count++;
            return true;
        }

        private function takeAround(box:GroundBox):void
        {
            var motion:RelativeMotion = search.motion;
            var x:Number = motion.latest * motion.x / 2;
            var y:Number = motion.latest * motion.y / 2;
            var z:Number = motion.latest * motion.z / 2;
            _around.x = box.x + x;
            _around.y = box.y + y;
            _around.z = box.z + z;
            _around.halfX = box.halfX + (x < 0 ? -x : x);
            _around.halfY = box.halfY + (y < 0 ? -y : y);
            _around.halfZ = box.halfZ + (z < 0 ? -z : z);
            var wider:Number = WIDER * Tolerances.ROUNDING * (Math.abs(_around.x) + Math.abs(_around.y) + Math.abs(_around.z)
                    + _around.halfX + _around.halfY + _around.halfZ + search.grid.cellWidth);
            _around.halfX += wider;
            _around.halfY += wider;
            _around.halfZ += wider;
        }

        // Whether the box comes near the triangle and its cell, and is not all in front of the triangle's plane.
        private function isNear():Boolean
        {
            var box:GroundBox = _around;
            var far:Number = search.maxDistance;
            var half:Number = search.grid.cellWidth / 2 + far;
            if (box.z - box.halfZ - far > triangle.high || box.z + box.halfZ + far < triangle.low || Math.abs(box.x - triangle.cellX) > box.halfX + half
                || Math.abs(box.y - triangle.cellY) > box.halfY + half)
            {
                return false;
            }
            var plane:TrianglePlane = triangle.plane;
            var normal:Vector3D = plane.normal;
            var front:Number = normal.x * box.x + normal.y * box.y + normal.z * box.z - Math.abs(normal.x) * box.halfX - Math.abs(normal.y) * box.halfY
                - Math.abs(normal.z) * box.halfZ;
            // a flat triangle has no plane
            return !(front - plane.greatest > far - leastDepth);
        }
    }
}
