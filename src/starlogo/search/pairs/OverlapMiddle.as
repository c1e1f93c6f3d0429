package starlogo.search.pairs
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Puts the point of a contact into the middle of the overlap of two bodies.
     *
     * @private
     */
    public final class OverlapMiddle
    {
        /**
         * Moves a contact's point along its normal, into the middle of the overlap. This is needed if a body is shorter along the normal than the
         * contact is deep. For example, the body may be inside the other one.
         *
         * @param a the first body of the contact
         * @param b the second body
         * @param out the contact. Its point is half of the depth away from the second body's end, along the normal
         */
        public static function moveToMiddle(a:Body, b:Body, out:ContactPoint):void
        {
            var low:Number = Math.max(0, out.depth - lengthOf(b, out));
            var high:Number = Math.min(out.depth, lengthOf(a, out));
            var offset:Number = (low + high - out.depth) / 2;
            out.x += offset * out.normalX;
            out.y += offset * out.normalY;
            out.z += offset * out.normalZ;
        }

        /** Moves a contact's point into the extents of a body, if it is outside. The ground has none. */
        public static function keepWithin(body:Body, out:ContactPoint):void
        {
            if (body.kind == ModelShape.GROUND)
            {
                return;
            }
            out.x = Math.max(Math.min(out.x, body.middleX + body.halfX), body.middleX - body.halfX);
            out.y = Math.max(Math.min(out.y, body.middleY + body.halfY), body.middleY - body.halfY);
            out.z = Math.max(Math.min(out.z, body.middleZ + body.halfZ), body.middleZ - body.halfZ);
        }

        // The length of a body along a normal. For bodies other than spheres it is the length of their extents.
        private static function lengthOf(body:Body, out:ContactPoint):Number
        {
            if (body.kind == ModelShape.GROUND)
            {
                return Infinity;
            }
            if (body.kind == BoundingStructure.SPHERE)
            {
                return 2 * body.halfX;
            }
            return 2 * body.halfAlong(out);
        }
    }
}
