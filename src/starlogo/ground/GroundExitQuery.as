package starlogo.ground
{
    import starlogo.convex.ContactPoint;
    import starlogo.convex.DepthProof;
    import starlogo.convex.RelativeMotion;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Touching;

    /**
     * Finds ways for a standing model out of the ground, from which a search for the shortest way begins. GroundModelQuery sets the model.
     *
     * @private
     */
    public final class GroundExitQuery
    {
        // Two exits have nearly the same direction if the cosine of their angle is larger.
        private static const SAME_EXIT:Number = 0.98;

        // The triangle of a contact counts as behind a plane if it is in front of it by at most this many margins of the plane's triangle, which are
        // rounding.
        private static const IN_FRONT:Number = 10;

        // The most exits that are found.
        private static const MOST_EXITS:int = 12;

        private var _pairs:PieceTrianglePairs;

        // The exit in front of a triangle that is tried.
        private var _tried:ContactPoint = new ContactPoint();

        /** @param pairs of the model, where it stands */
        public function GroundExitQuery(pairs:PieceTrianglePairs)
        {
            _pairs = pairs;
        }

        /**
         * Finds the planes of triangles that the standing structure around the model is behind: of planes with nearly the same direction, the one
         * that it is least behind. If the contact has a triangle of the ground, only planes that this triangle is not in front of count.
         *
         * @param contact of the model and the ground, here or near here
         * @param maxDistance how far away triangles may be
         * @param exits receives the contacts that lead out of the planes
         * @return their number
         */
        public function find(contact:ContactPoint, maxDistance:Number, exits:Vector.<ContactPoint>):int
        {
            var proof:DepthProof = contact.proof;
            var count:int = 0;
            _pairs.beginWhole(maxDistance);
            while (_pairs.next())
            {
                _pairs.kernel.findBehind(RelativeMotion.NONE, _tried);
                if (_tried.depth >= -_pairs.triangle.margin && (!proof.hasTriangle || isBehind(_tried, proof)))
                {
                    count = addExit(_tried, exits, count);
                }
            }
            for (var i:int = 0; i < count; i++)
            {
                _pairs.moveToWorld(exits[i]);
            }
            return count;
        }

        // Whether the triangle of a contact is not in front of the plane of an exit, which is that of the current triangle.
        private function isBehind(exit:ContactPoint, proof:DepthProof):Boolean
        {
            var origin:Placement = _pairs.origin;
            var x:Number = origin.x - proof.x;
            var y:Number = origin.y - proof.y;
            var z:Number = origin.z - proof.z;
            var slack:Number = IN_FRONT * _pairs.triangle.margin + x * exit.normalX + y * exit.normalY + z * exit.normalZ;
            if (x != 0 || y != 0 || z != 0)
            {
                slack += 2 * Touching.marginOfPlace(origin.x, origin.y, origin.z);
            }
            return _pairs.kernel.isBehindPlane(proof.corners, slack);
        }

        // Adds an exit to a number of exits. Of exits with nearly the same direction, the shortest is kept. Returns the new number.
        private static function addExit(exit:ContactPoint, exits:Vector.<ContactPoint>, count:int):int
        {
            var at:int = 0;
            while (at < count && exit.normalX * exits[at].normalX + exit.normalY * exits[at].normalY + exit.normalZ * exits[at].normalZ <= SAME_EXIT)
            {
                at++;
            }
            if (at == MOST_EXITS)
            {
                return count;
            }
            if (at == exits.length)
            {
                exits[at] = new ContactPoint();
            }
            if (at == count || exit.depth < exits[at].depth)
            {
                exits[at].copyFrom(exit);
            }
            return Math.max(count, at + 1);
        }
    }
}
