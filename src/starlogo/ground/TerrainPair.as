package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * Tests a placed model against the ground: whether the two overlap, when and how they first touch, and how far they are apart. The model is
     * a structure or a tree.
     *
     * <p>A connected piece that does not touch the ground's surface is wholly under the ground or wholly outside of it, so one point decides.
     * First, each convex piece is tested against the triangles of the surface near it. Then a point of the piece is tested.</p>
     *
     * <p>Answers are nested, because a node's piece contains the pieces and the triangles of all its
     * descendants.</p>
     *
     * @private
     */
    public final class TerrainPair extends GroundSearch
    {
        // Two ways have nearly the same direction if the cosine of their angle is larger.
        private static const SAME_EXIT:Number = 0.98;

        // A part counts as behind a plane if it reaches in front of it by at most this many gaps of the triangle. The rest is rounding.
        private static const PART_GAPS:Number = 10;

        // The most ways that are found.
        private static const MOST_EXITS:int = 12;

        // A contact is taken at once if the least length of a way out is at least this fraction of its depth.
        private static const NEEDED:Number = 0.8;

        /** A lower bound for the length of every way out of the last contact; 0 if none is known. */
        public var leastDepth:Number = 0;

        // The contact with the last triangle; the triangle of the ground that the last contact was with, if there was one; and the distance of the
        // nearest triangle so far.
        private var _tried:ContactPoint = new ContactPoint();
        private var _part:Vector.<Number> = new Vector.<Number>(9, true);
        private var _hasPart:Boolean = false;
        private var _nearest:Number = 0;

        // The motion of the search for the first touch.
        private var _sweep:RelativeMotion = new RelativeMotion();

        /** Whether the two overlap or touch where the model stands. */
        public function areOverlapping():Boolean
        {
            return overlapsAt(RelativeMotion.NONE, 0);
        }

        /** Whether a piece of the model overlaps the surface by more than a depth, or is wholly under the ground. */
        public function isDeeper(depth:Number):Boolean
        {
            begin(_tree, RelativeMotion.NONE, 0);
            _under = depth;
            while (next())
            {
                if (findOverlap())
                {
                    if (_tried.depth > depth)
                    {
                        return true;
                    }
                    if (_tree != null)
                    {
                        // the point of a flat piece may be on the surface
                        _point = null;
                    }
                }
            }
            return _isUnder;
        }

        /**
         * Finds the first moment at which the two overlap while the model moves, and the contact then.
         *
         * @param motion of the model; takes the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, with a normal that points out of the ground; null if only the time is needed
         */
        public function findFirst(motion:RelativeMotion, out:ContactPoint):void
        {
            leastDepth = 0;
            var touching:Number = 0;
            if (!overlapsAt(motion, 0))
            {
                findImpact(motion, out);
                if (motion.time != RelativeMotion.NEVER)
                {
                    return;
                }
                // rounding can miss a touch at the end of the motion
                touching = overlapsAt(motion, 1) ? 1 : RelativeMotion.NEVER;
            }
            motion.time = touching;
            if (out != null && touching != RelativeMotion.NEVER)
            {
                findContact(motion, out);
            }
        }

        /**
         * Finds when the model first touches the surface as it moves, and how.
         *
         * @param motion of the model; takes the time, from 0 to 1, or RelativeMotion.NEVER
         * @param out receives the contact, with a normal that points out of the ground; null if only the time is needed
         */
        public function findImpact(motion:RelativeMotion, out:ContactPoint):void
        {
            placeAt(motion, 0);
            begin(_tree, motion, 0);
            var first:Number = RelativeMotion.NEVER;
            setSweep(motion);
            while (first > 0 && next())
            {
                _sweep.latest = _faces.limit;
                if (_piece.staysBeside(_sweep))
                {
                    continue;
                }
                _piece.findTime(_sweep);
                if (_sweep.time < first)
                {
                    first = _faces.limit = _sweep.time;
                    if (out != null)
                    {
                        _piece.findContact(_sweep, out);
                        _piece.leadOutside(_sweep, out);
                    }
                }
            }
            motion.time = first;
            if (out != null && motion.time != RelativeMotion.NEVER)
            {
                moveToWorld(out);
            }
        }

        /**
         * Finds the contact of the model and the ground, which overlap at the motion's time. If the moving model first touches the surface
         * then, it is the contact of this touch. Otherwise it is the contact of the deepest piece, where the model stands then. If the model is
         * wholly under the ground, the contact lifts it up.
         *
         * @param out receives the contact, with a normal that points out of the ground
         */
        public function findContact(motion:RelativeMotion, out:ContactPoint):void
        {
            var time:Number = motion.time;
            leastDepth = 0;
            _hasPart = false;
            if (motion.x != 0 || motion.y != 0 || motion.z != 0)
            {
                findImpact(motion, out);
                var isSame:Boolean = motion.time <= time + Tolerances.SAME_TIME;
                motion.time = time;
                if (isSame)
                {
                    return;
                }
            }
            placeAt(motion, time);
            findDeepest(out, false);
            if (_hasPart)
            {
                leastDepth = out.depth;
            }
            else
            {
                findDeepest(out, true);
            }
            if (_hasPart)
            {
                moveToWorld(out);
            }
            else
            {
                findOuterContact(out);
            }
        }

        /**
         * Finds the planes of triangles that the standing structure around the model is behind: of planes with nearly the same direction, the one
         * that it is least behind.
         *
         * @param reach how far away triangles may be
         * @param ways receives the contacts that lead out of the planes
         * @return their number
         */
        public function findExits(reach:Number, ways:Vector.<ContactPoint>):int
        {
            var count:int = 0;
            begin(null, RelativeMotion.NONE, reach);
            while (next())
            {
                _piece.findBehind(RelativeMotion.NONE, _tried);
                if (_tried.depth >= -_faces.gap && (!_hasPart || isPartBehind()))
                {
                    count = addExit(ways, count);
                }
            }
            for (var i:int = 0; i < count; i++)
            {
                moveToWorld(ways[i]);
            }
            return count;
        }

        /** Finds the contact that lifts the model from its lowest place above all ground under it. */
        public function findOuterContact(out:ContactPoint):void
        {
            placeBox(_structure);
            var middle:Vector3D = _faces.middle;
            var half:Vector3D = _faces.half;
            var low:Number = middle.z - half.z;
            _faces.grid.findAround(middle.x + _faces.origin.x, middle.y + _faces.origin.y, half.x, half.y);
            out.setNormal(0, 0, 1);
            out.depth = Math.max(0, _faces.grid.greatest - _faces.origin.z - low);
            out.x = middle.x;
            out.y = middle.y;
            out.z = low + out.depth / 2;
            moveToWorld(out);
        }

        /**
         * Finds how far the two are apart where the model stands, and between which points.
         *
         * @param areTouching whether they overlap. If so, a point of both is found
         */
        public function findClosest(areTouching:Boolean, out:ClosestPoints):void
        {
            setNearest();
            out.distance = _nearest;
            if (_tree == null)
            {
                setPiece(_structure);
                _faces.begin();
                measure(out);
            }
            begin(_tree, RelativeMotion.NONE, _nearest);
            measure(out);
            if (areTouching)
            {
                // either the model's point is in the ground, or the surface's point is in the model
                var isUnder:Boolean = _faces.grid.heightAt(out.aX + _faces.origin.x, out.aY + _faces.origin.y) - _faces.origin.z >= out.aZ;
                out.aX = out.bX = isUnder ? out.aX : out.bX;
                out.aY = out.bY = isUnder ? out.aY : out.bY;
                out.aZ = out.bZ = isUnder ? out.aZ : out.bZ;
            }
            out.settle(areTouching);
            out.place(_faces.origin);
        }

        // Sets the search to the triangles at the height that is nearest to the model's middle, seen from above. The model is at most as far as its
        // farthest point is from there.
        private function setNearest():void
        {
            stop();
            placeBox(_structure);
            var middle:Vector3D = _faces.middle;
            var half:Vector3D = _faces.half;
            var width:Number = _faces.grid.cellWidth;
            var column:int = Math.max(0, Math.min(_faces.grid.columns - 1, Math.round((middle.x + _faces.origin.x - _faces.grid.x) / width)));
            var row:int = Math.max(0, Math.min(_faces.grid.rows - 1, Math.round((middle.y + _faces.origin.y - _faces.grid.y) / width)));
            var atX:Number = _faces.grid.x + column * width - _faces.origin.x;
            var atY:Number = _faces.grid.y + row * width - _faces.origin.y;
            var atZ:Number = _faces.grid.heights[int(row * _faces.grid.columns + column)] - _faces.origin.z;
            var x:Number = Math.abs(atX - middle.x) + half.x;
            var y:Number = Math.abs(atY - middle.y) + half.y;
            var z:Number = Math.abs(atZ - middle.z) + half.z;
            _nearest = Math.sqrt(x * x + y * y + z * z) * Tolerances.OUTER + Tolerances.SURFACES * width;
            middle.setTo(atX, atY, atZ);
            half.setTo(0, 0, 0);
            _faces.way = RelativeMotion.NONE;
            _faces.reach = 0;
            _faces.structure = null;
        }

        // Measures the distances of all pairs of a piece and a triangle, and keeps the closest points of the nearest ones.
        private function measure(out:ClosestPoints):void
        {
            while (next())
            {
                if (_piece.findCloser(out))
                {
                    _nearest = _faces.reach = out.distance;
                }
            }
        }

        // Finds the contact with the triangle that the model is deepest behind. It is of a piece whose deepest point is known to be about as deep in
        // the ground, or of a piece that overlaps a triangle.
        private function findDeepest(out:ContactPoint, overlaps:Boolean):void
        {
            var deepest:Number = 0;
            begin(_tree, RelativeMotion.NONE, 0);
            while (next())
            {
                var isUnder:Boolean = _piece.findBehind(RelativeMotion.NONE, _tried);
                if (deepest > 0 && _tried.depth < deepest + _faces.gap)
                {
                    continue;
                }
                var isDecided:Boolean = overlaps ? findOverlap() : isUnder && isNeeded();
                if (isDecided && (_tried.depth > deepest || _tried.depth == deepest && !_hasPart))
                {
                    deepest = _tried.depth;
                    if (overlaps)
                    {
                        _piece.leadOutside(RelativeMotion.NONE, _tried);
                    }
                    else
                    {
                        _faces.above = deepest;
                    }
                    keep(_tried, out);
                }
            }
        }

        // Finds the contact of the piece and the triangle along its own normal. Returns false if they are apart.
        private function findOverlap():Boolean
        {
            if (!_piece.areTouching())
            {
                return false;
            }
            _piece.findContact(RelativeMotion.NONE, _tried);
            return true;
        }

        private function keep(contact:ContactPoint, out:ContactPoint):void
        {
            out.copyFrom(contact);
            for (var i:int = 0; i < 9; i++)
            {
                _part[i] = _faces.corners[i];
            }
            _hasPart = true;
        }

        // Adds a way out to a number of ways. Of ways with nearly the same direction, the shortest is kept. Returns the new number.
        private function addExit(ways:Vector.<ContactPoint>, count:int):int
        {
            for (var i:int = 0; i < count; i++)
            {
                var way:ContactPoint = ways[i];
                if (_tried.normalX * way.normalX + _tried.normalY * way.normalY + _tried.normalZ * way.normalZ > SAME_EXIT)
                {
                    if (_tried.depth < way.depth)
                    {
                        way.copyFrom(_tried);
                    }
                    return count;
                }
            }
            if (count == MOST_EXITS)
            {
                return count;
            }
            if (count == ways.length)
            {
                ways[count] = new ContactPoint();
            }
            ways[count].copyFrom(_tried);
            return count + 1;
        }

        private function isPartBehind():Boolean
        {
            _tried.measure(_part, 0, 9);
            var greatest:Number = _tried.greatest;
            _tried.measure(_faces.corners, 0, 3);
            return greatest <= _tried.least + PART_GAPS * _faces.gap;
        }

        // Whether any way out of the ground is at least about as long as the last contact is deep, because the piece's deepest point has to get out.
        private function isNeeded():Boolean
        {
            var grid:HeightGrid = _faces.grid;
            var depth:Number = _tried.depth;
            if (!(depth >= 0))
            {
                return false;
            }
            var x:Number = _faces.origin.x + _tried.x - depth / 2 * _tried.normalX;
            var y:Number = _faces.origin.y + _tried.y - depth / 2 * _tried.normalY;
            var z:Number = _faces.origin.z + _tried.z - depth / 2 * _tried.normalZ;
            var high:Number = grid.heightAt(x, y);
            var border:Number = grid.isBlocky ? grid.cellWidth / 2 : 0;
            var left:Number = Math.min(x - grid.x, grid.x + (grid.columns - 1) * grid.cellWidth - x);
            var front:Number = Math.min(y - grid.y, grid.y + (grid.rows - 1) * grid.cellWidth - y);
            if (!(high > z) || Math.min(left, front) + border < depth)
            {
                return depth == 0;
            }
            grid.findAround(x, y, depth, depth);
            var least:Number = grid.least - z;
            if (!grid.isBlocky)
            {
                var slopeX:Number = grid.stepX / grid.cellWidth;
                var slopeY:Number = grid.stepY / grid.cellWidth;
                least = Math.max(least, (high - z) / Math.sqrt(1 + slopeX * slopeX + slopeY * slopeY));
            }
            return least >= NEEDED * depth;
        }

        private function overlapsAt(motion:RelativeMotion, time:Number):Boolean
        {
            placeAt(motion, time);
            begin(_tree, RelativeMotion.NONE, 0);
            _under = 0;
            while (next())
            {
                if (_piece.areTouching())
                {
                    return true;
                }
            }
            return _isUnder;
        }

        private function setSweep(motion:RelativeMotion):void
        {
            _sweep.x = motion.x;
            _sweep.y = motion.y;
            _sweep.z = motion.z;
        }

        private function moveToWorld(out:ContactPoint):void
        {
            out.x += _faces.origin.x;
            out.y += _faces.origin.y;
            out.z += _faces.origin.z;
        }
    }
}
