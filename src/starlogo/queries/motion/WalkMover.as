package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.agents.PlatformLink;
    import starlogo.convex.ContactPoint;
    import starlogo.queries.SeenAgents;
    import starlogo.queries.WalkOptions;

    /**
     * Goes a Walk, as a game character does. The agent slides along the ground. For this slide, surfaces that are too steep are walls. If a wall stops
     * the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground, or falls. The method
     * <code>go()</code> shows the order.
     *
     * <p>Steps take the walk to its next place, <code>Walk.place</code>, and return whether the agent stands there. Then the walk has the floor too. If the
     * agent does not stand after <code>stepUp()</code>, or a method that begins with "stand", the walk is where it was.</p>
     *
     * @private
     */
    public final class WalkMover
    {
        // Walk.closeDepth, as a part of the extent.
        private static const CLOSE_DEPTH:Number = 1e-6;

        // The least way down of a fall with the slide after it. A shorter one is undone. A part of the extent.
        private static const MIN_FALL:Number = 1e-8;

        // The most pushes out of what the agent overlaps where a walk begins.
        private static const MAX_PUSHES:int = 8;

        private var _slider:Slider = new Slider();
        private var _recovery:OverlapRecovery = new OverlapRecovery();
        private var _platforms:PlatformCarry;
        private var _foothold:Foothold;

        // The motion and the limits of a step.
        private var _motion:Vector3D = new Vector3D();
        private var _limits:SlideLimits = new SlideLimits();

        // How steps end: a slide, a slide that is only tried, and a way straight up or down.
        private var _slid:SlideResult = new SlideResult();
        private var _tried:SlideResult = new SlideResult();
        private var _vertical:MotionResult = new MotionResult();

        // Where a fall has come.
        private var _fallen:Vector3D = new Vector3D();

        /** @param seen has the rows */
        public function WalkMover(seen:SeenAgents)
        {
            _platforms = new PlatformCarry(seen, _slider);
            _foothold = new Foothold(seen);
        }

        /**
         * Goes a walk. A platform carries the agent first. Then it is pushed out of what it overlaps, goes the legs of its way, and falls if it does not
         * stand.
         *
         * @param link the agent, and what it stood on after its last walk
         * @param walk has the options and the way. It receives where it ends, how far the agent was pushed, and which part of the motion it
         *     has made
         * @return whether the agent stands at the end
         */
        public function go(link:PlatformLink, walk:Walk):Boolean
        {
            begin(link, walk);
            var stands:Boolean = walkLegs(walk, recover(walk)) || fall(walk);
            _recovery.restoreClearance(walk.body, walk.place);
            return stands;
        }

        // Begins a walk where the agent is, or where its platform carries it.
        private function begin(link:PlatformLink, walk:Walk):void
        {
            var platform:int = _platforms.find(link, walk);
            walk.body.setToAgent(link.agent, walk.carryTurn);
            walk.place.copyFrom(walk.body.from);
            walk.closeDepth = CLOSE_DEPTH * walk.body.extent;
            collectRows(walk, 0);
            if (platform >= 0)
            {
                _platforms.carry(walk, platform);
            }
        }

        // Finds the rows near a walk, and up to a distance from it.
        private static function collectRows(walk:Walk, distance:Number):void
        {
            var options:WalkOptions = walk.options;
            // the way on the steepest slope, how far a slide after a fall goes sideways, and the way of the platform, whatever their directions
            var range:Number = walk.legCount * walk.legLength / walk.walkableZ + widthAfterFall(walk) + walk.carry.length;
            walk.body.collectRowsWithin(range + distance, walk.legCount * options.stepHeight, walk.legCount * options.snap + options.fall, options.filter);
        }

        // Pushes the agent out of what it overlaps. Returns whether it stands then.
        private function recover(walk:Walk):Boolean
        {
            walk.legStart.copyFrom(walk.place);
            walk.footing.pushed = 0;
            moveVertically(walk, walk.place, -walk.closeDepth, _vertical);
            if (!_vertical.hasPlanes)
            {
                return standAtEnd(walk, _vertical);
            }
            pushOut(walk);
            var x:Number = walk.place.x - walk.legStart.x;
            var y:Number = walk.place.y - walk.legStart.y;
            var z:Number = walk.place.z - walk.legStart.z;
            walk.footing.pushed = Math.sqrt(x * x + y * y + z * z);
            walk.legStart.copyFrom(walk.place);
            return standBelow(walk, walk.place, walk.closeDepth);
        }

        // Pushes the agent out of what it overlaps deeply. The deepest overlap comes first. A push is a slide, so it leads through nothing else. All pushes
        // together are as long as the depths of all overlaps at the beginning.
        private function pushOut(walk:Walk):void
        {
            var left:Number = _recovery.measureOverlaps(walk.body, walk.place, walk.deepest);
            if (!(left > 0))
            {
                return;
            }
            collectRows(walk, left);
            var pushes:int = 0;
            do
            {
                var length:Number = Math.min(left, walk.deepest.depth);
                left -= length;
                _motion.setTo(0, 0, 0);
                walk.deepest.movePoint(_motion, length);
                _slider.slide(walk.body, walk.body.rows, walk.place, _motion, SlideLimits.NONE, _slid);
                walk.place.copyFrom(_slid.place);
                pushes++;
            }
            while (pushes < MAX_PUSHES && left > 0 && _recovery.measureOverlaps(walk.body, walk.place, walk.deepest) > 0);
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
                    stands ||= beginsStanding && standBelow(walk, walk.place, walk.closeDepth);
                }
                if (stands)
                {
                    stands = walkOnGround(walk);
                }
                else
                {
                    // in the air all surfaces are walls, except of level floors
                    slideAlong(walk, walk.legStart, 0, SlideLimits.LEVEL_Z, _slid);
                    endLeg(walk);
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
            slideAlong(walk, walk.place, rise, walk.walkableZ, _slid);
            if (_slid.wallRow >= 0 && stepUp(walk, _slid.place))
            {
                return true;
            }
            endLeg(walk);
            // the ground may have led up only for a part of the leg: on a ramp, and over the edge of a step
            var height:Number = Math.max(0, walk.place.z - walk.legStart.z);
            return standBelow(walk, walk.place, height + walk.options.snap + walk.closeDepth);
        }

        // Ends a leg where its slide ended.
        private function endLeg(walk:Walk):void
        {
            walk.place.copyFrom(_slid.place);
            if (_slid.wallRow >= 0)
            {
                walk.wallRow = _slid.wallRow;
            }
        }

        // Tries a leg again a step higher, and goes down again. Returns whether the agent comes farther than to a place without the step, and stands.
        private function stepUp(walk:Walk, plain:Vector3D):Boolean
        {
            moveVertically(walk, walk.legStart, walk.options.stepHeight, _vertical);
            var height:Number = _vertical.place.z - walk.legStart.z;
            if (height <= walk.closeDepth)
            {
                return false;
            }
            slideAlong(walk, _vertical.place, 0, walk.walkableZ, _tried);
            if (!isFarther(walk, _tried.place, plain))
            {
                return false;
            }
            var depth:Number = height + walk.options.snap + walk.closeDepth;
            var top:Number = _tried.place.z;
            moveVertically(walk, _tried.place, -depth, _vertical);
            return standAtEnd(walk, _vertical) || (_vertical.isStopped && slideOff(walk, _vertical.place, depth - (top - _vertical.place.z), plain));
        }

        // Whether a place is farther along the leg than another one.
        private static function isFarther(walk:Walk, place:Vector3D, other:Vector3D):Boolean
        {
            var farther:Number = (place.x - other.x) * walk.legMotion.x + (place.y - other.y) * walk.legMotion.y;
            return farther > walk.closeDepth * walk.legLength;
        }

        // Slides down what is too steep to stand on: a round agent that has met the edge of the next step hangs on it. Returns whether the agent comes
        // farther than to a place without the step, but no farther from where the leg began than the leg is long, and stands.
        private function slideOff(walk:Walk, from:Vector3D, depth:Number, plain:Vector3D):Boolean
        {
            slideDown(walk, from, depth, walk.legLength, _tried);
            var dx:Number = _tried.place.x - walk.legStart.x;
            var dy:Number = _tried.place.y - walk.legStart.y;
            return dx * dx + dy * dy <= walk.legLength * walk.legLength && isFarther(walk, _tried.place, plain)
                && standBelow(walk, _tried.place, walk.closeDepth);
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
            var isStopped:Boolean = false;
            _fallen.copyFrom(walk.place);
            for (var drop:Number = 1; left > 0 && !isStopped; drop *= 2)
            {
                var depth:Number = Math.min(left, drop);
                if (_fallen.z - depth < -Agent.LARGEST_COORDINATE)
                {
                    return false;
                }
                moveVertically(walk, _fallen, -depth, _vertical);
                left -= _vertical.time * depth;
                isStopped = _vertical.isStopped;
                _fallen.copyFrom(_vertical.place);
            }
            if (!isStopped)
            {
                // a fall can also end where the ground begins, without being stopped
                walk.place.copyFrom(_fallen);
                return standBelow(walk, walk.place, walk.closeDepth);
            }
            if (standOn(walk, _vertical.contact, _vertical.row, _fallen))
            {
                return true;
            }
            slideDown(walk, _fallen, Math.min(left, depthAfterFall(walk)), widthAfterFall(walk), _slid);
            if (!(walk.place.z - _slid.place.z < MIN_FALL * walk.body.extent))
            {
                walk.place.copyFrom(_slid.place);
            }
            return standBelow(walk, walk.place, walk.closeDepth);
        }

        // How far down the slide after a fall may lead.
        private static function depthAfterFall(walk:Walk):Number
        {
            return Math.min(walk.options.fall, walk.body.whole.placement.size);
        }

        // How far sideways the slide after a fall may lead.
        private static function widthAfterFall(walk:Walk):Number
        {
            return depthAfterFall(walk) / 2;
        }

        // Lets the agent stand on the ground below a place, if the ground is no deeper than this depth, and not too steep. Otherwise the agent stays where it
        // is. Returns whether it stands.
        private function standBelow(walk:Walk, place:Vector3D, depth:Number):Boolean
        {
            moveVertically(walk, place, -depth, _vertical);
            return standAtEnd(walk, _vertical);
        }

        // Lets the agent stand where a way down has ended, on what has stopped it or on what else it touches there. Otherwise the agent stays where it is.
        // Returns whether it stands.
        private function standAtEnd(walk:Walk, down:MotionResult):Boolean
        {
            var stands:Boolean = down.isStopped && standOn(walk, down.contact, down.row, down.place);
            if (stands || !down.isStopped)
            {
                return stands;
            }
            slideDown(walk, down.place, walk.closeDepth, walk.body.extent, _tried);
            return _tried.hasFloor && standOn(walk, _tried.floor, _tried.floorRow, down.place);
        }

        // Lets the agent stand at a place, on a row that it touches there, if the row carries it.
        private function standOn(walk:Walk, contact:ContactPoint, row:int, place:Vector3D):Boolean
        {
            if (!_foothold.findSurface(walk, contact, row, place, walk.floorNormal))
            {
                return false;
            }
            walk.place.copyFrom(place);
            walk.floorRow = row;
            return true;
        }

        // Goes straight up, or down if dz is less than 0, until something is in the way.
        private function moveVertically(walk:Walk, from:Vector3D, dz:Number, out:MotionResult):void
        {
            _motion.setTo(0, 0, dz);
            _slider.moveStraight(walk.body, walk.body.rows, from, _motion, out);
        }

        // Slides along the way of a leg, and up or down.
        private function slideAlong(walk:Walk, from:Vector3D, rise:Number, walkableZ:Number, out:SlideResult):void
        {
            _limits.setWalls(walkableZ, walk.legLength);
            _motion.setTo(walk.legMotion.x, walk.legMotion.y, rise);
            _slider.slide(walk.body, walk.body.rows, from, _motion, _limits, out);
        }

        // Slides down like a fall, as long as what it slides on is too steep to stand on.
        private function slideDown(walk:Walk, from:Vector3D, depth:Number, maxHorizontal:Number, out:SlideResult):void
        {
            _limits.setFall(Math.sqrt(1 - walk.walkableZ * walk.walkableZ) / walk.walkableZ, maxHorizontal);
            _motion.setTo(0, 0, -depth);
            _slider.slide(walk.body, walk.body.rows, from, _motion, _limits, out);
        }
    }
}
