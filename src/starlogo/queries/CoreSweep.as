package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.PairTests;

    use namespace engine;

    /**
     * Sweeps the core of a row of a table. The core is the row, but smaller by a slop, about the middle of its extents. What the core meets
     * stops the row. The core does not meet what the row only touches, leaves or runs along.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class CoreSweep
    {
        // The slop has four parts: fractions of the row's extent, of the largest extent near it, of the coordinates and of the motion.
        private static const OF_EXTENT:Number = 0.4 * Tolerances.SEPARATION;
        private static const OF_OTHERS:Number = 0.02 * Tolerances.SEPARATION;
        private static const OF_PLACES:Number = 16 * Tolerances.PLACES;
        private static const OF_MOTION:Number = 3 * Tolerances.ROUNDING;

        // The least half-extent of the row loses a slop, and the others lose in proportion. For a slim row, a tenth of its largest half-extent
        // takes the place of the least one. So no half-extent loses more than ten slops. The row loses at most half of its size.
        private static const SLIMMEST:Number = 10;
        private static const MOST_SHRINK:Number = 0.5;

        // An overlap is shallow if it is at most this part of the larger extent.
        private static const SHALLOW:Number = 1000 * Tolerances.SEPARATION;

        // The factor by which the inset of a core grows until the core is free.
        private static const NARROWER:Number = 4;

        // Another row is large if its largest half-extent is at least this many times the largest of the row that moves.
        private static const LARGE:Number = 8;

        // A row is flat if its core's nearest faces are in front of its own by less than this fraction of a slop. A slop is at least a hundred
        // times as wide as the gaps across which shapes touch.
        private static const FLAT:Number = 0.01;

        // A time after the end of the motion.
        private static const AFTER:Number = 1 + 1e-15;

        /** The slop: how much smaller than the row the core is on each side, in patches. <code>narrowFor()</code> makes it smaller still. */
        public var slop:Number = 0;

        /** How far before a touch a slide ends, in patches. It is less than the slop, so the row can enter a place as wide as itself. */
        public var clearance:Number = 0;

        /** Whether the row is too flat for its core to be narrower. */
        public var isFlat:Boolean = false;

        /** When the core meets the first row that was found, as a part of the motion. If none was found, it is greater than 1. */
        public var time:Number = 0;

        /** The contact at that time. */
        public var contact:ContactPoint = new ContactPoint();

        /** A row that the moving row does not touch anywhere on the motion, not even in its whole size; -1 if none is known. */
        public var clearRow:int = -1;

        /** When the row in its whole size touches the row of <code>findWhole()</code>. */
        public var wholeTime:Number = 0;

        private var _seen:QueryWorld;

        // The body that moves; a copy of it where the last test had it, whole or as the core; and a smaller copy of another row.
        private var _body:Body;
        private var _moving:Body = new Body();
        private var _standing:Body = new Body();

        // Where the moving body is in the last test, and which part of its size is taken off.
        private var _at:Vector3D = new Vector3D();
        private var _taken:Number = 0;

        // The largest and the least half-extent of the row.
        private var _largestHalf:Number = 0;
        private var _leastHalf:Number = 0;

        // The largest extent of the row and those near it, and half of the width of a cell of the ground.
        private var _largest:Number = 0;
        private var _cell:Number = 0;

        // How much smaller the core is on each side, in patches, and the part of its size that the row loses. The width is more than a slop for a
        // motion that begins in a shallow overlap.
        private var _coreInset:Number = 0;
        private var _shrink:Number = 0;

        // The motion, and the row's place at its end.
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _end:Vector3D = new Vector3D();
        private var _tried:ContactPoint = new ContactPoint();

        // When the row in its whole size meets the row that is tested; NaN if that is not known.
        private var _whole:Number = NaN;

        /** @param seen has the rows, and decides which of them touch */
        public function CoreSweep(seen:QueryWorld)
        {
            _seen = seen;
        }

        /** Begins with the body that moves. */
        public function begin(body:Body):void
        {
            _body = body;
            _at.x = NaN;
            _largestHalf = body.largestHalf;
            _leastHalf = body.leastHalf;
            _largest = 2 * _largestHalf;
            _cell = 0;
            clearRow = -1;
        }

        /** Adds a row that may be in the way. */
        public function addOther(other:int):void
        {
            var body:Body = _seen.table.bodyOf(other);
            if (body.form == ModelShape.GROUND)
            {
                _cell = body.largestHalf;
            }
            else
            {
                _largest = Math.max(_largest, 2 * body.largestHalf);
            }
        }

        /** Computes the slop of a motion. */
        public function beginMotion(at:Vector3D, motion:Vector3D):void
        {
            slop = OF_EXTENT * 2 * _largestHalf + OF_OTHERS * _largest
                + OF_PLACES * (Math.abs(at.x) + Math.abs(at.y) + Math.abs(at.z) + _cell)
                + OF_MOTION * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            clearance = slop / 4;
            setCoreInset(slop);
            isFlat = _shrink * _leastHalf < FLAT * slop;
        }

        /** Whether the row touches another when it stands at a place. */
        public function wholeTouchesAt(other:int, at:Vector3D):Boolean
        {
            put(at, 0);
            return touches(_seen.table.bodyOf(other));
        }

        /**
         * Whether a row that stands at a place is closer to another, along an axis, than half of the clearance.
         *
         * @param out receives the place beside it where the two touch
         */
        public function isCloseAt(other:int, at:Vector3D, out:Vector3D):Boolean
        {
            for (var side:Number = -clearance / 2; side <= clearance / 2; side += clearance)
            {
                out.setTo(at.x, at.y, at.z + side);
                if (wholeTouchesAt(other, out))
                {
                    return true;
                }
                out.setTo(at.x, at.y + side, at.z);
                if (wholeTouchesAt(other, out))
                {
                    return true;
                }
                out.setTo(at.x + side, at.y, at.z);
                if (wholeTouchesAt(other, out))
                {
                    return true;
                }
            }
            return false;
        }

        /** Whether the core touches another row when it stands at a place. The whole row is tested first: mostly it does not
         * touch either, and the copy mostly has the whole size already. */
        public function coreTouchesAt(other:int, at:Vector3D):Boolean
        {
            if (!wholeTouchesAt(other, at))
            {
                return false;
            }
            put(at, _shrink);
            return _seen.narrowPhase.areTouching(_moving, _seen.table.bodyOf(other));
        }

        /**
         * Whether the row at a place overlaps another that its core touches there. A core of a concave row may touch what is exactly between
         * two sides of the row. Then the other row, made smaller instead, does not touch the row. If it is the ground, no piece of the row is
         * deep in it.
         */
        public function overlapsAt(other:int, at:Vector3D):Boolean
        {
            var body:Body = _seen.table.bodyOf(other);
            put(at, 0);
            if (body.form == ModelShape.GROUND)
            {
                return _seen.narrowPhase.testsOf(_moving, body).isDeeper(_moving, body, slop);
            }
            _standing.readShrunk(body, null, shrinkOf(body.largestHalf, body.leastHalf, slop));
            return touches(_standing);
        }

        /** Whether the row at a place is deep in another, and can leave it by a short way. Writes their contact, whose depth has the clearance added. */
        public function isDeepIn(other:int, at:Vector3D, out:ContactPoint):Boolean
        {
            if (!coreTouchesAt(other, at) || findContact(other, at, out, true) || !overlapsAt(other, at))
            {
                return false;
            }
            out.depth += clearance;
            return _seen.table.forms[other] != ModelShape.TREE || out.depth <= Math.abs(out.normalX) * _body.halfX + Math.abs(out.normalY) * _body.halfY
                + Math.abs(out.normalZ) * _body.halfZ;
        }

        /**
         * Makes the core narrower for this motion, by at most SHALLOW of the largest extent, if it does not touch another row then. The core
         * stays nearly as wide as it can be, because a motion can go that much deeper.
         *
         * @return whether the narrower core does not touch it
         */
        public function narrowFor(other:int, at:Vector3D):Boolean
        {
            var inset:Number = _coreInset;
            var most:Number = slop + SHALLOW * _largest;
            setCoreInset(most);
            if (coreTouchesAt(other, at))
            {
                setCoreInset(inset);
                return false;
            }
            do
            {
                inset = Math.min(NARROWER * inset, most);
                setCoreInset(inset);
            }
            while (inset < most && coreTouchesAt(other, at));
            return true;
        }

        /**
         * Finds the contact of the row at a place with another row that it touches there.
         *
         * @param isSure true: the contact separates the two rows. False: a shallow contact of two of their parts is enough. The ground can be
         *     floor and wall at once, and a contact with one does not lead away from the other
         * @return whether the contact is shallow
         */
        public function findContact(other:int, at:Vector3D, out:ContactPoint, isSure:Boolean = false):Boolean
        {
            var body:Body = _seen.table.bodyOf(other);
            var shallow:Number = SHALLOW * extentWith(body);
            put(at, 0);
            var tests:PairTests = _seen.narrowPhase.testsOf(_moving, body);
            tests.findContact(_moving, body, RelativeMotion.NONE, out);
            if (isSure || out.depth > shallow)
            {
                tests.separate(_moving, body, RelativeMotion.NONE, out);
            }
            return out.depth <= shallow;
        }

        /** Sets the motion for the next tests. It forgets what was found on the way before. */
        public function aim(at:Vector3D, motion:Vector3D):void
        {
            _end.copyFrom(at);
            _end.incrementBy(motion);
            _motion.endAfter(motion.x, motion.y, motion.z);
            time = AFTER;
            clearRow = -1;
        }

        /**
         * Finds whether the core meets another row earlier than the row that was found before. If so, it writes <code>time</code> and
         * <code>contact</code>.
         *
         * @param from where the motion begins
         */
        public function find(other:int, from:Vector3D):Boolean
        {
            var body:Body = _seen.table.bodyOf(other);
            if (isWholeClear(body))
            {
                clearRow = other;
                return false;
            }
            put(_end, _shrink);
            if (!isNear(body, _motion, slop))
            {
                return false;
            }
            findImpact(body, _tried);
            var met:Number = _motion.time;
            if (met == RelativeMotion.NEVER && body.form == ModelShape.GROUND)
            {
                // a sheet may be wholly under the ground at the beginning, and then it touches no surface
                met = coreTouchesAt(other, from) ? 0 : met;
            }
            if (!(met < time))
            {
                return false;
            }
            time = met;
            wholeTime = _whole;
            contact.copyFrom(_tried);
            return true;
        }

        // Whether it is known that the row in its whole size does not meet another. For a tree that is much larger this is found first, because then
        // the end of the motion needs no test of its own. Such a tree can be a whole building, in which everything happens.
        private function isWholeClear(other:Body):Boolean
        {
            _whole = NaN;
            if (other.form != ModelShape.TREE || other.largestHalf < LARGE * _largestHalf)
            {
                return false;
            }
            put(_end, 0);
            _whole = RelativeMotion.NEVER;
            if (isNear(other, _motion, slop))
            {
                findImpact(other, null);
                _whole = _motion.time;
            }
            return _whole == RelativeMotion.NEVER;
        }

        // Finds when the row, which stands at its end, first meets another on the motion. The motion's record receives the time, because V8 would
        // make an object for a Number that is returned.
        private function findImpact(other:Body, out:ContactPoint):void
        {
            _seen.narrowPhase.testsOf(_moving, other).findImpact(_moving, other, _motion, out);
        }

        /**
         * Finds when the row in its whole size first touches the row that <code>find()</code> has found. The two may touch from the beginning,
         * for example if one agent is the floor under the row and also the wall in its way. Then the result is the time of the core, made
         * earlier by the width of the slop at the contact.
         *
         * @param along how far the motion goes along the contact's normal, less than 0
         * @param touch has that normal
         */
        public function findWhole(other:int, along:Number, touch:ContactPoint):void
        {
            put(_end, 0);
            var skin:Number = _shrink * (touch.normalX * (_moving.x - (1 - time) * _motion.x - touch.x)
                    + touch.normalY * (_moving.y - (1 - time) * _motion.y - touch.y)
                    + touch.normalZ * (_moving.z - (1 - time) * _motion.z - touch.z));
            var early:Number = Math.max(0, Math.min(1, time + skin / along));
            if (isNaN(wholeTime))
            {
                findImpact(_seen.table.bodyOf(other), null);
                wholeTime = _motion.time;
            }
            wholeTime = Math.abs(wholeTime - early) <= Math.abs(time - early) ? wholeTime : early;
        }

        /** Half of the gap across which the row and another still touch, at a place. It does not apply to spheres and points. */
        public function halfToleranceAt(other:int, at:Vector3D):Number
        {
            return Tolerances.SURFACES / 4 * extentWith(_seen.table.bodyOf(other)) + Tolerances.PLACES / 2 * (Math.abs(at.x) + Math.abs(at.y) + Math.abs(at.z));
        }

        // The larger extent of the row and another. The ground's extents are those of a cell, and do not count.
        private function extentWith(other:Body):Number
        {
            var largest:Number = other.form == ModelShape.GROUND ? 0 : other.largestHalf;
            return 2 * Math.max(largest, _largestHalf);
        }

        private function put(at:Vector3D, share:Number):void
        {
            if (share != _taken || at.x != _at.x || at.y != _at.y || at.z != _at.z)
            {
                _moving.readShrunk(_body, at, share);
                _at.copyFrom(at);
                _taken = share;
            }
        }

        private function touches(other:Body):Boolean
        {
            return isNear(other, RelativeMotion.NONE, slop) && _seen.narrowPhase.areTouching(_moving, other);
        }

        // Whether the extents of the row come this close to another's, anywhere on a motion that ends where the row is.
        private function isNear(other:Body, motion:RelativeMotion, distance:Number):Boolean
        {
            if (other.form == ModelShape.GROUND)
            {
                return true;
            }
            var x:Number = motion.x / 2;
            var y:Number = motion.y / 2;
            var z:Number = motion.z / 2;
            return Math.abs(_moving.x - x - other.x) <= _moving.halfX + other.halfX + Math.abs(x) + distance
                && Math.abs(_moving.y - y - other.y) <= _moving.halfY + other.halfY + Math.abs(y) + distance
                && Math.abs(_moving.z - z - other.z) <= _moving.halfZ + other.halfZ + Math.abs(z) + distance;
        }

        private function setCoreInset(width:Number):void
        {
            _coreInset = width;
            _shrink = shrinkOf(_largestHalf, _leastHalf, width);
        }

        private static function shrinkOf(largestHalf:Number, leastHalf:Number, width:Number):Number
        {
            var share:Number = width / Math.max(leastHalf, largestHalf / SLIMMEST);
            return share < MOST_SHRINK ? share : MOST_SHRINK;
        }
    }
}
