package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the triangles of the ground near the boxes of a model's tree. Those near a box that comes to few cells are found once, and kept for the boxes
     * inside of it.
     */
    internal final class NearTriangles
    {
        // Boxes are so much larger than they were, for rounding: as a multiple of Tolerances.ROUNDING and of all lengths. For a triangle they are larger by
        // the same multiple of its margin.
        private static const WIDER:Number = 10;

        /** What is looked for. Set the ground, the origin, the motion and the limits before boxes begin. Then only the limits may be narrowed. */
        public var search:GroundSearch = new GroundSearch();

        /** The triangle that <code>next()</code> has found. Read only. */
        public var triangle:GroundTriangle = null;

        /** A limit: only triangles count behind whose planes the box reaches at least so deep. */
        public var leastDepth:Number = 0;

        private var _source:GroundTriangles = new GroundTriangles();

        // The triangles so far, and the next of them. If they are not kept, the first one is overwritten. The list grows during the first searches,
        // up to the triangles of few cells, and its records are used again: later frames allocate nothing.
        private var _found:Vector.<GroundTriangle> = new Vector.<GroundTriangle>();
        private var _count:int = 0;
        private var _next:int = 0;
        private var _areKept:Boolean = false;

        // Whether the source has not begun yet. Many questions need no triangle.
        private var _isBefore:Boolean = false;

        // How many boxes were left when the triangles that are kept were looked for.
        private var _boxesLeft:int = 0;

        // The box with all of its motion; and where its middle then is, relative to the box, and by how much it is larger.
        private var _around:GroundBox = new GroundBox();
        private var _more:GroundBox = new GroundBox();

        /** Ends all searches. */
        public function stop():void
        {
            _areKept = _isBefore = false;
            _count = _next = 0;
            _source.stop();
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
                _isBefore = true;
                _count = 0;
                _boxesLeft = boxesLeft;
                search.box.copyFrom(box);
                search.shape = shape;
                findMore();
            }
            _around.x = box.x + _more.x;
            _around.y = box.y + _more.y;
            _around.z = box.z + _more.z;
            _around.halfX = box.halfX + _more.halfX;
            _around.halfY = box.halfY + _more.halfY;
            _around.halfZ = box.halfZ + _more.halfZ;
        }

        private function findMore():void
        {
            var box:GroundBox = search.box;
            var motion:RelativeMotion = search.motion;
            var grid:HeightGrid = search.grid;
            var toFirst:Number = Math.abs(grid.x - search.origin.x) + Math.abs(grid.y - search.origin.y);
            var wider:Number = WIDER * Tolerances.ROUNDING * (Math.abs(box.x) + Math.abs(box.y) + Math.abs(box.z) + Math.abs(motion.x) + Math.abs(motion.y)
                    + Math.abs(motion.z) + box.halfX + box.halfY + box.halfZ + grid.cellWidth + toFirst);
            _more.x = motion.latest * motion.x / 2;
            _more.y = motion.latest * motion.y / 2;
            _more.z = motion.latest * motion.z / 2;
            _more.halfX = Math.abs(_more.x) + wider;
            _more.halfY = Math.abs(_more.y) + wider;
            _more.halfZ = Math.abs(_more.z) + wider;
        }

        /** Goes on to the next triangle near the box. Returns false if there is none. */
        public function next():Boolean
        {
            while (_next < _count || find())
            {
                var found:GroundTriangle = _found[_next];
                _next++;
                if (isNear(found))
                {
                    triangle = found;
                    return true;
                }
            }
            return false;
        }

        // Finds one more triangle, and its plane. Returns false if there is none.
        private function find():Boolean
        {
            if (_isBefore)
            {
                _isBefore = false;
                _areKept = _source.begin(search);
            }
            else if (!_areKept)
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

        // Whether the box comes near the triangle and its cell, and is not all in front of the triangle's plane.
        private function isNear(near:GroundTriangle):Boolean
        {
            var box:GroundBox = _around;
            var far:Number = search.maxDistance + WIDER * near.margin;
            var x:Number = box.x;
            var y:Number = box.y;
            var z:Number = box.z;
            var halfX:Number = box.halfX;
            var halfY:Number = box.halfY;
            var halfZ:Number = box.halfZ;
            var fromCell:Number = search.grid.cellWidth / 2 + far;
            var besideX:Number = x > near.cellX ? x - near.cellX : near.cellX - x;
            var besideY:Number = y > near.cellY ? y - near.cellY : near.cellY - y;
            if (z - halfZ - far > near.high || z + halfZ + far < near.low || besideX > halfX + fromCell || besideY > halfY + fromCell)
            {
                return false;
            }
            var plane:TrianglePlane = near.plane;
            var across:Vector3D = plane.normal;
            var alongX:Number = across.x;
            var alongY:Number = across.y;
            var alongZ:Number = across.z;
            // the corner that is farthest behind the plane
            x = alongX > 0 ? x - halfX : x + halfX;
            y = alongY > 0 ? y - halfY : y + halfY;
            z = alongZ > 0 ? z - halfZ : z + halfZ;
            // a flat triangle has no plane
            return !(alongX * x + alongY * y + alongZ * z - plane.greatest > far - leastDepth);
        }
    }
}
