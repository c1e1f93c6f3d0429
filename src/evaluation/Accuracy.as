package evaluation
{
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionSystem;

    /** How often a collision system is right, over frames: how many of the pairs that it finds touch, and how many of those that touch it finds. */
    public final class Accuracy
    {
        /** The number of pairs that the system found. */
        public var found:int = 0;

        /** The number of these that touch. */
        public var right:int = 0;

        /** The number of pairs that touch. */
        public var touching:int = 0;

        /** The share of the found pairs that touch. */
        public function get precision():Number
        {
            return right / found;
        }

        /** The share of the touching pairs that are found. */
        public function get recall():Number
        {
            return right / touching;
        }

        /**
         * Adds a frame.
         *
         * @param pairs what the system has found: the two agents of each pair, in either order
         * @param truth the pairs that touch, as truthOf() gives them
         */
        public function add(pairs:Vector.<Agent>, truth:Object):void
        {
            var keys:Object = keysOf(pairs);
            for (var key:String in keys)
            {
                found++;
                right += key in truth ? 1 : 0;
            }
            for (key in truth)
            {
                touching++;
            }
        }

        /** A system's pairs of these agents in this frame, as the names of an object. */
        public static function truthOf(system:CollisionSystem, agents:Vector.<Agent>):Object
        {
            return keysOf(system.findCollisions(agents));
        }

        private static function keysOf(pairs:Vector.<Agent>):Object
        {
            var keys:Object = {};
            for (var i:int = 0; i < pairs.length; i += 2)
            {
                keys[Math.min(pairs[i].id, pairs[i + 1].id) + " " + Math.max(pairs[i].id, pairs[i + 1].id)] = true;
            }
            return keys;
        }
    }
}
