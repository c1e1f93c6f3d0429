package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.solid.SupportPoint;

    /**
     * Finds the point of a model that is deepest in the ground, without a look at pieces and triangles: it follows the normals of the ground. The point of the
     * model that is farthest against a normal leaves the ground along that normal. If the plane of the normal is not the ground's surface at the exit, the
     * search goes on with the normal there.
     *
     * <p>On most ground this is the contact that separates the two. But another point may be deeper behind another triangle, so callers test it.</p>
     */
    internal final class DeepestPointSearch
    {
        // How many normals are tried.
        private static const MAX_STEPS:int = 3;

        private var _under:GroundPoint = new GroundPoint();
        private var _normal:Vector3D = new Vector3D();
        private var _inwards:Vector3D = new Vector3D();
        private var _deepest:SupportPoint = new SupportPoint();
        private var _contact:ContactPoint = new ContactPoint();

        /**
         * Finds the contact of the deepest point.
         *
         * @param model where it stands
         * @param grid the ground
         * @param origin the place that the model is relative to
         * @param out receives the contact, in the world. Its depth is negative if all of the model is in front of the plane
         * @return whether the exit is on the ground's surface
         */
        public function find(model:ModelPiece, grid:HeightGrid, origin:Placement, out:ContactPoint):Boolean
        {
            var tolerance:Number = Tolerances.SEPARATION * grid.cellWidth;
            _under.x = origin.x;
            _under.y = origin.y;
            grid.findHeight(_under);
            // NaN where no ground is
            for (var step:int = 0; step < MAX_STEPS && _under.height == _under.height; step++)
            {
                var normal:Vector3D = _normal;
                grid.findNormal(_under, normal);
                var offset:Number = normal.x * (_under.x - origin.x) + normal.y * (_under.y - origin.y) + normal.z * (_under.height - origin.z);
                _inwards.setTo(-normal.x, -normal.y, -normal.z);
                model.findFarthest(_inwards, _deepest);
                var depth:Number = offset - (normal.x * _deepest.x + normal.y * _deepest.y + normal.z * _deepest.z);
                _under.x = _deepest.x + depth * normal.x + origin.x;
                _under.y = _deepest.y + depth * normal.y + origin.y;
                grid.findHeight(_under);
                if (Math.abs(_deepest.z + depth * normal.z + origin.z - _under.height) <= tolerance)
                {
                    out.setNormal(normal.x, normal.y, normal.z);
                    out.depth = depth;
                    out.x = _deepest.x + depth / 2 * normal.x + origin.x;
                    out.y = _deepest.y + depth / 2 * normal.y + origin.y;
                    out.z = _deepest.z + depth / 2 * normal.z + origin.z;
                    out.forget();
                    out.isDeepestOfA = true;
                    return true;
                }
            }
            return false;
        }

        /** Whether the deepest point is under the ground: a quick test, which shows it of most models that are in the ground. */
        public function isPointUnder(model:ModelPiece, grid:HeightGrid, origin:Placement):Boolean
        {
            if (!find(model, grid, origin, _contact))
            {
                return false;
            }
            _under.x = _deepest.x + origin.x;
            _under.y = _deepest.y + origin.y;
            grid.findHeight(_under);
            return _under.height >= _deepest.z + origin.z;
        }
    }
}
