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
        /** The smallest structure of each kind, or null; also if it is not kept for the client, so that it need not be computed again. */
        public var smallest:Vector.<BoundingStructure> = new Vector.<BoundingStructure>(3, true);

        /** The structure with the least volume, or with the cheapest tests within the factor. */
        public var tightest:BoundingStructure = null;

        /** Whether the client is given the smallest of each kind. */
        public var keepsAll:Boolean;

        /** The smallest structures of each kind as they were read, not checked yet; null for none. */
        public var unchecked:Vector.<BoundingStructure> = null;

        /** The structures that the fitters found later, when one of a missing kind was asked for; or null. */
        public var foundLater:ShapeStructures = null;

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
                // a volume that was read may be no number: such a structure is refused when it is checked
                if (tightest == null && structure != null && !(structure.volume > least * cheaperTestsFactor))
                {
                    tightest = structure;
                }
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
            return smallest[kind] == null && foundLater != null ? foundLater.smallest[kind] : smallest[kind];
        }

        /** Leaves only the tightest: the others are not checked yet. */
        public function trustTightestOnly():void
        {
            unchecked = smallest;
            smallest = new Vector.<BoundingStructure>(unchecked.length, true);
            smallest[tightest.kind] = tightest;
        }

        /**
         * Checks the structures that are not checked yet, and uses them if all of them enclose the model.
         *
         * @param vertices the model's, x, y, z each
         */
        public function checkRest(vertices:Vector.<Number>):void
        {
            if (unchecked != null && areEnclosing(unchecked, vertices))
            {
                smallest = unchecked;
            }
            unchecked = null;
        }

        /** Whether all of some structures contain all vertices, x, y, z each; null among them is left out. */
        public static function areEnclosing(structures:Vector.<BoundingStructure>, vertices:Vector.<Number>):Boolean
        {
            for each (var structure:BoundingStructure in structures)
            {
                if (structure != null && !encloses(structure, vertices))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
