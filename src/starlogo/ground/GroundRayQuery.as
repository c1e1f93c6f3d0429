package starlogo.ground
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.ShearedRay;

    use namespace engine;

    /**
     * Finds where a ray first meets the ground, or all places where it does.
     *
     * @private
     */
    public final class GroundRayQuery
    {
        // Longer than the distance of any two places of the world.
        private static const FARTHEST:Number = 4 * Placement.LARGEST_COORDINATE;

        private var _search:GroundSearch = new GroundSearch();
        private var _triangles:GroundTriangles = new GroundTriangles();
        private var _triangle:GroundTriangle = new GroundTriangle();
        private var _sheared:ShearedRay = new ShearedRay();

        // An upper bound of the radius of a triangle between the least and the greatest height.
        private var _largestRadius:Number = 0;

        /**
         * Finds where a ray first meets the ground.
         *
         * @param ray in the world
         * @param out receives the distance and the normal
         * @return whether it meets the ground
         */
        public function find(grid:HeightGrid, ray:Ray, out:RayCrossing):Boolean
        {
            out.setToStart(ray);
            if (beginsInside(grid, ray))
            {
                return true;
            }
            begin(grid, ray);
            while (nextTriangle())
            {
                if (_sheared.findEarlier(_triangle.corners, 0, 3, 6))
                {
                    _search.motion.latestTime = _sheared.first.distance;
                    _sheared.writeFirst(_triangle.corners, -1, out);
                }
            }
            return _sheared.first.distance < Infinity;
        }

        /**
         * Adds all crossings of a ray with the ground. A ray that begins in it crosses it where it begins, and where it comes out.
         *
         * @param ray in the world
         * @param out the crossings are added to it
         */
        public function findAll(grid:HeightGrid, ray:Ray, out:RayCrossings):void
        {
            if (beginsInside(grid, ray))
            {
                out.addInside(ray);
            }
            begin(grid, ray);
            while (nextTriangle())
            {
                _sheared.addCrossing(_triangle.corners, -1, out);
            }
        }

        // Goes on to the next triangle. Returns false if there is none. The rounding error is relative to the triangle's size. Walls that are far longer
        // than the ground is high are only long because the ray is.
        private function nextTriangle():Boolean
        {
            if (!_triangles.next(_triangle))
            {
                return false;
            }
            _sheared.setRadius(Math.min(_triangle.radius, _largestRadius));
            return true;
        }

        private static function beginsInside(grid:HeightGrid, ray:Ray):Boolean
        {
            return grid.heightAt(ray.origin.x + ray.from * ray.direction.x, ray.origin.y + ray.from * ray.direction.y) >= ray.origin.z + ray.from * ray.direction.z;
        }

        // Begins to visit the triangles near a ray.
        private function begin(grid:HeightGrid, ray:Ray):void
        {
            _search.box.x = ray.origin.x;
            _search.box.y = ray.origin.y;
            _search.box.z = ray.origin.z;
            _search.motion.x = ray.direction.x;
            _search.motion.y = ray.direction.y;
            _search.motion.z = ray.direction.z;
            _search.motion.latestTime = endOf(grid, ray);
            _search.grid = grid;
            _triangles.begin(_search);
            // only now, so that no corner depends on where the ray ends: tall walls are cut at the heights of the whole search
            _search.motion.latestTime = Math.min(ray.to, _search.motion.latestTime);
            var whole:HeightBounds = grid.pyramid.whole;
            // the cell's width, and twice as much because walls are cut a cell's width above and below
            _largestRadius = 3 * grid.cellWidth + whole.max - whole.min;
            _sheared.setTo(ray, _largestRadius);
        }

        // A distance at which a ray is beyond all of the ground: it leaves the grid along x or y. An upright ray leaves the heights.
        private static function endOf(grid:HeightGrid, ray:Ray):Number
        {
            if (ray.direction.x == 0 && ray.direction.y == 0)
            {
                return Math.abs(ray.origin.z) + Math.max(Math.abs(grid.pyramid.whole.min), Math.abs(grid.pyramid.whole.max));
            }
            var endX:Number = (Math.abs(ray.origin.x - grid.x) + grid.columns * grid.cellWidth) / Math.abs(ray.direction.x);
            var endY:Number = (Math.abs(ray.origin.y - grid.y) + grid.rows * grid.cellWidth) / Math.abs(ray.direction.y);
            return Math.min(FARTHEST, Math.min(endX, endY));
        }
    }
}
