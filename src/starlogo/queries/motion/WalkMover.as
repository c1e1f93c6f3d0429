package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.convex.ContactPoint;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.queries.SeenAgents;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Goes a Walk, as a game character does. The agent slides along the ground. For this slide, surfaces that are too steep are walls. If a wall stops
     * the agent, it tries the same way a step higher, and goes down again. At the end it goes down to the ground, or falls. The method
     * <code>go()</code> shows the order.
     *
     * <p>Steps take the walk to its next place, <code>Walk.place</code>, and return whether the agent stands there.</p>
     *
     * @private
     */
    public final class WalkMover
    {
        // A fall, with the slide after it, is undone if it leads less far down. A part of the extent.
        private static const REST:Number = 1e-8;

        // A walk begins with this many pushes at most.
        private static const MOST_PUSHES:int = 8;

        private var _slider:Slider = new Slider();
        private var _foothold:Foothold;

        // How motions end: up or down, along the ground, and those that may be undone.
        private var _upright:SlideResult = new SlideResult();
        private var _along:SlideResult = new SlideResult();
        private var _tried:SlideResult = new SlideResult();

        // The vector and the limits of a motion, where a fall has come, the rows without the platform and where it carries the agent, and contacts of
        // overlaps: the deepest one, and another.
        private var _vector:Vector3D = new Vector3D();
        private var _limits:SlideLimits = new SlideLimits();
        private var _fallen:Vector3D = new Vector3D();
        private var _others:IntList = new IntList();
        private var _carried:Vector3D = new Vector3D();
        private var _deepest:ContactPoint = new ContactPoint();
        private var _overlap:ContactPoint = new ContactPoint();

        /** @param seen has the rows */
        public function WalkMover(seen:SeenAgents)
        {
            _foothold = new Foothold(seen);
        }

        /** Finds the rows near a walk, and up to a distance from it. */
        public function findNear(walk:Walk, distance:Number):void
        {
            // the range has the way in it, whatever its direction
            walk.body.findRowsWithin(walk.range + distance, walk.pieces * walk.options.stepHeight,
                    walk.pieces * walk.options.snap + walk.options.fall, walk.agent, walk.options.filter);
        }

        /**
         * Carries the agent with a platform, before its walk. The agent slides along others that are in its way, but not into the platform. The
         * platform has moved already, so only the rest of its way, which the agent misses, can lead into it.
         *
         * @param platform its row
         */
        public function carry(walk:Walk, platform:int):void
        {
            _others.copyFrom(walk.body.rows, platform);
            var part:Number = _slider.slide(walk.body, _others, walk.place, walk.carry, SlideLimits.NONE, _along);
            if (part < 1 && leadsIntoPlatform(walk, platform, _along.place))
            {
                _slider.goStraight(walk.body, _others, walk.place, walk.carry, _tried);
                if (!leadsIntoPlatform(walk, platform, _tried.place))
                {
                    _along.place.copyFrom(_tried.place);
                }
            }
            walk.place.copyFrom(_along.place);
        }

        // Whether the rest of the way that the platform carries the agent, from its end back to a place, leads into the platform.
        private function leadsIntoPlatform(walk:Walk, platform:int, place:Vector3D):Boolean
        {
            _carried.copyFrom(walk.place);
            _carried.incrementBy(walk.carry);
            _vector.copyFrom(place);
            _vector.decrementBy(_carried);
            return _slider.meets(walk.body, platform, _carried, _vector);
        }

        /**
         * Goes the walk: recovers from overlaps, then goes each piece, and falls if the agent does not stand. The agent goes a piece along the ground.
         * If a wall stops it there, it tries to step up. Otherwise it steps down to the ground. Without ground it goes through the air. The walk
         * receives how far the agent was pushed, and which part of the motion it has made.
         *
         * @return whether the agent stands at the end
         */
        public function go(walk:Walk):Boolean
        {
            var stands:Boolean = recover(walk);
            var beginsInAir:Boolean = !stands;
            var startX:Number = walk.start.x;
            var startY:Number = walk.start.y;
            for (var i:int = 0; i < walk.pieces; i++)
            {
                if (i > 0)
                {
                    walk.start.copyFrom(walk.place);
                    // beyond a gap there may be ground again
                    stands ||= !beginsInAir && goDown(walk, walk.closeDepth);
                }
                if (stands)
                {
                    stands = goOnGround(walk);
                }
                else
                {
                    // in the air all surfaces are walls, except of level floors
                    slide(walk, walk.start, 0, SlideLimits.LEVEL_Z, _along);
                    walk.place.copyFrom(_along.place);
                }
            }
            var dx:Number = walk.place.x - startX;
            var dy:Number = walk.place.y - startY;
            walk.part = walk.pieceLength > 0 ? Math.min(1, Math.sqrt(dx * dx + dy * dy) / (walk.pieces * walk.pieceLength)) : 1;
            stands ||= walk.body.hasShape && fall(walk);
            _slider.restoreClearance(walk.body, walk.place);
            return stands;
        }

        // Goes a piece along the ground, and up or down with it. Returns whether the agent stands then.
        private function goOnGround(walk:Walk):Boolean
        {
            if (walk.pieceLength == 0)
            {
                // it stays exactly where it is
                walk.place.copyFrom(walk.start);
                return true;
            }
            slide(walk, walk.place, riseOf(walk), walk.cosine, _along);
            if (_along.metWall && stepUp(walk, _along.place))
            {
                return true;
            }
            walk.place.copyFrom(_along.place);
            // the ground may have led up only for a part of the piece: on a ramp, and over the edge of a step
            var height:Number = Math.max(0, walk.place.z - walk.start.z);
            return goDown(walk, height + walk.options.snap + walk.closeDepth);
        }

        // Pushes the agent out of what it overlaps. Returns whether it stands then.
        private function recover(walk:Walk):Boolean
        {
            walk.start.copyFrom(walk.place);
            walk.pushed = 0;
            var stands:Boolean = goDown(walk, walk.closeDepth);
            if (!_upright.isDeep)
            {
                return stands;
            }
            walk.place.copyFrom(walk.start);
            walk.pushed = pushOut(walk);
            walk.start.copyFrom(walk.place);
            return goDown(walk, walk.closeDepth);
        }

        // Pushes the agent out of what it overlaps, the deepest overlap first. A push is a slide, so it leads through nothing else. Returns how far the
        // agent is then from where the walk began.
        private function pushOut(walk:Walk):Number
        {
            var left:Number = findDeepest(walk, _deepest);
            if (left > 0)
            {
                findNear(walk, left);
            }
            for (var i:int = 0; i < MOST_PUSHES && left > 0 && findDeepest(walk, _deepest) > 0; i++)
            {
                var length:Number = Math.min(left, _deepest.depth);
                left -= length;
                _vector.setTo(0, 0, 0);
                _deepest.push(_vector, length);
                _slider.slide(walk.body, walk.body.rows, walk.place, _vector, SlideLimits.NONE, _along);
                walk.place.copyFrom(_along.place);
            }
            _vector.copyFrom(walk.place);
            _vector.decrementBy(walk.start);
            return _vector.length;
        }

        // Finds the deepest overlap of the agent where it is. A shallow one does not count, nor one with a one-way row. A push along the contact's normal by
        // its depth leads a clearance out of the row. Returns the sum of the depths of all overlaps; 0 if there is none.
        private function findDeepest(walk:Walk, out:ContactPoint):Number
        {
            var body:MovingBody = walk.body;
            var rows:IntList = body.rows;
            var sum:Number = 0;
            out.depth = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var row:int = rows.numbers[i];
                if (body.isOneWay(row) || !body.coreTouches(row, walk.place) || body.findContact(row, walk.place, true, _overlap)
                        || !body.overlaps(row, walk.place))
                {
                    continue;
                }
                body.warnIfInside(row, _overlap);
                _overlap.depth += body.core.clearance;
                // the shortest way out of a tree may lead through a wall of the tree if it is longer than the way to the middle of the body
                if (body.bodyOf(row).form != ModelShape.TREE || _overlap.depth <= body.source.halfAlong(_overlap))
                {
                    sum += _overlap.depth;
                    if (_overlap.depth > out.depth)
                    {
                        out.copyFrom(_overlap);
                    }
                }
            }
            return sum;
        }

        // How far a piece leads up or down if it runs along the ground below the agent.
        private static function riseOf(walk:Walk):Number
        {
            return -(walk.floorNormal.x * walk.piece.x + walk.floorNormal.y * walk.piece.y) / walk.floorNormal.z;
        }

        // Tries a piece again a step higher, and goes down again. Returns whether the agent comes farther than to a place without the step, and stands.
        private function stepUp(walk:Walk, plain:Vector3D):Boolean
        {
            goUpright(walk, walk.start, walk.options.stepHeight);
            var height:Number = _upright.place.z - walk.start.z;
            if (height <= walk.closeDepth)
            {
                return false;
            }
            slide(walk, _upright.place, 0, walk.cosine, _tried);
            walk.place.copyFrom(_tried.place);
            var depth:Number = height + walk.options.snap + walk.closeDepth;
            return isFarther(walk, plain) && (goDown(walk, depth) || (slideOff(walk, depth) && isFarther(walk, plain)));
        }

        // Whether the agent is farther along the piece than another place.
        private static function isFarther(walk:Walk, other:Vector3D):Boolean
        {
            var farther:Number = (walk.place.x - other.x) * walk.piece.x + (walk.place.y - other.y) * walk.piece.y;
            return farther > walk.closeDepth * walk.pieceLength;
        }

        // Slides down what is too steep to stand on, where the way down from a step has ended: a round agent that has met the edge of the next step hangs
        // on it. Returns whether the agent stands then, and is no farther from where the piece began than the piece is long.
        private function slideOff(walk:Walk, depth:Number):Boolean
        {
            if (_upright.floorRow < 0)
            {
                return false;
            }
            slideDown(walk, _upright.place, depth - (walk.place.z - _upright.place.z), walk.pieceLength);
            walk.place.copyFrom(_tried.place);
            var dx:Number = walk.place.x - walk.start.x;
            var dy:Number = walk.place.y - walk.start.y;
            return dx * dx + dy * dy <= walk.pieceLength * walk.pieceLength && goDown(walk, walk.closeDepth);
        }

        // Slides along the way of a piece, and up or down.
        private function slide(walk:Walk, from:Vector3D, rise:Number, walkableZ:Number, out:SlideResult):void
        {
            _limits.setTo(walkableZ, walk.pieceLength, SlideLimits.NO_FALL);
            _vector.setTo(walk.piece.x, walk.piece.y, rise);
            _slider.slide(walk.body, walk.body.rows, from, _vector, _limits, out);
        }

        // Goes straight up, or down if dz is less than 0, until something is in the way. Returns the free part.
        private function goUpright(walk:Walk, from:Vector3D, dz:Number):Number
        {
            _vector.setTo(0, 0, dz);
            return _slider.goStraight(walk.body, walk.body.rows, from, _vector, _upright);
        }

        // Slides down like a fall, as long as what it slides on is too steep to stand on.
        private function slideDown(walk:Walk, from:Vector3D, depth:Number, maxHorizontal:Number):void
        {
            _limits.setTo(SlideLimits.NO_WALLS, maxHorizontal, Math.sqrt(1 - walk.cosine * walk.cosine) / walk.cosine);
            _vector.setTo(0, 0, -depth);
            _slider.slide(walk.body, walk.body.rows, from, _vector, _limits, _tried);
        }

        // Goes down to the ground if it is no deeper than this depth, and not too steep. Otherwise the agent stays.
        private function goDown(walk:Walk, depth:Number):Boolean
        {
            goUpright(walk, walk.place, -depth);
            if (_upright.floorRow < 0 || !(_foothold.standOn(walk, _upright.floor, _upright.floorRow, _upright.place) || standOnOther(walk, _upright.place)))
            {
                return false;
            }
            walk.place.copyFrom(_upright.place);
            return true;
        }

        // Falls until something stops the agent, and slides down what is too steep. It falls in pieces that get longer, because rounding
        // errors grow with the length of a motion. If nothing stops an endless fall, it ends where it began.
        private function fall(walk:Walk):Boolean
        {
            var left:Number = walk.options.fall;
            var isStopped:Boolean = false;
            _fallen.copyFrom(walk.place);
            for (var piece:Number = 1; left > 0 && !isStopped; piece *= 2)
            {
                var depth:Number = Math.min(left, piece);
                if (_fallen.z - depth < -Agent.LARGEST_COORDINATE)
                {
                    return false;
                }
                left -= goUpright(walk, _fallen, -depth) * depth;
                isStopped = _upright.floorRow >= 0;
                _fallen.copyFrom(_upright.place);
            }
            if (!isStopped)
            {
                // a fall can also end where the ground begins, without being stopped
                walk.place.copyFrom(_fallen);
                return goDown(walk, walk.closeDepth);
            }
            if (_foothold.standOn(walk, _upright.floor, _upright.floorRow, _fallen))
            {
                walk.place.copyFrom(_fallen);
                return true;
            }
            var longest:Number = Math.min(walk.options.fall, walk.body.source.placement.size);
            slideDown(walk, _fallen, Math.min(left, longest), longest / 2);
            if (!(walk.place.z - _tried.place.z < REST * walk.body.extent))
            {
                walk.place.copyFrom(_tried.place);
            }
            return goDown(walk, walk.closeDepth);
        }

        // Lets the agent stand on what else it touches at a place, besides something too steep.
        private function standOnOther(walk:Walk, place:Vector3D):Boolean
        {
            slideDown(walk, place, walk.closeDepth, walk.body.extent);
            return _tried.floorRow >= 0 && _tried.floor.normalZ > -1 && _foothold.standOn(walk, _tried.floor, _tried.floorRow, place);
        }
    }
}
