package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;

    /**
     * The triangles of the ground near a piece of a model, one after the other.
     *
     * <p>A divisible piece that comes to few cells gets a list of the triangles near it. The list of a piece inside of it is chosen from this list, and
     * comes behind it. So the lists are those of one branch of the model's tree. The triangles near other pieces are not kept.</p>
     */
    internal final class NearTriangles
    {
        /** The triangle that <code>next()</code> has found. Read only. */
        public var triangle:NearTriangle = null;

        /** Where the list of the current piece begins and ends; both 0 if it has none. Read only. */
        public var listBegin:int = 0;
        public var listEnd:int = 0;

        /** A limit: triangles count behind whose planes the piece is at least this deep. */
        public var minDepth:Number = 0;

        private var _search:GroundSearch;
        private var _source:GroundTriangles = new GroundTriangles();

        // Whether the source may have more triangles near the current piece, which has no list.
        private var _hasMore:Boolean = false;

        // The records of the triangles that the source has found, and the lists. They grow during the first searches, up to the triangles of few cells. So
        // later frames allocate nothing.
        private var _found:Vector.<NearTriangle> = new Vector.<NearTriangle>();
        private var _lists:Vector.<NearTriangle> = new Vector.<NearTriangle>();

        // The place of the next triangle in the list; and the current piece if it is a triangle with the list of its node, or null.
        private var _next:int = 0;
        private var _inNode:ModelPieces = null;

        // The box around the whole motion of the current piece.
        private var _box:GroundBox = null;
        private var _swept:GroundBox = new GroundBox();

        /** @param search what is looked for, but for its box and shape. Before pieces begin, all of it is set. Then only the limits may be narrowed */
        public function NearTriangles(search:GroundSearch)
        {
            _search = search;
        }

        /** Ends: there is no next triangle. */
        public function stop():void
        {
            _hasMore = false;
            _next = listEnd = 0;
        }

        /** Begins with a piece. */
        public function begin(piece:ModelPieces):void
        {
            var from:int = piece.listBegin;
            var to:int = piece.listEnd;
            _hasMore = false;
            _inNode = null;
            if (to > 0 && piece.corners != null)
            {
                _inNode = piece;
                listBegin = _next = from;
                listEnd = to;
                return;
            }
            _box = piece.box;
            if (_search.motion != RelativeMotion.NONE)
            {
                _swept.copyFrom(_box);
                _swept.extendAlong(_search.motion);
                _box = _swept;
            }
            listBegin = _next = to;
            listEnd = to > 0 ? choose(from, to, to) : findAll(piece);
        }

        // Begins to look for triangles near a piece. Makes a list of all if it is divisible and comes to few cells. Returns the end of the list.
        private function findAll(piece:ModelPieces):int
        {
            var count:int = 0;
            _search.box.copyFrom(piece.box);
            _search.shape = piece.shapeInBox;
            _source.begin(_search);
            _hasMore = !(piece.isDivisible && _source.comesToFewCells);
            while (!_hasMore && findMore(count))
            {
                _lists[count] = _found[count];
                _found[count].setBox(_source.slack);
                count++;
            }
            return count;
        }

        /** Goes on to the next triangle near the piece. Returns false if there is none. */
        public function next():Boolean
        {
            while (_next < listEnd)
            {
                triangle = _lists[_next];
                _next++;
                if (!triangle.hasPlane)
                {
                    triangle.setPlane();
                }
                if (_inNode == null || !isInFront(_inNode, triangle))
                {
                    return true;
                }
            }
            return _hasMore && nextOfSource();
        }

        // Goes on to the next triangle near the piece, which has no list. All triangles that the source finds for a standing box are near it.
        private function nextOfSource():Boolean
        {
            var areNear:Boolean = _box != _swept && _search.maxDistance == 0;
            while (findMore(0))
            {
                triangle = _lists[0] = _found[0];
                if (!areNear)
                {
                    triangle.setBox(_source.slack);
                }
                if (areNear || choose(0, 1, 1) > 1)
                {
                    triangle.setPlane();
                    return true;
                }
            }
            _hasMore = false;
            return false;
        }

        // Finds one more triangle. Returns false if there is none.
        private function findMore(at:int):Boolean
        {
            if (at == _found.length)
            {
                _found.push(new NearTriangle());
            }
            var found:NearTriangle = _found[at];
            found.hasPlane = false;
            return _source.next(found.ground);
        }

        // Chooses triangles of a list that are near the box: the box comes near the triangle's own box, and is not all in front of its plane. Adds them to the
        // list that ends at an index. Returns its new end.
        private function choose(from:int, to:int, end:int):int
        {
            var x:Number = _box.x;
            var y:Number = _box.y;
            var z:Number = _box.z;
            var halfX:Number = _box.halfX;
            var halfY:Number = _box.halfY;
            var halfZ:Number = _box.halfZ;
            var far:Number = _search.maxDistance;
            var front:Number = far - minDepth + _source.slack;
            for (var i:int = from; i < to; i++)
            {
                var near:NearTriangle = _lists[i];
                var box:GroundBox = near.box;
                // the tests of boxes are written out because a call takes the player longer
                var distance:Number = z - box.z;
                var maxDistance:Number = halfZ + box.halfZ + far;
                if (distance > maxDistance || distance < -maxDistance)
                {
                    continue;
                }
                distance = x - box.x;
                maxDistance = halfX + box.halfX + far;
                if (distance > maxDistance || distance < -maxDistance)
                {
                    continue;
                }
                distance = y - box.y;
                maxDistance = halfY + box.halfY + far;
                if (distance > maxDistance || distance < -maxDistance)
                {
                    continue;
                }
                if (!near.hasPlane)
                {
                    near.setPlane();
                }
                // the corner of the box that is farthest behind the plane
                var normal:Vector3D = near.plane.normal;
                distance = normal.x * (normal.x > 0 ? x - halfX : x + halfX) + normal.y * (normal.y > 0 ? y - halfY : y + halfY)
                    + normal.z * (normal.z > 0 ? z - halfZ : z + halfZ) - near.plane.max;
                // a flat triangle has no plane
                if (!(distance > front))
                {
                    _lists[end++] = near;
                }
            }
            return end;
        }

        // Whether a piece that is a triangle is all in front of a plane.
        private function isInFront(piece:ModelPieces, near:NearTriangle):Boolean
        {
            var corners:Vector.<Number> = piece.corners;
            var normal:Vector3D = near.plane.normal;
            var motion:RelativeMotion = _search.motion;
            var least:Number = normal.x * corners[0] + normal.y * corners[1] + normal.z * corners[2];
            var other:Number = normal.x * corners[3] + normal.y * corners[4] + normal.z * corners[5];
            least = other < least ? other : least;
            other = normal.x * corners[6] + normal.y * corners[7] + normal.z * corners[8];
            least = other < least ? other : least;
            var travel:Number = (normal.x * motion.x + normal.y * motion.y + normal.z * motion.z) * motion.latest;
            least = travel < 0 ? least + travel : least;
            return least - near.plane.max > _search.maxDistance - minDepth + piece.shapeMargin + _source.slack;
        }
    }
}
