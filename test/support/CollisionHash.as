package support
{
    import evaluation.scenes.Scene;
    import flash.utils.Dictionary;
    import starlogo.agents.Agent;
    import starlogo.collision.CollisionSystem;

    /**
     * One number for the ordered collisions of a scene over some frames: a RunningHash of the agents' places in the list, pair by pair in the
     * order of the first one's place, then of the second's.
     */
    public final class CollisionHash
    {
        private static const PLACES:int = 65536;

        private var _hash:RunningHash = new RunningHash();

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
                _hash.addShort(found.length);
                var pairs:Array = [];
                for (i = 0; i < found.length; i += 2)
                {
                    pairs.push(places[found[i]] * PLACES + places[found[i + 1]]);
                }
                pairs.sort(Array.NUMERIC);
                for each (var pair:Number in pairs)
                {
                    _hash.addShort(pair / PLACES);
                    _hash.addShort(pair % PLACES);
                }
            }
        }

        /** The hash: eight hexadecimal digits. */
        public function toString():String
        {
            return _hash.toString();
        }
    }
}
