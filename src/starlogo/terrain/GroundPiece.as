package starlogo.terrain
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.ClosestTriangles;
    import starlogo.intersection.TriangleBox;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.intersection.sweep.StructureSweep;
    import starlogo.intersection.sweep.TriangleOverlap;
    import starlogo.intersection.sweep.TriangleSweep;
    import starlogo.intersection.triangleTriangle;

    use namespace engine;

    /**
     * Tests a convex part of an agent against triangles of the ground, one at a time. The part is a sphere, capsule, box or triangle in the
     * world.
     */
    internal final class GroundPiece
    {
        private static const TRIANGLE:int = 4;

        /** The largest gap across which the piece and a triangle of the ground still touch, in addition to the piece's margin. */
        public var gap:Number = 0;

        /**
         * Before <code>findTime()</code>: the latest time to look at. After it: when the piece first touches the triangle, or
         * RelativeMotion.NEVER.
         */
        public var time:Number = 0;

        /** The distance of the closest triangle that was measured. It is less than 0 if the triangle is deep inside of the piece. */
        public var distance:Number = 0;

        // The corners of a box's triangles. A corner's number has a bit for each axis along which it is on the far side.
        private static const BOX_CORNERS:Vector.<int> = new <int>[
                0, 1, 3, 0, 3, 2, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4, 2, 3, 7, 2, 7, 6, 0, 2, 6, 0, 6, 4, 1, 3, 7, 1, 7, 5];

        // The piece's kind. For each kind, a structure in the world. The current one of these structures.
        private var _kind:int = 0;
        private var _structures:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);
        private var _placed:BoundingStructure = null;

        // The core as a triangle: a triangle itself, a capsule's two ends, or the centre of a sphere or box. The radius around the core, and
        // the margin across which the piece still touches. The triangle's extents.
        private var _core:Vector.<Number> = new Vector.<Number>(9, true);
        private var _radius:Number = 0;
        private var _margin:Number = 0;
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        // Whether the triangles of a box have been computed, and their corners.
        private var _areSides:Boolean = false;
        private var _sides:Vector.<Number> = new Vector.<Number>(3 * BOX_CORNERS.length, true);

        private var _closest:ClosestTriangles = new ClosestTriangles();
        private var _box:TriangleBox = new TriangleBox();
        private var _sweep:StructureSweep = new StructureSweep();
        private var _triangleSweep:TriangleSweep = new TriangleSweep();
        private var _overlap:TriangleOverlap = new TriangleOverlap();
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _outside:ContactPoint = new ContactPoint();

        /** Creates a piece that is not set yet. */
        public function GroundPiece()
        {
        }

        /** Sets the piece to a structure of a placed model, enlarged by a margin. */
        public function setStructure(structure:BoundingStructure, placement:Placement, margin:Number):void
        {
            var placed:BoundingStructure = _structures[structure.kind] = structure.place(placement, _structures[structure.kind]);
            placed.widen(margin);
            setPlaced(placed);
        }

        /** Sets the piece to a structure in the world. The object is kept. */
        public function setPlaced(placed:BoundingStructure):void
        {
            _kind = placed.kind;
            _placed = placed;
            _radius = 0;
            _margin = 0;
            if (_kind == BoundingStructure.BOX)
            {
                _box.box = Box(placed);
                setCore(_box.box.center, _box.box.center);
            }
            else if (_kind == BoundingStructure.CAPSULE)
            {
                setCore(Capsule(placed).start, Capsule(placed).end);
                _radius = Capsule(placed).radius;
            }
            else
            {
                setCore(Sphere(placed).center, Sphere(placed).center);
                _radius = Sphere(placed).radius;
            }
        }

        /** Sets the piece to a triangle of a placed model: nine numbers of a list, from an index on. */
        public function setTriangle(corners:Vector.<Number>, at:int, placement:Placement, margin:Number):void
        {
            _kind = TRIANGLE;
            _radius = 0;
            _margin = margin;
            for (var i:int = 0; i < 9; i += 3)
            {
                var x:Number = corners[int(at + i)] * placement.size;
                var y:Number = corners[int(at + i + 1)] * placement.size;
                var z:Number = corners[int(at + i + 2)] * placement.size;
                _core[i] = placement.r00 * x + placement.r01 * y + placement.r02 * z + placement.x;
                _core[int(i + 1)] = placement.r10 * x + placement.r11 * y + placement.r12 * z + placement.y;
                _core[int(i + 2)] = placement.r20 * x + placement.r21 * y + placement.r22 * z + placement.z;
            }
            for (i = 0; i < 3; i++)
            {
                _extents[2 * i] = Math.min(_core[i], Math.min(_core[i + 3], _core[i + 6])) - margin;
                _extents[2 * i + 1] = Math.max(_core[i], Math.max(_core[i + 3], _core[i + 6])) + margin;
            }
        }

        /** Sets a box to the triangle's extents. */
        public function writeBox(box:PassingBox):void
        {
            box.x = (_extents[0] + _extents[1]) / 2;
            box.y = (_extents[2] + _extents[3]) / 2;
            box.z = (_extents[4] + _extents[5]) / 2;
            box.halfX = (_extents[1] - _extents[0]) / 2;
            box.halfY = (_extents[3] - _extents[2]) / 2;
            box.halfZ = (_extents[5] - _extents[4]) / 2;
        }

        /** Whether a point of the piece is under the ground. Only for pieces that do not touch the ground's surface. */
        public function isUnder(grid:HeightGrid):Boolean
        {
            grid.placeX = _core[0];
            grid.placeY = _core[1];
            grid.findHeight();
            return grid.height >= _core[2];
        }

        /** Whether it touches a triangle. */
        public function touches(corners:Vector.<Number>):Boolean
        {
            if (_kind == BoundingStructure.BOX)
            {
                _box.tolerance = gap;
                return _box.touches(corners, 0);
            }
            _closest.reach = _radius * Tolerances.TOUCHING + _margin + gap;
            if (isAbove(corners))
            {
                return false;
            }
            if (_kind == TRIANGLE)
            {
                return triangleTriangle(corners, 0, _core, 0, _closest);
            }
            return _closest.areWithin(corners, 0, _core, 0);
        }

        /** Forgets all triangles, and sets the motion. The piece moves from where it stands, so the motion's start is not used. */
        public function begin(motion:RelativeMotion):void
        {
            _motion.x = motion.x;
            _motion.y = motion.y;
            _motion.z = motion.z;
            _triangleSweep.tolerance = _overlap.tolerance = _margin;
            if (_kind != TRIANGLE)
            {
                _sweep.begin(_placed, _motion);
            }
            _closest.begin();
            _areSides = false;
        }

        /** Finds when the moving piece first touches a triangle, and sets <code>time</code>. */
        public function findTime(corners:Vector.<Number>):void
        {
            if (_kind == TRIANGLE)
            {
                _triangleSweep.relate(corners, 0, _core, 0);
                _motion.time = time;
                _triangleSweep.findTime(_motion);
                time = _motion.time;
            }
            else if (touches(corners))
            {
                time = 0;
            }
            else
            {
                _sweep.setTriangle(corners, 0);
                _sweep.findTime(time);
                time = _sweep.time <= time ? _sweep.time : RelativeMotion.NEVER;
            }
        }

        /** Finds the contact of the piece and a triangle at <code>time</code>. The normal points out of the ground. */
        public function findContact(corners:Vector.<Number>, out:ContactPoint):void
        {
            if (_kind != TRIANGLE)
            {
                _sweep.setTriangle(corners, 0);
                _sweep.findContact(time, out);
            }
            else
            {
                _overlap.relate(corners, 0, _core, 0);
                _motion.time = time;
                _overlap.findContact(_motion, out);
                out.setNormal(-out.normalX, -out.normalY, -out.normalZ);
                out.x += corners[0];
                out.y += corners[1];
                out.z += corners[2];
            }
            // where a moving piece first touches a sharp edge, the normal may point behind one of the edge's faces
            var isFirstTouch:Boolean = time > 0 && out.normalX * _motion.x + out.normalY * _motion.y + out.normalZ * _motion.z < 0;
            GroundFaces.findOutside(corners, _outside);
            if (!isFirstTouch && out.normalX * _outside.normalX + out.normalY * _outside.normalY + out.normalZ * _outside.normalZ < 0)
            {
                out.setNormal(_outside.normalX, _outside.normalY, _outside.normalZ);
            }
        }

        /** Measures the distance to a triangle of the ground, and updates <code>distance</code>. */
        public function measure(corners:Vector.<Number>):void
        {
            if (_kind != BoundingStructure.BOX)
            {
                _closest.add(_core, 0, corners, 0);
            }
            else if (!_areSides)
            {
                findSides();
            }
            for (var i:int = 0; _kind == BoundingStructure.BOX && i < _sides.length; i += 9)
            {
                _closest.add(_sides, i, corners, 0);
            }
            distance = Math.sqrt(_closest.squared) - _radius;
        }

        /** Writes the closest points that were found. */
        public function writeClosest(out:ClosestPair):void
        {
            out.copyPoints(_closest.points);
            out.gapX = out.aX - out.bX;
            out.gapY = out.aY - out.bY;
            out.gapZ = out.aZ - out.bZ;
            out.radiusA = _radius;
            out.radiusB = 0;
            out.separate();
        }

        private function findSides():void
        {
            var box:Box = _box.box;
            _areSides = true;
            for (var i:int = 0; i < BOX_CORNERS.length; i++)
            {
                var x:Number = (BOX_CORNERS[i] & 1) == 0 ? -box.halfX : box.halfX;
                var y:Number = (BOX_CORNERS[i] & 2) == 0 ? -box.halfY : box.halfY;
                var z:Number = (BOX_CORNERS[i] & 4) == 0 ? -box.halfZ : box.halfZ;
                _sides[3 * i] = box.center.x + x * box.axisX.x + y * box.axisY.x + z * box.axisZ.x;
                _sides[3 * i + 1] = box.center.y + x * box.axisX.y + y * box.axisY.y + z * box.axisZ.y;
                _sides[3 * i + 2] = box.center.z + x * box.axisX.z + y * box.axisY.z + z * box.axisZ.z;
            }
        }

        // Whether the whole piece is above the plane of a triangle. Most pieces are.
        private function isAbove(corners:Vector.<Number>):Boolean
        {
            GroundFaces.findOutside(corners, _outside);
            var x:Number = _outside.normalX;
            var y:Number = _outside.normalY;
            var z:Number = _outside.normalZ;
            var plane:Number = x * corners[0] + y * corners[1] + z * corners[2] + _closest.reach;
            return x * _core[0] + y * _core[1] + z * _core[2] > plane && x * _core[3] + y * _core[4] + z * _core[5] > plane
                && x * _core[6] + y * _core[7] + z * _core[8] > plane;
        }

        private function setCore(start:Vector3D, end:Vector3D):void
        {
            _core[0] = start.x;
            _core[1] = start.y;
            _core[2] = start.z;
            _core[3] = _core[6] = end.x;
            _core[4] = _core[7] = end.y;
            _core[5] = _core[8] = end.z;
        }
    }
}
