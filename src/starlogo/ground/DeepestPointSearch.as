package starlogo.ground
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    /**
     * Finds the point of a model that is deepest in the ground, without a look at pieces and triangles: it follows the normals of the ground. The point of the
     * model that is farthest against a normal leaves the ground along that normal. If the plane of the normal is not the ground's surface at the exit, the
     * search goes on with the normal there. If it goes to and fro between two planes, these are the sides of a valley, or a ridge (RidgeExitSearch).
     *
     * <p>Another point may be deeper behind another triangle.</p>
     */
    internal final class DeepestPointSearch
    {
        // How many normals are tried.
        private static const MAX_STEPS:int = 4;

        private static const NONE:Vector3D = new Vector3D();

        private var _ridges:RidgeExitSearch = new RidgeExitSearch();

        // The place on the surface where the search is, and how far the end of the last exit is above it.
        private var _at:GroundPoint = new GroundPoint();
        private var _above:Number = 0;

        // The planes of the last two steps.
        private var _last:GroundPlane = new GroundPlane();
        private var _lastButOne:GroundPlane = new GroundPlane();

        // The plane of a quick test.
        private var _tried:GroundPlane = new GroundPlane();

        /** Sets a plane to the surface under the middle of a model's box. Returns false if no ground is there. */
        public function beginUnder(model:ModelPiece, search:GroundSearch, out:GroundPlane):Boolean
        {
            _at.x = model.box.x + search.origin.x;
            _at.y = model.box.y + search.origin.y;
            search.grid.findHeight(_at);
            setPlane(search, out);
            return !isNaN(_at.height);
        }

        /**
         * Finds the plane of the exit of the deepest point, and adds it. If the point has to get out of both sides of a valley, adds both. Adds none if the
         * search does not come to the ground's surface.
         *
         * @param model where it stands
         * @param planes say how far it is displaced. The next one is set: the search begins with it
         */
        public function addExit(model:ModelPiece, search:GroundSearch, planes:GroundPlanes):void
        {
            var plane:GroundPlane = planes.next;
            var by:Vector3D = planes.displacement;
            for (var step:int = 0; step < MAX_STEPS; step++)
            {
                if (step > 1 && plane.normal.x == _lastButOne.normal.x && plane.normal.y == _lastButOne.normal.y)
                {
                    break;
                }
                plane.findPoint(model);
                goToEnd(search, plane, by);
                if (isAtEnd(search))
                {
                    planes.add();
                    return;
                }
                if (isNaN(_at.height))
                {
                    return;
                }
                _lastButOne.copyFrom(_last);
                _last.copyFrom(plane);
                setPlane(search, plane);
            }
            if (_above < 0)
            {
                plane.copyFrom(_last);
                planes.add();
                planes.next.copyFrom(_lastButOne);
                planes.add();
            }
            // between two points of a tree's triangles there is mostly nothing
            else if (!model.areTriangles && _ridges.find(model, _lastButOne, _last, plane))
            {
                goToEnd(search, plane, by);
                if (isAtEnd(search))
                {
                    planes.add();
                }
            }
        }

        /** Whether a point that is deepest behind a plane is under the ground: a quick test, which shows it of most models that are in the ground. */
        public function isPointUnder(model:ModelPiece, search:GroundSearch):Boolean
        {
            model.findWholeBox();
            // most models whose lowest height is not in the ground under their middle are not in the ground
            if (!beginUnder(model, search, _tried) || model.box.z - model.box.halfZ > _at.height - search.origin.z)
            {
                return false;
            }
            for (var step:int = 0; step < MAX_STEPS; step++)
            {
                _tried.findPoint(model);
                if (_tried.depthUnderGround(search, NONE) >= 0)
                {
                    return true;
                }
                goToEnd(search, _tried, NONE);
                if (isNaN(_at.height) || isAtEnd(search))
                {
                    return false;
                }
                setPlane(search, _tried);
            }
            return false;
        }

        // Sets a plane to the surface at the place where the search is.
        private function setPlane(search:GroundSearch, plane:GroundPlane):void
        {
            var origin:Placement = search.origin;
            var normal:Vector3D = plane.normal;
            search.grid.findNormal(_at, normal);
            plane.offset = normal.x * (_at.x - origin.x) + normal.y * (_at.y - origin.y) + normal.z * (_at.height - origin.z);
        }

        // Goes to the surface at the end of the displaced exit of a plane's point.
        private function goToEnd(search:GroundSearch, plane:GroundPlane, by:Vector3D):void
        {
            var normal:Vector3D = plane.normal;
            var x:Number = plane.point.x + by.x;
            var y:Number = plane.point.y + by.y;
            var z:Number = plane.point.z + by.z;
            // not the depth, because the point may be the mean of some that are as deep up to rounding
            var length:Number = plane.offset - (normal.x * x + normal.y * y + normal.z * z);
            _at.x = x + length * normal.x + search.origin.x;
            _at.y = y + length * normal.y + search.origin.y;
            search.grid.findHeight(_at);
            _above = z + length * normal.z + search.origin.z - _at.height;
        }

        // Whether the end of the last exit is on the surface.
        private function isAtEnd(search:GroundSearch):Boolean
        {
            return Math.abs(_above) <= Tolerances.SEPARATION * search.grid.cellWidth;
        }
    }
}
