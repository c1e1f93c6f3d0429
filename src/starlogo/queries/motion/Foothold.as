package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayEntry;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.rays.RowRayTest;
    import starlogo.search.Body;

    /**
     * Decides whether an agent that walks can stand on what is below it. A surface carries the agent if it is not too steep. At an edge, such as that of a
     * step, the face behind the edge decides.
     *
     * @private
     */
    public final class Foothold
    {
        // At an edge, the face this far behind the edge is tested. A part of the extent.
        private static const BEHIND_EDGE:Number = 1e-4;

        private static const DOWN:Vector3D = new Vector3D(0, 0, -1);

        private var _rowRays:RowRayTest;

        // The ray at an edge: where it begins, and what it meets.
        private var _origin:Vector3D = new Vector3D();
        private var _ray:Ray = new Ray();
        private var _entry:RayEntry = new RayEntry();

        /** @param seen has the rows */
        public function Foothold(seen:SeenAgents)
        {
            _rowRays = new RowRayTest(seen);
        }

        /**
         * Finds the surface of a row that carries an agent.
         *
         * @param contact the contact with the row below the agent
         * @param place where the agent would stand
         * @param out receives the normal of the surface
         * @return whether there is one
         */
        public function findSurface(walk:Walk, contact:ContactPoint, row:int, place:Vector3D, out:Vector3D):Boolean
        {
            if (contact.normalZ >= walk.walkableZ)
            {
                out.setTo(contact.normalX, contact.normalY, contact.normalZ);
                return true;
            }
            return !isTooHigh(walk, contact, place) && findFaceBehind(walk, contact, row, out);
        }

        // Whether an edge is more than a step above the lowest point of the agent, where the leg began or at its place.
        private static function isTooHigh(walk:Walk, contact:ContactPoint, place:Vector3D):Boolean
        {
            var body:Body = walk.body.whole;
            var bottom:Number = body.middleZ - body.halfZ - body.placement.z;
            return contact.z > Math.min(walk.legStart.z, place.z) + bottom + walk.options.stepHeight + walk.closeDepth;
        }

        // Finds the normal of the face behind an edge. Returns whether there is a face that is not too steep.
        private function findFaceBehind(walk:Walk, contact:ContactPoint, row:int, out:Vector3D):Boolean
        {
            var across:Number = Math.sqrt(contact.normalX * contact.normalX + contact.normalY * contact.normalY);
            if (!(across > 0))
            {
                // a ceiling has nothing behind it
                return false;
            }
            var behind:Number = BEHIND_EDGE * walk.body.extent;
            // the ray begins outside of all faces that are not too steep
            var above:Number = 2 * behind / walk.walkableZ;
            _origin.setTo(contact.x - behind * contact.normalX / across, contact.y - behind * contact.normalY / across, contact.z + above);
            _ray.aim(_origin, DOWN);
            _ray.to = 2 * above;
            if (!_rowRays.findRayEntry(row, _ray, _entry) || _entry.distance == 0 || !(_entry.normalZ >= walk.walkableZ))
            {
                return false;
            }
            out.setTo(_entry.normalX, _entry.normalY, _entry.normalZ);
            return true;
        }
    }
}
