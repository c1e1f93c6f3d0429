package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.search.penetration.HalfSpaceSolver;
    import starlogo.search.penetration.ShortestExit;

    /**
     * The rest of a motion, and the planes of the contacts that the motion has met. It turns the rest so that it crosses none of them (Fauerby, "Improved
     * collision detection and response", 2003). Fauerby keeps two planes. Here all are kept that the Slider does not remove.
     *
     * @private
     */
    public final class SlidePlanes
    {
        /** A motion runs along a plane if the sine of the angle between them is at most this. */
        public static const PARALLEL_SINE:Number = 1e-12;

        // STUCK: a motion shorter than this fraction of the whole counts as none. SAME: two planes are the same if the cosine of the angle
        // between them is greater than this.
        private static const STUCK:Number = 1e-10;
        private static const SAME:Number = 1 - 1e-14;

        // A slope may be less steep than a fall needs by this fraction, because its normal has rounding errors.
        private static const STEEPNESS_ROUNDING:Number = 1e-6;

        /** The rest of the motion. */
        public var motion:Vector3D = new Vector3D();

        /** The length of the rest. */
        public var length:Number = 0;

        /** The length of the way so far. */
        public var gone:Number = 0;

        /** The number of planes. */
        public var count:int = 0;

        /** By plane: the contact whose plane it is. */
        public var contacts:Vector.<ContactPoint> = new Vector.<ContactPoint>();

        /** By plane: the row that it belongs to. */
        public var rows:Vector.<int> = new Vector.<int>();

        /** The index of the first plane of the current corner. */
        public var corner:int = 0;

        // How far the rest may go on the ground plane at most.
        private var _maxHorizontal:Number = Infinity;

        // How far a fall has to go down for each patch on the ground plane; less than 0 for a motion that is no fall.
        private var _fallSlope:Number = -1;

        // The rest of the motion when the corner began, and the shortest displacement out of the planes from its end.
        private var _cornerMotion:Vector3D = new Vector3D();
        private var _halfSpaces:HalfSpaceSolver = new HalfSpaceSolver();
        private var _exit:ShortestExit = new ShortestExit();

        /**
         * Begins a motion, without planes.
         *
         * @param limits how it may go
         */
        public function begin(whole:Vector3D, limits:SlideLimits):void
        {
            _maxHorizontal = limits.maxHorizontal;
            _fallSlope = limits.fallSlope;
            _cornerMotion.copyFrom(whole);
            motion.copyFrom(whole);
            length = Math.sqrt(whole.x * whole.x + whole.y * whole.y + whole.z * whole.z);
            gone = 0;
            count = 0;
            beginCorner();
        }

        /**
         * Begins a corner. All planes that are added from now on belong to it. <code>project()</code> then projects the motion that
         * is left now, or for a fall the whole motion.
         */
        public function beginCorner():void
        {
            corner = count;
            if (_fallSlope < 0)
            {
                _cornerMotion.copyFrom(motion);
            }
        }

        /** Moves a place by a part of the rest, from 0 to 1, and takes this part off the rest. */
        public function advance(place:Vector3D, part:Number):void
        {
            gone += part * length;
            _maxHorizontal -= part * Math.sqrt(motion.x * motion.x + motion.y * motion.y);
            place.x += part * motion.x;
            place.y += part * motion.y;
            place.z += part * motion.z;
            motion.scaleBy(1 - part);
            _cornerMotion.scaleBy(1 - part);
            length *= 1 - part;
        }

        /**
         * Adds the plane of a contact with a row. The motion must not cross it against its normal. It replaces a plane with the same normal, up to
         * rounding.
         *
         * @return the index of the plane
         */
        public function add(contact:ContactPoint, row:int):int
        {
            var same:int = 0;
            while (same < count && !isSame(contacts[same], contact))
            {
                same++;
            }
            if (same == contacts.length)
            {
                contacts.push(new ContactPoint());
            }
            contacts[same].copyFrom(contact);
            rows[same] = row;
            count = Math.max(count, same + 1);
            return same;
        }

        /** Makes the rest of the motion level, from the next <code>project()</code> on. */
        public function makeHorizontal():void
        {
            _cornerMotion.z = 0;
        }

        /** Makes the rest so steep that it does not cross a plane, from the next <code>project()</code> on. Its way on the ground plane stays. */
        public function climb(plane:ContactPoint):void
        {
            var rise:Number = -(plane.normalX * _cornerMotion.x + plane.normalY * _cornerMotion.y) / plane.normalZ;
            _cornerMotion.z = Math.max(rise, _cornerMotion.z);
        }

        /** Removes a plane. */
        public function remove(at:int):void
        {
            count--;
            contacts[at].copyFrom(contacts[count]);
            rows[at] = rows[count];
        }

        /**
         * Finds the plane that the motion crosses at the steepest angle.
         *
         * @param out receives the contact, without a triangle, because the plane stands for all triangles of the row
         * @return the row; -1 if the motion crosses no plane
         */
        public function findCrossed(out:ContactPoint):int
        {
            var row:int = -1;
            var least:Number = -PARALLEL_SINE * length;
            for (var i:int = 0; i < count; i++)
            {
                var along:Number = contacts[i].along(motion);
                if (along < least)
                {
                    least = along;
                    row = rows[i];
                    out.copyFrom(contacts[i]);
                    out.triangle = -1;
                }
            }
            return row;
        }

        /**
         * Makes the rest the motion that crosses no plane and is nearest to what it was when the corner began. If this is hardly any motion, or a fall
         * that is not steep enough, none is left.
         *
         * @param without the index of a plane that does not count; -1 for none
         */
        public function project(without:int = -1):void
        {
            _halfSpaces.begin();
            for (var i:int = 0; i < count; i++)
            {
                if (i != without)
                {
                    _halfSpaces.add(contacts[i].normalX, contacts[i].normalY, contacts[i].normalZ, -contacts[i].along(_cornerMotion));
                }
            }
            var whole:Number = Math.sqrt(_cornerMotion.x * _cornerMotion.x + _cornerMotion.y * _cornerMotion.y + _cornerMotion.z * _cornerMotion.z);
            stop();
            // at a point of three planes no motion is left
            if (_halfSpaces.solve(2, PARALLEL_SINE * whole, _exit))
            {
                motion.copyFrom(_cornerMotion);
                motion.incrementBy(_exit.displacement);
                length = Math.sqrt(motion.x * motion.x + motion.y * motion.y + motion.z * motion.z);
            }
            if (isTooLevel())
            {
                stop();
                return;
            }
            shortenHorizontally();
            if (length <= STUCK * whole)
            {
                stop();
            }
        }

        private function stop():void
        {
            length = 0;
            motion.setTo(0, 0, 0);
        }

        private static function isSame(a:ContactPoint, b:ContactPoint):Boolean
        {
            return a.normalX * b.normalX + a.normalY * b.normalY + a.normalZ * b.normalZ > SAME;
        }

        // Whether this is a fall that is not steep enough.
        private function isTooLevel():Boolean
        {
            return _fallSlope >= 0 && -motion.z < _fallSlope * Math.sqrt(motion.x * motion.x + motion.y * motion.y) * (1 - STEEPNESS_ROUNDING);
        }

        // Shortens the motion to how far it may still go on the ground plane.
        private function shortenHorizontally():void
        {
            var wide:Number = Math.sqrt(motion.x * motion.x + motion.y * motion.y);
            if (wide > _maxHorizontal)
            {
                var share:Number = Math.max(0, _maxHorizontal / wide);
                motion.scaleBy(share);
                length *= share;
            }
        }
    }
}
