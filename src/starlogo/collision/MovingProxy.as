package starlogo.collision
{
    import starlogo.broadphase.AgentProxy;
    import starlogo.engine;

    use namespace engine;

    /** An agent's shape on its way: a proxy for all of that, where it was in the frame before, and whether it sweeps. */
    internal final class MovingProxy extends AgentProxy
    {
        /** What moves, where it is now. */
        public var shape:WorldShape;

        /** The way since the frame before; 0 where there is none. */
        public var wayX:Number = 0;

        /** @copy #wayX */
        public var wayY:Number = 0;

        /** @copy #wayX */
        public var wayZ:Number = 0;

        /** Whether it sweeps, and has a way. */
        public var isSweeping:Boolean = false;

        /** The search that saw it last; it counts those that sweep, and what comes between two of them. */
        public var seenIn:int = -1;

        private var _lastX:Number = 0;
        private var _lastY:Number = 0;
        private var _lastZ:Number = 0;
        private var _lastModel:String = null;
        private var _lastRevision:int = -1;

        /**
         * @param shape what moves
         */
        public function MovingProxy(shape:WorldShape)
        {
            super(shape.agent, shape.cacheToken);
            this.shape = shape;
        }

        /** Remembers that the shape was seen where it was computed last. */
        public function noteShape(search:int):void
        {
            seenIn = search;
            _lastX = shape.x - shape.offsetX;
            _lastY = shape.y - shape.offsetY;
            _lastZ = shape.z - shape.offsetZ;
            _lastModel = shape.model;
            _lastRevision = shape.revision;
        }

        /**
         * Finds the way since then, and puts the extents around all of it.
         *
         * @param search the search before this one
         */
        public function takeWay(search:int):void
        {
            var hasWay:Boolean = seenIn == search && _lastModel == shape.model && agent.jumpRevision <= _lastRevision;
            wayX = hasWay ? placement.x - _lastX : 0;
            wayY = hasWay ? placement.y - _lastY : 0;
            wayZ = hasWay ? placement.z - _lastZ : 0;
            isSweeping = hasWay && agent.sweeps;
            x = shape.x - wayX / 2;
            y = shape.y - wayY / 2;
            z = shape.z - wayZ / 2;
            halfX = shape.halfX + Math.abs(wayX) / 2;
            halfY = shape.halfY + Math.abs(wayY) / 2;
            halfZ = shape.halfZ + Math.abs(wayZ) / 2;
        }

        /** Remembers where the agent is now. */
        public function notePlace(search:int):void
        {
            seenIn = search;
            _lastX = placement.x;
            _lastY = placement.y;
            _lastZ = placement.z;
            _lastModel = shape.model;
            _lastRevision = shape.revision;
        }
    }
}
