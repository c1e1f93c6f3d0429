package starlogo.intersection
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactFeature;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.contact.Zonotope;
    import starlogo.intersection.contact.findPairContact;
    import starlogo.intersection.distance.RoundGap;
    import starlogo.intersection.distance.DistanceResult;
    import starlogo.intersection.distance.moveToSurfaces;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.TriangleContactFinder;
    import starlogo.intersection.sweep.TriangleSweep;
    import starlogo.intersection.sweep.findTimeOfImpact;

    use namespace engine;

    /**
     * Tests a sphere, capsule, box or triangle against triangles, one after the other: whether the two touch, when and how they first touch,
     * and how far they are apart. Allocates nothing.
     *
     * <p>A structure that moves first touches a triangle at an edge of the triangle, or with a corner that comes to the triangle's face. An
     * edge is a capsule without a radius, so the structures' own kernels answer for it. A corner moves along a ray. The corners of a sphere
     * or capsule are the ends of its axis, with the radius around them.</p>
     *
     * @private
     */
    public final class ConvexTriangle
    {
        private static const TRIANGLE:int = 4;

        // A box's twelve triangles as a strip of corners: each corner and the next two are a triangle. See Box.cornerInto().
        private static const STRIP:Vector.<int> = new <int>[6, 7, 2, 3, 1, 7, 5, 6, 4, 2, 0, 1, 4, 5];

        /** The margin that is added to the shape on all sides. Input of <code>begin()</code> and <code>beginTriangle()</code>. */
        public var margin:Number = 0;

        /** Whether the triangles are the outside of a solid, and counter-clockwise. Then contacts point out of the solid. */
        public var isOneSided:Boolean = false;

        /** The largest gap across which the shape and the triangle still touch, in addition to the margin. */
        public var gap:Number = 0;

        /** A time of the motion: see findTime and findContact. */
        public var time:Number = 0;

        /** The structure at the beginning; null for a triangle. Read only. */
        public var structure:BoundingStructure = null;

        /** The radius around the shape's corners. Read only. */
        public var radius:Number = 0;

        /** A point of the shape. Read only. */
        public var point:Vector3D = null;

        /** The distance of the nearest triangle that was measured. */
        public var distance:Number = 0;

        // The shape's kind, and a structure for each kind.
        private var _kind:int = 0;
        private var _structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);
        private var _motion:RelativeMotion = new RelativeMotion();

        // The shape's corners as a strip of triangles, and the radius around them. A box's corners are computed when they are needed. Rounding
        // is relative to the size.
        private var _corners:Vector.<Number> = new Vector.<Number>(3 * STRIP.length, true);
        private var _end:int = 0;
        private var _size:Number = 0;

        // The triangle, an edge of it, and its unit normal. The normal is NaN if the triangle has no area. Comparisons with NaN are false, so
        // the triangle counts as its edges then.
        private var _triangle:Vector.<Number>;
        private var _at:int = 0;
        private var _isPrepared:Boolean = false;
        private var _face:ContactPoint = new ContactPoint();
        private var _edge:Capsule = new Capsule(new Vector3D(), new Vector3D(), 0);

        private var _box:TriangleBox = new TriangleBox();
        private var _closest:TrianglePairDistance = new TrianglePairDistance();
        private var _core:RoundGap = new RoundGap();
        private var _sweep:TriangleSweep = new TriangleSweep();
        private var _overlap:TriangleContactFinder = new TriangleContactFinder();
        private var _displacement:RelativeMotion = new RelativeMotion(0);
        private var _tried:ContactPoint = new ContactPoint();
        private var _sum:Zonotope = new Zonotope();
        private var _feature:ContactFeature = new ContactFeature();
        private var _otherFeature:ContactFeature = new ContactFeature();
        private var _corner:Vector3D = new Vector3D();
        private var _point:Vector3D = new Vector3D();
        private var _deepest:DeepestPoint = new DeepestPoint();

        /**
         * Begins with a structure.
         *
         * @param shape the structure; not kept
         * @param placement moves it into the triangles' space
         * @param motion its motion from there. The motion's start is not used
         */
        public function begin(shape:BoundingStructure, placement:Placement, motion:RelativeMotion):void
        {
            _kind = shape.kind;
            structure = _structures[_kind] = shape.place(placement, _structures[_kind]);
            radius = _end = 0;
            if (_kind == BoundingStructure.BOX)
            {
                _box.box = Box(structure);
                _box.box.halfX += margin; // V8 makes an object for the argument of widen()
                _box.box.halfY += margin;
                _box.box.halfZ += margin;
                _size = _box.box.halfX + _box.box.halfY + _box.box.halfZ;
                point = _box.box.center;
            }
            else if (_kind == BoundingStructure.CAPSULE)
            {
                var capsule:Capsule = Capsule(structure);
                radius = capsule.radius += margin;
                setAxis(capsule.start, capsule.end);
            }
            else
            {
                var sphere:Sphere = Sphere(structure);
                radius = sphere.radius += margin;
                setAxis(sphere.center, sphere.center);
            }
            beginMotion(motion);
        }

        /** Begins with a triangle: nine numbers of a list, from an index on. See begin for the placement and the motion. */
        public function beginTriangle(corners:Vector.<Number>, at:int, placement:Placement, motion:RelativeMotion):void
        {
            _kind = TRIANGLE;
            radius = _sweep.tolerance = _overlap.tolerance = margin;
            _size = 0;
            placement.movePoints(corners, at, at + 9, _corners);
            _end = 9;
            point = _corner;
            point.setTo(_corners[0], _corners[1], _corners[2]);
            beginMotion(motion);
        }

        /** Sets the other triangle: nine numbers of a list, from an index on. The list is kept. */
        public function setTriangle(corners:Vector.<Number>, at:int):void
        {
            _triangle = corners;
            _at = at;
            _isPrepared = false;
        }

        /** Whether the two touch at the beginning. */
        public function touches():Boolean
        {
            if (_kind == BoundingStructure.BOX)
            {
                _box.tolerance = gap;
                return _box.touches(_triangle, _at);
            }
            _closest.reach = radius * Tolerances.TOUCHING + gap;
            if (_kind == TRIANGLE)
            {
                return triangleTriangle(_corners, 0, _triangle, _at, _closest);
            }
            return !isApart(false) && _closest.areWithin(_triangle, _at, _corners, 0);
        }

        /**
         * Finds when the two first touch. Reads the latest time from <code>time</code>, and writes the result: RelativeMotion.NEVER for no
         * touch.
         *
         * @param startsApart whether it is known that they do not touch at the beginning
         */
        public function findTime(startsApart:Boolean = false):void
        {
            var latest:Number = time;
            if (!startsApart && touches())
            {
                time = 0;
                return;
            }
            if (latest == 0 || isApart(true))
            {
                time = RelativeMotion.NEVER;
                return;
            }
            if (_kind == TRIANGLE)
            {
                _sweep.relate(_triangle, _at, _corners, 0);
                _motion.time = latest;
                _sweep.findTime(_motion);
                time = _motion.time;
                return;
            }
            time = RelativeMotion.NEVER;
            var isFirst:Boolean = meetFace();
            for (var i:int = 0; i < 9 && !isFirst; i += 3)
            {
                setEdge(i);
                _motion.latest = time < latest ? time : latest;
                findTimeOfImpact(structure, _edge, _motion);
                time = _motion.time < time ? _motion.time : time;
            }
            time = time <= latest ? time : RelativeMotion.NEVER;
        }

        /**
         * Finds how the two touch at <code>time</code>. The normal is perpendicular to the face or to an edge. The one along which the two
         * overlap least is chosen.
         *
         * @param out receives the contact, with a normal that points from the triangle to the shape
         */
        public function findContact(out:ContactPoint):void
        {
            prepare();
            if (_kind == TRIANGLE)
            {
                _overlap.relate(_triangle, _at, _corners, 0);
                _motion.time = time;
                _overlap.findContact(_motion, out);
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
            }
            else
            {
                findContactOfStructure(out);
            }
            // Where a moving shape first touches a sharp edge, the normal may point behind one of the edge's faces.
            var isFirstTouch:Boolean = time > 0 && speedAlong(out) < 0;
            if (isOneSided && !isFirstTouch && out.normalX * _face.normalX + out.normalY * _face.normalY + out.normalZ * _face.normalZ < -Tolerances.DIRECTION)
            {
                out.setNormal(_face.normalX, _face.normalY, _face.normalZ);
            }
        }

        /**
         * Finds how far the shape reaches behind the triangle's plane at the beginning.
         *
         * @param out receives the depth, the triangle's normal, and the middle of the overlap at the shape's deepest point
         * @return whether this point is behind the triangle itself
         */
        public function findBehind(out:ContactPoint):Boolean
        {
            prepare();
            out.setNormal(_face.normalX, _face.normalY, _face.normalZ);
            if (_kind == BoundingStructure.BOX)
            {
                _deepest.findOfBox(_box.box, out);
            }
            else
            {
                _deepest.findOfCorners(_corners, _kind == TRIANGLE ? 9 : 6, out);
            }
            var deepest:Vector3D = _deepest.point;
            out.push(deepest, -radius);
            out.depth = out.normalX * _triangle[_at] + out.normalY * _triangle[int(_at + 1)] + out.normalZ * _triangle[int(_at + 2)] - out.along(deepest);
            out.x = deepest.x + out.depth / 2 * out.normalX;
            out.y = deepest.y + out.depth / 2 * out.normalY;
            out.z = deepest.z + out.depth / 2 * out.normalZ;
            return isOverTriangle(deepest, _triangle, _at, _face);
        }

        /** Measures the distance of the two. Updates <code>distance</code> if this triangle is the nearest one since the beginning. */
        public function measure():void
        {
            prepare();
            for (var i:int = 0; i < _end - 6; i += 3)
            {
                _closest.add(_corners, i, _triangle, _at);
            }
            distance = Math.sqrt(_closest.squared) - radius;
        }

        /** Writes the closest points of the shape and of the nearest triangle that was measured. */
        public function writeClosest(out:DistanceResult):void
        {
            out.copyPoints(_closest.points);
            _core.x = out.aX - out.bX;
            _core.y = out.aY - out.bY;
            _core.z = out.aZ - out.bZ;
            _core.radiusA = radius;
            moveToSurfaces(_core, out);
        }

        private function beginMotion(motion:RelativeMotion):void
        {
            _motion.x = motion.x;
            _motion.y = motion.y;
            _motion.z = motion.z;
            _isPrepared = false;
            _closest.begin();
        }

        private function setAxis(start:Vector3D, end:Vector3D):void
        {
            // Vector3D.distance() makes an object in some players
            var x:Number = end.x - start.x;
            var y:Number = end.y - start.y;
            var z:Number = end.z - start.z;
            _size = radius + Math.sqrt(x * x + y * y + z * z);
            point = start;
            addCorner(start);
            addCorner(end);
            addCorner(end);
        }

        private function addCorner(at:Vector3D):void
        {
            _corners[_end] = at.x;
            _corners[int(_end + 1)] = at.y;
            _corners[int(_end + 2)] = at.z;
            _end += 3;
        }

        // Computes what most tests need: the normal of the triangle, and the corners of a box.
        private function prepare():void
        {
            if (_isPrepared)
            {
                return;
            }
            _isPrepared = true;
            for (var i:int = 0; _end < 3 * STRIP.length && _kind == BoundingStructure.BOX; i++)
            {
                _box.box.cornerInto(STRIP[i], _corner);
                addCorner(_corner);
            }
            var p:Vector.<Number> = _triangle;
            _face.setTriangleNormal(p, _at);
            if (!(_face.length * _face.length > Tolerances.FLAT_TRIANGLE * _face.squared * _face.squared))
            {
                _face.setNormal(NaN, NaN, NaN);
            }
            // Without this radius, rounding would hide the direction of the gap when the gap is almost closed.
            _edge.radius = Tolerances.ROUNDING * (_size + Math.sqrt(_face.squared) + Math.abs(p[_at]) + Math.abs(p[int(_at + 1)]) + Math.abs(p[int(_at + 2)]));
        }

        // Without setTo(), because V8 makes objects for its numbers where it does not inline it.
        private function setEdge(first:int):void
        {
            var from:int = _at + first;
            var to:int = first == 6 ? _at : from + 3;
            _edge.start.x = _triangle[from];
            _edge.start.y = _triangle[int(from + 1)];
            _edge.start.z = _triangle[int(from + 2)];
            _edge.end.x = _triangle[to];
            _edge.end.y = _triangle[int(to + 1)];
            _edge.end.z = _triangle[int(to + 2)];
        }

        private function speedAlong(contact:ContactPoint):Number
        {
            return contact.normalX * _motion.x + contact.normalY * _motion.y + contact.normalZ * _motion.z;
        }

        // Whether the shape is on one side of the triangle's plane, and stays there until the time if it moves.
        private function isApart(isMoving:Boolean):Boolean
        {
            prepare();
            // not by speedAlong(): V8 would make an object of what it returns
            var speed:Number = _face.normalX * _motion.x + _face.normalY * _motion.y + _face.normalZ * _motion.z;
            var way:Number = isMoving ? time * speed : 0;
            var least:Number = -gap - _edge.radius;
            _face.measure(_triangle, _at, _at + 9);
            var low:Number = _face.least;
            var high:Number = _face.greatest;
            _face.measure(_corners, 0, _end);
            return high - _face.least + radius - Math.min(way, 0) < least || _face.greatest - low + radius + Math.max(way, 0) < least;
        }

        // Finds when a corner of the structure comes to the triangle's face. Returns whether no other part of it comes to the face's plane
        // earlier, so that none touches an edge earlier.
        private function meetFace():Boolean
        {
            var first:Number = Infinity;
            var speed:Number = speedAlong(_face);
            var back:Number = speed < 0 ? radius : -radius;
            var x:Number = _face.normalX;
            var y:Number = _face.normalY;
            var z:Number = _face.normalZ;
            var plane:Number = x * _triangle[_at] + y * _triangle[int(_at + 1)] + z * _triangle[int(_at + 2)] + back;
            for (var i:int = 0; i < _end; i += 3)
            {
                var impact:Number = (plane - (x * _corners[i] + y * _corners[int(i + 1)] + z * _corners[int(i + 2)])) / speed;
                // touches() projects in another order. So if the shape comes to the plane, rounding may have put a corner a little beyond it.
                impact = impact < 0 && Math.abs(impact * speed) < _edge.radius
                    && speed * (plane - back - (x * point.x + y * point.y + z * point.z)) > 0 ? 0 : impact;
                first = impact < first ? impact : first;
                if (impact >= 0 && impact < time)
                {
                    _point.x = _corners[i] + impact * _motion.x - back * x;
                    _point.y = _corners[int(i + 1)] + impact * _motion.y - back * y;
                    _point.z = _corners[int(i + 2)] + impact * _motion.z - back * z;
                    time = isOverTriangle(_point, _triangle, _at, _face) ? impact : time;
                }
            }
            return time < RelativeMotion.NEVER && time == first;
        }

        private function findContactOfStructure(out:ContactPoint):void
        {
            _motion.time = time;
            _displacement.stopAt(_motion);
            out.depth = Infinity;
            // The side of the structure's middle comes first, because the first one is kept if rounding decides.
            _face.measure(_triangle, _at, _at + 9);
            var plane:Number = _face.least;
            _face.measure(_corners, 0, _end);
            var side:int = (_face.least + _face.greatest) / 2 + time * speedAlong(_face) < plane ? -1 : 1;
            _tried.setNormal(side * _face.normalX, side * _face.normalY, side * _face.normalZ);
            keepLeast(out);
            _tried.setNormal(-side * _face.normalX, -side * _face.normalY, -side * _face.normalZ);
            keepLeast(out);
            for (var i:int = 0; i < 9; i += 3)
            {
                setEdge(i);
                findPairContact(structure, _edge, _displacement, _tried);
                keepLeast(out);
            }
            _point.setTo(-out.normalX, -out.normalY, -out.normalZ);
            _sum.setTo(structure, _displacement);
            _sum.supportInto(_feature, _point);
            _feature.setVector(radius * _point.x, radius * _point.y, radius * _point.z);
            _feature.move();
            _otherFeature.setFarthest(_triangle, _at, out, 1);
            _feature.findCommonPoint(_otherFeature, out);
            out.x = _feature.x;
            out.y = _feature.y;
            out.z = _feature.z;
            out.depth = out.depth > 0 ? out.depth : 0;
        }

        // Keeps the normal if the two overlap less along it. If rounding decides, the one before is kept.
        private function keepLeast(out:ContactPoint):void
        {
            _tried.measure(_corners, 0, _end);
            var least:Number = _tried.least;
            _tried.measure(_triangle, _at, _at + 9);
            var depth:Number = _tried.greatest - least + radius - time * speedAlong(_tried);
            if (depth < out.depth - _edge.radius)
            {
                out.setNormal(_tried.normalX, _tried.normalY, _tried.normalZ);
                out.depth = depth;
            }
        }
    }
}
