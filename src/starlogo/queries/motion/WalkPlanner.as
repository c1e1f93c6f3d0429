package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.queries.NestedPool;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.WalkOptions;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Computes a walk, as a game character does. The agent slides along the ground. For this slide, surfaces that are too steep are walls. If a wall stops
     * the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground, or falls. The method
     * <code>plan()</code> shows the order.
     *
     * <p>A walk is a WalkState, which each method takes on to its next place and floor. A method that begins with "try", here or in FloorFinder, returns
     * whether the agent stands then. If it does not, the walk is as it was.</p>
     *
     * @private
     */
    public final class WalkPlanner
    {
        // Ground as steep as the limit is not too steep, although its normal has rounding errors. A fraction of the limit's cosine.
        private static const SLOPE_ROUNDING:Number = 1e-9;

        // A substep of a walk is as long as the agent, or longer if the walk would have more substeps than this.
        private static const MAX_SUBSTEPS:int = 64;

        // WalkState.maxFloorDistance is this part of the extent, or this many slops if they are more: near what is far larger, and far from the origin. A walk
        // ends a clearance above the ground, and the shrunk body meets the ground up to ten slops farther down.
        private static const FLOOR_DISTANCE:Number = 1e-6;
        private static const FLOOR_SLOPS:Number = 20;

        // The least way down of a fall with the slide after it. A shorter one is undone. A part of the extent.
        private static const MIN_FALL:Number = 1e-8;

        // The most pushes out of what the agent overlaps where a walk begins.
        private static const MAX_PUSHES:int = 8;

        // The walk of a question.
        private var _walkPool:NestedPool;

        private var _near:NearRows;
        private var _slider:Slider;
        private var _platforms:PlatformCarry;
        private var _floorFinder:FloorFinder;

        // A push or the motion of a substep, within one call.
        private var _motion:Vector3D = new Vector3D();

        // The contact of the deepest overlap.
        private var _deepest:ContactPoint = new ContactPoint();

        /**
         * @param seen has the rows
         * @param near finds the rows near its way
         * @param slider moves the agent
         * @param platforms carries and lifts the agent
         */
        public function WalkPlanner(seen:SeenAgents, near:NearRows, slider:Slider, platforms:PlatformCarry)
        {
            _near = near;
            _slider = slider;
            _walkPool = new NestedPool(seen, WalkState);
            _platforms = platforms;
            _floorFinder = new FloorFinder(seen, slider);
        }

        /**
         * Finds where a walk leads. A platform carries the agent first. Then it is pushed out of what it overlaps, goes the substeps of its way, and falls if
         * it does not stand. Nothing moves.
         *
         * @param agent the agent that walks
         * @param dx how far along x
         * @param dy how far along y
         * @param options how it walks
         * @return where the walk ends, and how it came there: valid until the next walk that is nested as deep
         */
        public function plan(agent:Agent, dx:Number, dy:Number, options:WalkOptions):WalkState
        {
            var walk:WalkState = WalkState(_walkPool.current);
            begin(agent, dx, dy, options, walk);
            pushOut(walk);
            walkSubsteps(walk);
            if (!walk.stands)
            {
                fall(walk);
            }
            _slider.depenetration.restoreClearance(walk.body, walk.place);
            return walk;
        }

        // Begins a walk where the agent is, or where its platform carries it.
        private function begin(agent:Agent, dx:Number, dy:Number, options:WalkOptions, walk:WalkState):void
        {
            var body:MovingBody = walk.body.setToAgent(agent).aim(dx, dy, 0);
            walk.options.copyFrom(options);
            walk.minFloorNormalZ = (1 - SLOPE_ROUNDING) * Trigonometry.cosine(options.slopeDegrees);
            var length:Number = Math.sqrt(dx * dx + dy * dy);
            walk.substepCount = Math.min(MAX_SUBSTEPS, Math.max(1, Math.ceil(length / agent.size)));
            walk.substepMotion.setTo(dx / walk.substepCount, dy / walk.substepCount, 0);
            walk.substepLength = length / walk.substepCount;
            walk.floorRow = walk.wallRow = -1;
            _platforms.find(agent, walk);
            body.turn(walk.carryTurn);
            walk.place.copyFrom(body.from);
            collectRows(walk, 0);
            if (walk.platformRow >= 0)
            {
                _platforms.carry(walk);
            }
        }

        // Finds the rows near a walk, and up to a distance from it, and how far below the agent its floor may be.
        private function collectRows(walk:WalkState, distance:Number):void
        {
            var options:WalkOptions = walk.options;
            var body:MovingBody = walk.body;
            // the way on the steepest slope, how far a slide after a fall goes sideways, and the way of the platform, whatever their directions
            var range:Number = walk.substepCount * walk.substepLength / walk.minFloorNormalZ + maxSlideDepth(walk) / 2 + walk.carry.length + distance;
            range += maxFloorDistanceAmong(walk, _near.extentBoundFor(body));
            _near.findWithin(body, range, walk.substepCount * options.stepHeight, walk.substepCount * options.snap + options.fall, options.filter);
            walk.maxFloorDistance = maxFloorDistanceAmong(walk, body.largestExtentAmong(body.rows));
        }

        // How far below the agent its floor may be, among rows of at most this extent.
        private function maxFloorDistanceAmong(walk:WalkState, largest:Number):Number
        {
            return Math.max(FLOOR_DISTANCE * walk.body.extent, FLOOR_SLOPS * _near.maxSlop(walk.body, walk.substepLength, largest));
        }

        // Pushes the agent out of what it overlaps, and lets it stand if there is a floor.
        private function pushOut(walk:WalkState):void
        {
            walk.substepStart.copyFrom(walk.place);
            var lift:Number = liftByPlatforms(walk);
            var down:MotionResult = _slider.moveVertically(walk.body, walk.place, -walk.maxFloorDistance);
            if (down.startsPenetrating)
            {
                pushOutOfDeep(walk, lift);
                down = _slider.moveVertically(walk.body, walk.place, -walk.maxFloorDistance);
            }
            // not Vector3D.distance(), which makes an object in some players
            _motion.copyFrom(walk.place);
            _motion.decrementBy(walk.substepStart);
            walk.pushed = _motion.length;
            walk.substepStart.copyFrom(walk.place);
            _floorFinder.tryStandAtEnd(walk, down);
        }

        // Lifts the agent with one-way rows that have risen into it, if there is room. Returns how far they lead.
        private function liftByPlatforms(walk:WalkState):Number
        {
            var lift:Number = _platforms.findLift(walk);
            if (lift > 0)
            {
                collectRows(walk, lift);
                walk.place.copyFrom(_slider.moveVertically(walk.body, walk.place, lift).place);
            }
            return lift;
        }

        // Pushes the agent out of what it overlaps deeply. The deepest overlap comes first. A push is a slide, so it leads through nothing else. All pushes
        // together are as long as the depths of all overlaps at the beginning. Platforms have lifted the agent before.
        private function pushOutOfDeep(walk:WalkState, lift:Number):void
        {
            var depenetration:Depenetration = _slider.depenetration;
            var left:Number = depenetration.measureOverlaps(walk.body, walk.place, _deepest);
            if (left > 0)
            {
                // the filter's accepts may walk another agent, so the overlaps are measured again
                collectRows(walk, lift + left);
            }
            for (var i:int = 0; i < MAX_PUSHES && left > 0 && depenetration.measureOverlaps(walk.body, walk.place, _deepest) > 0; i++)
            {
                var length:Number = Math.min(left, _deepest.depth);
                left -= length;
                _motion.setTo(0, 0, 0);
                _deepest.movePoint(_motion, length);
                walk.place.copyFrom(_slider.slide(walk.body, walk.body.rows, walk.place, _motion).place);
            }
        }

        // Goes all substeps: along the ground where the agent stands, else through the air.
        private function walkSubsteps(walk:WalkState):void
        {
            var startX:Number = walk.substepStart.x;
            var startY:Number = walk.substepStart.y;
            var beginsStanding:Boolean = walk.stands;
            for (var i:int = 0; i < walk.substepCount; i++)
            {
                if (i > 0)
                {
                    walk.substepStart.copyFrom(walk.place);
                }
                // beyond a gap there may be ground again
                if (walk.stands || (beginsStanding && _floorFinder.tryStandBelow(walk, walk.place)))
                {
                    walkOnGround(walk);
                }
                else
                {
                    walkInAir(walk);
                }
            }
            var dx:Number = walk.place.x - startX;
            var dy:Number = walk.place.y - startY;
            walk.part = walk.substepLength > 0 ? Math.min(1, Math.sqrt(dx * dx + dy * dy) / (walk.substepCount * walk.substepLength)) : 1;
        }

        // Goes a substep along the ground, and up or down with it. If a wall stops the agent there, it tries to step up. Otherwise it steps down to the ground,
        // or stands no more.
        private function walkOnGround(walk:WalkState):void
        {
            if (walk.substepLength == 0)
            {
                // it stays exactly where it is
                walk.place.copyFrom(walk.substepStart);
                return;
            }
            // the slide begins along the ground below the agent
            var normal:Vector3D = walk.floorNormal;
            var slopeZ:Number = -(normal.x * walk.substepMotion.x + normal.y * walk.substepMotion.y) / normal.z;
            var wallBefore:int = walk.wallRow;
            var slid:MotionResult = slideOnFloors(walk, walk.place, slopeZ);
            endSubstep(walk, slid);
            if (slid.wallRow < 0 || !tryStepUp(walk, wallBefore))
            {
                // the ground may have led up only for a part of the substep: on a ramp, and over the edge of a step
                _floorFinder.tryStandBelow(walk, walk.place, Math.max(0, walk.place.z - walk.substepStart.z) + walk.options.snap);
            }
        }

        // Goes a substep through the air, where all surfaces are walls, except of horizontal floors. The agent keeps its height.
        private function walkInAir(walk:WalkState):void
        {
            var slid:MotionResult = _slider.slideLevel(walk.body, walk.substepStart, walk.substepMotion, walk.substepLength);
            endSubstep(walk, slid);
            if (slid.startsPenetrating && slid.fraction == 0)
            {
                // what wedges the agent may lead it up, but not down
                slid = _slider.slide(walk.body, walk.body.rows, walk.substepStart, walk.substepMotion);
                if (slid.place.z > walk.place.z)
                {
                    endSubstep(walk, slid);
                }
            }
        }

        // Takes a walk to where the slide of a substep ended. Whether the agent stands there is not known yet.
        private static function endSubstep(walk:WalkState, slid:MotionResult):void
        {
            walk.floorRow = -1;
            walk.place.copyFrom(slid.place);
            walk.wallRow = slid.wallRow >= 0 ? slid.wallRow : walk.wallRow;
        }

        // Tries a substep again a step higher, and goes down again. Returns whether the agent comes farther than without the step, and stands. Then the last
        // wall is one that it met there, or the one before the substep.
        private function tryStepUp(walk:WalkState, wallBefore:int):Boolean
        {
            var up:MotionResult = _slider.moveVertically(walk.body, walk.substepStart, walk.options.stepHeight);
            var height:Number = up.place.z - walk.substepStart.z;
            if (height <= walk.maxFloorDistance)
            {
                return false;
            }
            var slid:MotionResult = slideOnFloors(walk, up.place, 0);
            if (!isFarther(walk, slid.place))
            {
                return false;
            }
            var upperWall:int = slid.wallRow;
            var depth:Number = height + walk.options.snap + walk.maxFloorDistance;
            var top:Number = slid.place.z;
            var down:MotionResult = _slider.moveVertically(walk.body, slid.place, -depth);
            if (_floorFinder.tryStandAtEnd(walk, down) || (down.hasContact && trySlideOff(walk, down.place, depth - (top - down.place.z))))
            {
                walk.wallRow = upperWall >= 0 ? upperWall : wallBefore;
                return true;
            }
            return false;
        }

        // Whether a place is farther along the substep than where the walk is.
        private static function isFarther(walk:WalkState, place:Vector3D):Boolean
        {
            var farther:Number = (place.x - walk.place.x) * walk.substepMotion.x + (place.y - walk.place.y) * walk.substepMotion.y;
            return farther > walk.maxFloorDistance * walk.substepLength;
        }

        // Slides down what is too steep to stand on, from the end of the way down: a round agent that has met the edge of the next step hangs on it. Returns
        // whether the agent comes farther than without the step, but no farther from where the substep began than the substep is long, and stands.
        private function trySlideOff(walk:WalkState, from:Vector3D, depth:Number):Boolean
        {
            var end:Vector3D = _slider.slideDown(walk.body, from, depth, walk.minFloorNormalZ, walk.substepLength).place;
            var dx:Number = end.x - walk.substepStart.x;
            var dy:Number = end.y - walk.substepStart.y;
            return dx * dx + dy * dy <= walk.substepLength * walk.substepLength && isFarther(walk, end) && _floorFinder.tryStandBelow(walk, end);
        }

        // Falls until something stops the agent, and slides down what is too steep. If nothing stops an endless fall, it ends where it began. While the
        // agent's model is loading it does not fall.
        private function fall(walk:WalkState):void
        {
            if (!walk.body.hasShape)
            {
                return;
            }
            // It goes in drops that get longer, because rounding errors grow with the length of a motion. It goes no farther than to where it is below all that is
            // near: walls of the ground have no lower end, and a very long wall would have errors as large as a floor.
            var depthLeft:Number = depthBelowAll(walk);
            var fallLeft:Number = walk.options.fall;
            var from:Vector3D = walk.place;
            for (var drop:Number = 1; fallLeft > 0 && depthLeft > 0; drop *= 2)
            {
                var depth:Number = Math.min(fallLeft, Math.min(drop, depthLeft));
                var down:MotionResult = _slider.moveVertically(walk.body, from, -depth);
                // the touch counts, not the clearance before it
                fallLeft -= down.fraction * depth;
                depthLeft -= depth;
                if (down.hasContact)
                {
                    settle(walk, down, fallLeft);
                    return;
                }
                from = down.place;
            }
            if (fallLeft < Infinity)
            {
                walk.place.setTo(from.x, from.y, from.z - fallLeft);
                // a fall can also end where the ground begins, without being stopped
                _floorFinder.tryStandBelow(walk, walk.place);
            }
        }

        // How far down the agent is below all rows near its walk. From there on, only walls of the ground are left.
        private static function depthBelowAll(walk:WalkState):Number
        {
            var body:MovingBody = walk.body;
            var lowest:Number = Infinity;
            for (var i:int = 0; i < body.rows.count; i++)
            {
                var other:Body = body.bodyOf(body.rows.values[i]);
                lowest = Math.min(lowest, other.kind == ModelShape.GROUND ? other.shape.grid.pyramid.whole.min : other.middleZ - other.halfZ);
            }
            return Math.max(body.extent, walk.place.z + body.fullBody.offsetZ + body.extent - lowest);
        }

        // Lets the agent stand on what has stopped its fall. If that is too steep, it slides down there, at most as far as it may still fall.
        private function settle(walk:WalkState, stop:MotionResult, fallLeft:Number):void
        {
            if (_floorFinder.tryStandOn(walk, stop, stop.place))
            {
                return;
            }
            var depth:Number = maxSlideDepth(walk);
            var end:Vector3D = _slider.slideDown(walk.body, stop.place, Math.min(fallLeft, depth), walk.minFloorNormalZ, depth / 2).place;
            if (!(walk.place.z - end.z < MIN_FALL * walk.body.extent))
            {
                walk.place.copyFrom(end);
            }
            _floorFinder.tryStandBelow(walk, walk.place);
        }

        // How far down the slide after a fall may lead. Sideways it may lead half as far.
        private static function maxSlideDepth(walk:WalkState):Number
        {
            return Math.min(walk.options.fall, walk.body.fullBody.placement.size);
        }

        // Slides on floors along the way of a substep, and up or down.
        private function slideOnFloors(walk:WalkState, from:Vector3D, dz:Number):MotionResult
        {
            _motion.setTo(walk.substepMotion.x, walk.substepMotion.y, dz);
            return _slider.slideOnFloors(walk.body, from, _motion, walk.minFloorNormalZ, walk.substepLength);
        }
    }
}
