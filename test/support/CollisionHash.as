package support
{
    import flash.utils.Dictionary;
    import evaluation.scenes.Scene;
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionSystem;

    /**
     * One number for the ordered collisions of a scene over some frames: FNV-1a over the agents' places in the list, pair by pair in the
     * order of the first one's place, then of the second's.
     */
    public final class CollisionHash
    {
        private static const PLACES:int = 65536;

        private var _hash:uint = 2166136261;
        private var _collisions:int = 0;

        /**
         * @param scene is played
         * @param collider finds the collisions
         * @param frames how many
         */
        public function CollisionHash(scene:Scene, collider:CollisionSystem, frames:int)
        {
            var places:Dictionary = new Dictionary();
            for (var i:int = 0; i < scene.agents.length; i++)
            {
                places[scene.agents[i]] = i;
            }
            for (var frame:int = 0; frame < frames; frame++)
            {
                scene.step();
                var found:Vector.<Agent> = collider.findCollisions(scene.agents);
                _collisions += found.length / 2;
                add(found.length);
                var pairs:Array = [];
                for (i = 0; i < found.length; i += 2)
                {
                    pairs.push(places[found[i]] * PLACES + places[found[i + 1]]);
                }
                pairs.sort(Array.NUMERIC);
                for each (var pair:Number in pairs)
                {
                    add(pair / PLACES);
                    add(pair % PLACES);
                }
            }
        }

        /** The collisions of all frames. */
        public function get collisions():int
        {
            return _collisions;
        }

        /** The hash: eight hexadecimal digits. */
        public function toString():String
        {
            return ("0000000" + _hash.toString(16)).slice(-8);
        }

        private function add(number:int):void
        {
            addByte(number & 0xff);
            addByte((number >>> 8) & 0xff);
            addByte(number >>> 16);
        }

        private function addByte(value:int):void
        {
            _hash ^= value;
            // times 16777619, which is 2^24 + 403, within 32 bits
            var low:uint = (_hash & 0xffff) * 403;
            var high:uint = ((_hash >>> 16) * 403) << 16;
            _hash = low + high + (_hash << 24);
        }
    }
}
