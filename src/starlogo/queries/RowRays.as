package starlogo.queries
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.rayStructure;
    import starlogo.search.AgentTable;
    import starlogo.search.ModelShape;
    import starlogo.search.TreePairs;
    import starlogo.solid.SolidRay;
    import starlogo.terrain.HeightGrid;
    import starlogo.terrain.FixtureAgent;

    use namespace engine;

    /**
     * Finds the point where a ray first meets a row of a table, as a collider sees the row.
     *
     * <p>It first moves the ray into the space of the row's model. There the structure, the tree and the triangles are as they were fitted,
     * and rounding errors depend on the model's size, not on its place. The ray is given there by the point of its line that is nearest to
     * the row's place. This is the same for all systems. So if a ray meets a model's triangles, it meets the structures around them at the
     * same distance or earlier.</p>
     *
     * <p>A ray is a line without thickness. So the margin by which shapes are widened for touching (Tolerances.PLACES) is not added.</p>
     *
     * @private
     */
    public final class RowRays
    {
        /** The distance from the ray's origin to the last row that it met, in patches. It is 0 if the origin is inside. */
        public var distance:Number = 0;

        /** The normal at that point: a unit vector, against the ray. */
        public var normalX:Number = 0;

        /** @copy #normalX */
        public var normalY:Number = 0;

        /** @copy #normalX */
        public var normalZ:Number = 0;

        /**
         * The number of the triangle that the ray meets, as the model counts them. It is -1 if no triangle decides, or if the ray's origin is
         * inside.
         */
        public var triangle:int = -1;

        /** How far the ray goes, in patches. A row at exactly this distance is met. You may make it smaller between rows. */
        public var limit:Number = Infinity;

        /** The ray's origin and direction, in the world. */
        public var ray:Ray = new Ray();

        private var _table:AgentTable;
        private var _trees:TreePairs;
        private var _line:Ray = new Ray();
        private var _inModel:Ray = new Ray();
        private var _solid:SolidRay = new SolidRay();
        private var _placement:Placement = new Placement();

        /** Begins without a ray. */
        public function RowRays()
        {
        }

        /**
         * Begins with the rows of a table. Set ray and limit first.
         *
         * @param table has the rows
         * @param trees knows how deep trees are visited
         * @throws RangeError if the limit is negative or not a number
         */
        public function begin(table:AgentTable, trees:TreePairs):void
        {
            if (!(limit >= 0))
            {
                throw new RangeError("maxDistance must not be negative: " + limit);
            }
            _table = table;
            _trees = trees;
        }

        /** Whether the ray meets a row within the limit. If it does, distance and normal are set. */
        public function meets(row:int):Boolean
        {
            var shape:ModelShape = _table.shapes[row];
            if (shape == null)
            {
                return false;
            }
            if (shape.form == ModelShape.GROUND)
            {
                var ground:FixtureAgent = FixtureAgent(_table.agents[row]);
                return meetsGround(ground.terrain.grid);
            }
            var placement:Placement = _table.placementOf(row, _placement);
            var line:Ray = _line;
            var toX:Number = placement.x - ray.x;
            var toY:Number = placement.y - ray.y;
            var toZ:Number = placement.z - ray.z;
            line.directionX = ray.directionX;
            line.directionY = ray.directionY;
            line.directionZ = ray.directionZ;
            var ahead:Number = toX * line.directionX + toY * line.directionY + toZ * line.directionZ;
            line.x = ahead * line.directionX - toX;
            line.y = ahead * line.directionY - toY;
            line.z = ahead * line.directionZ - toZ;
            var found:Ray = _inModel;
            var size:Number = placement.size;
            found.bringInto(placement, line);
            var start:Number = -ahead / size;
            found.from = start;
            // this limit is too large by rounding errors; rows beyond the exact limit are left out below
            found.to = (limit - ahead + Tolerances.ROUNDING * (limit + Math.abs(ahead))) / size;
            found.faceBack();
            if (!found.isFinite || !meetsShape(row, shape, found))
            {
                return false;
            }
            distance = found.from > start ? Math.max(0, found.from * size + ahead) : 0;
            if (distance > limit)
            {
                return false;
            }
            normalX = placement.r00 * found.normalX + placement.r01 * found.normalY + placement.r02 * found.normalZ;
            normalY = placement.r10 * found.normalX + placement.r11 * found.normalY + placement.r12 * found.normalZ;
            normalZ = placement.r20 * found.normalX + placement.r21 * found.normalY + placement.r22 * found.normalZ;
            return true;
        }

        private function meetsGround(grid:HeightGrid):Boolean
        {
            ray.from = 0;
            ray.to = limit;
            if (!grid.rays.find(grid, ray))
            {
                return false;
            }
            distance = ray.from;
            normalX = ray.normalX;
            normalY = ray.normalY;
            normalZ = ray.normalZ;
            triangle = -1;
            return true;
        }

        private function meetsShape(row:int, shape:ModelShape, found:Ray):Boolean
        {
            triangle = -1;
            if (shape.hierarchy != null)
            {
                var isMet:Boolean = _solid.find(shape.hierarchy, _trees.depthOf(_table, row), _trees.exact, found);
                triangle = _solid.triangle;
                return isMet;
            }
            return rayStructure(found, shape.structure);
        }
    }
}
