package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.search.AgentTable;
    import starlogo.search.RowPairs;

    use namespace engine;

    /**
     * Moves a row of a table among others, until it touches one or along what it touches. A motion is stopped by what it would go into, never by what it
     * touches, leaves or runs along (NarrowSweep).
     *
     * <p>At the beginning the row is lifted out of what it overlaps by no more than rounding in a game makes. Where it overlaps another deeper, the plane
     * of the contact stands for the other: it must not be crossed, and nothing else of the other counts.</p>
     *
     * @private
     */
    public final class Mover
    {
        // Overlaps deeper than this part of the larger extent are planes.
        private static const SHALLOW:Number = 1000 * Tolerances.SEPARATION;

        // So many places are tried for the end in a touch.
        private static const STEPS_INTO_TOUCH:int = 6;

        // What is met no farther on is met in the same corner; and so far on, the contact's normal is found that an edge does not tell. As a part of the larger extent.
        private static const NEXT:Number = 1e-4;

        // Between two walls lifts may go to and fro: what is left after so many rounds are planes.
        private static const LIFTING_ROUNDS:int = 6;

        // A motion that was turned so often ends.
        private static const MOST_TURNS:int = 8;

        // No row that does not meet another is so many hairs deep in it.
        private static const MOST_HAIRS:Number = 20;

        /** Decides what touches. */
        public var pairs:RowPairs;

        /** How far the last row has come, as a part of its motion. */
        public var part:Number = 1;

        /** Whether another stopped the last row that did not slide. */
        public var hasContact:Boolean = false;

        /** The row of the other. */
        public var contactRow:int = -1;

        /** Where its agent is then. */
        public var at:Vector3D = new Vector3D();

        private var _sweep:NarrowSweep;
        private var _rest:SlidePlanes = new SlidePlanes();
        private var _others:Vector.<int> = new Vector.<int>();
        private var _count:int = 0;

        // Where it was before it was lifted, and how far it was.
        private var _before:Vector3D = new Vector3D();
        private var _lift:Vector3D = new Vector3D();

        // How it meets what it meets first; how far the rest of the motion goes along the normal, which is less than 0; whether it stops there.
        private var _contact:ContactPoint = new ContactPoint();
        private var _along:Number = 0;

        // Whether each normal is looked for a little farther on.
        private var _isCareful:Boolean = false;

        private var _standing:ContactPoint = new ContactPoint();

        /** @param pairs decide what touches */
        public function Mover(pairs:RowPairs)
        {
            this.pairs = pairs;
            _sweep = new NarrowSweep(pairs);
        }

        /**
         * Finds where a row comes to, which is back where it was afterwards.
         *
         * @param table has the row
         * @param row moves
         * @param others of the same table, as agents
         * @param motion how far it is to go
         * @param slides whether it goes on along what it meets
         */
        public function move(table:AgentTable, row:int, others:Vector.<Agent>, motion:Vector3D, slides:Boolean):void
        {
            at.setTo(table.x[row], table.y[row], table.z[row]);
            _rest.begin(motion);
            hasContact = _isCareful = false;
            _contact.setNormal(0, 0, 0);
            part = 1;
            if (!(_rest.length * _rest.length > Tolerances.VANISHING))
            {
                _rest.advance(at, 1);
                return;
            }
            readOthers(table, others);
            _sweep.begin(table, row, _rest.motion);
            _before.copyFrom(at);
            liftOut();
            _rest.beginCorner();
            if (slides)
            {
                slide();
                leaveTouches();
            }
            else
            {
                goUntilTouch();
            }
            _sweep.end();
        }

        /** How the row touches the other, where it has a contact; the next move overwrites it. */
        public function get contact():ContactPoint
        {
            return _contact;
        }

        private function readOthers(table:AgentTable, others:Vector.<Agent>):void
        {
            _count = 0;
            for (var i:int = 0; i < others.length; i++)
            {
                var row:int = table.rowOf(others[i]);
                if (table.shapes[row] != null)
                {
                    _others[_count] = row;
                    _count++;
                }
            }
        }

        // Lifts the row out of what it would have to go into to be where it is. What it cannot be lifted out of becomes a plane.
        private function liftOut():void
        {
            var isFree:Boolean = false;
            for (var round:int = 1; !isFree && round <= LIFTING_ROUNDS; round++)
            {
                isFree = true;
                for (var i:int = _count - 1; i >= 0; i--)
                {
                    if (!_sweep.meetsAt(_others[i], at))
                    {
                        continue;
                    }
                    isFree = false;
                    _sweep.findContact(_others[i], at, _standing);
                    if (round < LIFTING_ROUNDS && _standing.depth <= SHALLOW * _sweep.extent + _sweep.hair)
                    {
                        _standing.push(at, _standing.depth + _sweep.hair / 2);
                        continue;
                    }
                    _rest.add(_standing, _others[i]);
                    _count--;
                    _others[i] = _others[_count];
                }
            }
        }

        private function goUntilTouch():void
        {
            var crossed:ContactPoint = _rest.findCrossed();
            if (crossed != null)
            {
                _contact.copyFrom(crossed);
                contactRow = _rest.crossedRow;
                hasContact = true;
                part = 0;
            }
            else if (findFirst())
            {
                var time:Number = _sweep.timeOfTouch(_along, _contact);
                // without the lift it would have been there before
                _lift.copyFrom(at);
                _lift.decrementBy(_before);
                time += _contact.along(_lift) / _along;
                part = time > 0 ? (time < 1 ? time : 1) : 0;
                if (-part * _along < _sweep.hair && _sweep.touchesAt(contactRow, _before))
                {
                    part = 0;
                }
                hasContact = true;
                _contact.depth = 0;
            }
            at.copyFrom(_before);
            _rest.advance(at, part);
            if (hasContact && part > 0)
            {
                endTouching();
            }
        }

        // Ends in the touch, on the side that the row comes from: what has no thickness does not touch beyond it, and could not come back. Where rounding of
        // a long way hides the touch, the last hair of it is swept again. If that does not help, the row ends short of it.
        private function endTouching():void
        {
            if (!stepIntoTouch())
            {
                _lift.setTo(-_sweep.hair * _contact.normalX, -_sweep.hair * _contact.normalY, -_sweep.hair * _contact.normalZ);
                _contact.push(at, _sweep.hair / 2);
                _before.copyFrom(at);
                _sweep.aim(at, _lift);
                _sweep.findWhole(contactRow);
                _contact.push(at, -_sweep.wholeTime * _sweep.hair);
                if (_sweep.wholeTime > 1 || !stepIntoTouch())
                {
                    at.copyFrom(_before);
                }
            }
        }

        // Tries places from half of the gap across which the two touch on. Returns whether they touch.
        private function stepIntoTouch():Boolean
        {
            var gap:Number = _sweep.gapAt(at);
            _contact.push(at, gap);
            for (var i:int = 1; i < STEPS_INTO_TOUCH; i++)
            {
                if (_sweep.touchesAt(contactRow, at))
                {
                    return true;
                }
                _contact.push(at, -gap);
            }
            return _sweep.touchesAt(contactRow, at);
        }

        private function slide():void
        {
            var whole:Number = _rest.length;
            var gone:Number = 0;
            for (var turns:int = 0; turns < MOST_TURNS && isLeft(); turns++)
            {
                if (!findFirst())
                {
                    gone += _rest.advance(at, 1);
                    break;
                }
                if (!isSoon())
                {
                    _rest.beginCorner();
                    _isCareful = false;
                }
                // a gap of a whole hair would be too wide: the row would not get into a place as wide as it is
                gone += _rest.advance(at, Math.max(_sweep.timeOfTouch(_along, _contact) + _sweep.hair / 2 / _along, 0));
                _rest.add(_contact, contactRow);
                dropNeedless();
            }
            part = gone < whole ? gone / whole : 1;
        }

        // Whether any motion is left. Where a corner leaves none, its planes are found once more, with care.
        private function isLeft():Boolean
        {
            var isStuck:Boolean = !_rest.project();
            if (isStuck && !_isCareful && _rest.count > _rest.corner)
            {
                _isCareful = true;
                _rest.count = _rest.corner;
                isStuck = !_rest.project();
            }
            return !isStuck;
        }

        // At the edges of tiles a contact's plane may be of a side that the next tile hides. All that a corner has is still there: a plane without which nothing
        // is met in the corner goes.
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

        // Whether what is met first is met in the same corner.
        private function isSoon():Boolean
        {
            return _sweep.time * _rest.length < NEXT * _sweep.extent;
        }

        // Lifts the row half a hair off what it still touches of what it has touched at last, if there is room.
        private function leaveTouches():void
        {
            _before.copyFrom(at);
            for (var i:int = 0; i < _sweep.touchedCount; i++)
            {
                var other:int = _sweep.touched[i];
                if (_sweep.touchesAt(other, at))
                {
                    _sweep.findContact(other, at, _standing);
                    var by:Number = _standing.depth + _sweep.hair / 2;
                    if (by > MOST_HAIRS * _sweep.hair)
                    {
                        _standing.copyFrom(_contact);
                        by = 2 * _sweep.hair;
                    }
                    _standing.push(at, by);
                }
            }
            var isFree:Boolean = true;
            for (i = 0; i < _count && isFree && !at.equals(_before); i++)
            {
                isFree = !_sweep.touchesAt(_others[i], at);
            }
            if (!isFree)
            {
                at.copyFrom(_before);
            }
        }

        // Finds what the rest of the motion meets first.
        private function findFirst():Boolean
        {
            var motion:Vector3D = _rest.motion;
            _sweep.aim(at, motion);
            for (var i:int = 0; i < _count; i++)
            {
                if (_sweep.find(_others[i]))
                {
                    contactRow = _others[i];
                }
            }
            if (_sweep.time > 1)
            {
                return false;
            }
            _contact.copyFrom(_sweep.contact);
            _sweep.measure(contactRow);
            _along = _contact.along(motion);
            if (_along >= 0 || _isCareful)
            {
                turnAgainst(_sweep.time + NEXT * _sweep.extent / _rest.length);
            }
            return true;
        }

        // A contact whose normal does not point against the motion is of features that do not stop it, and that of two edges may have any normal. What stops the
        // motion is touched a little later.
        private function turnAgainst(later:Number):void
        {
            var motion:Vector3D = _rest.motion;
            _lift.setTo(at.x + later * motion.x, at.y + later * motion.y, at.z + later * motion.z);
            if (_sweep.touchesAt(contactRow, _lift))
            {
                _sweep.findContact(contactRow, _lift, _standing);
                if (_standing.along(motion) < 0)
                {
                    _contact.copyFrom(_standing);
                    _along = _contact.along(motion);
                }
            }
            if (_along >= 0)
            {
                _contact.setNormal(-motion.x, -motion.y, -motion.z);
                _contact.normalise();
                _along = -_rest.length;
            }
        }
    }
}
