package starlogo.search.pairs
{
    import flash.geom.Vector3D;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.NarrowPhase;
    import starlogo.search.TreeLimits;
    import starlogo.solid.ModelTree;
    import starlogo.solid.SupportPoint;
    import starlogo.solid.SupportSearch;

    use namespace engine;

    /**
     * Tests whether a body touches the edges of the world, when it touches them, and how. The edges are the second body of each pair. Motions
     * end where the first body is.
     *
     * <p>An edge is a plane, so a body touches it if the farthest point of its shape does. Structures reach to the ends of their
     * extents. A tree may reach less far.</p>
     *
     * <p>A body that touches several edges has one contact. Its depth is the length of the shortest way back from all of them. Its normal is
     * the direction of that way.</p>
     *
     * @private
     */
    public final class EdgePairTests extends PairTests
    {
        // By edge: the direction out of the world.
        private static const OUTWARDS:Vector.<Vector3D> = new <Vector3D>[new Vector3D(-1, 0, 0), new Vector3D(1, 0, 0), new Vector3D(0, -1, 0),
                new Vector3D(0, 1, 0), new Vector3D(0, 0, -1), new Vector3D(0, 0, 1)];

        // By edge: how far the body is beyond it; less than 0 if the body is before it.
        private var _penetrations:Vector.<Number> = new Vector.<Number>(6, true);

        private var _limits:TreeLimits;
        private var _supportSearch:SupportSearch = new SupportSearch();
        private var _farthest:SupportPoint = new SupportPoint();

        /** @param limits how far trees are tested */
        public function EdgePairTests(limits:TreeLimits)
        {
            _limits = limits;
        }

        /** Gives these tests to a narrow phase that does not have them. */
        public static function addTo(narrowPhase:NarrowPhase):void
        {
            narrowPhase.edgeTests ||= new EdgePairTests(narrowPhase.treeLimits);
        }

        /** @inheritDoc */
        override public function areTouching(a:Body, b:Body):Boolean
        {
            var tolerance:Number = touchToleranceOf(a);
            findPenetrations(a, b, RelativeMotion.NONE, tolerance, _penetrations);
            for (var edge:int = 0; edge < 6; edge++)
            {
                if (_penetrations[edge] + tolerance >= 0)
                {
                    return true;
                }
            }
            return false;
        }

        /** @inheritDoc */
        override public function findFirstTouch(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            var tolerance:Number = touchToleranceOf(a);
            // first at the end
            motion.time = 1;
            findPenetrations(a, b, motion, tolerance, _penetrations);
            motion.time = RelativeMotion.NEVER;
            for (var edge:int = 0; edge < 6; edge++)
            {
                var end:Number = _penetrations[edge] + tolerance;
                var start:Number = end - along(edge, motion.x, motion.y, motion.z);
                if (start >= 0)
                {
                    motion.time = 0;
                }
                else if (end >= 0)
                {
                    motion.time = Math.min(motion.time, start / (start - end));
                }
            }
            findContactIfNeeded(a, b, motion, out);
        }

        /**
         * @inheritDoc
         *
         * <p>If the body touches no edge, it is the contact with the nearest edge, with a depth of 0.</p>
         */
        override public function findContactOfParts(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            var deepest:int = findDeepest(a, b, motion, _penetrations);
            var left:Number = 1 - motion.time;
            findFarthest(a, OUTWARDS[deepest], _farthest);
            out.x = _farthest.x - left * motion.x;
            out.y = _farthest.y - left * motion.y;
            out.z = _farthest.z - left * motion.z;
            // the edges are at right angles, so the shortest way back from all is the sum of the ways back from each
            var wayX:Number = 0;
            var wayY:Number = 0;
            var wayZ:Number = 0;
            var count:int = 0;
            for (var edge:int = 0; edge < 6; edge += 2)
            {
                // of two opposite edges, the one with the larger value counts
                var one:int = _penetrations[edge] >= _penetrations[int(edge + 1)] ? edge : edge + 1;
                if (_penetrations[one] >= -touchToleranceOf(a) || one == deepest)
                {
                    var way:Number = lengthOfWayBack(_penetrations[one], one == deepest, a);
                    wayX -= way * OUTWARDS[one].x;
                    wayY -= way * OUTWARDS[one].y;
                    wayZ -= way * OUTWARDS[one].z;
                    count++;
                    moveToMiddle(one, _penetrations[one], b, out);
                }
            }
            var length:Number = Math.sqrt(wayX * wayX + wayY * wayY + wayZ * wayZ);
            out.setNormal(wayX / length, wayY / length, wayZ / length);
            var depth:Number = Math.max(0, _penetrations[deepest]);
            out.depth = count > 1 && depth > 0 ? length : depth;
        }

        /** @inheritDoc */
        override public function separate(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            // findContactOfParts has put the point to its place
        }

        /** @inheritDoc */
        override protected function findClosestInOrder(a:Body, b:Body, areTouching:Boolean, out:ClosestPoints):void
        {
            var deepest:int = findDeepest(a, b, RelativeMotion.NONE, _penetrations);
            var outwards:Vector3D = OUTWARDS[deepest];
            findFarthest(a, outwards, _farthest);
            var own:Number = along(deepest, _farthest.x, _farthest.y, _farthest.z);
            var toEdge:Number = coordinateOf(b, deepest) - own;
            // corners that count as equally far are not quite, and the point is their mean
            var toEnd:Number = toEdge + _penetrations[deepest];
            out.distance = -_penetrations[deepest];
            if (areTouching)
            {
                // what is beyond the edge is of both
                toEdge = toEnd;
            }
            out.a.x = _farthest.x + toEnd * outwards.x;
            out.a.y = _farthest.y + toEnd * outwards.y;
            out.a.z = _farthest.z + toEnd * outwards.z;
            out.b.x = _farthest.x + toEdge * outwards.x;
            out.b.y = _farthest.y + toEdge * outwards.y;
            out.b.z = _farthest.z + toEdge * outwards.z;
            out.correct(areTouching);
        }

        // Finds how far the body is beyond each edge at the time of a motion. Returns the edge that it is furthest beyond.
        private function findDeepest(a:Body, b:Body, motion:RelativeMotion, penetrations:Vector.<Number>):int
        {
            // for trees, the points at all edges are needed
            findPenetrations(a, b, motion, Infinity, penetrations);
            var deepest:int = 0;
            for (var edge:int = 1; edge < 6; edge++)
            {
                deepest = penetrations[edge] > penetrations[deepest] ? edge : deepest;
            }
            return deepest;
        }

        // The largest gap between a body and an edge that still counts as a touch.
        private static function touchToleranceOf(body:Body):Number
        {
            return body.margin + Tolerances.ROUNDING * body.maxHalf;
        }

        // Finds how far the body is beyond each edge at the time of a motion. A tree's own points are computed only for edges that its extents come to on
        // the motion, within the tolerance.
        private function findPenetrations(body:Body, edges:Body, motion:RelativeMotion, tolerance:Number, out:Vector.<Number>):void
        {
            for (var edge:int = 0; edge < 6; edge++)
            {
                var coordinate:Number = coordinateOf(edges, edge);
                var radius:Number = Math.abs(along(edge, body.halfX, body.halfY, body.halfZ));
                var beyond:Number = radius + (along(edge, body.middleX, body.middleY, body.middleZ) - coordinate);
                var way:Number = along(edge, motion.x, motion.y, motion.z);
                if (body.kind == ModelShape.TREE && (beyond >= -tolerance || beyond - way >= -tolerance))
                {
                    findFarthest(body, OUTWARDS[edge], _farthest);
                    beyond = _farthest.support - coordinate;
                }
                out[edge] = beyond - (1 - motion.time) * way;
            }
        }

        // Finds how far a body reaches in a direction.
        private function findFarthest(body:Body, direction:Vector3D, out:SupportPoint):void
        {
            var tree:ModelTree = body.shape.tree;
            var depth:int = tree == null ? 1 : _limits.depthOf(body);
            _supportSearch.find(tree == null ? null : tree.treeFor(depth), depth, body.shape.structure, body.placement, direction, out);
        }

        // The place of an edge in the direction out of the world.
        private static function coordinateOf(edges:Body, edge:int):Number
        {
            // the first number is 1 or -1: whether the direction is the axis or against it
            return along(edge, 1, 1, 1) * edges.shape.edges[edge];
        }

        // The length of a vector in the direction out of the world.
        private static function along(edge:int, x:Number, y:Number, z:Number):Number
        {
            return x * OUTWARDS[edge].x + y * OUTWARDS[edge].y + z * OUTWARDS[edge].z;
        }

        // The length of the way back from an edge. For edges other than the deepest, it is longer by a tenth of the tolerance of a contact's depth, and
        // at least by more than the gap that still counts as a touch, so that it leads away from each of the edges. For the deepest one it is at least
        // as long as that. A point has no extent; the patch counts in its place.
        private static function lengthOfWayBack(penetration:Number, isDeepest:Boolean, body:Body):Number
        {
            var half:Number = body.maxHalf == 0 ? 1 : body.maxHalf;
            var overshoot:Number = Math.max(Tolerances.SEPARATION / 5 * half, 2 * touchToleranceOf(body));
            var depth:Number = Math.max(0, penetration);
            return isDeepest ? Math.max(depth, overshoot) : depth + overshoot;
        }

        // Moves the point of a contact into the middle of the overlap with an edge. There may be no such edge: then its place is infinite.
        private static function moveToMiddle(edge:int, penetration:Number, edges:Body, out:ContactPoint):void
        {
            var outwards:Vector3D = OUTWARDS[edge];
            var offset:Number = coordinateOf(edges, edge) + penetration / 2 - along(edge, out.x, out.y, out.z);
            if (isFinite(offset))
            {
                out.x += offset * outwards.x;
                out.y += offset * outwards.y;
                out.z += offset * outwards.z;
            }
        }
    }
}
