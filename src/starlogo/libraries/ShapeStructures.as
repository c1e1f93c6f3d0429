package starlogo.libraries
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * What the BoundingStructuresLibrary keeps of one shape.
     *
     * @private
     */
    public final class ShapeStructures
    {
        /** What has the least volume, or the cheapest tests within the factor. */
        public var tightest:BoundingStructure;

        /** The smallest one found, or null. */
        public var sphere:Sphere;

        /** The smallest one found, or null. */
        public var capsule:Capsule;

        /** The smallest one found, or null. */
        public var box:Box;

        /** By the numbers of the kinds, the smallest one found of each, or null: kept or not, it need not be found again. */
        public var found:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);

        /**
         * By the numbers of the kinds, what is said to be the smallest of each, but has not been looked at; null for nothing.
         */
        public var offered:Vector.<BoundingStructure> = null;

        /** All of them, found when one was asked for that was not kept; or null. */
        public var late:ShapeStructures = null;

        /**
         * @param found all that were found
         * @param cheaperTestsFactor how much larger than the smallest one the tightest may be for cheaper tests
         * @param keepsAll whether the smallest one of each kind is kept beside the tightest
         */
        public function ShapeStructures(found:Vector.<BoundingStructure>, cheaperTestsFactor:Number, keepsAll:Boolean)
        {
            tightest = choose(found, cheaperTestsFactor);
            for (var kind:int = 0; kind < this.found.length; kind++)
            {
                this.found[kind] = smallest(found, kind);
            }
            if (keepsAll)
            {
                sphere = this.found[BoundingStructure.SPHERE] as Sphere;
                capsule = this.found[BoundingStructure.CAPSULE] as Capsule;
                box = this.found[BoundingStructure.BOX] as Box;
            }
        }

        /**
         * The smallest structure of a kind, as far as one was found.
         *
         * @param kind BoundingStructure.SPHERE, CAPSULE or BOX
         * @return null if there is none
         */
        public function ofKind(kind:int):BoundingStructure
        {
            if (tightest.kind == kind)
            {
                return tightest;
            }
            return found[kind] == null && late != null ? late.ofKind(kind) : found[kind];
        }

        /** Leaves nothing but the tightest; the others are offered. */
        public function offer():void
        {
            offered = found;
            found = new Vector.<BoundingStructure>(offered.length, true);
            found[tightest.kind] = tightest;
        }

        private static function choose(found:Vector.<BoundingStructure>, factor:Number):BoundingStructure
        {
            var least:Number = Infinity;
            for each (var structure:BoundingStructure in found)
            {
                least = Math.min(least, structure.volume);
            }
            var chosen:BoundingStructure = null;
            for each (structure in found)
            {
                if (structure.volume <= least * factor && (chosen == null || isCheaper(structure, chosen)))
                {
                    chosen = structure;
                }
            }
            return chosen;
        }

        // The kinds are numbered by the cost of their tests.
        private static function isCheaper(a:BoundingStructure, b:BoundingStructure):Boolean
        {
            return a.kind == b.kind ? a.volume < b.volume : a.kind < b.kind;
        }

        private static function smallest(found:Vector.<BoundingStructure>, kind:int):BoundingStructure
        {
            var best:BoundingStructure = null;
            for each (var structure:BoundingStructure in found)
            {
                if (structure.kind == kind && (best == null || structure.volume < best.volume))
                {
                    best = structure;
                }
            }
            return best;
        }
    }
}
