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

        // If a motion leads this many slops deeper into what it was lifted out of, the row has left the surface. Otherwise its core met it.
        private static const MOST_SLOPS:Number = 2;

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

        /** The overlap that <code>findDeepest()</code> has found. */
        public var overlap:DeepestOverlap = new DeepestOverlap();

        private var _sweep:CoreSweep;
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _lifts:EndClearance = new EndClearance();

        // The rows in the way, and how many of them no plane replaces. These come first.
        private var _others:NumberList = new NumberList();
        private var _count:int = 0;

        // The place of the row before it was lifted, the lift, and a place or a way.
        private var _before:Vector3D = new Vector3D();
        private var _lift:StartLift = new StartLift();
        private var _tried:Vector3D = new Vector3D();

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
        public function findLift(motion:Vector3D, out:StartLift):Boolean
        {
            start(motion);
            out.copyFrom(_lift);
            out.way.copyFrom(at);
            out.way.decrementBy(_before);
            return isLifted;
        }

        /**
         * Computes where the body ends if it goes from <code>at</code> until it touches a row.
         *
         * @param motion the whole motion
         * @param ending TOUCH or SHORT
         * @param lift the lift of <code>findLift()</code>; null for none
         */
        public function goUntilTouch(motion:Vector3D, ending:int, lift:StartLift = null):void
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
            goFromStart(isStopped ? Math.max(0, fraction + _sweep.clearance / _along) : fraction);
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
        private function start(motion:Vector3D, lift:StartLift = null, widest:Number = Infinity, steepness:Number = -1):Boolean
        {
            _rest.begin(motion, widest, steepness);
            _lift.clear();
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
                _lift.copyFrom(lift);
                at.incrementBy(lift.way);
            }
            _lift.most = MOST_SLOPS * _sweep.slop;
            _count = _others.count;
            liftOut();
            isDeep = _rest.count > 0;
            if (_sweep.isFlat && !isDeep)
            {
                // its core is as flat, and a sweep touches across a wider gap than a row that stands
                _tried.copyFrom(at);
                restoreClearance(false);
                isLifted ||= at.x != _tried.x || at.y != _tried.y || at.z != _tried.z;
            }
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
                    _lift.clear();
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
                _lift.add(_standing);
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

        /** Finds the deepest overlap of the body at <code>at</code>. Returns whether there is one. */
        public function findDeepest():Boolean
        {
            return overlap.find(_sweep, at, _others.numbers, _others.count);
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
                _tried.copyFrom(at);
                _tried.decrementBy(_before);
                var time:Number = _sweep.wholeTime + contact.along(_tried) / _along;
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
            _tried.setTo(at.x + _sweep.time * motion.x, at.y + _sweep.time * motion.y, at.z + _sweep.time * motion.z);
            goFromStart(fraction);
            if (!stepIntoTouch())
            {
                at.copyFrom(_tried);
            }
        }

        // Moves the row by a part of the motion from its place before the lift, but no deeper into what it was lifted out of.
        private function goFromStart(part:Number):void
        {
            at.copyFrom(_before);
            _rest.advance(at, part);
            _lift.keepDepth(at, _before.x, _before.y, _before.z);
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
