package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.agents.warnOfInside;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.NumberList;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.queries.SeenAgents;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.pairs.PairTests;

    use namespace engine;

    /**
     * A body at the places that a motion tries, whole and as its core. The core is the body, but smaller by a slop, about the middle of its
     * extents. It does not touch what the body only touches.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class MovingBody
    {
        // The slop has four parts: fractions of the body's extent, of the largest extent near it, of the coordinates and of the motion.
        private static const OF_EXTENT:Number = 0.4 * Tolerances.SEPARATION;
        private static const OF_OTHERS:Number = 0.02 * Tolerances.SEPARATION;
        private static const OF_PLACES:Number = 16 * Tolerances.PLACES;
        private static const OF_MOTION:Number = 3 * Tolerances.ROUNDING;

        // The least half-extent of the body loses a slop, and the others lose in proportion. For a slim body, a tenth of its largest half-extent
        // takes the place of the least one. So no half-extent loses more than ten slops. The body loses at most half of its size.
        private static const SLIMMEST:Number = 10;
        private static const MOST_SHRINK:Number = 0.5;

        // An overlap is shallow if it is at most this part of the larger extent.
        private static const SHALLOW:Number = 1000 * Tolerances.SEPARATION;

        // The factor by which the inset of a core grows until the core is free.
        private static const NARROWER:Number = 4;

        // A body is flat if its core's nearest faces are behind its own by less than this fraction of a slop. A slop is at least a hundred
        // times as wide as the gaps across which shapes touch.
        private static const FLAT:Number = 0.01;

        // A one-way row stops the body with surfaces whose normal has at least this z: no steeper than 45 degrees, and a little for rounding.
        private static const UPWARDS:Number = Math.SQRT1_2 - 1e-9;

        private var _seen:SeenAgents;

        // The body where it begins.
        private var _source:Body;

        // The body at the place of its last test.
        private var _whole:Body = new Body();

        // Its core at the place of the last test of the core; and this place, whose x is NaN if the core's size has changed.
        private var _core:Body = new Body();
        private var _coreAt:Vector3D = new Vector3D();

        // A smaller copy of another row.
        private var _smaller:Body = new Body();
        private var _contact:ContactPoint = new ContactPoint();

        // The largest extent of the body and the rows near it, and half of the width of a cell of the ground.
        private var _largest:Number = 0;
        private var _cell:Number = 0;

        // The setup of the motion.
        private var _setup:MotionSetup = null;

        /** @param seen has the rows, and decides which of them touch */
        public function MovingBody(seen:SeenAgents)
        {
            _seen = seen;
        }

        /**
         * Becomes a body.
         *
         * @param body stays where it is
         * @param rows the rows that may be in its way
         */
        public function setBody(body:Body, rows:NumberList):void
        {
            _source = body;
            _coreAt.x = NaN;
            if (body.shape != null)
            {
                _whole.copyFrom(body);
            }
            _largest = 2 * largestHalf;
            _cell = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var other:Body = _seen.table.bodyOf(rows.numbers[i]);
                if (other.form == ModelShape.GROUND)
                {
                    _cell = other.largestHalf;
                }
                else
                {
                    _largest = Math.max(_largest, 2 * other.largestHalf);
                }
            }
        }

        /** Begins a motion. The setup receives its slop and its core. */
        public function beginMotion(from:Vector3D, motion:Vector3D, setup:MotionSetup):void
        {
            _setup = setup;
            setup.slop = OF_EXTENT * 2 * largestHalf + OF_OTHERS * _largest
                + OF_PLACES * (Math.abs(from.x) + Math.abs(from.y) + Math.abs(from.z) + _cell)
                + OF_MOTION * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            setup.clearance = setup.slop / 4;
            setInset(setup.slop);
            setup.isFlat = setup.shrink * _source.leastHalf < FLAT * setup.slop;
        }

        /** Goes on with the setup of an earlier motion. */
        public function resume(setup:MotionSetup):void
        {
            _setup = setup;
            _coreAt.x = NaN;
        }

        /** The setup of the motion. Others only read it. */
        public function get setup():MotionSetup
        {
            return _setup;
        }

        /** Half of the largest extent of the body. */
        public function get largestHalf():Number
        {
            return _source.largestHalf;
        }

        /** The whole body at a place. It is valid until the next call. */
        public function wholeAt(place:Vector3D):Body
        {
            _whole.moveTo(place);
            return _whole;
        }

        /** The core at a place. It is valid until the next call. */
        public function coreAt(place:Vector3D):Body
        {
            if (place.x != _coreAt.x || place.y != _coreAt.y || place.z != _coreAt.z)
            {
                _core.readShrunk(_source, place, _setup.shrink);
                _coreAt.copyFrom(place);
            }
            return _core;
        }

        /** Whether the whole body touches a row when it stands at a place. */
        public function touches(row:int, place:Vector3D):Boolean
        {
            return areTouching(wholeAt(place), _seen.table.bodyOf(row));
        }

        /** Whether the core touches a row when the body stands at a place. The whole body is tested first, because mostly it does not touch either. */
        public function coreTouches(row:int, place:Vector3D):Boolean
        {
            return touches(row, place) && _seen.narrowPhase.areTouching(coreAt(place), _seen.table.bodyOf(row));
        }

        /**
         * Whether the body at a place overlaps a row that its core touches there. A core of a concave body may touch what is exactly between
         * two sides of the body. Then the row, made smaller instead, does not touch the body. If the row is the ground, no piece of the body is
         * deep in it.
         */
        public function overlaps(row:int, place:Vector3D):Boolean
        {
            var other:Body = _seen.table.bodyOf(row);
            var whole:Body = wholeAt(place);
            if (other.form == ModelShape.GROUND)
            {
                return _seen.narrowPhase.groundTestsOf(other).isDeeper(whole, other, _setup.slop);
            }
            _smaller.readShrunk(other, null, shrinkOf(other.largestHalf, other.leastHalf, _setup.slop));
            return areTouching(whole, _smaller);
        }

        /**
         * Finds the contact of the whole body at a place with a row that it touches there.
         *
         * @param isSure true: the contact separates the two. False: a shallow contact of two of their parts is enough. The ground can be
         *     floor and wall at once, and a contact with one does not lead away from the other
         * @param out receives the contact
         * @return whether the contact is shallow
         */
        public function findContact(row:int, place:Vector3D, isSure:Boolean, out:ContactPoint):Boolean
        {
            var other:Body = _seen.table.bodyOf(row);
            var whole:Body = wholeAt(place);
            var shallow:Number = SHALLOW * extentWith(other);
            var pairTests:PairTests = _seen.narrowPhase.testsOf(whole, other);
            pairTests.findContactOfParts(whole, other, RelativeMotion.NONE, out);
            if (isSure || out.depth > shallow)
            {
                pairTests.separate(whole, other, RelativeMotion.NONE, out);
            }
            return out.depth <= shallow;
        }

        /** Whether a row stops only what comes from above. See Agent.isOneWay. */
        public function isOneWay(row:int):Boolean
        {
            return _seen.table.list.agents[row].isOneWay;
        }

        /** Whether the body goes on through a row that it meets with this contact, because the row is one-way, and the body comes not from above. */
        public function passes(row:int, contact:ContactPoint):Boolean
        {
            return isOneWay(row) && contact.normalZ < UPWARDS;
        }

        /** Whether the body at a place, where its core touches a row, is within it and the row is one-way. If it rests on the row, it is not. */
        public function isWithinOneWay(row:int, place:Vector3D):Boolean
        {
            return isOneWay(row) && !(findContact(row, place, false, _contact) && _contact.normalZ >= UPWARDS);
        }

        /**
         * Whether a contact leads out of a row by a short way. The shortest way out of a tree may lead through a wall of the tree if it is
         * longer than the way to the middle of the body.
         */
        public function isExitShort(row:int, contact:ContactPoint):Boolean
        {
            return _seen.table.shapes[row].form != ModelShape.TREE || contact.depth <= Math.abs(contact.normalX) * _source.halfX
                + Math.abs(contact.normalY) * _source.halfY + Math.abs(contact.normalZ) * _source.halfZ;
        }

        /** Warns of a motion that begins so deep inside of a tree that the tree does not stop it: in a closed room, for example, which is solid. */
        public function warnIfInside(row:int, contact:ContactPoint):void
        {
            if (!isExitShort(row, contact))
            {
                var below:Number = _source.placement.r22 == 1 ? _source.halfZ - _source.offsetZ : 0;
                warnOfInside(_seen.table.list.agents, row, _source.shape.modelName, _source.placement, below, contact.depth);
            }
        }

        /**
         * Makes the core narrower for this motion, by at most SHALLOW of the largest extent, if it does not touch a row then. The core stays
         * nearly as wide as it can be, because a motion can go that much deeper.
         *
         * @return whether the core does not touch the row any more
         */
        public function narrow(row:int, place:Vector3D):Boolean
        {
            var inset:Number = _setup.inset;
            var most:Number = _setup.slop + SHALLOW * _largest;
            setInset(most);
            if (coreTouches(row, place))
            {
                setInset(inset);
                return false;
            }
            do
            {
                inset = Math.min(NARROWER * inset, most);
                setInset(inset);
            }
            while (inset < most && coreTouches(row, place));
            return true;
        }

        /** Half of the gap across which the body and a row still touch, at a place. It does not apply to spheres and points. */
        public function halfToleranceAt(row:int, place:Vector3D):Number
        {
            return Tolerances.SURFACES / 4 * extentWith(_seen.table.bodyOf(row)) + Tolerances.PLACES / 2 * (Math.abs(place.x) + Math.abs(place.y) + Math.abs(place.z));
        }

        /** Whether the extents of a body come this close to another's, anywhere on a motion that ends where the body is. */
        public static function isNear(body:Body, other:Body, motion:RelativeMotion, distance:Number):Boolean
        {
            if (other.form == ModelShape.GROUND)
            {
                return true;
            }
            var x:Number = motion.x / 2;
            var y:Number = motion.y / 2;
            var z:Number = motion.z / 2;
            return Math.abs(body.x - x - other.x) <= body.halfX + other.halfX + Math.abs(x) + distance
                && Math.abs(body.y - y - other.y) <= body.halfY + other.halfY + Math.abs(y) + distance
                && Math.abs(body.z - z - other.z) <= body.halfZ + other.halfZ + Math.abs(z) + distance;
        }

        private function areTouching(whole:Body, other:Body):Boolean
        {
            return isNear(whole, other, RelativeMotion.NONE, _setup.slop) && _seen.narrowPhase.areTouching(whole, other);
        }

        // The larger extent of the body and another. The ground's extents are those of a cell, and do not count.
        private function extentWith(other:Body):Number
        {
            var largest:Number = other.form == ModelShape.GROUND ? 0 : other.largestHalf;
            return 2 * Math.max(largest, largestHalf);
        }

        private function setInset(width:Number):void
        {
            _setup.inset = width;
            _coreAt.x = NaN;
            _setup.shrink = shrinkOf(largestHalf, _source.leastHalf, width);
        }

        private static function shrinkOf(largestHalf:Number, leastHalf:Number, width:Number):Number
        {
            var taken:Number = width / Math.max(leastHalf, largestHalf / SLIMMEST);
            return taken < MOST_SHRINK ? taken : MOST_SHRINK;
        }
    }
}
