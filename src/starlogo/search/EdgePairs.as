package starlogo.search
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.terrain.WorldBounds;

    use namespace engine;

    /**
     * Tests whether a row of a table touches the edges of the world, when it touches them, and how.
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
    public final class EdgePairs
    {
        /** The edges. */
        public var bounds:WorldBounds = null;

        /** The time at which the last tested row first touches an edge, from 0 to 1. It is RelativeMotion.NEVER if the row touches none. */
        public var time:Number = RelativeMotion.NEVER;

        private var _pairs:RowPairs;

        // By axis: the middle of the row's extents, half of their lengths, the row's motion, and the way back of a contact. _margin is the
        // largest gap between the row and an edge that still counts as a touch.
        private var _middle:Vector.<Number> = new Vector.<Number>(3, true);
        private var _half:Vector.<Number> = new Vector.<Number>(3, true);
        private var _way:Vector.<Number> = new Vector.<Number>(3, true);
        private var _back:Vector.<Number> = new Vector.<Number>(3, true);
        private var _margin:Number = 0;

        // By edge, in the order of x, y and z, with the least first: how far the row is beyond it at the end of its motion. It is less than
        // 0 if the row is before the edge.
        private var _beyond:Vector.<Number> = new Vector.<Number>(6, true);

        // By axis: the row's farthest point in the direction of the last tested edge.
        private var _point:Vector.<Number> = new Vector.<Number>(3, true);

        // The box that trees are moved against, and how they touch it.
        private var _box:Box = new Box(new Vector3D(), Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, 1, 1, 1);
        private var _shape:ModelShape = new ModelShape("edge", 0, 0);
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _touch:ContactPoint = new ContactPoint();

        /** @param pairs finds when trees touch */
        public function EdgePairs(pairs:RowPairs)
        {
            _pairs = pairs;
            _shape.setStructure(_box);
            _shape.isUpright = _shape.meetsTriangles = true;
        }

        /**
         * Finds when a row first touches an edge, and writes it to <code>time</code>.
         *
         * @param way the row's motion. It ends where the row is now
         */
        public function findTime(table:AgentTable, row:int, way:Vector3D):void
        {
            read(table, row, way);
            time = RelativeMotion.NEVER;
            for (var edge:int = 0; edge < 6; edge++)
            {
                findBeyond(table, row, edge);
                var end:Number = _beyond[edge] + _margin;
                var start:Number = end - comeTo(edge);
                if (start >= 0)
                {
                    time = 0;
                }
                else if (end >= 0)
                {
                    time = Math.min(time, start / (start - end));
                }
            }
        }

        /**
         * Finds how a row touches the edges. Call <code>findTime()</code> for this row first.
         *
         * @param at the time, from 0 to 1
         * @param out takes the contact. Its normal points into the world. If the row touches no edge, it is the contact with the nearest
         *     edge, with a depth of 0
         */
        public function findContact(table:AgentTable, row:int, at:Number, out:ContactPoint):void
        {
            var nearest:int = 0;
            for (var edge:int = 0; edge < 6; edge++)
            {
                _beyond[edge] -= (1 - at) * comeTo(edge);
                nearest = _beyond[edge] > _beyond[nearest] ? edge : nearest;
            }
            var count:int = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                // of two opposite edges, the one with the larger value counts
                edge = _beyond[2 * axis] >= _beyond[2 * axis + 1] ? 2 * axis : 2 * axis + 1;
                var isTouched:Boolean = _beyond[edge] >= -_margin;
                if (isTouched)
                {
                    count++;
                }
                setBack(edge, isTouched || edge == nearest);
            }
            findPoint(table, row, nearest);
            for (axis = 0; axis < 3; axis++)
            {
                placePoint(axis, 1 - at);
            }
            out.setNormal(_back[0], _back[1], _back[2]);
            out.normalise();
            out.depth = count > 1 ? out.length : Math.max(0, _beyond[nearest]);
            out.x = _point[0];
            out.y = _point[1];
            out.z = _point[2];
        }

        private function read(table:AgentTable, row:int, way:Vector3D):void
        {
            var extents:Extents = table.extents;
            _middle[0] = extents.x[row];
            _middle[1] = extents.y[row];
            _middle[2] = extents.z[row];
            _half[0] = extents.halfX[row];
            _half[1] = extents.halfY[row];
            _half[2] = extents.halfZ[row];
            _way[0] = way.x;
            _way[1] = way.y;
            _way[2] = way.z;
            _margin = table.marginOf(row) + Tolerances.ROUNDING * extents.largestHalf(row);
        }

        // How far the row's motion goes towards an edge.
        private function comeTo(edge:int):Number
        {
            return edge % 2 == 0 ? -_way[edge >> 1] : _way[edge >> 1];
        }

        private function findBeyond(table:AgentTable, row:int, edge:int):void
        {
            var at:Number = _middle[edge >> 1];
            var limit:Number = bounds.edges[edge];
            var beyond:Number = _half[edge >> 1];
            if (edge % 2 == 0)
            {
                beyond += limit - at;
            }
            else
            {
                beyond += at - limit;
            }
            _beyond[edge] = beyond;
            if (table.forms[row] == ModelShape.TREE && (beyond >= -_margin || beyond - comeTo(edge) >= -_margin))
            {
                findTouch(table, row, edge);
                _beyond[edge] = beyond - 2 * _half[edge >> 1] * _motion.time;
            }
        }

        // Moves a tree against a box that stands where its extents end.
        private function findTouch(table:AgentTable, row:int, edge:int):void
        {
            var axis:int = edge >> 1;
            var sign:int = edge % 2 == 0 ? -1 : 1;
            var size:Number = 2 * table.extents.largestHalf(row);
            _box.halfX = _box.halfY = _box.halfZ = size;
            _point[0] = _middle[0];
            _point[1] = _middle[1];
            _point[2] = _middle[2];
            _point[axis] += sign * (_half[axis] + size);
            table.readFixture(RowList.EDGE, bounds.agent, _shape, _point);
            _point[0] = _point[1] = _point[2] = 0;
            _point[axis] = sign * 2 * _half[axis];
            _motion.x = _point[0];
            _motion.y = _point[1];
            _motion.z = _point[2];
            _pairs.findImpact(table, row, RowList.EDGE, _motion, _touch);
            if (_motion.time == RelativeMotion.NEVER)
            {
                _motion.time = 0;
            }
        }

        // Sets the way back along an axis. In a corner it is longer by a tenth of the tolerance of a contact's depth, so that it leads away from
        // each of the edges.
        private function setBack(edge:int, isTouched:Boolean):void
        {
            var by:Number = 0;
            if (isTouched)
            {
                // the extents of a tree are larger than its shape
                by = Tolerances.SEPARATION / 5 * Math.max(_half[0], Math.max(_half[1], _half[2]));
                by += Math.max(0, _beyond[edge]);
            }
            _back[edge >> 1] = edge % 2 == 0 ? by : -by;
        }

        // Finds the row's farthest point in the direction of an edge. If several points are equally far, it is the middle of them.
        private function findPoint(table:AgentTable, row:int, edge:int):void
        {
            _point[0] = _middle[0];
            _point[1] = _middle[1];
            _point[2] = _middle[2];
            switch (table.forms[row])
            {
                case ModelShape.TREE:
                    findTouch(table, row, edge);
                    _point[0] = _touch.x - _motion.time * _motion.x;
                    _point[1] = _touch.y - _motion.time * _motion.y;
                    _point[2] = _touch.z - _motion.time * _motion.z;
                    break;
                case BoundingStructure.BOX:
                    var box:Box = Box(table.structureOf(row));
                    pushAlong(box.axisX.x, box.axisX.y, box.axisX.z, box.halfX, edge);
                    pushAlong(box.axisY.x, box.axisY.y, box.axisY.z, box.halfY, edge);
                    pushAlong(box.axisZ.x, box.axisZ.y, box.axisZ.z, box.halfZ, edge);
                    break;
                case BoundingStructure.CAPSULE:
                    var capsule:Capsule = Capsule(table.structureOf(row));
                    pushAlong(capsule.end.x - capsule.start.x, capsule.end.y - capsule.start.y, capsule.end.z - capsule.start.z, 0.5, edge);
                    break;
            }
        }

        // Moves the point towards an edge, by a part of an axis.
        private function pushAlong(x:Number, y:Number, z:Number, part:Number, edge:int):void
        {
            var towards:Number = edge < 2 ? x : (edge < 4 ? y : z);
            if (Math.abs(towards) <= Tolerances.SEPARATION * (Math.abs(x) + Math.abs(y) + Math.abs(z)))
            {
                return;
            }
            if (towards > 0 == (edge % 2 == 0))
            {
                part = -part;
            }
            _point[0] += part * x;
            _point[1] += part * y;
            _point[2] += part * z;
        }

        // Moves the point back along the motion. If the normal leads away from an edge, moves it into the middle of the overlap.
        private function placePoint(axis:int, left:Number):void
        {
            var edge:int = _back[axis] > 0 ? 2 * axis : 2 * axis + 1;
            _point[axis] -= left * _way[axis];
            var by:Number = _beyond[edge] / 2;
            if (_back[axis] != 0 && isFinite(by))
            {
                _point[axis] = edge % 2 == 0 ? bounds.edges[edge] - by : bounds.edges[edge] + by;
            }
        }
    }
}
