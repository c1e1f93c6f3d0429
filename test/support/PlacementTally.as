package support
{
    /** How often a collider is right about placements. */
    public final class PlacementTally
    {
        /** Which collider, and how it is set. */
        public var name:String;

        /** Placements that meet and are told so. */
        public var found:int = 0;

        /** Placements that meet and are missed. */
        public var missed:int = 0;

        /** Placements that do not meet, but are told so. */
        public var falseHits:int = 0;

        /** Placements that do not meet and are told so. */
        public var apart:int = 0;

        public function PlacementTally(name:String)
        {
            this.name = name;
        }

        /** Counts an answer. */
        public function add(isHit:Boolean, isTrue:Boolean):void
        {
            if (isHit)
            {
                isTrue ? found++ : falseHits++;
            }
            else
            {
                isTrue ? missed++ : apart++;
            }
        }

        /** The share of what is found in what is there, in per cent. */
        public function get recall():Number
        {
            return 100 * found / (found + missed);
        }

        /** The share of what is true in what is told, in per cent. */
        public function get precision():Number
        {
            return 100 * found / (found + falseHits);
        }

        public function toString():String
        {
            return "  " + (name + "                              ").substr(0, 30) + " recall " + recall.toFixed(2) + " %, precision " + precision.toFixed(2)
                + " %, " + missed + " missed, " + falseHits + " false";
        }
    }
}
