package starlogo.intersection.sweep
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactFinder;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.distance.findClosest;

    /**
     * Finds when a sphere, capsule or box that moves touches a triangle for the first time, and how the two touch.
     *
     * <p>Two convex bodies first touch at an edge of the triangle, or at a corner of the structure that comes to the triangle's face. An edge is a
     * capsule without a radius, so the structures' own kernels answer for it. A corner moves along a ray. The corners of a sphere or capsule are
     * the middles of its ends, with the radius around them.</p>
     *
     * @private
     */
    public final class StructureSweep
    {
        private static const MOST_CORNERS:int = 8;

        /** When the two first touch, from 0 to 1, or RelativeMotion.NEVER. */
        public var time:Number = RelativeMotion.NEVER;

        private var _structure:BoundingStructure;
        private var _motion:RelativeMotion;

        // The structure's corners at the beginning, how far it reaches around them, and the length that rounding is relative to.
        private var _corners:Vector.<Number> = new Vector.<Number>(3 * MOST_CORNERS, true);
        private var _cornerCount:int = 0;
        private var _radius:Number = 0;
        private var _size:Number = 0;

        // The triangle, and its unit normal; 0 if the triangle has no area.
        private var _triangle:Vector.<Number>;
        private var _at:int = 0;
        private var _face:ContactPoint = new ContactPoint();
        private var _edge:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        private var _finder:ContactFinder = new ContactFinder();
        private var _tried:ContactPoint = new ContactPoint();
        private var _closest:ClosestPair = new ClosestPair();

        // Whether a corner of the structure is over the face whose normal was taken.
        private var _isOver:Boolean = true;
        private var _point:Vector3D = new Vector3D();

        /** Creates a sweep without a structure. */
        public function StructureSweep()
        {
        }

        /**
         * Begins with a structure.
         *
         * @param structure at the beginning of its motion; kept
         * @param motion the structure's motion, with a start of 0; kept, and its time is overwritten
         */
        public function begin(structure:BoundingStructure, motion:RelativeMotion):void
        {
            _structure = structure;
            _motion = motion;
            _cornerCount = 0;
            _radius = 0;
            if (structure.kind == BoundingStructure.BOX)
            {
                readBox(Box(structure));
                return;
            }
            var sphere:Sphere = structure as Sphere;
            if (sphere != null)
            {
                addCorner(sphere.center);
                _size = _radius = sphere.radius;
                return;
            }
            var capsule:Capsule = Capsule(structure);
            addCorner(capsule.start);
            addCorner(capsule.end);
            _radius = capsule.radius;
            _size = _radius + Vector3D.distance(capsule.start, capsule.end);
        }

        /**
         * Sets the triangle.
         *
         * @param corners nine numbers of the triangle: x, y, z of each corner; kept
         * @param at index of the first of them
         */
        public function setTriangle(corners:Vector.<Number>, at:int):void
        {
            _triangle = corners;
            _at = at;
            var ux:Number = corners[int(at + 3)] - corners[at];
            var uy:Number = corners[int(at + 4)] - corners[int(at + 1)];
            var uz:Number = corners[int(at + 5)] - corners[int(at + 2)];
            var vx:Number = corners[int(at + 6)] - corners[at];
            var vy:Number = corners[int(at + 7)] - corners[int(at + 1)];
            var vz:Number = corners[int(at + 8)] - corners[int(at + 2)];
            var longest:Number = ux * ux + uy * uy + uz * uz + vx * vx + vy * vy + vz * vz;
            _face.setNormal(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx);
            _face.normalise();
            // Without this radius, rounding would hide the direction of the gap when the gap is almost closed.
            _edge.radius = Tolerances.ROUNDING * (_size + Math.sqrt(longest) + Math.abs(corners[at]) + Math.abs(corners[int(at + 1)])
                    + Math.abs(corners[int(at + 2)]));
            if (!(_face.length * _face.length > Tolerances.FLAT_TRIANGLE * longest * longest))
            {
                // The triangle counts as its edges.
                _face.setNormal(0, 0, 0);
            }
        }

        /**
         * Finds when the two first touch, and sets <code>time</code>. They must not touch at the beginning. Times after the limit do not
         * matter.
         */
        public function findTime(limit:Number):void
        {
            time = RelativeMotion.NEVER;
            if (staysOnOneSide(limit))
            {
                return;
            }
            for (var i:int = 0; i < 9; i += 3)
            {
                setEdge(i);
                findTimeOfImpact(_structure, _edge, _motion);
                time = _motion.time < time ? _motion.time : time;
            }
            for (i = 0; i < 3 * _cornerCount; i += 3)
            {
                meetFace(i);
            }
        }

        /**
         * Finds how the two touch at a time of the motion, from 0 to 1. The normal is the normal of the face or of an edge. The one along which
         * the two overlap least is chosen.
         *
         * @param out receives the contact, with a normal that points from the triangle to the structure
         */
        public function findContact(time:Number, out:ContactPoint):void
        {
            var displacement:RelativeMotion = _finder.displacement;
            displacement.startX = time * _motion.x;
            displacement.startY = time * _motion.y;
            displacement.startZ = time * _motion.z;
            out.depth = Infinity;
            _isOver = true;
            if (_face.normalX != 0 || _face.normalY != 0 || _face.normalZ != 0)
            {
                tryFace(1, out);
                tryFace(-1, out);
            }
            var isAtEdge:Boolean = !_isOver;
            var slack:Number = isAtEdge ? 0 : Tolerances.SEPARATION * _size;
            for (var i:int = 0; i < 9; i += 3)
            {
                setEdge(i);
                _finder.find(_structure, _edge, _tried);
                var depth:Number = highest(_tried) - lowest(_tried);
                if (depth < out.depth - slack)
                {
                    out.copyFrom(_tried);
                    out.depth = depth;
                    isAtEdge = true;
                }
            }
            if (isAtEdge)
            {
                findPointOfEdges(out);
            }
            out.depth = out.depth > 0 ? out.depth : 0;
        }

        private function addCorner(at:Vector3D):void
        {
            var to:int = 3 * _cornerCount;
            _corners[to] = at.x;
            _corners[int(to + 1)] = at.y;
            _corners[int(to + 2)] = at.z;
            _cornerCount++;
        }

        private function readBox(box:Box):void
        {
            for (var i:int = 0; i < MOST_CORNERS; i++)
            {
                var x:Number = box.halfX;
                var y:Number = box.halfY;
                var z:Number = box.halfZ;
                x = (i & 1) == 0 ? x : -x;
                y = (i & 2) == 0 ? y : -y;
                z = (i & 4) == 0 ? z : -z;
                _point.setTo(box.center.x + x * box.axisX.x + y * box.axisY.x + z * box.axisZ.x,
                        box.center.y + x * box.axisX.y + y * box.axisY.y + z * box.axisZ.y,
                        box.center.z + x * box.axisX.z + y * box.axisY.z + z * box.axisZ.z);
                addCorner(_point);
            }
            _size = box.halfX + box.halfY + box.halfZ;
        }

        private function setEdge(first:int):void
        {
            var from:int = _at + first;
            var to:int = first == 6 ? _at : from + 3;
            _edge.start.setTo(_triangle[from], _triangle[int(from + 1)], _triangle[int(from + 2)]);
            _edge.end.setTo(_triangle[to], _triangle[int(to + 1)], _triangle[int(to + 2)]);
        }

        // Puts a contact's point between the structure and the edge that is nearest to it.
        private function findPointOfEdges(out:ContactPoint):void
        {
            var displacement:RelativeMotion = _finder.displacement;
            _point.setTo(displacement.startX, displacement.startY, displacement.startZ);
            var least:Number = Infinity;
            for (var i:int = 0; i < 9; i += 3)
            {
                setEdge(i);
                _edge.start.decrementBy(_point);
                _edge.end.decrementBy(_point);
                findClosest(_structure, _edge, _closest);
                if (_closest.distance < least)
                {
                    least = _closest.distance;
                    out.x = (_closest.aX + _closest.bX) / 2 + _point.x;
                    out.y = (_closest.aY + _closest.bY) / 2 + _point.y;
                    out.z = (_closest.aZ + _closest.bZ) / 2 + _point.z;
                }
            }
        }

        // How far a corner of the structure is from the triangle's plane.
        private function aboveFace(corner:int):Number
        {
            return _face.normalX * (_corners[corner] - _triangle[_at]) + _face.normalY * (_corners[int(corner + 1)] - _triangle[int(_at + 1)])
                + _face.normalZ * (_corners[int(corner + 2)] - _triangle[int(_at + 2)]);
        }

        private function get speed():Number
        {
            return _face.normalX * _motion.x + _face.normalY * _motion.y + _face.normalZ * _motion.z;
        }

        // Whether the structure does not come to the triangle's plane.
        private function staysOnOneSide(limit:Number):Boolean
        {
            var low:Number = Infinity;
            var high:Number = -Infinity;
            for (var i:int = 0; i < 3 * _cornerCount; i += 3)
            {
                var above:Number = aboveFace(i);
                low = above < low ? above : low;
                high = above > high ? above : high;
            }
            var way:Number = speed * limit;
            low = way < 0 ? low + way : low;
            high = way > 0 ? high + way : high;
            var reach:Number = _radius + Tolerances.ROUNDING * _size;
            return low > reach || high < -reach;
        }

        // Finds when a corner of the structure comes to the triangle's face. A corner that is in the plane already can only come to the face
        // over an edge.
        private function meetFace(corner:int):void
        {
            var above:Number = aboveFace(corner);
            var rate:Number = speed;
            var side:Number = above > 0 ? 1 : -1;
            var impact:Number = (side * _radius - above) / rate;
            if (impact >= 0 && impact < time && side * rate < 0)
            {
                var back:Number = side * _radius;
                _point.setTo(_corners[corner] + impact * _motion.x - back * _face.normalX,
                        _corners[int(corner + 1)] + impact * _motion.y - back * _face.normalY,
                        _corners[int(corner + 2)] + impact * _motion.z - back * _face.normalZ);
                if (isOverFace(_point))
                {
                    time = impact;
                }
            }
        }

        // Whether a point is over the triangle's face.
        private function isOverFace(point:Vector3D):Boolean
        {
            for (var i:int = 0; i < 9; i += 3)
            {
                var from:int = _at + i;
                var to:int = i == 6 ? _at : from + 3;
                var ux:Number = _triangle[to] - _triangle[from];
                var uy:Number = _triangle[int(to + 1)] - _triangle[int(from + 1)];
                var uz:Number = _triangle[int(to + 2)] - _triangle[int(from + 2)];
                var vx:Number = point.x - _triangle[from];
                var vy:Number = point.y - _triangle[int(from + 1)];
                var vz:Number = point.z - _triangle[int(from + 2)];
                if (_face.normalX * (uy * vz - uz * vy) + _face.normalY * (uz * vx - ux * vz) + _face.normalZ * (ux * vy - uy * vx) < 0)
                {
                    return false;
                }
            }
            return true;
        }

        // How far the triangle goes up along a contact's normal.
        private function highest(contact:ContactPoint):Number
        {
            var most:Number = -Infinity;
            for (var i:int = _at; i < _at + 9; i += 3)
            {
                var along:Number = contact.normalX * _triangle[i] + contact.normalY * _triangle[int(i + 1)] + contact.normalZ * _triangle[int(i + 2)];
                most = along > most ? along : most;
            }
            return most;
        }

        // How far the displaced structure goes down along a contact's normal.
        private function lowest(contact:ContactPoint):Number
        {
            var least:Number = Infinity;
            for (var i:int = 0; i < 3 * _cornerCount; i += 3)
            {
                var along:Number = alongNormal(contact, i);
                least = along < least ? along : least;
            }
            return least - _radius;
        }

        private function alongNormal(contact:ContactPoint, corner:int):Number
        {
            var displacement:RelativeMotion = _finder.displacement;
            return contact.normalX * (_corners[corner] + displacement.startX) + contact.normalY * (_corners[int(corner + 1)] + displacement.startY)
                + contact.normalZ * (_corners[int(corner + 2)] + displacement.startZ);
        }

        // Takes the normal of the face, or its opposite, if the two overlap less along it.
        private function tryFace(side:Number, out:ContactPoint):void
        {
            _tried.setNormal(side * _face.normalX, side * _face.normalY, side * _face.normalZ);
            var low:Number = lowest(_tried);
            var depth:Number = highest(_tried) - low;
            if (!(depth < out.depth))
            {
                return;
            }
            out.copyFrom(_tried);
            out.depth = depth;
            _isOver = findMiddle(out, low);
        }

        // Puts the point in the middle of the structure's corners that are lowest and over the face. Returns whether there are any.
        private function findMiddle(out:ContactPoint, low:Number):Boolean
        {
            var back:Number = _radius;
            if (out.depth > 0)
            {
                back -= out.depth / 2;
            }
            var displacement:RelativeMotion = _finder.displacement;
            var count:int = 0;
            out.x = out.y = out.z = 0;
            for (var i:int = 0; i < 3 * _cornerCount; i += 3)
            {
                if (alongNormal(out, i) - _radius > low + Tolerances.SEPARATION * _size)
                {
                    continue;
                }
                _point.setTo(_corners[i] + displacement.startX, _corners[int(i + 1)] + displacement.startY, _corners[int(i + 2)] + displacement.startZ);
                if (isOverFace(_point))
                {
                    out.push(_point, -back);
                    out.x += _point.x;
                    out.y += _point.y;
                    out.z += _point.z;
                    count++;
                }
            }
            out.x /= count;
            out.y /= count;
            out.z /= count;
            return count > 0;
        }
    }
}
