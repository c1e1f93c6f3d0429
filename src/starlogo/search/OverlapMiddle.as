package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;

    use namespace engine;

    /** Puts the point of a contact into the middle of the overlap of two rows. */
    internal final class OverlapMiddle
    {
        /** Has only static members. */
        public function OverlapMiddle()
        {
        }

        /**
         * Moves a contact's point along its normal, into the middle of the overlap. This is needed if a row is shorter along the normal than the
         * contact is deep. For example, the row may be inside the other one.
         *
         * @param a the first row of the contact
         * @param b the second row
         * @param out the contact. Its point is half of the depth away from the second row's end, along the normal
         */
        public static function setAlong(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            var low:Number = Math.max(0, out.depth - across(table, b, out));
            var high:Number = Math.min(out.depth, across(table, a, out));
            var by:Number = (low + high - out.depth) / 2;
            out.x += by * out.normalX;
            out.y += by * out.normalY;
            out.z += by * out.normalZ;
        }

        /** Moves a contact's point into the extents of a row, if it is outside. */
        public static function keepWithin(extents:Extents, row:int, out:ContactPoint):void
        {
            out.x = Math.max(Math.min(out.x, extents.x[row] + extents.halfX[row]), extents.x[row] - extents.halfX[row]);
            out.y = Math.max(Math.min(out.y, extents.y[row] + extents.halfY[row]), extents.y[row] - extents.halfY[row]);
            out.z = Math.max(Math.min(out.z, extents.z[row] + extents.halfZ[row]), extents.z[row] - extents.halfZ[row]);
        }

        // The length of a row along a normal. For rows other than spheres it is the length of their extents.
        private static function across(table:AgentTable, row:int, out:ContactPoint):Number
        {
            var extents:Extents = table.extents;
            if (table.forms[row] == ModelShape.GROUND)
            {
                return Infinity;
            }
            if (table.forms[row] == BoundingStructure.SPHERE)
            {
                return 2 * extents.halfX[row];
            }
            return 2 * (extents.halfX[row] * Math.abs(out.normalX) + extents.halfY[row] * Math.abs(out.normalY)
                    + extents.halfZ[row] * Math.abs(out.normalZ));
        }
    }
}
