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
     * What a row of a table would go into as it moves: what it only touches, leaves or runs along is not met.
     *
     * <p>Two rows meet if they touch in both of two trials: with the moving row a hair smaller than it is, about the middle of its extents, and with the
     * other a hair smaller. One alone is not enough: a sheet is too thin to lose a hair of its thickness, and the inner faces of a U come nearer to the
     * post that it is round.</p>
     *
     * @private
     */
    public final class NarrowSweep
    {
        // A hair, as a part of the larger extent; besides, of what places and motions are rounded by, how many times as much.
        private static const HAIR:Number = 0.02 * Tolerances.SEPARATION;
        private static const OF_PLACES:Number = 16 * Tolerances.PLACES;
        private static const OF_MOTION:Number = 3 * Tolerances.ROUNDING;

        // A row loses a hair of its least extent, or of the largest divided by this: so its corners lose no more than that many hairs, and half of it at most.
        private static const SLIMMEST:Number = 10;
        private static const MOST_SHARE:Number = 0.5;

        // A time after the end of a motion.
        private static const AFTER:Number = 1 + 1e-15;

        /** The larger extent of the last pair that was asked about. */
        public var extent:Number = 0;

        /** How wide a hair is between the two. */
        public var hair:Number = 0;

        /** When it meets the first that was found, as a part of the motion; after 1 if none was. */
        public var time:Number = 0;

        /** How it does. */
        public var contact:ContactPoint = new ContactPoint();

        /** When the row, as large as it is, touches the last that was asked about. */
        public var wholeTime:Number = 0;

        /** What it has touched, met or not: the first of these rows. */
        public var touched:Vector.<int> = new Vector.<int>();

        /** How many these are. */
        public var touchedCount:int = 0;

        private var _pairs:RowPairs;
        private var _separation:Separation;
        private var _table:AgentTable;
        private var _row:int;
        private var _moving:MovedRow = new MovedRow();
        private var _standing:MovedRow = new MovedRow();

        // How much of a hair is because of rounding.
        private var _rounding:Number = 0;

        // Of the row of the pair that was smaller when the two met: where its middle was, and the share that it lacked, less than 0 if it was the one that moves.
        private var _middleX:Number = 0;
        private var _middleY:Number = 0;
        private var _middleZ:Number = 0;
        private var _loss:Number = 0;

        // The motion, and where the row is after it.
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _end:Vector3D = new Vector3D();

        // When the row, as large as it is, touches what was found.
        private var _foundWhole:Number = 0;
        private var _tried:ContactPoint = new ContactPoint();
        private var _triedOther:ContactPoint = new ContactPoint();

        /** @param pairs decide what touches */
        public function NarrowSweep(pairs:RowPairs)
        {
            _pairs = pairs;
            _separation = new Separation(pairs);
        }

        /** Takes a row that moves; <code>end()</code> has to follow. */
        public function begin(table:AgentTable, row:int, motion:Vector3D):void
        {
            _table = table;
            _row = row;
            touchedCount = 0;
            _moving.take(table, row);
            _rounding = OF_PLACES * (Math.abs(table.x[row]) + Math.abs(table.y[row]) + Math.abs(table.z[row]))
                + OF_MOTION * (Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
        }

        /** Puts the row back as it was. */
        public function end():void
        {
            _moving.giveBack();
            _table = null;
        }

        /** Whether the row touches another at a place. */
        public function touchesAt(other:int, at:Vector3D):Boolean
        {
            measure(other);
            _moving.put(at, 0);
            return isNear(other, RelativeMotion.NONE) && _pairs.areTouching(_table, _row, other);
        }

        /** Whether the row would have to go into another to be at a place. */
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
            return isMeeting && _pairs.areTouching(_table, _row, other);
        }

        /** How the row, which touches another at a place, touches it. */
        public function findContact(other:int, at:Vector3D, out:ContactPoint):void
        {
            measure(other);
            _moving.put(at, 0);
            RelativeMotion.NONE.time = 0;
            _pairs.findContact(_table, _row, other, RelativeMotion.NONE, out);
            _separation.find(_table, _row, other, RelativeMotion.NONE, out);
        }

        /** Sets the motion that is asked about from now on; nothing has been found or touched on it. */
        public function aim(at:Vector3D, motion:Vector3D):void
        {
            _end.copyFrom(at);
            _end.incrementBy(motion);
            _motion.endAfter(motion.x, motion.y, motion.z);
            time = AFTER;
            touchedCount = 0;
        }

        /** Finds when the row, as large as it is, first touches another: <code>wholeTime</code>. */
        public function findWhole(other:int):void
        {
            measure(other);
            _moving.put(_end, 0);
            wholeTime = RelativeMotion.NEVER;
            if (isNear(other, _motion))
            {
                _pairs.findImpact(_table, _row, other, _motion, null);
                wholeTime = _motion.time;
            }
        }

        /** Half of the gap across which the last two that were asked about still touch at a place, unless they are spheres or points. */
        public function gapAt(at:Vector3D):Number
        {
            return Tolerances.SURFACES / 4 * extent + Tolerances.PLACES / 2 * (Math.abs(at.x) + Math.abs(at.y) + Math.abs(at.z));
        }

        /** Whether the row meets another, and earlier than what was found before: then this is found, <code>time</code> and <code>contact</code>. */
        public function find(other:int):Boolean
        {
            findWhole(other);
            if (!(wholeTime < time))
            {
                return false;
            }
            touched[touchedCount] = other;
            touchedCount++;
            narrowOther(other);
            _pairs.findImpact(_table, _row, other, _motion, _triedOther);
            _standing.giveBack();
            var second:Number = _motion.time;
            if (!(second < time))
            {
                return false;
            }
            var share:Number = shareOf(_moving);
            _moving.put(_end, share);
            _pairs.findImpact(_table, _row, other, _motion, _tried);
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
                    // it loses as much everywhere
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
         * Finds when the row, as large as it is, first touches what <code>find()</code> has found. Where it touches that at the beginning already, as
         * a floor that has a wall, the time is that at which it would be as deep as the smaller row is not.
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

        /** Finds the larger extent of the row and another, and how wide a hair is between them. */
        public function measure(other:int):void
        {
            extent = 2 * Math.max(_table.extents.largestHalf(other), _moving.largestHalf);
            hair = HAIR * extent + _rounding;
        }

        // Whether the extents of the row, all along a motion that ends where it is, come as near to those of another as a hair.
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

        private function narrowOther(other:int):void
        {
            _standing.take(_table, other);
            _standing.narrow(shareOf(_standing));
        }

        private function shareOf(row:MovedRow):Number
        {
            var share:Number = hair / Math.max(row.leastHalf, row.largestHalf / SLIMMEST);
            return share < MOST_SHARE ? share : MOST_SHARE;
        }
    }
}
