// This room has what the client's blocks call: a class for each drawer of blocks, and a method for each block. BlockChecks checks what a block
// is given, and BlockError says what is wrong in words for students; the work is done by the rooms collision, queries and terrain. Read this
// file first, then DetectionBlocks.
package starlogo.blocks
{
    import flash.geom.Vector3D;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.Collider;
    import starlogo.collision.Collision;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.Contact;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.search.CollisionSearch;

    use namespace engine;

    /**
     * The blocks that react to collisions and choose how they are found: "on collision with", "when touching starts", "when touching ends",
     * "use collision system" (thesis §7.1).
     */
    public class CollisionBlocks
    {
        /** Every agent counts as a sphere of its size: BinCollider. */
        public static const UNIT_SPHERES:String = "unit spheres";

        /** Every agent counts as its bounding structure: TightestFitCollider. */
        public static const TIGHTEST_FITS:String = "tightest fits";

        /** Every agent counts as its hierarchy: HierarchicalCollider. */
        public static const HIERARCHIES:String = "hierarchies";

        /** Hierarchical agents count as their hierarchies, all others as their bounding structures: CombinationCollider. */
        public static const COMBINATION:String = "combination";

        /** Every agent counts as the triangles of its model: HierarchicalCollider in exact mode. */
        public static const EXACT:String = "exact";

        private static const NAMES:Array = [UNIT_SPHERES, TIGHTEST_FITS, HIERARCHIES, COMBINATION, EXACT];

        private var _greatLand:GreatLand;
        private var _agents:Vector.<Agent>;
        private var _systems:Object = {};
        private var _collision:Collision;

        // A search of the system that was in use when it was made, for present places; null before the first. It never gets a list of agents, so it takes
        // all agents where they are now.
        private var _search:CollisionSearch = null;

        /**
         * Creates blocks without scripts. The collision system is "tightest fits".
         *
         * @param greatLand has the models of the agents
         * @param agents the game's own list of its agents; it is not copied
         * @throws ArgumentError if one is null
         */
        public function CollisionBlocks(greatLand:GreatLand, agents:Vector.<Agent>)
        {
            requireGiven("the GreatLand", greatLand);
            requireGiven("the list of agents", agents);
            _greatLand = greatLand;
            _agents = agents;
            var exact:HierarchicalCollider = new HierarchicalCollider(greatLand);
            exact.exact = true;
            _systems[UNIT_SPHERES] = new BinCollider(greatLand);
            _systems[TIGHTEST_FITS] = new TightestFitCollider(greatLand);
            _systems[HIERARCHIES] = new HierarchicalCollider(greatLand);
            _systems[COMBINATION] = new CombinationCollider(greatLand);
            _systems[EXACT] = exact;
            _collision = new Collision(systemNamed(TIGHTEST_FITS));
        }

        /** The names that "use collision system" offers. */
        public static function get systemNames():Array
        {
            return NAMES.concat();
        }

        /** The game's models. */
        public function get greatLand():GreatLand
        {
            return _greatLand;
        }

        /** The game's agents. */
        public function get agents():Vector.<Agent>
        {
            return _agents;
        }

        /** The Collision that finds the collisions and calls the scripts. */
        public function get collision():Collision
        {
            return _collision;
        }

        /** The name of the collision system in use; null if the game has given its Collision one of its own. */
        public function get systemName():String
        {
            for each (var name:String in NAMES)
            {
                if (_systems[name] === _collision.collisionSystem)
                {
                    return name;
                }
            }
            return null;
        }

        /**
         * The collision system with a name. The same name always gives the same system.
         *
         * @throws BlockError if there is no such system
         */
        public function systemNamed(name:String):CollisionSystem
        {
            if (NAMES.indexOf(name) < 0)
            {
                throw new BlockError("use collision system", "does not know " + BlockChecks.nameOf(name) + ". Choose one of these: " + NAMES.join(", ") + ".");
            }
            return _systems[name];
        }

        /**
         * The block "use collision system". The change counts from the next frame on.
         *
         * @param name one of systemNames
         * @throws BlockError if it is none of them
         */
        public function useCollisionSystem(name:String):void
        {
            _collision.collisionSystem = systemNamed(name);
        }

        /**
         * The block "on collision with ... do".
         *
         * @param breed the breed that has the block
         * @param otherBreed the breed that it collides with, or Collision.ANY_BREED
         * @param script called with the collider and the collidee in every frame in which they touch
         * @throws BlockError if something is missing
         * @throws ArgumentError as Collision.onCollision
         */
        public function onCollision(breed:String, otherBreed:String, script:Function):void
        {
            checkScript("on collision with", breed, otherBreed, script);
            _collision.onCollision(breed, otherBreed, script);
        }

        /**
         * The block "when touching starts".
         *
         * @param breed as in onCollision
         * @param otherBreed as in onCollision
         * @param script called in the first frame in which the two agents touch
         * @throws BlockError if something is missing
         * @throws ArgumentError as in onCollision
         */
        public function whenTouchingStarts(breed:String, otherBreed:String, script:Function):void
        {
            checkScript("when touching starts", breed, otherBreed, script);
            _collision.onCollisionStart(breed, otherBreed, script);
        }

        /**
         * The block "when touching ends".
         *
         * @param breed as in onCollision
         * @param otherBreed as in onCollision
         * @param script called in the first frame in which the two agents no longer touch
         * @throws BlockError if something is missing
         * @throws ArgumentError as in onCollision
         */
        public function whenTouchingEnds(breed:String, otherBreed:String, script:Function):void
        {
            checkScript("when touching ends", breed, otherBreed, script);
            _collision.onCollisionEnd(breed, otherBreed, script);
        }

        /**
         * Removes all scripts and forgets which agents touch. Call it before a program starts again. The collision system and the filter
         * stay.
         */
        public function forgetScripts():void
        {
            _collision.reset();
        }

        /**
         * @private How two agents touch where they are now, in the system in use; null if they do not touch.
         *
         * @throws BlockError if the system is not one of the engine's
         */
        engine function contactNow(block:String, agent:Agent, other:Agent):Contact
        {
            var collider:Collider = _collision.systemOfFrame.samePairsCollider;
            if (collider == null)
            {
                throw new BlockError(block, "does not work with a collision system of the game's own.");
            }
            if (_search == null || _search.narrowPhase !== collider.narrowPhase)
            {
                _search = new CollisionSearch(collider.narrowPhase);
            }
            return _search.contacts.areColliding(agent, other) ? collider.contactIn(_search, agent, other, new Contact()) : null;
        }

        /** @private Moves an agent by the shortest way out of what it touches. @param contact how it touches that where it is now; null if it does not */
        engine static function pushOut(agent:Agent, contact:Contact):void
        {
            if (contact != null)
            {
                var normal:Vector3D = contact.normal;
                agent.moveTo(agent.x + contact.depth * normal.x, agent.y + contact.depth * normal.y, agent.z + contact.depth * normal.z);
            }
        }

        private static function checkScript(block:String, breed:String, otherBreed:String, script:Function):void
        {
            BlockChecks.requireBreed(block, breed);
            BlockChecks.requireBreed(block, otherBreed);
            if (script == null)
            {
                throw new BlockError(block, "has nothing to do: put blocks into it.");
            }
        }
    }
}
