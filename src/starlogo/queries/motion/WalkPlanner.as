package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.copyVector;
    import starlogo.queries.Footing;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.WalkOptions;

    use namespace engine;

    /**
     * Goes a Walk, as a game character does. The agent slides along the ground. For this slide, surfaces that are too steep are walls. If a wall stops
     * the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground, or falls. The method
     * <code>go()</code> shows the order.
     *
     * <p>Steps take the walk to its next place, <code>Walk.place</code>, and return whether the agent stands there. Then the walk has the floor too. If the
     * agent does not stand after a method that begins with "try", the walk is where it was.</p>
     *
     * @private
     */
    public final class WalkPlanner
    {
        // Ground as steep as the limit is not too steep, although its normal has rounding errors. A fraction of the limit's cosine.
        private static const SLOPE_ROUNDING:Number = 1e-9;

        // A leg of a walk is as long as the agent, or longer if the walk would have more legs than this.
        private static const MAX_LEGS:int = 64;

        // Walk.closeDepth is this part of the extent, or this many slops if they are more: near what is far larger, and far from the origin. A walk ends a
        // clearance above the ground, and the shrunk body meets the ground up to ten slops farther down.
        private static const CLOSE_DEPTH:Number = 1e-6;
        private static const CLOSE_SLOPS:Number = 20;

        // The least way down of a fall with the slide after it. A shorter one is undone. A part of the extent.
        private static const MIN_FALL:Number = 1e-8;

        // The most pushes out of what the agent overlaps where a walk begins.
        private static const MAX_PUSHES:int = 8;

        private static const UP:Vector3D = new Vector3D(0, 0, 1);

        private var _seen:SeenAgents;
        private var _slider:Slider = new Slider();
        private var _recovery:OverlapRecovery = new OverlapRecovery();
        private var _platforms:PlatformCarry;
        private var _foothold:Foothold;

        // The motion and the limits of a step.
        private var _motion:Vector3D = new Vector3D();
        private var _limits:SlideLimits = new SlideLimits(-Infinity);

        // How a slide ended, and a way straight up or down. Each is returned, and valid until the next one of its kind.
        private var _slid:MotionResult = new MotionResult();
        private var _vertical:MotionResult = new MotionResult();

        /** @param seen has the rows */
        public function WalkPlanner(seen:SeenAgents)
        {
            _seen = seen;
            _platforms = new PlatformCarry(seen, _slider);
            _foothold = new Foothold(seen);
        }

        /**
         * Finds where a walk leads. A platform carries the agent first. Then it is pushed out of what it overlaps, goes the legs of its way, and falls if
         * it does not stand. Nothing moves.
         *
         * @param agent the agent that walks
         * @param dx how far along x
         * @param dy how far along y
         * @param options how it walks
         * @param out receives where the walk ends, and the footing there
         */
        public function go(agent:Agent, dx:Number, dy:Number, options:WalkOptions, out:Walk):void
        {
            var carrier:int = begin(agent, dx, dy, options, out);
            var stands:Boolean = walkLegs(out, standOrPushOut(out, carrier)) || fall(out);
            _recovery.restoreClearance(out.body, out.place);
            writeFooting(out, stands, out.footing);
        }

        // Begins a walk where the agent is, or where its platform carries it. Returns the platform's row; -1 if none carries it.
        private function begin(agent:Agent, dx:Number, dy:Number, options:WalkOptions, walk:Walk):int
        {
            _seen.requirePlaced(agent);
            walk.options.copyFrom(options);
            walk.walkableZ = (1 - SLOPE_ROUNDING) * Trigonometry.cosine(options.slopeDegrees);
            var length:Number = Math.sqrt(dx * dx + dy * dy);
            walk.legCount = Math.min(MAX_LEGS, Math.max(1, Math.ceil(length / agent.size)));
            walk.legMotion.setTo(dx / walk.legCount, dy / walk.legCount, 0);
            walk.legLength = length / walk.legCount;
            var platform:int = _platforms.find(agent, walk);
            walk.body.setToAgent(agent, walk.carryTurn).aim(dx, dy, 0);
            walk.place.copyFrom(walk.body.from);
            collectRows(walk, 0);
            if (platform >= 0)
            {
                _platforms.carry(walk, platform);
            }
            return platform;
        }

        // Writes how the agent stands where the walk has ended. The push and the part of the way are written already.
        private function writeFooting(walk:Walk, stands:Boolean, out:Footing):void
        {
            var agents:Vector.<Agent> = _seen.table.listed.agentsByRow;
            out.stands = stands;
            out.on = stands ? agents[walk.floorRow] : null;
            out.against = walk.wallRow >= 0 ? agents[walk.wallRow] : null;
            copyVector(stands ? walk.floorNormal : UP, out.normal);
        }

        // Finds the rows near a walk, and up to a distance from it, and how close to them it stands.
        private function collectRows(walk:Walk, distance:Number):void
        {
            var options:WalkOptions = walk.options;
            var body:MovingBody = walk.body;
            // the way on the steepest slope, how far a slide after a fall goes sideways, and the way of the platform, whatever their directions
            var range:Number = walk.legCount * walk.legLength / walk.walkableZ + depthAfterFall(walk) / 2 + walk.carry.length + distance;
            range += closeDepthAmong(walk, body.boundOfExtents);
            body.collectRowsWithin(range, walk.legCount * options.stepHeight, walk.legCount * options.snap + options.fall, options.filter);
            walk.closeDepth = closeDepthAmong(walk, body.largestExtent);
        }

        // How close a walk stands to rows of at most this extent.
        private static function closeDepthAmong(walk:Walk, largest:Number):Number
        {
            return Math.max(CLOSE_DEPTH * walk.body.extent, CLOSE_SLOPS * walk.body.maxSlop(walk.legLength, largest));
        }

        // Pushes the agent out of what it overlaps. Returns whether it stands then.
        private function standOrPushOut(walk:Walk, carrier:int):Boolean
        {
            walk.legStart.copyFrom(walk.place);
            var risen:Number = riseWithPlatforms(walk, carrier);
            var down:MotionResult = moveVertically(walk, walk.place, -walk.closeDepth);
            var isOverlapping:Boolean = down.hasPlanes;
            if (isOverlapping)
            {
                pushOut(walk, risen);
            }
            var x:Number = walk.place.x - walk.legStart.x;
            var y:Number = walk.place.y - walk.legStart.y;
            var z:Number = walk.place.z - walk.legStart.z;
            walk.footing.pushed = Math.sqrt(x * x + y * y + z * z);
            walk.legStart.copyFrom(walk.place);
            return isOverlapping ? tryStandBelow(walk, walk.place, walk.closeDepth) : tryStandAtEnd(walk, down);
        }

        // Leads the agent up with one-way rows that have risen into it since it was moved, if there is room. Returns how far they have.
        private function riseWithPlatforms(walk:Walk, carrier:int):Number
        {
            var height:Number = _recovery.measureRise(walk.body, walk.place, carrier);
            if (height > 0)
            {
                collectRows(walk, height);
                walk.place.copyFrom(moveVertically(walk, walk.place, height).place);
            }
            return height;
        }

        // Pushes the agent out of what it overlaps deeply. The deepest overlap comes first. A push is a slide, so it leads through nothing else. All pushes
        // together are as long as the depths of all overlaps at the beginning.
        // The agent has risen so far before.
        private function pushOut(walk:Walk, risen:Number):void
        {
            var left:Number = _recovery.measureOverlaps(walk.body, walk.place, walk.deepestOverlap);
            if (!(left > 0))
            {
                return;
            }
            collectRows(walk, risen + left);
            var pushes:int = 0;
            do
            {
                var length:Number = Math.min(left, walk.deepestOverlap.depth);
                left -= length;
                _motion.setTo(0, 0, 0);
                walk.deepestOverlap.movePoint(_motion, length);
                _slider.slide(walk.body, walk.body.rows, walk.place, _motion, SlideLimits.NONE, _slid);
                walk.place.copyFrom(_slid.place);
                pushes++;
            }
            while (pushes < MAX_PUSHES && left > 0 && _recovery.measureOverlaps(walk.body, walk.place, walk.deepestOverlap) > 0);
        }

        // Goes all legs: along the ground if the agent stands, else straight on through the air. Returns whether it stands at the end.
        private function walkLegs(walk:Walk, beginsStanding:Boolean):Boolean
        {
            var stands:Boolean = beginsStanding;
            var startX:Number = walk.legStart.x;
            var startY:Number = walk.legStart.y;
            walk.wallRow = -1;
            for (var i:int = 0; i < walk.legCount; i++)
            {
                if (i > 0)
                {
                    walk.legStart.copyFrom(walk.place);
                    // beyond a gap there may be ground again
                    stands ||= beginsStanding && tryStandBelow(walk, walk.place, walk.closeDepth);
                }
                if (stands)
                {
                    stands = walkOnGround(walk);
                }
                else
                {
                    // in the air all surfaces are walls, except of level floors
                    endLeg(walk, slideAlong(walk, walk.legStart, 0, SlideLimits.LEVEL_Z));
                }
            }
            var dx:Number = walk.place.x - startX;
            var dy:Number = walk.place.y - startY;
            walk.footing.part = walk.legLength > 0 ? Math.min(1, Math.sqrt(dx * dx + dy * dy) / (walk.legCount * walk.legLength)) : 1;
            return stands;
        }

        // Goes a leg along the ground, and up or down with it. If a wall stops the agent there, it tries to step up. Otherwise it steps down to the ground.
        // Returns whether it stands then.
        private function walkOnGround(walk:Walk):Boolean
        {
            if (walk.legLength == 0)
            {
                // it stays exactly where it is
                walk.place.copyFrom(walk.legStart);
                return true;
            }
            // the slide begins along the ground below the agent
            var normal:Vector3D = walk.floorNormal;
            var rise:Number = -(normal.x * walk.legMotion.x + normal.y * walk.legMotion.y) / normal.z;
            var wallBefore:int = walk.wallRow;
            var slid:MotionResult = slideAlong(walk, walk.place, rise, walk.walkableZ);
            endLeg(walk, slid);
            if (slid.wallRow >= 0 && tryStepUp(walk))
            {
                walk.wallRow = wallBefore;
                return true;
            }
            // the ground may have led up only for a part of the leg: on a ramp, and over the edge of a step
            var height:Number = Math.max(0, walk.place.z - walk.legStart.z);
            return tryStandBelow(walk, walk.place, height + walk.options.snap + walk.closeDepth);
        }

        // Ends a leg where its slide ended.
        private static function endLeg(walk:Walk, slid:MotionResult):void
        {
            walk.place.copyFrom(slid.place);
            if (slid.wallRow >= 0)
            {
                walk.wallRow = slid.wallRow;
            }
        }

        // Tries a leg again a step higher, and goes down again. Returns whether the agent comes farther than without the step, and stands.
        private function tryStepUp(walk:Walk):Boolean
        {
            var up:MotionResult = moveVertically(walk, walk.legStart, walk.options.stepHeight);
            var height:Number = up.place.z - walk.legStart.z;
            if (height <= walk.closeDepth)
            {
                return false;
            }
            var slid:MotionResult = slideAlong(walk, up.place, 0, walk.walkableZ);
            if (!isFarther(walk, slid.place))
            {
                return false;
            }
            var depth:Number = height + walk.options.snap + walk.closeDepth;
            var top:Number = slid.place.z;
            var down:MotionResult = moveVertically(walk, slid.place, -depth);
            return tryStandAtEnd(walk, down) || (down.hasContact && trySlideOff(walk, down.place, depth - (top - down.place.z)));
        }

        // Whether a place is farther along the leg than where the walk is.
        private static function isFarther(walk:Walk, place:Vector3D):Boolean
        {
            var farther:Number = (place.x - walk.place.x) * walk.legMotion.x + (place.y - walk.place.y) * walk.legMotion.y;
            return farther > walk.closeDepth * walk.legLength;
        }

        // Slides down what is too steep to stand on, from the end of the way down: a round agent that has met the edge of the next step hangs on it. Returns
        // whether the agent comes farther than without the step, but no farther from where the leg began than the leg is long, and stands.
        private function trySlideOff(walk:Walk, from:Vector3D, depth:Number):Boolean
        {
            var place:Vector3D = slideDown(walk, from, depth, walk.legLength).place;
            var dx:Number = place.x - walk.legStart.x;
            var dy:Number = place.y - walk.legStart.y;
            return dx * dx + dy * dy <= walk.legLength * walk.legLength && isFarther(walk, place) && tryStandBelow(walk, place, walk.closeDepth);
        }

        // Falls until something stops the agent, and slides down what is too steep. It falls in drops that get longer, because rounding
        // errors grow with the length of a motion. If nothing stops an endless fall, it ends where it began. Returns whether the agent stands then. While its
        // model is loading it does not fall.
        private function fall(walk:Walk):Boolean
        {
            if (!walk.body.hasShape)
            {
                return false;
            }
            var left:Number = walk.options.fall;
            var place:Vector3D = walk.place;
            var isStopped:Boolean = false;
            var down:MotionResult = null;
            for (var drop:Number = 1; left > 0 && !isStopped; drop *= 2)
            {
                var depth:Number = Math.min(left, drop);
                if (place.z - depth < -Agent.LARGEST_COORDINATE)
                {
                    return false;
                }
                down = moveVertically(walk, place, -depth);
                left -= down.fraction * depth;
                isStopped = down.hasContact;
                place = down.place;
            }
            if (!isStopped)
            {
                // a fall can also end where the ground begins, without being stopped
                walk.place.copyFrom(place);
                return tryStandBelow(walk, walk.place, walk.closeDepth);
            }
            if (tryStandOn(walk, down, place))
            {
                return true;
            }
            var depthAfter:Number = depthAfterFall(walk);
            var slid:MotionResult = slideDown(walk, place, Math.min(left, depthAfter), depthAfter / 2);
            if (!(walk.place.z - slid.place.z < MIN_FALL * walk.body.extent))
            {
                walk.place.copyFrom(slid.place);
            }
            return tryStandBelow(walk, walk.place, walk.closeDepth);
        }

        // How far down the slide after a fall may lead. Sideways it may lead half as far.
        private static function depthAfterFall(walk:Walk):Number
        {
            return Math.min(walk.options.fall, walk.body.whole.placement.size);
        }

        // Lets the agent stand on the ground below a place, if the ground is no deeper than this depth, and not too steep. Otherwise the agent stays where it
        // is. Returns whether it stands.
        private function tryStandBelow(walk:Walk, place:Vector3D, depth:Number):Boolean
        {
            return tryStandAtEnd(walk, moveVertically(walk, place, -depth));
        }

        // Lets the agent stand where a way down has ended, on what has stopped it or on what else it touches there. Otherwise the agent stays where it is.
        // Returns whether it stands.
        private function tryStandAtEnd(walk:Walk, down:MotionResult):Boolean
        {
            if (!down.hasContact || tryStandOn(walk, down, down.place))
            {
                return down.hasContact;
            }
            var slid:MotionResult = slideDown(walk, down.place, walk.closeDepth, walk.body.extent);
            return slid.hasContact && tryStandOn(walk, slid, down.place);
        }

        // Lets the agent stand at a place, on the row that a motion has met there, if the row carries it. Returns whether it does.
        private function tryStandOn(walk:Walk, met:MotionResult, place:Vector3D):Boolean
        {
            if (!_foothold.findSurface(walk, met.contact, met.row, place, walk.floorNormal))
            {
                return false;
            }
            walk.place.copyFrom(place);
            walk.floorRow = met.row;
            return true;
        }

        // Goes straight up, or down if dz is less than 0, until something is in the way.
        private function moveVertically(walk:Walk, from:Vector3D, dz:Number):MotionResult
        {
            _motion.setTo(0, 0, dz);
            _slider.moveStraight(walk.body, walk.body.rows, from, _motion, _vertical);
            return _vertical;
        }

        // Slides along the way of a leg, and up or down.
        private function slideAlong(walk:Walk, from:Vector3D, rise:Number, leastFloorZ:Number):MotionResult
        {
            _limits.setWalls(leastFloorZ, walk.legLength);
            _motion.setTo(walk.legMotion.x, walk.legMotion.y, rise);
            _slider.slide(walk.body, walk.body.rows, from, _motion, _limits, _slid);
            return _slid;
        }

        // Slides down like a fall, as long as what it slides on is too steep to stand on.
        private function slideDown(walk:Walk, from:Vector3D, depth:Number, maxHorizontal:Number):MotionResult
        {
            _limits.setFall(Math.sqrt(1 - walk.walkableZ * walk.walkableZ) / walk.walkableZ, maxHorizontal);
            _motion.setTo(0, 0, -depth);
            _slider.slide(walk.body, walk.body.rows, from, _motion, _limits, _slid);
            return _slid;
        }
    }
}
