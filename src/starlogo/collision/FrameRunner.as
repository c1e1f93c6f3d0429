package starlogo.collision
{
    import flash.errors.IllegalOperationError;
    import flash.utils.getTimer;
    import starlogo.agents.Agent;
    import starlogo.agents.AgentPredicate;
    import starlogo.agents.copyAgents;
    import starlogo.engine;
    import starlogo.ground.HeightGrid;
    import starlogo.handlers.HandlerTable;
    import starlogo.search.EnvironmentAgent;
    import starlogo.search.FoundPairs;
    import starlogo.search.PairReader;
    import starlogo.search.SearchInput;

    use namespace engine;

    /** Runs the frames of a Collision: finds the pairs, and calls their handlers. It knows what the frame under way does with a collider. */
    internal final class FrameRunner
    {
        // What frames do with a collider. While they search, they call findCollisions of the collider, or of a system around it. While handlers run,
        // contacts stay those of the frame.

        /** They do not use the collider. */
        public static const UNUSED:int = 0;

        /** They use the collider, but neither search nor run handlers now: between frames, and while the filter runs. */
        public static const IDLE:int = 1;

        /** The frame under way searches for its pairs. */
        public static const SEARCHING:int = 2;

        /** The handlers of the frame under way run. */
        public static const HANDLING:int = 3;

        /** The collision system of the next frame. */
        public var nextSystem:BaseCollider = null;

        /** What the frame under way searches among. Read only. */
        public var input:SearchInput = new SearchInput();

        /** What is kept of the last frame. */
        public var lastFrame:LastFrame = new LastFrame();

        /** Counts and times of the last frame. Read only. */
        public var statistics:CollisionStatistics = new CollisionStatistics();

        /** The errors that handlers threw in the last frame. Read only. */
        public var handlerErrors:Vector.<Error> = new Vector.<Error>();

        private var _handlers:HandlerTable;
        private var _dispatcher:HandlerDispatcher;
        private var _pairReader:PairReader = new PairReader();

        // The collision system of the frame under way, or null; and what the frame does with it: IDLE, SEARCHING or HANDLING.
        private var _system:BaseCollider = null;
        private var _state:int = IDLE;

        // The heights that handlers see, even if they change the ground; null if none run, or without ground. The edges never change.
        private var _heldGround:HeightGrid = null;

        /** @param handlers the handlers of the frames */
        public function FrameRunner(handlers:HandlerTable)
        {
            _handlers = handlers;
            _dispatcher = new HandlerDispatcher(handlers);
        }

        /** The system of the frame under way, which a handler may have exchanged for the next one; or else the next frame's. */
        public function get system():BaseCollider
        {
            return _system || nextSystem;
        }

        /** What frames do with a collider: UNUSED, IDLE, SEARCHING or HANDLING. */
        public function stateWith(collider:Collider):int
        {
            if (collider === system.innerCollider)
            {
                return _state;
            }
            return collider === nextSystem.innerCollider ? IDLE : UNUSED;
        }

        /** Throws an IllegalOperationError if a frame is under way. @param what the method that was called */
        public function requireNoFrame(what:String):void
        {
            if (_system != null)
            {
                throw new IllegalOperationError(what + " must not be called from a handler, or from the filter");
            }
        }

        /** Forgets the last frame, so all touches and motions begin again. */
        public function reset():void
        {
            lastFrame = new LastFrame();
            nextSystem.forgetMotions();
            system.forgetMotions();
        }

        /**
         * Runs a frame. What the filter or a handler exchanges counts from the next frame on.
         *
         * @param agents the game's own list, which handlers may change
         * @param ground the ground, or null
         * @param edges the edges of the world, or null
         * @param filter decides which agents take part; null if all do
         * @throws Error as <code>Collision.update()</code> does, the first error of a handler too
         */
        public function run(agents:Vector.<Agent>, ground:EnvironmentAgent, edges:EnvironmentAgent, filter:AgentPredicate):void
        {
            var start:Number = getTimer();
            var frameSystem:BaseCollider = nextSystem;
            handlerErrors.length = 0;
            _system = frameSystem;
            try
            {
                _handlers.begin(agents);
                input.begin(agents, _handlers.interests, ground, edges, filter);
                findAndCall(agents);
            }
            finally
            {
                _dispatcher.endFrame();
                _state = IDLE;
                _system = null;
                releaseGround();
            }
            statistics.frameMs = getTimer() - start;
            frameSystem.onFrame(statistics);
            if (handlerErrors.length > 0)
            {
                throw handlerErrors[0];
            }
        }

        // Finds the pairs of the frame, and calls their handlers.
        private function findAndCall(agents:Vector.<Agent>):void
        {
            // after the filter, which may have called reset(). A handler may call it too, and then the frame goes on with the one before
            var frame:LastFrame = lastFrame;
            frame.search = null;
            _state = SEARCHING;
            var pairs:FoundPairs = _system.findPairs(input, _pairReader, statistics);
            _state = HANDLING;
            frame.agents = copyAgents(input.agents, frame.agents);
            if (input.ground != null)
            {
                _heldGround = input.ground.surface.grid;
                _heldGround.hold();
            }
            statistics.handlerCalls = _dispatcher.callHandlers(pairs, _system, frame.tracker, agents, handlerErrors);
            var searched:Collider = _system.samePairsCollider;
            frame.search = searched == null ? null : searched.search;
        }

        private function releaseGround():void
        {
            if (_heldGround != null)
            {
                _heldGround.release();
                _heldGround = null;
            }
        }
    }
}
