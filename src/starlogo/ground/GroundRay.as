package starlogo.ground
{
    import starlogo.agents.Agent;
    import starlogo.convex.FaceNormal;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayTriangleTest;

    use namespace engine;

    /**
     * Finds where a ray first meets the ground.
     *
     * @private
     */
    public final class GroundRay
    {
        // Longer than any way between two places of the world.
        private static const FARTHEST:Number = 4 * Agent.LARGEST_COORDINATE;

        private var _box:GroundBox = new GroundBox();
        private var _triangles:GroundTriangles = new GroundTriangles();
        private var _test:RayTriangleTest = new RayTriangleTest();
        private var _outside:FaceNormal = new FaceNormal();

        public function GroundRay()
        {
            _box.way = new RelativeMotion();
        }

        /**
         * Narrows a ray to the part behind its first hit.
         *
         * @param ray in the world; its beginning becomes the hit, with the normal there, which points out of the ground
         * @return whether there is a hit
         */
        public function find(grid:HeightGrid, ray:Ray):Boolean
        {
            if (grid.heightAt(ray.x, ray.y) >= ray.z)
            {
                ray.faceBack();
                return true;
            }
            _box.x = ray.x;
            _box.y = ray.y;
            _box.z = ray.z;
            _box.way.x = ray.directionX;
            _box.way.y = ray.directionY;
            _box.way.z = ray.directionZ;
            _box.limit = FARTHEST;
            _triangles.begin(grid, _box);
            // only now, so that the distance does not depend on where the ray ends
            _box.limit = Math.min(ray.to, FARTHEST);
            var isHit:Boolean = false;
            _test.begin(ray, _triangles.corners, grid.cellWidth);
            while (_triangles.next())
            {
                var before:Number = _test.least;
                _test.look(0, 1);
                if (_test.least < before || _test.triangle == 0 && !isHit)
                {
                    isHit = true;
                    _box.limit = _test.least;
                    _outside.setTriangle(_triangles.corners, 0);
                }
            }
            if (isHit)
            {
                ray.from = _test.least;
                ray.setNormal(_outside.x, _outside.y, _outside.z);
            }
            return isHit;
        }
    }
}
