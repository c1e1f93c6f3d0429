package starlogo.models.collada
{
    import starlogo.geometry.AffineTransform;

    /** A node of a COLLADA document at one of its places in the scene. */
    internal final class ColladaPlace
    {
        /** The place around this one; null for that of the scene. Read only. */
        public var around:ColladaPlace;

        /** How many places are around this one. Read only. */
        public var depth:int;

        /** What takes points of the node to the scene, by the transforms that are visited so far. Read only. */
        public var transform:AffineTransform;

        private var _node:ColladaElement;

        // The index of the node's element that is visited next.
        private var _next:int = 0;

        // The places are numbered in the order in which they are entered. This one has the number _first, and those in it the next ones, up to _end.
        private var _first:int;
        private var _end:int;

        /**
         * @param node the node's element
         * @param around the place around this one; null for the scene
         * @param first how many places were entered before this one
         */
        public function ColladaPlace(node:ColladaElement, around:ColladaPlace, first:int)
        {
            _node = node;
            this.around = around;
            _first = first;
            depth = around == null ? 0 : around.depth + 1;
            transform = around == null ? new AffineTransform() : around.transform;
        }

        /** Visits the node's next transform, which comes before those so far. */
        public function addTransform(local:AffineTransform):void
        {
            transform = transform.after(local);
        }

        /** The next element in the node. Null if all were visited. */
        public function nextElement():ColladaElement
        {
            return _next < _node.children.length ? _node.children[_next++] : null;
        }

        /** Ends the visit of the node. @param placeCount how many places have been entered */
        public function leave(placeCount:int):void
        {
            _end = placeCount;
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
                var next:int = indexFrom(places, outer._first);
                if (next < places.length && places[next]._first < outer._end)
                {
                    return places[next];
                }
            }
            return places[0];
        }

        /** Whether a node is at this place, or at one around it. */
        public function isWithin(node:ColladaElement):Boolean
        {
            for (var place:ColladaPlace = this; place != null; place = place.around)
            {
                if (place._node == node)
                {
                    return true;
                }
            }
            return false;
        }

        // The index of the first place that was entered when there were at least so many.
        private static function indexFrom(places:Array, first:int):int
        {
            var low:int = 0;
            var high:int = places.length;
            while (low < high)
            {
                var middle:int = (low + high) >> 1;
                if (places[middle]._first < first)
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
    }
}
