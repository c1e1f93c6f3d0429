package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;

    /**
     * What the BoundingStructuresLibrary has of one shape. Structures are listed by the numbers of their kinds, which are numbered by the
     * cost of their tests.
     *
     * @private
     */
    public final class ShapeStructures
    {
        /** The smallest structure of each kind, or null; also if the client is not given it, so that it need not be computed again. */
        public var smallest:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);

        /** The structure with the least volume, or with the cheapest tests within the factor. */
        public var tightest:BoundingStructure = null;

        /** Whether the client is given the smallest of each kind. */
        public var keepsAll:Boolean;

        /**
         * @param found all structures that were found; null among them is left out
         * @param cheaperTestsFactor how much larger than the smallest one the tightest may be for cheaper tests
         * @param keepsAll whether the client is given the smallest of each kind
         */
        public function ShapeStructures(found:Vector.<BoundingStructure>, cheaperTestsFactor:Number, keepsAll:Boolean)
        {
            this.keepsAll = keepsAll;
            var least:Number = Infinity;
            for each (var structure:BoundingStructure in found)
            {
                if (structure != null && (smallest[structure.kind] == null || structure.volume < smallest[structure.kind].volume))
                {
                    smallest[structure.kind] = structure;
                    least = Math.min(least, structure.volume);
                }
            }
            for each (structure in smallest)
            {
                // a volume that was read may be no number
                if (tightest == null && structure != null && !(structure.volume > least * cheaperTestsFactor))
                {
                    tightest = structure;
                }
            }
        }

        /** Takes what other fitters found of kinds that are missing. */
        public function addMissing(other:ShapeStructures):void
        {
            for (var kind:int = 0; kind < smallest.length; kind++)
            {
                smallest[kind] ||= other.smallest[kind];
            }
        }
    }
}
