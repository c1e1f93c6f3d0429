package soak
{
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;
    import starlogo.collision.Collision;
    import starlogo.collision.Contact;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    /** The ground and the edges of a soak's world. Both change all the time, and each breed has handlers of another kind for them. */
    internal final class SoakGround
    {
        /** What is counted here. */
        internal static const COUNTED:Array = ["mounds raised", "walls raised", "grounds made of slopes or of columns", "grounds made flat", "edges moved",
                "touches of the ground", "starts with the ground", "ends with the ground", "touches of the edges", "starts with the edges",
                "ends with the edges"];

        private static const WIDTH:int = 9;
        private static const HALF:Number = 8;

        private var _random:SeededRandom;
        private var _counts:SoakCounts;
        private var _witness:SoakWitness;
        private var _terrain:Terrain = new Terrain(WIDTH, WIDTH, 2, -HALF, -HALF);
        private var _bounds:WorldBounds = new WorldBounds(-HALF, -HALF, -Infinity, HALF, HALF, Infinity);

        /**
         * @param collision gets the ground, the edges and the handlers
         * @param random decides
         * @param counts is told
         * @param witness likewise
         */
        public function SoakGround(collision:Collision, random:SeededRandom, counts:SoakCounts, witness:SoakWitness)
        {
            _random = random;
            _counts = counts;
            _witness = witness;
            makeFlat();
            collision.terrain = _terrain;
            collision.bounds = _bounds;
            collision.onCollision(Collision.TERRAIN, "walls", withoutContact("touches of the ground"));
            collision.onCollisionStart("bears", Collision.TERRAIN, withContact("starts with the ground"));
            collision.onCollisionEnd("bears", Collision.TERRAIN, withoutContact("ends with the ground"));
            collision.onCollision("walls", Collision.EDGE, withContact("touches of the edges"));
            collision.onCollision(Collision.EDGE, "turtles", withoutContact("touches of the edges"));
            collision.onCollisionStart("balls", Collision.EDGE, withContact("starts with the edges"));
            collision.onCollisionEnd("balls", Collision.EDGE, withoutContact("ends with the edges"));
        }

        /** Changes some heights, and now and then all of them, the surface or the edges. */
        internal function change():void
        {
            if (_random.chance(0.2))
            {
                _terrain.raiseMound(_random.between(-HALF, HALF), _random.between(-HALF, HALF), _random.between(1, 8), _random.between(-1, 1));
                _counts.add("mounds raised");
            }
            if (_random.chance(0.1))
            {
                _terrain.raiseWall(_random.between(-HALF, HALF), _random.between(-HALF, HALF), _random.between(-1, 1));
                _counts.add("walls raised");
            }
            if (_random.chance(0.03))
            {
                _terrain.isBlocky = !_terrain.isBlocky;
                _counts.add("grounds made of slopes or of columns");
            }
            if (_random.chance(0.03))
            {
                makeFlat();
                _counts.add("grounds made flat");
            }
            if (_random.chance(0.05))
            {
                _bounds.setTo(-_random.between(4, HALF), -HALF, -Infinity, _random.between(4, HALF), _random.pick([4, HALF, Infinity]), 3);
                _counts.add("edges moved");
            }
        }

        // Below the agents' places.
        private function makeFlat():void
        {
            _terrain.reset();
            _terrain.raiseMound(0, 0, 1000, -0.5);
        }

        private function withContact(name:String):Function
        {
            return function(collider:Agent, collidee:Agent, contact:Contact):void
            {
                _counts.add(name);
                _witness.seeContact(collider, collidee, contact);
            };
        }

        private function withoutContact(name:String):Function
        {
            return function(collider:Agent, collidee:Agent):void
            {
                _counts.add(name);
                _witness.seePair(collider, collidee);
            };
        }
    }
}
