package starlogo.search.penetration
{
    /** Between which distances along a direction two bodies part, as a record. */
    internal final class PartingDistances
    {
        /** The two touch here; 0 if they have not been tested at a smaller distance than the outer one. */
        public var inner:Number = 0;

        /** The two are free here, once they have been tested. */
        public var outer:Number = 0;

        /** Becomes all distances up to an outer one. */
        public function setTo(outer:Number):void
        {
            inner = 0;
            this.outer = outer;
        }
    }
}
