package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.intersection.contact.ContactPoint;

    use namespace engine;

    /** Where the point of a contact is in the overlap of two rows. */
    internal final class OverlapMiddle
    {
        /** Has only static members. */
        public function OverlapMiddle()
        {
        }

        /**
         * Where a row reaches less far along the normal than the depth, as one that is inside of a larger one does, has the point in the middle of it.
         *
         * @param a the first row of the contact, wherever it is
         * @param b the second
         * @param out the contact, its point half of the depth from where the second ends along the normal
         */
        public static function setAlong(table:AgentTable, a:int, b:int, out:ContactPoint):void
        {
            var low:Number = out.depth - across(table, b, out);
            var high:Number = across(table, a, out);
            if (low > 0 || high < out.depth)
            {
                low = low > 0 ? low : 0;
                high = high < out.depth ? high : out.depth;
                var by:Number = (low + high - out.depth) / 2;
                out.x += by * out.normalX;
                out.y += by * out.normalY;
                out.z += by * out.normalZ;
            }
        }

        /** Puts a contact's point into the extents of a row, where it is not. */
        public static function keepWithin(extents:Extents, row:int, out:ContactPoint):void
        {
            out.x = Math.max(Math.min(out.x, extents.x[row] + extents.halfX[row]), extents.x[row] - extents.halfX[row]);
            out.y = Math.max(Math.min(out.y, extents.y[row] + extents.halfY[row]), extents.y[row] - extents.halfY[row]);
            out.z = Math.max(Math.min(out.z, extents.z[row] + extents.halfZ[row]), extents.z[row] - extents.halfZ[row]);
        }

        // How far across a row is along a normal, or its extents are.
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
