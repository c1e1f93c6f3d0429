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

        // The exits of the last two steps.
        private var _last:GroundExit = new GroundExit();
        private var _lastButOne:GroundExit = new GroundExit();

        // The exit of a quick test.
        private var _exit:GroundExit = new GroundExit();

        /** Sets the plane of an exit to the surface under the middle of a model's box. Returns false if no ground is there. */
        public function beginUnder(model:ModelPiece, search:GroundSearch, exit:GroundExit):Boolean
        {
            _at.x = model.box.x + search.origin.x;
            _at.y = model.box.y + search.origin.y;
            search.grid.findHeight(_at);
            setPlane(search, exit);
            return !isNaN(_at.height);
        }

        /**
         * Finds the exit of the deepest point.
         *
         * @param model where it stands
         * @param by how far it is displaced
         * @param out the one at the index has the plane to begin with. It receives the exit, and if the point has to get out of both sides of a valley, the next
         *     one receives the other
         * @return how many exits there are: 1 ends on the ground's surface, 2 are of a valley; 0 if none is found
         */
        public function find(model:ModelPiece, search:GroundSearch, by:Vector3D, out:Vector.<GroundExit>, index:int):int
        {
            var exit:GroundExit = out[index];
            for (var step:int = 0; step < MAX_STEPS; step++)
            {
                if (step > 1 && exit.normal.x == _lastButOne.normal.x && exit.normal.y == _lastButOne.normal.y)
                {
                    break;
                }
                exit.findPoint(model);
                goToEnd(search, exit, by);
                if (isAtEnd(search))
                {
                    return 1;
                }
                if (isNaN(_at.height))
                {
                    return 0;
                }
                _lastButOne.copyFrom(_last);
                _last.copyFrom(exit);
                setPlane(search, exit);
            }
            if (_above < 0)
            {
                exit.copyFrom(_last);
                out[index + 1].copyFrom(_lastButOne);
                return 2;
            }
            // between two points of a tree's triangles there is mostly nothing
            if (model.areTriangles || !_ridges.find(model, _lastButOne, _last, exit))
            {
                return 0;
            }
            goToEnd(search, exit, by);
            return isAtEnd(search) ? 1 : 0;
        }

        /** Whether a point that is deepest behind a plane is under the ground: a quick test, which shows it of most models that are in the ground. */
        public function isPointUnder(model:ModelPiece, search:GroundSearch):Boolean
        {
            model.findWholeBox();
            // most models whose lowest height is not in the ground under their middle are not in the ground
            if (!beginUnder(model, search, _exit) || model.box.z - model.box.halfZ > _at.height - search.origin.z)
            {
                return false;
            }
            for (var step:int = 0; step < MAX_STEPS; step++)
            {
                _exit.findPoint(model);
                if (_exit.heightOver(search, NONE) >= 0)
                {
                    return true;
                }
                goToEnd(search, _exit, NONE);
                if (isNaN(_at.height) || isAtEnd(search))
                {
                    return false;
                }
                setPlane(search, _exit);
            }
            return false;
        }

        // Sets the plane of an exit to the surface at the place where the search is.
        private function setPlane(search:GroundSearch, exit:GroundExit):void
        {
            var origin:Placement = search.origin;
            var normal:Vector3D = exit.normal;
            search.grid.findNormal(_at, normal);
            exit.offset = normal.x * (_at.x - origin.x) + normal.y * (_at.y - origin.y) + normal.z * (_at.height - origin.z);
        }

        // Goes to the surface at the end of a displaced exit.
        private function goToEnd(search:GroundSearch, exit:GroundExit, by:Vector3D):void
        {
            var normal:Vector3D = exit.normal;
            var x:Number = exit.point.x + by.x;
            var y:Number = exit.point.y + by.y;
            var z:Number = exit.point.z + by.z;
            // not the depth, because the point may be the mean of some that are as deep up to rounding
            var length:Number = exit.offset - (normal.x * x + normal.y * y + normal.z * z);
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
