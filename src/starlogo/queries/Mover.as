package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.search.Body;
    import starlogo.search.NumberList;

    use namespace engine;

    /**
     * Moves a row of a table among others, until it touches one of them, or along the rows that it touches. A row that it would go into stops
     * it. A row that it only touches, leaves or runs along never stops it, because the core of the row is swept (CoreSweep).
     *
     * <p>At the beginning the row may overlap others a little, because of rounding in the game. Then it is lifted out of them first. If it
     * overlaps another row more deeply, the plane of their contact stands for that row. The motion must not cross the plane, and nothing else of
     * that row counts.</p>
     *
     * @private
     */
    public final class Mover
    {
        /** An ending of a motion: the row touches the other row. */
        public static const TOUCH:int = 0;

        /** An ending: the clearance before the touch. */
        public static const SHORT:int = 1;

        // The number of places that are tried in order to find one at which the two touch. A sweep may end some 30 gaps before a triangle of
        // the ground.
        private static const STEPS_INTO_TOUCH:int = 64;

        // If the next row is met within this many slops, this is the same corner.
        private static const NEXT:Number = 4;

        // A normal is vertical if the square of its horizontal part is at most this. The rest is a rounding error.
        private static const UPRIGHT:Number = 1e-20;

        // Between two walls the row may be lifted to and fro. After this many rounds it stays where it is.
        private static const LIFTING_ROUNDS:int = 6;

        // From this round on the contact has to separate the two rows. Contacts of parts of a row may point sideways, round after round.
        private static const SURE_ROUND:int = 2;

        // A motion ends after this many iterations.
        private static const MOST_ITERATIONS:int = 8;

        /** Whether the last slide met a wall: a surface that was too steep for it. */
        public var metWall:Boolean = false;

        /** The fraction of its motion that the row has gone, from 0 to 1. */
        public var fraction:Number = 1;

        /** Whether the last motion began deep in another row. */
        public var isDeep:Boolean = false;

        /** Whether the last motion began with a lift out of a row. */
        public var isLifted:Boolean = false;

        /** The row that stopped the last motion; -1 for none, and after a slide. */
        public var contactRow:int = -1;

        /** The contact with that row. The next motion overwrites it. */
        public var contact:ContactPoint = new ContactPoint();

        /** The most level contact that the last slide has met: the one with the greatest z of its normal. If there is none, its
         * normalZ is -2. */
        public var floor:ContactPoint = new ContactPoint();

        /** The other row of that contact. */
        public var floorRow:int = -1;

        /** The place of the row's agent at the end. */
        public var at:Vector3D = new Vector3D();

        /** The deepest overlap that <code>findDeepest()</code> has found. */
        public var deepest:ContactPoint = new ContactPoint();

        /** The sum of the depths of all overlaps that it has found. */
        public var overlap:Number = 0;

        private var _sweep:CoreSweep;
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _lifts:EndClearance = new EndClearance();

        // The rows in the way, and how many of them no plane replaces. These come first.
        private var _others:NumberList = new NumberList();
        private var _count:int = 0;

        // The place of the row before it was lifted, and the lift.
        private var _before:Vector3D = new Vector3D();
        private var _lift:Vector3D = new Vector3D();

        // How far the rest of the motion goes along the contact's normal, which is less than 0.
        private var _along:Number = 0;

        // Whether no contact showed what stops the motion, so that the normal is just the opposite of the motion.
        private var _isNormalFallback:Boolean = false;

        private var _standing:ContactPoint = new ContactPoint();

        /** @param seen has the rows, and tests which of them touch */
        public function Mover(seen:QueryWorld)
        {
            _sweep = new CoreSweep(seen);
        }

        /**
         * Begins with a body and the rows in its way.
         *
         * @param body the body that moves. It stays where it is
         * @param others the rows, of which those from an index to another count
         * @param except a row that does not count, or -1
         */
        public function begin(body:Body, others:Vector.<int>, from:int, end:int, except:int = -1):void
        {
            at.setTo(body.placement.x, body.placement.y, body.placement.z);
            _sweep.begin(body);
            _others.count = 0;
            for (var i:int = from; i < end; i++)
            {
                if (others[i] != except)
                {
                    _others.add(others[i]);
                    _sweep.addOther(others[i]);
                }
            }
            _count = _others.count;
        }

        /**
         * Computes how the beginning of a motion lifts the body out of its rows, all together.
         *
         * @param out receives the lift: 0 if the body overlaps nothing, or does not get free
         * @return whether there is a lift
         */
        public function findLift(motion:Vector3D, out:Vector3D):Boolean
        {
            start(motion);
            out.copyFrom(at);
            out.decrementBy(_before);
            return isLifted;
        }

        /**
         * Computes where the body ends if it goes from <code>at</code> until it touches a row.
         *
         * @param motion the whole motion
         * @param ending TOUCH or SHORT
         * @param lift the lift of <code>findLift()</code>; null for none
         */
        public function goUntilTouch(motion:Vector3D, ending:int, lift:Vector3D = null):void
        {
            if (!start(motion, lift))
            {
                return;
            }
            findTouch();
            var isStopped:Boolean = contactRow >= 0 && fraction > 0;
            if (isStopped && ending == TOUCH)
            {
                endTouching();
                return;
            }
            at.copyFrom(_before);
            _rest.advance(at, isStopped ? Math.max(0, fraction + _sweep.clearance / _along) : fraction);
        }

        /**
         * Computes where the body ends if it goes from <code>at</code> and slides along what it meets.
         *
         * @param motion the whole motion
         * @param steepest a contact counts as an upright wall if the z of its normal is less than this. With -2 none does so
         * @param widest how far the body may go on the ground plane at most
         * @param steepness for a fall: the least slope on which it goes on, as a tangent
         */
        public function slide(motion:Vector3D, steepest:Number = -2, widest:Number = Infinity, steepness:Number = -1):void
        {
            floor.setNormal(0, 0, -2);
            if (!start(motion, null, widest, steepness))
            {
                return;
            }
            var whole:Number = _rest.length;
            for (var iterations:int = 0; iterations < MOST_ITERATIONS && _rest.project(); iterations++)
            {
                if (!findFirst())
                {
                    _rest.advance(at, 1);
                    break;
                }
                if (!isSoon())
                {
                    _rest.beginCorner();
                }
                _sweep.findWhole(contactRow, _along, contact);
                _rest.advance(at, Math.max(_sweep.wholeTime + _sweep.clearance / _along, 0));
                if (!_isNormalFallback && contact.normalZ > floor.normalZ)
                {
                    floor.copyFrom(contact);
                    floorRow = contactRow;
                }
                if (contact.normalZ < steepest)
                {
                    standUp();
                }
                _rest.add(contact, contactRow);
                dropNeedless();
            }
            contactRow = -1;
            fraction = _rest.gone < whole ? _rest.gone / whole : 1;
        }

        /** Whether the body would go into a row on a straight way from a place. */
        public function meets(row:int, from:Vector3D, motion:Vector3D):Boolean
        {
            _sweep.beginMotion(from, motion);
            _sweep.aim(from, motion);
            return _sweep.find(row, from);
        }

        // Begins a motion at a place that is lifted out of what the row overlaps there. Returns whether there is any motion.
        private function start(motion:Vector3D, lift:Vector3D = null, widest:Number = Infinity, steepness:Number = -1):Boolean
        {
            _rest.begin(motion, widest, steepness);
            contactRow = -1;
            metWall = isDeep = isLifted = false;
            contact.setNormal(0, 0, 0);
            fraction = 1;
            _sweep.beginMotion(at, motion);
            _before.copyFrom(at);
            if (!(_rest.length * _rest.length > Tolerances.VANISHING))
            {
                _rest.advance(at, 1);
                return false;
            }
            if (lift != null)
            {
                at.incrementBy(lift);
            }
            _count = _others.count;
            liftOut();
            isDeep = _rest.count > 0;
            _rest.beginCorner();
            return true;
        }

        // Lifts the row out of rows that it overlaps a little at its place. If no round frees it, the last round puts it back at its place.
        private function liftOut():void
        {
            var isFree:Boolean = false;
            for (var round:int = 0; !isFree && round <= LIFTING_ROUNDS; round++)
            {
                isFree = true;
                if (round == LIFTING_ROUNDS)
                {
                    at.copyFrom(_before);
                }
                for (var i:int = _count - 1; i >= 0; i--)
                {
                    if (_sweep.coreTouchesAt(_others.numbers[i], at))
                    {
                        isFree = false;
                        liftOutOf(i, round);
                    }
                }
            }
        }

        // Lifts the row out of another. If the overlap is deeper, the contact's plane replaces the other row.
        private function liftOutOf(i:int, round:int):void
        {
            var other:int = _others.numbers[i];
            var isShallow:Boolean = _sweep.findContact(other, at, _standing, round >= SURE_ROUND);
            if (isShallow && round < LIFTING_ROUNDS)
            {
                _standing.push(at, _standing.depth + _sweep.clearance);
                isLifted = true;
                return;
            }
            if (!_sweep.narrowFor(other, at) && _sweep.overlapsAt(other, at))
            {
                _rest.add(_standing, other);
                _count--;
                // the others keep their order, because the first in the list is named if several are met at once
                for (var next:int = i; next < _count; next++)
                {
                    _others.numbers[next] = _others.numbers[int(next + 1)];
                }
                _others.numbers[_count] = other;
            }
        }

        /**
         * Finds the deepest overlap of the body at <code>at</code>. An overlap that a motion only lifts out of does not count. Neither does an
         * overlap with a tree that is deeper than the middle of the body, because the shortest way out may lead through a wall of the tree.
         *
         * @return whether there is one
         */
        public function findDeepest():Boolean
        {
            deepest.depth = overlap = 0;
            for (var i:int = 0; i < _others.count; i++)
            {
                if (_sweep.isDeepIn(_others.numbers[i], at, _standing))
                {
                    overlap += _standing.depth;
                    if (_standing.depth > deepest.depth)
                    {
                        deepest.copyFrom(_standing);
                    }
                }
            }
            return overlap > 0;
        }

        // Finds when the row touches another first, and which.
        private function findTouch():void
        {
            var crossed:int = _rest.findCrossed();
            if (crossed >= 0)
            {
                contact.copyFrom(_rest.planes[crossed]);
                contactRow = _rest.rows[crossed];
                fraction = 0;
            }
            else if (findFirst())
            {
                _sweep.findWhole(contactRow, _along, contact);
                // without the lift the row would have touched earlier
                _lift.copyFrom(at);
                _lift.decrementBy(_before);
                var time:Number = _sweep.wholeTime + contact.along(_lift) / _along;
                fraction = time > 0 ? (time < 1 ? time : 1) : 0;
                if (-fraction * _along < _sweep.slop && _sweep.wholeTouchesAt(contactRow, _before))
                {
                    fraction = 0;
                }
                contact.depth = 0;
            }
        }

        // Moves the row into the touch, on the side that it comes from. If it went beyond a row without thickness, the two would not touch,
        // and it could not come back. On a long way rounding may hide the touch. Then the row ends where its core touches the other.
        private function endTouching():void
        {
            var motion:Vector3D = _rest.motion;
            _lift.setTo(at.x + _sweep.time * motion.x, at.y + _sweep.time * motion.y, at.z + _sweep.time * motion.z);
            at.copyFrom(_before);
            _rest.advance(at, fraction);
            if (!stepIntoTouch())
            {
                at.copyFrom(_lift);
            }
        }

        // Tries several places, from half a margin before the contact on. The margin is the gap across which the two still touch. Returns whether
        // they touch at one of the places.
        private function stepIntoTouch():Boolean
        {
            var margin:Number = _sweep.halfToleranceAt(contactRow, at);
            contact.push(at, margin);
            for (var i:int = 1; i < STEPS_INTO_TOUCH; i++)
            {
                if (_sweep.wholeTouchesAt(contactRow, at))
                {
                    return true;
                }
                contact.push(at, -margin);
            }
            return _sweep.wholeTouchesAt(contactRow, at);
        }

        // If a contact is too steep, this turns it into an upright wall. The rest of the motion becomes level, because the slope would stop
        // a motion up or down.
        private function standUp():void
        {
            metWall = true;
            if (contact.normalX * contact.normalX + contact.normalY * contact.normalY > UPRIGHT)
            {
                contact.setNormal(contact.normalX, contact.normalY, 0);
                contact.normalise();
                _rest.makeHorizontal();
            }
        }

        // Removes planes that are not needed. At the edges of tiles, a contact's plane may belong to a side that the next tile hides. A plane is
        // removed if the motion meets nothing in this corner without it.
        private function dropNeedless():void
        {
            for (var i:int = _rest.count - 2; i >= _rest.corner; i--)
            {
                if (_rest.project(i) && !(findFirst() && isSoon()))
                {
                    _rest.remove(i);
                }
            }
        }

        // Whether the row that is met first is met in the same corner.
        private function isSoon():Boolean
        {
            return _sweep.time * _rest.length < NEXT * _sweep.slop;
        }

        /**
         * Lifts the row off what it only touches at the end, if there is room.
         *
         * @param isAtEnd whether the row is where the last motion has ended, so that it does not touch what the sweep has found clear
         */
        public function restoreClearance(isAtEnd:Boolean):void
        {
            _lifts.restoreClearance(_sweep, at, _others.numbers, _count, isAtEnd ? _sweep.clearRow : -1);
        }

        // Finds the row that the rest of the motion meets first. Returns whether there is one.
        private function findFirst():Boolean
        {
            var motion:Vector3D = _rest.motion;
            _sweep.aim(at, motion);
            for (var i:int = 0; i < _count; i++)
            {
                if (_sweep.find(_others.numbers[i], at))
                {
                    contactRow = _others.numbers[i];
                }
            }
            if (_sweep.time > 1)
            {
                return false;
            }
            contact.copyFrom(_sweep.contact);
            _along = contact.along(motion);
            _isNormalFallback = !(_along < -SlidePlanes.PARALLEL_SINE * _rest.length);
            if (_isNormalFallback)
            {
                contact.setNormal(-motion.x, -motion.y, -motion.z);
                contact.normalise();
                _along = -_rest.length;
            }
            return true;
        }
    }
}
