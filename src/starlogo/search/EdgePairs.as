package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.Box;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.distance.ClosestPair;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.terrain.EdgesAgent;

    use namespace engine;

    /**
     * Tests whether a row touches the edges of the world, when it touches them, and how. The edges are the second row of each pair. Motions
     * end where the first row is.
     *
     * <p>An edge is a plane, so a row touches it if the farthest point of its shape does. Spheres, capsules and boxes reach to the ends of
     * their extents. A tree may reach less far. To find out how much less, it is moved against a box that stands at the end of its
     * extents.</p>
     *
     * <p>A row that touches several edges has one contact. Its depth is the length of the shortest way back from all of them. Its normal is
     * the direction of that way.</p>
     *
     * @private
     */
    public final class EdgePairs extends PairTests
    {
        private var _pairs:RowPairs;

        // By axis: the middle of the row's extents, half of their lengths, the row's motion, the way back of a contact, and the contact's point.
        // _largest is the largest half, and _margin the largest gap between the row and an edge that still counts as a touch.
        private var _middle:Vector.<Number> = new Vector.<Number>(3, true);
        private var _half:Vector.<Number> = new Vector.<Number>(3, true);
        private var _way:Vector.<Number> = new Vector.<Number>(3, true);
        private var _back:Vector.<Number> = new Vector.<Number>(3, true);
        private var _point:Vector.<Number> = new Vector.<Number>(3, true);
        private var _largest:Number = 0;
        private var _margin:Number = 0;

        // By edge: its place, and how far the row is beyond it, less than 0 if the row is before it. _nearest is the edge of the last contact.
        private var _edges:Vector.<Number>;
        private var _beyond:Vector.<Number> = new Vector.<Number>(6, true);
        private var _nearest:int = 0;

        // The box that rows are moved against, and how they touch it.
        private var _agent:Agent = new Agent("box");
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
        private var _shape:ModelShape = new ModelShape("box", Agent.ANY_KIND, 0);
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _touch:ContactPoint = new ContactPoint();

        /** @param pairs finds how rows touch a box */
        public function EdgePairs(pairs:RowPairs)
        {
            _pairs = pairs;
            _agent.giveIdBack();
            _shape.setStructure(_box);
            _shape.isUpright = _shape.meetsTriangles = true;
        }

        /** @inheritDoc */
        override public function areTouching(table:AgentTable, a:int, b:int):Boolean
        {
            read(table, a, b, RelativeMotion.NONE);
            for (var edge:int = 0; edge < 6; edge++)
            {
                if (_beyond[edge] >= -_margin)
                {
                    return true;
                }
            }
            return false;
        }

        /** @inheritDoc */
        override public function findTime(table:AgentTable, a:int, b:int, motion:RelativeMotion):void
        {
            read(table, a, b, motion);
            motion.time = RelativeMotion.NEVER;
            for (var edge:int = 0; edge < 6; edge++)
            {
                var end:Number = _beyond[edge] + _margin;
                var start:Number = end - signOf(edge) * _way[edge >> 1];
                if (start >= 0)
                {
                    motion.time = 0;
                }
                else if (end >= 0)
                {
                    motion.time = Math.min(motion.time, start / (start - end));
                }
            }
        }

        /**
         * @inheritDoc
         *
         * <p>If the row touches no edge, it is the contact with the nearest edge, with a depth of 0.</p>
         */
        override public function findContact(table:AgentTable, a:int, b:int, motion:RelativeMotion, out:ContactPoint):void
        {
            read(table, a, b, motion);
            var left:Number = 1 - motion.time;
            _nearest = 0;
            for (var edge:int = 0; edge < 6; edge++)
            {
                _beyond[edge] -= left * signOf(edge) * _way[edge >> 1];
                _nearest = _beyond[edge] > _beyond[_nearest] ? edge : _nearest;
            }
            findFarthest(table, a, _nearest);
            var touched:int = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                // of two opposite edges, the one with the larger value counts
                edge = _beyond[2 * axis] >= _beyond[2 * axis + 1] ? 2 * axis : 2 * axis + 1;
                var isTouched:Boolean = _beyond[edge] >= -_margin;
                if (isTouched)
                {
                    touched++;
                }
                _point[axis] -= left * _way[axis];
                _back[axis] = 0;
                if (isTouched || edge == _nearest)
                {
                    leadBack(edge);
                }
            }
            out.setNormal(_back[0], _back[1], _back[2]);
            out.normalise();
            out.depth = touched > 1 ? out.length : Math.max(0, _beyond[_nearest]);
            out.x = _point[0];
            out.y = _point[1];
            out.z = _point[2];
        }

        /** @inheritDoc */
        override public function findClosest(table:AgentTable, a:int, b:int, areTouching:Boolean, out:ClosestPair):void
        {
            findOuterContact(table, a, b, _touch);
            var gap:Number = areTouching ? 0 : -_beyond[_nearest];
            out.aX = _touch.x + gap / 2 * _touch.normalX;
            out.aY = _touch.y + gap / 2 * _touch.normalY;
            out.aZ = _touch.z + gap / 2 * _touch.normalZ;
            out.bX = _touch.x - gap / 2 * _touch.normalX;
            out.bY = _touch.y - gap / 2 * _touch.normalY;
            out.bZ = _touch.z - gap / 2 * _touch.normalZ;
            out.distance = gap;
            out.settle(areTouching);
        }

        private function read(table:AgentTable, row:int, edges:int, motion:RelativeMotion):void
        {
            var extents:Extents = table.extents;
            _edges = EdgesAgent(table.agents[edges]).edges;
            _middle[0] = extents.x[row];
            _middle[1] = extents.y[row];
            _middle[2] = extents.z[row];
            _half[0] = extents.halfX[row];
            _half[1] = extents.halfY[row];
            _half[2] = extents.halfZ[row];
            _way[0] = motion.x;
            _way[1] = motion.y;
            _way[2] = motion.z;
            _largest = Math.max(_half[0], Math.max(_half[1], _half[2]));
            _margin = table.marginOf(row) + Tolerances.ROUNDING * _largest;
            var isTree:Boolean = table.forms[row] == ModelShape.TREE;
            for (var edge:int = 0; edge < 6; edge++)
            {
                var axis:int = edge >> 1;
                var beyond:Number = _half[axis] + signOf(edge) * (_middle[axis] - _edges[edge]);
                _beyond[edge] = beyond;
                if (isTree && (beyond >= -_margin || beyond - signOf(edge) * _way[axis] >= -_margin))
                {
                    findFarthest(table, row, edge);
                    _beyond[edge] = beyond - 2 * _half[axis] * _motion.time;
                }
            }
        }

        // The direction of an edge along its axis.
        private static function signOf(edge:int):int
        {
            return edge % 2 == 0 ? -1 : 1;
        }

        // Finds the row's farthest point in the direction of an edge, or the middle of several such points. It moves the row against a box that
        // stands where the row's extents end. The time of this motion tells how much less far the row reaches.
        private function findFarthest(table:AgentTable, row:int, edge:int):void
        {
            var axis:int = edge >> 1;
            var size:Number = 2 * _largest;
            _box.halfX = _box.halfY = _box.halfZ = size;
            _point[0] = _middle[0];
            _point[1] = _middle[1];
            _point[2] = _middle[2];
            _point[axis] += signOf(edge) * (_half[axis] + size);
            table.readShape(RowList.BOX, _agent, _shape, _point);
            _point[0] = _point[1] = _point[2] = 0;
            _point[axis] = signOf(edge) * 2 * _half[axis];
            _motion.x = _point[0];
            _motion.y = _point[1];
            _motion.z = _point[2];
            _pairs.findImpact(table, row, RowList.BOX, _motion, _touch);
            if (_motion.time == RelativeMotion.NEVER)
            {
                _motion.time = 0;
                _pairs.findContact(table, row, RowList.BOX, _motion, _touch);
            }
            _point[0] = _touch.x - _motion.time * _motion.x;
            _point[1] = _touch.y - _motion.time * _motion.y;
            _point[2] = _touch.z - _motion.time * _motion.z;
        }

        // Sets the way back from an edge, and moves the point into the middle of the overlap. In a corner the way is longer by a tenth of the
        // tolerance of a contact's depth, so that it leads away from each of the edges.
        private function leadBack(edge:int):void
        {
            var axis:int = edge >> 1;
            var beyond:Number = _beyond[edge];
            if (isFinite(beyond))
            {
                _point[axis] = _edges[edge] + signOf(edge) * beyond / 2;
            }
            // the extents of a tree are larger than its shape
            _back[axis] = -signOf(edge) * (Tolerances.SEPARATION / 5 * _largest + Math.max(0, beyond));
        }
    }
}
