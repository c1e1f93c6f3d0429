package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.rays.RowRayTest;
    import starlogo.search.Body;

    /**
     * Finds the floor of an agent that walks, and lets the agent stand on it. A floor is a surface that is not too steep. At an edge, such as that of
     * a step, the face behind the edge decides.
     *
     * @private
     */
    public final class FloorFinder
    {
        // At an edge, the face this far behind the edge is tested. A part of the extent.
        private static const BEHIND_EDGE:Number = 1e-4;

        private var _rowRays:RowRayTest;
        private var _slider:Slider;

        // The ray straight down behind an edge, and what it meets.
        private var _ray:Ray = new Ray();
        private var _entry:RayCrossing = new RayCrossing();

        /**
         * @param seen has the rows
         * @param slider moves the agent
         */
        public function FloorFinder(seen:SeenAgents, slider:Slider)
        {
            _slider = slider;
            _rowRays = new RowRayTest(seen);
            _ray.aim(new Vector3D(), new Vector3D(0, 0, -1));
        }

        /**
         * Lets the agent stand on the ground below a place, if the ground is near enough and not too steep. Otherwise the agent stays where it is.
         *
         * @param deeper how much deeper than the walk's floor distance the ground may be
         * @return whether it stands
         */
        public function tryStandBelow(walk:WalkState, place:Vector3D, deeper:Number = 0):Boolean
        {
            return tryStandAtEnd(walk, _slider.moveVertically(walk.body, place, -(deeper + walk.maxFloorDistance)));
        }

        /**
         * Lets the agent stand where a way down has ended, on what has stopped it or on what else it touches there. Otherwise the agent stays where it is.
         * Returns whether it stands.
         */
        public function tryStandAtEnd(walk:WalkState, down:MotionResult):Boolean
        {
            if (!down.hasContact)
            {
                return false;
            }
            if (tryStandOn(walk, down, down.place))
            {
                return true;
            }
            var slid:MotionResult = _slider.slideDown(walk.body, down.place, walk.maxFloorDistance, walk.minFloorNormalZ, walk.body.extent);
            return slid.hasContact && tryStandOn(walk, slid, down.place);
        }

        /**
         * Lets the agent stand at a place, on the row that a motion has met there, if the row carries it. Returns whether it does.
         */
        public function tryStandOn(walk:WalkState, met:MotionResult, place:Vector3D):Boolean
        {
            var contact:ContactPoint = met.contact;
            if (contact.normalZ >= walk.minFloorNormalZ)
            {
                walk.floorNormal.setTo(contact.normalX, contact.normalY, contact.normalZ);
            }
            else if (isTooHigh(walk, contact, place) || !findFaceBehind(walk, contact, met.row, walk.floorNormal))
            {
                return false;
            }
            walk.place.copyFrom(place);
            walk.floorRow = met.row;
            return true;
        }

        // Whether an edge is more than a step above the lowest point of the agent, where the substep began or at its place.
        private static function isTooHigh(walk:WalkState, contact:ContactPoint, place:Vector3D):Boolean
        {
            var body:Body = walk.body.fullBody;
            var bottom:Number = body.middleZ - body.halfZ - body.placement.z;
            return contact.z > Math.min(walk.substepStart.z, place.z) + bottom + walk.options.stepHeight + walk.maxFloorDistance;
        }

        // Finds the normal of the face behind an edge. Returns whether there is a face that is not too steep.
        private function findFaceBehind(walk:WalkState, contact:ContactPoint, row:int, out:Vector3D):Boolean
        {
            var across:Number = Math.sqrt(contact.normalX * contact.normalX + contact.normalY * contact.normalY);
            if (!(across > 0))
            {
                // a ceiling has nothing behind it
                return false;
            }
            var behind:Number = BEHIND_EDGE * walk.body.extent;
            // the ray begins outside of all faces that are not too steep
            var above:Number = 2 * behind / walk.minFloorNormalZ;
            _ray.origin.x = contact.x - behind * contact.normalX / across;
            _ray.origin.y = contact.y - behind * contact.normalY / across;
            _ray.origin.z = contact.z + above;
            _ray.to = 2 * above;
            if (!_rowRays.findRayEntry(row, _ray, _entry) || _entry.distance == 0 || !(_entry.normal.z >= walk.minFloorNormalZ))
            {
                return false;
            }
            out.setTo(_entry.normal.x, _entry.normal.y, _entry.normal.z);
            return true;
        }
    }
}
