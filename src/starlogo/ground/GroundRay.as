package starlogo.ground
{
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
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

        private var _faces:GroundTriangles = new GroundTriangles();
        private var _triangles:RayTriangleTest = new RayTriangleTest();
        private var _outside:ContactPoint = new ContactPoint();

        public function GroundRay()
        {
            _faces.way = new RelativeMotion();
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
            _faces.middle.setTo(ray.x, ray.y, ray.z);
            _faces.half.setTo(0, 0, 0);
            _faces.way.x = ray.directionX;
            _faces.way.y = ray.directionY;
            _faces.way.z = ray.directionZ;
            _faces.limit = FARTHEST;
            _faces.grid = grid;
            _faces.begin();
            // only now, so that the distance does not depend on where the ray ends
            _faces.limit = Math.min(ray.to, FARTHEST);
            var isHit:Boolean = false;
            _triangles.begin(ray, _faces.corners, grid.cellWidth);
            while (_faces.next())
            {
                var before:Number = _triangles.least;
                _triangles.look(0, 1);
                if (_triangles.least < before || _triangles.triangle == 0 && !isHit)
                {
                    isHit = true;
                    _faces.limit = _triangles.least;
                    _outside.setTriangleNormal(_faces.corners, 0);
                }
            }
            if (isHit)
            {
                ray.from = _triangles.least;
                ray.setNormal(_outside.normalX, _outside.normalY, _outside.normalZ);
            }
            return isHit;
        }
    }
}
