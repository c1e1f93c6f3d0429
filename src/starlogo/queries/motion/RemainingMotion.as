package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.search.penetration.HalfSpaceSolver;
    import starlogo.search.penetration.ShortestDisplacement;

    /**
     * The motion that remains of a slide. It is turned so that it crosses none of the planes that the slide has met (Fauerby, "Improved collision detection
     * and response", 2003). Fauerby keeps two planes. Here all count that the Slider does not remove.
     *
     * <p>Without planes it would be the wanted motion. <code>climb()</code> and <code>level()</code> change the wanted motion, and
     * <code>project()</code> turns it out of the planes.</p>
     *
     * @private
     */
    public final class RemainingMotion
    {
        /** A motion runs along a plane if the sine of the angle between them is at most this. */
        public static const PARALLEL_SINE:Number = 1e-12;

        // A motion that is shorter than this fraction of the wanted one counts as none.
        private static const STUCK:Number = 1e-10;

        // A slope may be less steep than a fall needs by this fraction, because its normal has rounding errors.
        private static const STEEPNESS_ROUNDING:Number = 1e-6;

        /** The remaining motion. Read only. */
        public var motion:Vector3D = new Vector3D();

        /** The length of the way so far. Read only. */
        public var gone:Number = 0;

        private var _limits:SlideLimits = SlideLimits.NONE;

        // The wanted motion, and how far it may go on the ground plane at most.
        private var _wanted:Vector3D = new Vector3D();
        private var _maxHorizontal:Number = Infinity;

        // The shortest displacement from the end of the wanted motion out of the planes.
        private var _halfSpaces:HalfSpaceSolver = new HalfSpaceSolver();
        private var _exit:ShortestDisplacement = new ShortestDisplacement();

        /**
         * Begins a slide.
         *
         * @param limits how it may go
         */
        public function begin(wanted:Vector3D, limits:SlideLimits):void
        {
            _limits = limits;
            _maxHorizontal = limits.maxHorizontal;
            _wanted.copyFrom(wanted);
            motion.copyFrom(wanted);
            gone = 0;
            shorten();
        }

        /** Begins a corner: the remaining motion becomes the wanted one. A fall begins each corner straight down again. */
        public function beginCorner():void
        {
            if (!_limits.isFall)
            {
                _wanted.copyFrom(motion);
            }
        }

        /** Moves a place by a fraction of the remaining motion, from 0 to 1, and takes this fraction off it. */
        public function advance(place:Vector3D, fraction:Number):void
        {
            gone += fraction * motion.length;
            _maxHorizontal -= fraction * horizontalLength();
            place.x += fraction * motion.x;
            place.y += fraction * motion.y;
            place.z += fraction * motion.z;
            motion.scaleBy(1 - fraction);
            _wanted.scaleBy(1 - fraction);
        }

        /** Makes the wanted motion level. */
        public function level():void
        {
            _wanted.z = 0;
        }

        /** Makes the wanted motion so steep that it does not cross a plane. Its way on the ground plane stays. */
        public function climb(plane:ContactPoint):void
        {
            var rise:Number = -(plane.normalX * _wanted.x + plane.normalY * _wanted.y) / plane.normalZ;
            _wanted.z = Math.max(rise, _wanted.z);
        }

        /**
         * The motion that crosses no plane and is nearest to the wanted one becomes the remaining motion. If this is hardly any motion, or a fall that is not steep
         * enough, none is left.
         *
         * @param without the index of a plane that does not count; -1 for none
         */
        public function project(planes:ContactList, without:int = -1):void
        {
            _halfSpaces.begin();
            for (var i:int = 0; i < planes.count; i++)
            {
                if (i != without)
                {
                    var plane:ContactPoint = planes.contacts[i];
                    _halfSpaces.add(plane.normalX, plane.normalY, plane.normalZ, -plane.along(_wanted));
                }
            }
            // at a point of three planes no motion is left
            if (_halfSpaces.solve(2, PARALLEL_SINE * _wanted.length, _exit))
            {
                motion.copyFrom(_wanted);
                motion.incrementBy(_exit.displacement);
                shorten();
            }
            else
            {
                motion.setTo(0, 0, 0);
            }
        }

        // Shortens the remaining motion to how far it may still go on the ground plane. None is left of a fall that is not steep enough, and of hardly any motion.
        private function shorten():void
        {
            var wide:Number = horizontalLength();
            var isTooLevel:Boolean = _limits.isFall && -motion.z < _limits.fallSlope * wide * (1 - STEEPNESS_ROUNDING);
            if (wide > _maxHorizontal)
            {
                motion.scaleBy(Math.max(0, _maxHorizontal / wide));
            }
            if (isTooLevel || motion.length < STUCK * _wanted.length)
            {
                motion.setTo(0, 0, 0);
            }
        }

        // The length of the remaining motion on the ground plane.
        private function horizontalLength():Number
        {
            return Math.sqrt(motion.x * motion.x + motion.y * motion.y);
        }
    }
}
