// This room is what a game calls: a Collision finds who touches, once a frame, and calls handlers. Its FrameRunner shows the steps of a frame:
// 1. HandlerTable (in the room handlers) takes the handlers as they are now. SearchInput asks the game's filter who takes part.
// 2. Collider, the base of the collision systems, searches for the pairs: CollisionSearch, in the room search. In its place BaseCollider asks a
// system of the game's own, and PairReader reads what that has found.
// 3. HandlerDispatcher lets FrameContacts compute the contacts that handlers take. It calls handlers for ended touches (TouchTracker), then for pairs.
// Snapshots (snapshots/) goes back to earlier frames. Read this file first, then FrameRunner, Collider, HandlerDispatcher, and CollisionSearch.
package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;
    import starlogo.agents.Breeds;
    import starlogo.collision.snapshots.Snapshots;
    import starlogo.data.requireGiven;
    import starlogo.data.textOf;
    import starlogo.engine;
    import starlogo.handlers.CollisionHandler;
    import starlogo.handlers.HandlerTable;
    import starlogo.search.BreedInterests;
    import starlogo.search.EnvironmentAgent;
    import starlogo.search.NarrowPhase;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.WorldBounds;

    use namespace engine;

    /**
     * Finds the collisions of a game once a frame, and calls the handlers of the agents' breeds, as the client's block "on collision with" does
     * (thesis §3.7, §6.1).
     *
     * <p>All pairs of a frame are known before the first handler runs. A handler may do anything to the game. If it moves or adds agents, this
     * counts from the next frame on. If it removes an agent from the list, no further handler of this frame is called for it, unless the agent is
     * back in the list before the next of these calls. If a handler throws, the others are still called. Then update throws the first error, and
     * <code>handlerErrors</code> has all of them.</p>
     *
     * <p>If an agent sweeps (<code>Agent.sweeps</code>), the pairs come by the time at which their motions make them touch. So a handler can stop a
     * paintball at its first touch by removing it from the list.</p>
     *
     * <p>In a pair, the handlers of the agent that is first in the list run first: those for starts, then the others, each in the order in which they
     * were added. The two agents' breeds count as they are when the calls of the pair begin.</p>
     *
     * <p>Any number of Collisions may share agents. A handler of one Collision may update another. But each Collision needs a collider of its own,
     * because a collider keeps the agents' positions of the last frame. The time for the calls is in proportion to the number of agents and
     * calls. If a handler removes an agent from the list, or gives it another place in it, this costs one search of the list.</p>
     */
    public class Collision extends QuerySource
    {
        /** Stands for any breed in place of a breed's name (§6.1, "any other agent"). */
        public static const ANY_BREED:String = BreedInterests.ANY_BREED;

        /**
         * Stands for the ground in place of a breed's name. A handler for it gets <code>terrain.agent</code>. ANY_BREED does not stand for
         * the ground. No other agent may have this breed.
         */
        public static const TERRAIN:String = Breeds.TERRAIN;

        /**
         * The ground, or null for none. Agents collide with it if their breeds have handlers together with <code>TERRAIN</code>. Other
         * agents cost nothing. You may exchange the ground. If the filter or a handler does so, this counts from the next frame on. The ground
         * needs one of the engine's collision systems.
         */
        public var terrain:Terrain = null;

        /**
         * Stands for the edges of the world in place of a breed's name. A handler for them gets <code>bounds.agent</code>, and a contact
         * whose normal points into the world. ANY_BREED does not stand for them. No other agent may have this breed.
         */
        public static const EDGE:String = Breeds.EDGE;

        /**
         * The edges of the world, or null for none. Agents collide with them if their breeds have handlers together with <code>EDGE</code>.
         * Other agents cost nothing. You may exchange the edges, as the ground. They need one of the engine's collision systems.
         */
        public var bounds:WorldBounds = null;

        /**
         * Decides which agents take part: an AgentFilter, or null for all. Other agents cost no tests and collide with nothing, as if they
         * were not in the list. But when such an agent takes part again, its motion begins where the last frame saw it. The filter is asked
         * once a frame about each agent, before anything is tested. If it throws an error, the frame ends, and no handler runs.
         */
        public var filter:AgentPredicate = null;

        // The collision system as the game has given it.
        private var _givenSystem:CollisionSystem;

        private var _handlers:HandlerTable = new HandlerTable();
        private var _frames:FrameRunner = new FrameRunner(_handlers);
        private var _snapshots:Snapshots = new Snapshots();

        /**
         * Creates a Collision without handlers.
         *
         * @param collisionSystem decides which agents collide
         * @throws ArgumentError as the property collisionSystem does
         */
        public function Collision(collisionSystem:CollisionSystem)
        {
            this.collisionSystem = collisionSystem;
        }

        /**
         * Decides which agents collide. It may be exchanged between frames; a handler may exchange it for the next frame. A collider belongs to
         * this Collision until it is exchanged, whether it is the system itself or inside a BaseCollider. Motions begin anew with
         * another collider: agents that sweep do so from its second frame on.
         *
         * @throws ArgumentError if it is null, or if its collider belongs to another Collision. Nothing has changed then
         */
        public function get collisionSystem():CollisionSystem
        {
            return _givenSystem;
        }

        public function set collisionSystem(value:CollisionSystem):void
        {
            requireGiven("collisionSystem", value);
            var next:BaseCollider = BaseCollider.wrap(value);
            if (next.innerCollider != null)
            {
                next.innerCollider.attachTo(_frames);
            }
            _givenSystem = value;
            _frames.nextSystem = next;
        }

        /** Counts and times of the last frame. The next frame overwrites them. */
        public function get statistics():CollisionStatistics
        {
            return _frames.statistics;
        }

        /**
         * The list of the last update as it was when the update began, before handlers changed it. It is empty before the first update. Pass it to
         * <code>restore()</code>. Do not change it. The next update overwrites it, so copy it to keep it. An update that refuses its list leaves it.
         */
        public function get lastAgents():Vector.<Agent>
        {
            return _frames.lastFrame.agents;
        }

        /**
         * The errors that handlers threw in the last frame, in order. The next frame empties the list, even if it refuses its agents. If a handler throws
         * something else, it becomes the message of an Error. At the end of each message stand the breeds for which the handler was added: those of
         * the last one, if handlers throw the same object.
         */
        public function get handlerErrors():Vector.<Error>
        {
            return _frames.handlerErrors;
        }

        /**
         * The breeds that the handlers of the last frame name and that none of its agents has now. One of them may be misspelt. A handler that you add or
         * remove after that frame counts from the next one on. Before the first frame, and after <code>reset()</code>, there are none. TERRAIN is
         * among them without a <code>terrain</code>, and EDGE without <code>bounds</code>.
         */
        public function get breedsWithoutAgents():Vector.<String>
        {
            return _handlers.breedsWithout(lastAgents.concat(new <Agent>[ground, edges]));
        }

        /** The counts of its last frame, as text. */
        public function toString():String
        {
            return "Collision: " + statistics;
        }

        /**
         * Adds a function that is called in every frame for each agent of a breed that collides with an agent of another breed.
         *
         * <p>Within one breed, the handler is called twice for a pair: as (a, b) and as (b, a). A handler added while handlers run is called from
         * the next frame on.</p>
         *
         * @param breed the breed of the collider, the agent whose handler it is; ANY_BREED for all agents
         * @param otherBreed the breed of the collidee, the agent it collides with; ANY_BREED for any other agent
         * @param handler <code>function(collider:Agent, collidee:Agent):void</code>, or with a third argument,
         *     <code>contact:Contact</code>. The engine computes contacts only for handlers that take them. A parameter counts whether it has
         *     a default value or not. A handler <code>function(...all):void</code> gets the two agents. A handler that takes no arguments
         *     at all passes here, but Adobe's player throws an ArgumentError when it is called, so a line is traced if none has a name
         * @throws ArgumentError if one is null, a breed has no name, or each breed is TERRAIN or EDGE. In Flash also if the handler has one parameter,
         *     or more than three
         */
        public function onCollision(breed:String, otherBreed:String, handler:Function):void
        {
            _handlers.add(breed, otherBreed, handler, CollisionHandler.EVERY_FRAME);
        }

        /**
         * Adds a handler for the first frame of a touch. It is called before the handlers of onCollision, and not again while the two touch.
         *
         * <p>A touch begins again when one of the two has changed its breed, and when the first handler for starts or ends of these breeds is
         * added.</p>
         *
         * @param breed as in onCollision
         * @param otherBreed as in onCollision
         * @param handler as in onCollision
         * @throws ArgumentError as in onCollision
         */
        public function onCollisionStart(breed:String, otherBreed:String, handler:Function):void
        {
            _handlers.add(breed, otherBreed, handler, CollisionHandler.START);
        }

        /**
         * Adds a handler for the end of a touch. It is called in the first frame in which the two no longer touch. A touch also ends when one of
         * the two was removed from the list, when the collision system no longer finds the pair, and when one has changed its breed. The handler
         * is called for the breeds that the two had when the touch began.
         *
         * <p>Ends come before all other calls of a frame, in the order in which the touches began. The handlers are called for the same
         * directions as those for starts. One of the two agents, or both, may have left the list. If the ground or the edges were exchanged since the
         * touch began, the handler gets the agent of the former ones. Its place may not be known any more, so do not ask how or whether it touches.</p>
         *
         * @param breed as in onCollision
         * @param otherBreed as in onCollision
         * @param handler <code>function(collider:Agent, collidee:Agent):void</code>. There is no contact any more: a third argument would be null
         * @throws ArgumentError as in onCollision
         */
        public function onCollisionEnd(breed:String, otherBreed:String, handler:Function):void
        {
            _handlers.add(breed, otherBreed, handler, CollisionHandler.END);
        }

        /**
         * Removes a handler of onCollision, onCollisionStart or onCollisionEnd. If it was added several times, the first of them is removed. A
         * removed handler is not called again, not even in this frame.
         *
         * @param breed as in onCollision
         * @param otherBreed as in onCollision
         * @param handler the same function
         * @param kind "collision", "start" or "end": by which of the three methods it was added; null for any of them
         * @return whether it was there
         * @throws ArgumentError if one of the first three is null, a breed has no name, or there is no such kind
         */
        public function removeHandler(breed:String, otherBreed:String, handler:Function, kind:String = null):Boolean
        {
            return _handlers.remove(breed, otherBreed, handler, CollisionHandler.phasesNamed(kind));
        }

        /**
         * Removes all handlers and forgets the last frame, so all touches and motions begin again in the next. The collision system, the ground,
         * the edges and the filter stay. If a handler calls reset, no further handler runs in this frame.
         */
        public function reset():void
        {
            _handlers.clear();
            _frames.reset();
        }

        /**
         * Runs one frame: finds every pair that has handlers, then calls them.
         *
         * @param agents the agents of the game; a handler may change this list, in place. Another list in the client's variable, as from
         *     <code>agents = agents.filter(...)</code>, counts from the next frame on
         * @throws ArgumentError if an agent is null or listed twice, or its model is not known; no handler has then run
         * @throws RangeError if a structure is out of the world; no handler has then run
         * @throws IllegalOperationError if called from a handler of its own or from the filter, or if the system knows no terrain and there is one
         * @throws Error the first error that a handler threw, after all handlers have run
         */
        public function update(agents:Vector.<Agent>):void
        {
            _frames.requireNoFrame("update");
            requireGiven("agents", agents);
            _frames.run(agents, ground, edges, filter);
        }

        /**
         * Writes down what the next frame needs of the last one: where it saw the agents of its list, which of them touch, and what they stand on.
         * <code>restore()</code> goes back to that frame, in this Collision or in another with the same handlers and a collision system of the
         * same kind. The bytes name agents by their indices in <code>lastAgents</code>. So keep a copy of that list.
         *
         * @param withTraits whether the agents' traits are written too, as they are now: place, turn, size, shape, breed, colour,
         *     <code>sweeps</code>, <code>hierarchical</code>, <code>traversalDepth</code>, <code>collideAs</code> and <code>isOneWay</code>.
         *     Otherwise the game keeps them
         * @param withGround whether the heights of the ground are written. Without them <code>restore()</code> leaves the ground as it is
         * @return the bytes, about 25 for each agent of the list, 79 for its traits, and 17 for each pair that touches and has handlers for starts
         *     or ends
         * @throws IllegalOperationError if called from a handler or the filter, if the collision system is not one of the engine's or has searched
         *     another list since the last frame, or if the last frame refused its list or failed because a contact could not be computed. Before
         *     any frame has taken a list, the snapshot is that of no agents
         */
        public function snapshot(withTraits:Boolean = false, withGround:Boolean = true):ByteArray
        {
            return _snapshots.write(_frames.lastFrame, engineCollider("snapshot").search, ground, edges, withTraits, withGround);
        }

        /**
         * Goes back to the frame of a snapshot, and gives the agents the traits that are in it. The next frames then find the same pairs and make
         * the same calls as the frames after the snapshot, to the last bit. No handler is called.
         *
         * @param bytes the result of <code>snapshot()</code>; not changed
         * @param agents the list <code>lastAgents</code> of that frame. They may be other objects, created since then, or for another
         *     Collision. If the snapshot is without traits, the game has put the agents' traits back
         * @throws ArgumentError if one is null, if the bytes are no snapshot of these agents or are of another kind of collision system, or if
         *     <code>update()</code> would refuse the list; nothing has changed then
         * @throws RangeError if a structure is out of the world; nothing has changed then
         * @throws IllegalOperationError as in snapshot
         */
        public function restore(bytes:ByteArray, agents:Vector.<Agent>):void
        {
            var collider:Collider = engineCollider("restore");
            requireGiven("bytes", bytes);
            requireGiven("agents", agents);
            _snapshots.restore(bytes, agents, collider.search, ground, edges, _frames.lastFrame);
            collider.contactSearch = collider.search;
        }

        /** @private The system of the frame under way, which a handler may have exchanged for the next one; or else the collision system. */
        engine function get systemOfFrame():BaseCollider
        {
            return _frames.system;
        }

        /** @private */
        override engine function findNarrowPhase():NarrowPhase
        {
            return _frames.nextSystem.findNarrowPhase();
        }

        /** @private */
        override engine function get collisionOfGround():Collision
        {
            return this;
        }

        // The engine's collider for a snapshot.
        private function engineCollider(what:String):Collider
        {
            _frames.requireNoFrame(what);
            var collider:Collider = _frames.nextSystem.samePairsCollider;
            if (collider == null)
            {
                throw new IllegalOperationError(what + " needs one of the engine's collision systems, not " + textOf(_givenSystem, "a Collider"));
            }
            return collider;
        }

        private function get ground():EnvironmentAgent
        {
            return terrain == null ? null : terrain.environmentAgent;
        }

        private function get edges():EnvironmentAgent
        {
            return bounds == null ? null : bounds.environmentAgent;
        }
    }
}
