package starlogo.queries
{
    import flash.geom.Vector3D;
    import starlogo.broadphase.Extents;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.intersection.contact.ContactPoint;
    import starlogo.intersection.sweep.RelativeMotion;
    import starlogo.search.AgentTable;
    import starlogo.search.ModelShape;
    import starlogo.search.MovedRow;
    import starlogo.search.RowPairs;
    import starlogo.search.Separation;

    use namespace engine;

    /**
     * Finds the rows that a moving row of a table would go into. A row that it only touches, leaves or runs along does not stop it.
     *
     * <p>Two rows meet if they touch in both of two trials. In the first trial the moving row is a hair smaller than it is, about the middle of
     * its extents. In the second trial the other row is a hair smaller. A hair is 2e-11 of the larger extent, plus rounding errors.</p>
     *
     * <p>One trial is not enough. A sheet is too thin to lose a hair of its thickness. And if a U becomes smaller, its inner faces come nearer
     * to a post between them.</p>
     *
     * @private
     */
    public final class NarrowSweep
    {
        // HAIR is the width of a hair, as a part of the larger extent. The rounding errors of places and motions, times the other two factors,
        // are added to it.
        private static const HAIR:Number = 0.02 * Tolerances.SEPARATION;
        private static const OF_PLACES:Number = 16 * Tolerances.PLACES;
        private static const OF_MOTION:Number = 3 * Tolerances.ROUNDING;

        // In a trial the smallest half-extent of the smaller row loses a hair, and the others lose in proportion. For a slim row, a tenth
        // of its largest half-extent takes the place of the smallest one. So no half-extent loses more than ten hairs. A row loses at most
        // half of its size.
        private static const SLIMMEST:Number = 10;
        private static const MOST_SHARE:Number = 0.5;

        // An overlap is shallow if it is at most this part of the larger extent.
        private static const SHALLOW:Number = 1000 * Tolerances.SEPARATION;

        // A time after the end of the motion.
        private static const AFTER:Number = 1 + 1e-15;

        /** The larger extent of the last pair that was tested. */
        public var extent:Number = 0;

        /** The width of a hair for the last pair that was tested, in patches. */
        public var hair:Number = 0;

        /** When the row meets the first row that was found, as a part of the motion. If none was found, it is greater than 1. */
        public var time:Number = 0;

        /** The contact at that time. */
        public var contact:ContactPoint = new ContactPoint();

        /** When the row in its whole size touches the last row that was tested. */
        public var wholeTime:Number = 0;

        /**
         * The rows that it touched at the beginning, or on the last part of its way, whether it met them or not. A row may be there twice. The
         * list may be longer than <code>touchedCount</code>.
         */
        public var touched:Vector.<int> = new Vector.<int>();

        /** The number of rows that it has touched. */
        public var touchedCount:int = 0;

        // The number of rows that it touched at the beginning.
        private var _firstCount:int = 0;

        private var _pairs:RowPairs;
        private var _separation:Separation;
        private var _table:AgentTable;
        private var _row:int;
        private var _moving:MovedRow = new MovedRow();
        private var _standing:MovedRow = new MovedRow();

        // Whether rows lose more than a hair in a trial.
        private var _isWide:Boolean = false;

        // The part of a hair that stands for rounding errors.
        private var _rounding:Number = 0;

        // The smaller row of the two when they met: its middle, and the part of its size that was taken off. The part is negative if the
        // smaller row is the moving row.
        private var _middleX:Number = 0;
        private var _middleY:Number = 0;
        private var _middleZ:Number = 0;
        private var _loss:Number = 0;

        // The motion, and the row's places at its beginning and at its end.
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _start:Vector3D = new Vector3D();
        private var _end:Vector3D = new Vector3D();

        // When the row in its whole size touches the row that was found.
        private var _foundWhole:Number = 0;
        private var _tried:ContactPoint = new ContactPoint();
        private var _triedOther:ContactPoint = new ContactPoint();

        /** @param pairs decides which rows touch */
        public function NarrowSweep(pairs:RowPairs)
        {
            _pairs = pairs;
            _separation = new Separation(pairs);
        }

        /** Begins with the row that moves. Call <code>end()</code> at the end. */
        public function begin(table:AgentTable, row:int):void
        {
            _table = table;
            _row = row;
            _moving.take(table, row);
        }

        /** Puts the row back to its own place, in its whole size, and the other row of a trial too. */
        public function end():void
        {
            _standing.giveBack();
            _moving.giveBack();
            _table = null;
        }

        /** Whether the row touches another when it stands at a place. */
        public function touchesAt(other:int, at:Vector3D):Boolean
        {
            measure(other);
            _moving.put(at, 0);
            return isNear(other, RelativeMotion.NONE) && _pairs.areTouching(_table, _row, other);
        }

        /** Whether the row goes into another at the beginning of its way. If it only touches the other, this is remembered. */
        public function meetsAt(other:int, at:Vector3D):Boolean
        {
            if (!touchesAt(other, at))
            {
                return false;
            }
            narrowOther(other);
            var isMeeting:Boolean = _pairs.areTouching(_table, _row, other);
            _standing.giveBack();
            _moving.put(at, shareOf(_moving));
            isMeeting &&= _pairs.areTouching(_table, _row, other);
            if (!isMeeting)
            {
                addTouched(other);
                _firstCount = touchedCount;
            }
            return isMeeting;
        }

        /**
         * Finds the contact of the row at a place with another row that it touches there.
         *
         * @param isDeep whether the contact has to separate the two rows. Otherwise, a shallow contact of two of their parts may do, because the
         *     ground can be a floor and a wall, and the contact with one of them does not lead away from the other
         * @return whether the contact is shallow
         */
        public function findContact(other:int, at:Vector3D, out:ContactPoint, isDeep:Boolean = false):Boolean
        {
            measure(other);
            _moving.put(at, 0);
            _pairs.testsOf(_table, _row, other).findContact(_table, _row, other, RelativeMotion.NONE, out);
            if (isDeep || out.depth > SHALLOW * extent)
            {
                _separation.find(_table, _row, other, RelativeMotion.NONE, out);
            }
            return out.depth <= SHALLOW * extent;
        }

        /**
         * From now on, rows also lose SHALLOW of the larger extent in trials, if the row at a place does not meet another then. Otherwise their
         * overlap would hide what stops the row later.
         *
         * @return whether it does not
         */
        public function widenFor(other:int, at:Vector3D):Boolean
        {
            var wasWide:Boolean = _isWide;
            _isWide = true;
            var isFree:Boolean = !meetsAt(other, at);
            _isWide = wasWide || isFree;
            return isFree;
        }

        /** Begins another motion from a place: forgets all rows that it has touched. */
        public function beginMotion(at:Vector3D, motion:Vector3D):void
        {
            _rounding = OF_PLACES * (Math.abs(at.x) + Math.abs(at.y) + Math.abs(at.z))
                + OF_MOTION * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            _isWide = false;
            touchedCount = _firstCount = 0;
        }

        /** Sets the motion for the next tests. It forgets what was found on the way before. */
        public function aim(at:Vector3D, motion:Vector3D):void
        {
            _start.copyFrom(at);
            _end.copyFrom(at);
            _end.incrementBy(motion);
            _motion.endAfter(motion.x, motion.y, motion.z);
            time = AFTER;
            touchedCount = _firstCount;
        }

        /** Finds when the row in its whole size first touches another, and writes it to <code>wholeTime</code>. */
        public function findWhole(other:int):void
        {
            measure(other);
            _moving.put(_end, 0);
            wholeTime = RelativeMotion.NEVER;
            if (isNear(other, _motion))
            {
                findImpact(other, 0, null);
                wholeTime = _motion.time;
            }
        }

        // Finds when the row, which stands at its end, first touches another. A sheet may be wholly under the ground at the beginning, and then it touches no surface.
        private function findImpact(other:int, share:Number, out:ContactPoint):void
        {
            _pairs.testsOf(_table, _row, other).findImpact(_table, _row, other, _motion, out);
            if (_motion.time == RelativeMotion.NEVER && _table.forms[other] == ModelShape.GROUND)
            {
                _moving.put(_start, share);
                _motion.time = _pairs.areTouching(_table, _row, other) ? 0 : RelativeMotion.NEVER;
                _moving.put(_end, share);
            }
        }

        /** Half of the gap across which the last two tested rows still touch, at a place. It does not apply to spheres and points. */
        public function gapAt(at:Vector3D):Number
        {
            return Tolerances.SURFACES / 4 * extent + Tolerances.PLACES / 2 * (Math.abs(at.x) + Math.abs(at.y) + Math.abs(at.z));
        }

        /**
         * Tests whether the row meets another earlier than the row that was found before. If so, it writes <code>time</code> and
         * <code>contact</code>.
         */
        public function find(other:int):Boolean
        {
            findWhole(other);
            if (!(wholeTime < time))
            {
                return false;
            }
            addTouched(other);
            narrowOther(other);
            _pairs.testsOf(_table, _row, other).findImpact(_table, _row, other, _motion, _triedOther);
            _standing.giveBack();
            var second:Number = _motion.time;
            if (!(second < time))
            {
                return false;
            }
            var share:Number = shareOf(_moving);
            _moving.put(_end, share);
            findImpact(other, share, _tried);
            var first:Number = _motion.time;
            if (!(first < time))
            {
                return false;
            }
            var extents:Extents = _table.extents;
            _foundWhole = wholeTime;
            if (second > first)
            {
                time = second;
                contact.copyFrom(_triedOther);
                _loss = shareOf(_standing);
                _middleX = extents.x[other];
                _middleY = extents.y[other];
                _middleZ = extents.z[other];
                if (_table.forms[other] == ModelShape.GROUND)
                {
                    // the ground becomes narrower by the same width everywhere
                    _middleX = contact.x - extents.halfX[other] * contact.normalX;
                    _middleY = contact.y - extents.halfX[other] * contact.normalY;
                    _middleZ = contact.z - extents.halfX[other] * contact.normalZ;
                }
            }
            else
            {
                time = first;
                contact.copyFrom(_tried);
                _loss = -share;
                _middleX = extents.x[_row] - (1 - time) * _motion.x;
                _middleY = extents.y[_row] - (1 - time) * _motion.y;
                _middleZ = extents.z[_row] - (1 - time) * _motion.z;
            }
            return true;
        }

        /**
         * Finds when the row in its whole size first touches the row that <code>find()</code> has found. The two may touch from the beginning,
         * for example if one agent is the floor under the row and also the wall in its way. Then the result is the time of the smaller row, made
         * earlier by the width that this row has lost at the contact.
         *
         * @param along how far the motion goes along the contact's normal, less than 0
         * @param touch has that normal
         */
        public function timeOfTouch(along:Number, touch:ContactPoint):Number
        {
            var deeper:Number = _loss * (touch.normalX * (touch.x - _middleX) + touch.normalY * (touch.y - _middleY) + touch.normalZ * (touch.z - _middleZ));
            // the smaller row never touches before the whole one
            var earlier:Number = deeper > 0 ? deeper / along : 0;
            return Math.min(time, _foundWhole > time + earlier / 2 ? _foundWhole : time + earlier);
        }

        /**
         * Finds the larger extent of the row and another, and the width of a hair between them. The ground's extents are those of a cell. Cells
         * only add rounding errors, because they are tested with the row's margins.
         */
        public function measure(other:int):void
        {
            var largest:Number = _table.extents.largestHalf(other);
            var isGround:Boolean = _table.forms[other] == ModelShape.GROUND;
            extent = isGround ? 2 * _moving.largestHalf : 2 * Math.max(largest, _moving.largestHalf);
            hair = HAIR * extent + _rounding;
            if (isGround)
            {
                hair += OF_PLACES * largest;
            }
        }

        // Whether the extents of the row come within a hair of another's, anywhere on a motion that ends at the row's place in the table.
        private function isNear(other:int, motion:RelativeMotion):Boolean
        {
            if (_table.forms[other] == ModelShape.GROUND)
            {
                return true;
            }
            var extents:Extents = _table.extents;
            var x:Number = motion.x / 2;
            var y:Number = motion.y / 2;
            var z:Number = motion.z / 2;
            return Math.abs(extents.x[_row] - x - extents.x[other]) <= extents.halfX[_row] + extents.halfX[other] + Math.abs(x) + hair
                && Math.abs(extents.y[_row] - y - extents.y[other]) <= extents.halfY[_row] + extents.halfY[other] + Math.abs(y) + hair
                && Math.abs(extents.z[_row] - z - extents.z[other]) <= extents.halfZ[_row] + extents.halfZ[other] + Math.abs(z) + hair;
        }

        private function addTouched(other:int):void
        {
            touched[touchedCount] = other;
            touchedCount++;
        }

        private function narrowOther(other:int):void
        {
            _standing.take(_table, other);
            _standing.narrow(shareOf(_standing));
        }

        private function shareOf(row:MovedRow):Number
        {
            var width:Number = _isWide ? hair + SHALLOW * extent : hair;
            var share:Number = width / Math.max(row.leastHalf, row.largestHalf / SLIMMEST);
            return share < MOST_SHARE ? share : MOST_SHARE;
        }
    }
}
