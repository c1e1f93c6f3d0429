package starlogo.terrain
{
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.TriangleRay;

    use namespace engine;

    /**
     * Finds where a ray first meets the ground.
     *
     * @private
     */
    public final class GroundRay
    {
        private var _faces:GroundFaces = new GroundFaces();
        private var _triangles:TriangleRay = new TriangleRay();
        private var _outside:ContactPoint = new ContactPoint();

        /** Creates a finder that has found nothing yet. */
        public function GroundRay()
        {
        }

        /**
         * Narrows a ray to the part behind its first hit.
         *
         * @param ray in the world; its beginning becomes the hit, with the normal there, which points out of the ground
         * @return whether there is a hit
         */
        public function find(grid:HeightGrid, ray:Ray):Boolean
        {
            grid.placeX = ray.x;
            grid.placeY = ray.y;
            grid.findHeight();
            if (grid.height >= ray.z)
            {
                ray.faceBack();
                return true;
            }
            if (!beginOver(grid, ray))
            {
                return false;
            }
            var isHit:Boolean = false;
            _triangles.begin(ray, grid.cellWidth);
            while (_faces.next())
            {
                var before:Number = _triangles.at;
                _triangles.look(_faces.corners, 0, 1);
                if (_triangles.at < before || _triangles.triangle == 0 && !isHit)
                {
                    isHit = true;
                    _faces.box.limit = _triangles.at;
                    GroundFaces.findOutside(_faces.corners, _outside);
                }
            }
            if (isHit)
            {
                ray.from = _triangles.at;
                ray.normalX = _outside.normalX;
                ray.normalY = _outside.normalY;
                ray.normalZ = _outside.normalZ;
                ray.turnNormal();
            }
            return isHit;
        }

        // Begins with the part of the ray that is over the terrain. Returns false if there is none.
        private function beginOver(grid:HeightGrid, ray:Ray):Boolean
        {
            var box:PassingBox = _faces.box;
            var middle:Number = grid.isBlocky ? grid.cellWidth / 2 : 0;
            var highest:Number = 2 * Agent.LARGEST_COORDINATE;
            box.x = ray.x;
            box.y = ray.y;
            box.z = ray.z;
            box.halfX = box.halfY = box.halfZ = 0;
            box.wayX = ray.directionX;
            box.wayY = ray.directionY;
            box.wayZ = ray.directionZ;
            box.from = 0;
            box.to = ray.to;
            box.cut(box.x, grid.cellWidth, box.wayX, grid.x - middle, grid.x + (grid.columns - 1) * grid.cellWidth + middle);
            box.cut(box.y, grid.cellWidth, box.wayY, grid.y - middle, grid.y + (grid.rows - 1) * grid.cellWidth + middle);
            box.cut(box.z, 0, box.wayZ, -highest, grid.greatest);
            box.limit = box.to;
            var isOver:Boolean = box.from <= box.to;
            if (isOver)
            {
                _faces.begin(grid);
            }
            return isOver;
        }
    }
}
