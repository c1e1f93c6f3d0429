package starlogo.collision
{
    import starlogo.agents.Agent;
    import starlogo.agents.AgentRecord;
    import starlogo.broadphase.AgentProxy;
    import starlogo.broadphase.Bins;
    import starlogo.broadphase.PairSink;
    import starlogo.engine;
    import starlogo.motion.Way;
    import starlogo.motion.pointPointTouch;

    use namespace engine;

    /**
     * A search in which somebody sweeps: the shapes go into bins with all of their ways, and pairs of which one sweeps are tested along
     * them. It has bins of its own, so that those of other frames stay as they are.
     *
     * <p>A way is in at most four bins, however long it is: those of a level that is wide enough. But it meets everybody in
     * a rectangle around it; whom it passes by, a few comparisons tell. So a frame costs time in proportion to the agents
     * and to the pairs whose rectangles overlap, which of long ways across a crowd are many.</p>
     */
    internal final class SweptSearch extends PairSink
    {
        /** The way of the first of two shapes of which one sweeps, relative to the other, once <code>firstOverlap()</code> was asked. */
        public var way:Way = new Way();

        /** The bins of these searches. */
        public var bins:Bins = new Bins();

        /** Shapes in them. */
        public var memberCount:int = 0;

        private var _strategy:ShapeStrategy;
        private var _interests:BreedInterests;

        // Numbers the searches; one that sweeps nobody, however often, counts as one.
        private var _search:int = 0;

        // Pairs that nobody cares about, tests of spheres, and pairs that were tested along their ways.
        private var _skippedPairs:int = 0;
        private var _spherePairs:int = 0;
        private var _sweptPairs:int = 0;

        // The pairs as they were found, and when they touch.
        private var _length:int = 0;
        private var _found:Vector.<WorldShape> = new Vector.<WorldShape>();
        private var _times:Vector.<Number> = new Vector.<Number>();
        private var _order:TimeOrder = new TimeOrder();

        // When the extents of a pair begin to overlap in those directions that were looked at, and cease to.
        private var _enters:Number;
        private var _leaves:Number;

        /**
         * @param strategy says what shapes agents have
         */
        public function SweptSearch(strategy:ShapeStrategy)
        {
            _strategy = strategy;
        }

        /** Whether anybody in a list sweeps. */
        public static function isNeeded(agents:Vector.<Agent>):Boolean
        {
            for (var i:int = agents.length - 1; i >= 0; i--)
            {
                var agent:Agent = agents[i];
                if (agent != null && agent.sweeps)
                {
                    return true;
                }
            }
            return false;
        }

        /** Remembers where the shapes are of a search that was none of these. */
        public function noteShapes(listed:Vector.<WorldShape>):void
        {
            _search++;
            for (var i:int = 0; i < listed.length; i++)
            {
                if (listed[i].level != null)
                {
                    motionOf(listed[i]).noteShape(_search);
                }
            }
        }

        /**
         * Finds the pairs that touch on their ways and that somebody cares about.
         *
         * @param listed the shapes, up to date
         * @param interests the pairs of breeds; null for all
         */
        public function find(listed:Vector.<WorldShape>, interests:BreedInterests):void
        {
            _interests = interests == null || interests.areAll ? null : interests;
            _length = _skippedPairs = _spherePairs = _sweptPairs = 0;
            var stayed:int = 0;
            var members:int = 0;
            bins.clear();
            for (var i:int = 0; i < listed.length; i++)
            {
                var shape:WorldShape = listed[i];
                if (shape.level == null)
                {
                    continue;
                }
                var motion:MovingProxy = shape.motion || motionOf(shape);
                motion.takeWay(_search);
                if (interests == null || shape.breedIndex >= 0)
                {
                    motion.breedIndex = shape.breedIndex;
                    bins.fit(motion);
                    bins.add(motion);
                    members++;
                    if (motion.binnedIn == _search)
                    {
                        stayed++;
                    }
                    motion.binnedIn = _search + 1;
                }
            }
            _search++;
            var somebodyLeft:Boolean = stayed < memberCount;
            memberCount = members;
            bins.findPairs(this, somebodyLeft);
            // those of other searches
            _found.length = _length;
            _order.sort(_times, _length >> 1);
        }

        /**
         * Hands the pairs over that were found, in the order of their times.
         *
         * @param agents takes them, or null
         * @param records takes their shapes, if that is null
         * @return how many agents or records they are
         */
        public function takePairs(agents:Vector.<Agent>, records:Vector.<AgentRecord>):int
        {
            var order:Vector.<int> = _order.order;
            for (var i:int = 0; i < _length; i++)
            {
                var shape:WorldShape = _found[int(2 * order[i >> 1] + (i & 1))];
                if (agents != null)
                {
                    agents[i] = shape.agent;
                }
                else
                {
                    records[i] = shape;
                }
            }
            return _length;
        }

        /** Lets go of the shapes of the last of these searches, before one that is none of them. */
        public function end():void
        {
            bins.clear();
            bins.findPairs(this);
            _found.length = _length = memberCount = 0;
        }

        /** Adds what the search did to statistics that have the strategy's counts. */
        public function countInto(statistics:CollisionStatistics):void
        {
            statistics.candidatePairs = bins.pairCount - _skippedPairs;
            statistics.sweptPairs = _sweptPairs;
            statistics.sphereSphereTests += _spherePairs;
        }

        /** @inheritDoc */
        override public function onCandidates(proxy:AgentProxy, others:Vector.<AgentProxy>, count:int):void
        {
            var motion:MovingProxy = proxy as MovingProxy;
            var shape:WorldShape = motion.shape;
            if (_interests != null)
            {
                var kept:int = _interests.keepThoseThatCount(motion, others, count);
                _skippedPairs += count - kept;
                count = kept;
            }
            for (var i:int = 0; i < count; i++)
            {
                // untyped, the cheapest of casts
                var untyped:* = others[i];
                var otherMotion:MovingProxy = untyped;
                var other:WorldShape = otherMotion.shape;
                var time:Number = firstOverlap(shape, other);
                if (time == Way.NEVER)
                {
                    continue;
                }
                // as the list has them
                var isLater:Boolean = shape.listIndex > other.listIndex;
                _found[_length] = isLater ? other : shape;
                _found[int(_length + 1)] = isLater ? shape : other;
                _times[_length >> 1] = time;
                _length += 2;
            }
        }

        /** Whether the last search, one of these, looked at two shapes along their ways. */
        public function isPairSwept(a:WorldShape, b:WorldShape):Boolean
        {
            return a.motion != null && b.motion != null && a.motion.seenIn == _search && b.motion.seenIn == _search
                && (a.motion.isSweeping || b.motion.isSweeping);
        }

        /** When two shapes overlap, along their ways if one of them sweeps: from 0 to 1, or Way.NEVER. */
        public function firstOverlap(a:WorldShape, b:WorldShape):Number
        {
            var motionA:MovingProxy = a.motion;
            var motionB:MovingProxy = b.motion;
            if (!motionA.isSweeping && !motionB.isSweeping)
            {
                return areOverlapping(a, b) ? 1 : Way.NEVER;
            }
            var x:Number = motionA.wayX - motionB.wayX;
            var y:Number = motionA.wayY - motionB.wayY;
            var z:Number = motionA.wayZ - motionB.wayZ;
            if (x == 0 && y == 0 && z == 0)
            {
                _sweptPairs++;
                way.endAfter(0, 0, 0);
                return areOverlapping(a, b) ? 0 : Way.NEVER;
            }
            if (a.isSphere && b.isSphere)
            {
                _sweptPairs++;
                _spherePairs++;
                way.endAfter(x, y, z);
                var dx:Number = a.x - b.x;
                var dy:Number = a.y - b.y;
                var dz:Number = a.z - b.z;
                var radii:Number = a.radius + b.radius;
                var time:Number = pointPointTouch(dx - x, dy - y, dz - z, x, y, z, radii);
                if (time == Way.NEVER && dx * dx + dy * dy + dz * dz <= radii * radii)
                {
                    // no rounding hides what stands there
                    return 1;
                }
                return time;
            }
            if (passEachOther(a, b, x, y, z))
            {
                return Way.NEVER;
            }
            _sweptPairs++;
            way.endAfter(x, y, z);
            return _strategy.firstOverlap(a, b, way);
        }

        private function areOverlapping(a:WorldShape, b:WorldShape):Boolean
        {
            if (a.isSphere && b.isSphere)
            {
                _spherePairs++;
                var dx:Number = a.x - b.x;
                var dy:Number = a.y - b.y;
                var dz:Number = a.z - b.z;
                var radii:Number = a.radius + b.radius;
                return dx * dx + dy * dy + dz * dz <= radii * radii;
            }
            var reach:Number = a.reachZ + b.reachZ;
            if (a.z - b.z > reach || b.z - a.z > reach)
            {
                return false;
            }
            return a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY && _strategy.overlaps(a, b);
        }

        // Whether the extents of two shapes, which now are where they are at the end of the way, never overlap in all directions at once.
        private function passEachOther(a:WorldShape, b:WorldShape, x:Number, y:Number, z:Number):Boolean
        {
            _enters = 0;
            _leaves = 1;
            return isGap(b.x - a.x, x, a.reachX + b.reachX) || isGap(b.y - a.y, y, a.reachY + b.reachY)
                || isGap(b.z - a.z, z, a.reachZ + b.reachZ);
        }

        // One direction: where b is from a at the end, and how far it has come down.
        private function isGap(at:Number, speed:Number, reach:Number):Boolean
        {
            at += speed;
            if (speed < 0)
            {
                speed = -speed;
                at = -at;
            }
            if (at < -reach || at - reach > _leaves * speed)
            {
                return true;
            }
            if (at > reach)
            {
                var enters:Number = (at - reach) / speed;
                if (enters > _enters)
                {
                    _enters = enters;
                }
            }
            if (at + reach < _leaves * speed)
            {
                _leaves = (at + reach) / speed;
            }
            return _enters > _leaves;
        }

        private static function motionOf(shape:WorldShape):MovingProxy
        {
            if (shape.motion == null)
            {
                shape.motion = new MovingProxy(shape);
            }
            return shape.motion;
        }
    }
}
