package starlogo.collision
{
    import flash.utils.getTimer;
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.search.BaseShapeChoice;
    import starlogo.search.BreedInterests;
    import starlogo.search.CollisionSearch;
    import starlogo.search.FoundPairs;
    import starlogo.search.SearchInput;
    import starlogo.search.NarrowPhase;
    import starlogo.search.PairReader;

    use namespace engine;

    /**
     * The base class of the engine's collision systems. It finds collisions between the shapes that a BaseShapeChoice gives to agents.
     *
     * <p>It tests only agents that are near each other on the ground plane (thesis §3.7), each pair once. A frame takes time in proportion to the
     * number of agents and of pairs that overlap on the ground plane. The memory is in proportion to the number of agents. After the first frame it
     * allocates nothing. It places an agent's shape again only when the agent has changed. Any number of colliders may share agents.</p>
     *
     * <p>Pairs come in the order of the list: by the first agent's index, then by the second's. In a pair, the agent that is first in the list
     * comes first. The ground and the edges of the world come after all agents. If an agent sweeps, pairs come by time of impact, and pairs of the
     * same time in the order of the list.</p>
     *
     * <p>A Collision searches with a collider itself. It calls <code>contactOf()</code> of a subclass, but not its
     * <code>findCollisions()</code>, <code>findCollisionsAmong()</code> and <code>areColliding()</code>. To find other pairs, put a BaseCollider
     * around the collider, and override the methods there.</p>
     *
     * <p>While a ModelLoader is loading an agent's model, the agent collides with nothing. The statistics count it. Models may be replaced
     * and removed at any time.</p>
     */
    public class Collider extends BaseCollider
    {
        /** @private The search that the collider makes. */
        engine var search:CollisionSearch;

        /** @private The search whose contacts contactOf gives. */
        engine var contactSearch:CollisionSearch;

        // The frames of the last Collision to which the collider was attached, or null. They own the collider while they use it, and keep their motions and
        // contacts there.
        private var _owner:FrameRunner = null;

        // The search for the game's own calls of findCollisions while a Collision owns the collider, or null.
        private var _extraSearch:CollisionSearch = null;

        private var _statistics:CollisionStatistics = new CollisionStatistics();
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _point:ContactPoint = new ContactPoint();
        private var _input:SearchInput = new SearchInput();

        /**
         * Creates a collider.
         *
         * @param choice chooses the shapes that represent agents: a ShapeChoice
         * @throws ArgumentError if it is null, or another BaseShapeChoice, without tests of its shapes
         */
        public function Collider(choice:BaseShapeChoice)
        {
            super();
            requireGiven("choice", choice);
            search = new CollisionSearch(narrowPhaseFor(choice));
            contactSearch = search;
        }

        /** @private */
        override engine function get innerCollider():Collider
        {
            return this;
        }

        /** @private */
        override engine function get samePairsCollider():Collider
        {
            return this;
        }

        /** @private The tests of pairs that a choice of shapes needs. */
        engine function narrowPhaseFor(choice:BaseShapeChoice):NarrowPhase
        {
            var tests:NarrowPhase = new NarrowPhase(choice);
            choice.addTests(tests);
            return tests;
        }

        /** @private Has the choice of shapes and the settings, and tests pairs of agents, for questions too. */
        engine function get narrowPhase():NarrowPhase
        {
            return search.narrowPhase;
        }

        /** @inheritDoc */
        override public function get statistics():CollisionStatistics
        {
            return _statistics;
        }

        /** @inheritDoc */
        override public function areColliding(a:Agent, b:Agent):Boolean
        {
            requireTwo(a, b);
            return search.contacts.areColliding(a, b);
        }

        /** @inheritDoc */
        override public function findCollisions(agents:Vector.<Agent>, out:Vector.<Agent> = null):Vector.<Agent>
        {
            return findCollisionsAmong(agents, null, out);
        }

        /** @inheritDoc */
        override public function findCollisionsAmong(agents:Vector.<Agent>, interests:BreedInterests, out:Vector.<Agent> = null):Vector.<Agent>
        {
            requireGiven("agents", agents);
            var inSearch:CollisionSearch = search;
            var state:int = stateOfOwner;
            if (state != FrameRunner.UNUSED && state != FrameRunner.SEARCHING)
            {
                // The next frame's motions begin where the last frame saw the agents, so a game's own call must not change that. While a Collision
                // searches it is no call of the game's: a BaseCollider around this collider makes it
                _extraSearch ||= new CollisionSearch(narrowPhase);
                inSearch = _extraSearch;
            }
            var found:Vector.<Agent> = out || new Vector.<Agent>();
            _input.begin(agents, interests || BreedInterests.ALL, null, null, null);
            if (state == FrameRunner.SEARCHING)
            {
                _input.takeFilterOf(_owner.input);
            }
            var pairs:FoundPairs = find(inSearch, _input);
            if (found.length > 2 * pairs.count)
            {
                found.length = 2 * pairs.count;
            }
            pairs.copyAgentsTo(found);
            return found;
        }

        /**
         * Computes how two agents touch. If both were in the last search, it takes them as they were then. Otherwise it takes them as they are now.
         * The last search is a frame of the collider's Collision, or a call of <code>findCollisions</code>. While handlers run, and after them until
         * the next search, it is the frame's, even if a handler has called <code>findCollisions</code>. <code>reset()</code> and
         * <code>restore()</code> of the Collision forget it, and so does another Collision that begins to use the collider.
         *
         * <p>The ground and the edges of the world count as they are now. In a handler they count as the frame has seen them, also after a handler
         * has changed them. Only a model's pose counts at once.</p>
         *
         * @param collider the normal points to it
         * @param collidee another agent
         * @param out receives the contact; created if null
         * @return out. If the two do not touch, the point is half way between the points where they are nearest, the normal points from one of these
         *     points to the other, and the depth is 0
         * @throws ArgumentError if one is null, if both are the same agent, or if a model is unknown or still loading
         */
        override public function contactOf(collider:Agent, collidee:Agent, out:Contact = null):Contact
        {
            requireTwo(collider, collidee);
            return contactIn(contactSearch, collider, collidee, out || new Contact());
        }

        /** @private As contactOf, in one of the collider's searches. */
        engine function contactIn(inSearch:CollisionSearch, collider:Agent, collidee:Agent, contact:Contact):Contact
        {
            if (stateOfOwner != FrameRunner.HANDLING)
            {
                inSearch.table.environment.refresh();
            }
            inSearch.contacts.findContact(collider, collidee, _motion, _point);
            contact.setFromPoint(_point);
            contact.time = _motion.time;
            contact.approachSpeed = Math.max(0, -(_motion.x * _point.normalX + _motion.y * _point.normalY + _motion.z * _point.normalZ));
            return contact;
        }

        /**
         * @private Lets the frames of a Collision own the collider, as long as they use it. If they did not use it before, no agent has a motion then.
         *
         * @throws ArgumentError if another owns it
         */
        engine function attachTo(owner:FrameRunner):void
        {
            if (stateOfOwner == FrameRunner.UNUSED)
            {
                forgetMotions();
            }
            else if (_owner !== owner)
            {
                throw new ArgumentError("the collider belongs to another Collision, whose motions and contacts it keeps: give each Collision "
                        + "a collider of its own, or first exchange the collisionSystem of the other");
            }
            _owner = owner;
        }

        /** @private */
        override engine function forgetMotions():void
        {
            search.table.forgetMotionStarts();
        }

        /** @private */
        override engine function findPairs(input:SearchInput, reader:PairReader, counts:CollisionStatistics):FoundPairs
        {
            var pairs:FoundPairs = find(search, input);
            counts.copyFrom(_statistics);
            return pairs;
        }

        // What the last owner does with the collider. It is the owner unless that is UNUSED.
        private function get stateOfOwner():int
        {
            return _owner == null ? FrameRunner.UNUSED : _owner.stateWith(this);
        }

        private function find(inSearch:CollisionSearch, input:SearchInput):FoundPairs
        {
            var start:Number = getTimer();
            var pairs:FoundPairs = inSearch.find(input);
            if (stateOfOwner != FrameRunner.HANDLING)
            {
                contactSearch = inSearch;
            }
            _statistics.readSearch(inSearch, pairs);
            _statistics.findMs = getTimer() - start;
            return pairs;
        }

        /** @private Throws an ArgumentError if one of two agents is null, or they are the same. */
        engine static function requireTwo(a:Agent, b:Agent):void
        {
            if (a == null || b == null)
            {
                throw new ArgumentError("two agents are needed, not " + a + " and " + b);
            }
            if (a === b)
            {
                throw new ArgumentError("two different agents are needed, not twice " + a);
            }
        }
    }
}
