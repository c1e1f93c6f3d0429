package starlogo.collision
{
    import starlogo.broadphase.AgentProxy;
    import starlogo.engine;
    import starlogo.geometry.Placement;

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

        /** The search that had it in its bins last. */
        public var binnedIn:int = -1;

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
         * Finds the way since then, puts the extents around all of it, and remembers that the agent was seen where it is now.
         *
         * @param search the search before this one
         */
        public function takeWay(search:int):void
        {
            var place:Placement = placement;
            var toX:Number = place.x;
            var toY:Number = place.y;
            var toZ:Number = place.z;
            x = shape.x;
            y = shape.y;
            z = shape.z;
            halfX = shape.halfX;
            halfY = shape.halfY;
            halfZ = shape.halfZ;
            wayX = wayY = wayZ = 0;
            isSweeping = false;
            if (seenIn == search && _lastModel == shape.model && agent.jumpRevision <= _lastRevision)
            {
                isSweeping = agent.sweeps;
                wayX = toX - _lastX;
                wayY = toY - _lastY;
                wayZ = toZ - _lastZ;
                x -= wayX / 2;
                y -= wayY / 2;
                z -= wayZ / 2;
                var half:Number = wayX < 0 ? -wayX : wayX;
                halfX += half / 2;
                half = wayY < 0 ? -wayY : wayY;
                halfY += half / 2;
                half = wayZ < 0 ? -wayZ : wayZ;
                halfZ += half / 2;
            }
            seenIn = search + 1;
            _lastX = toX;
            _lastY = toY;
            _lastZ = toZ;
            _lastModel = shape.model;
            _lastRevision = shape.revision;
        }
    }
}
