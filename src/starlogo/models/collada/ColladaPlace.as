package starlogo.models.collada
{
    import starlogo.models.building.AffineTransform;

    /** A node of a COLLADA document at one of its places in the scene. */
    internal final class ColladaPlace
    {
        /** The node's element. */
        public var node:ColladaElement;

        /** The place around this one; null for that of the scene. */
        public var around:ColladaPlace;

        /** How many places are around this one. */
        public var depth:int;

        /** What takes points of the node to the scene. It grows with each of the node's transform elements that is visited. */
        public var transform:AffineTransform;

        /** The number of places that come before this one. */
        public var first:int;

        /** The number of places before this one, of this one and of those in it, when all of them are visited. */
        public var end:int;

        /**
         * @param node the node's element
         * @param around the place around this one; null for the scene
         * @param first the number of places that come before this one
         */
        public function ColladaPlace(node:ColladaElement, around:ColladaPlace, first:int)
        {
            this.node = node;
            this.around = around;
            this.first = first;
            depth = around == null ? 0 : around.depth + 1;
            transform = around == null ? new AffineTransform() : around.transform;
        }

        /**
         * Of the places of a node, the one that is in the innermost place around this that has one; the first of those. So each of several
         * figures has joints of its own.
         *
         * @param places in the scene's order, at least one
         */
        public function nearestOf(places:Array):ColladaPlace
        {
            for (var outer:ColladaPlace = this; places.length > 1 && outer != null; outer = outer.around)
            {
                var next:int = indexFrom(places, outer.first);
                if (next < places.length && places[next].first < outer.end)
                {
                    return places[next];
                }
            }
            return places[0];
        }

        // The index of the first place that has at least so many places before it.
        private static function indexFrom(places:Array, first:int):int
        {
            var low:int = 0;
            var high:int = places.length;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (places[middle].first < first)
                {
                    low = middle + 1;
                }
                else
                {
                    high = middle;
                }
            }
            return low;
        }

        /** Whether a node is at this place, or at one around it. */
        public function isWithin(node:ColladaElement):Boolean
        {
            for (var place:ColladaPlace = this; place != null; place = place.around)
            {
                if (place.node == node)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
