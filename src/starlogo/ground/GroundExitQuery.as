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

        // The most exits that are found.
        private static const MOST_EXITS:int = 12;

        private var _pairs:PieceTrianglePairs;

        // The way out in front of the current triangle.
        private var _tried:ContactPoint = new ContactPoint();

        /** @param pairs of the model, where it stands */
        public function GroundExitQuery(pairs:PieceTrianglePairs)
        {
            _pairs = pairs;
        }

        /**
         * Finds ways out in front of the planes of triangles. The standing structure around the model is behind these planes or touches them. Of ways in
         * nearly the same direction, the shortest counts. If the contact has a triangle of the ground, only planes count that this triangle is not in
         * front of.
         *
         * @param contact of the model and the ground, here or near here
         * @param maxDistance how far away from the structure triangles may be
         * @param exits receives a contact for each way, in the world; made longer if needed
         * @return how many ways there are
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

        // Whether the triangle of a contact is not in front of the current triangle's plane, up to rounding.
        private function isBehind(exit:ContactPoint, proof:DepthProof):Boolean
        {
            var origin:Placement = _pairs.origin;
            var x:Number = origin.x - proof.x;
            var y:Number = origin.y - proof.y;
            var z:Number = origin.z - proof.z;
            var slack:Number = GroundTriangle.MARGINS_OF_ROUNDING * _pairs.triangle.margin + x * exit.normalX + y * exit.normalY + z * exit.normalZ;
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
