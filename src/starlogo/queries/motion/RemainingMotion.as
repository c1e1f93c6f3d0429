package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.geometry.HalfSpaceSolver;

    /**
     * The motion that remains of a slide. It is turned so that it crosses none of the planes that the slide has met (Fauerby, "Improved collision detection
     * and response", 2003). Fauerby keeps two planes. Here all count that the Slider does not remove.
     *
     * <p>Without planes it would be the desired motion. <code>liftOverPlane()</code> and <code>flatten()</code> change the desired motion, and
     * <code>project()</code> turns it out of the planes.</p>
     *
     * @private
     */
    public final class RemainingMotion
    {
        /** A motion runs along a plane if the sine of the angle between them is at most this. */
        public static const PARALLEL_SINE:Number = 1e-12;

        /** In place of the least slope of a fall, for a motion that is no fall. */
        public static const NO_FALL:Number = 0;

        // A motion that is shorter than this fraction of the desired one counts as none.
        private static const STUCK:Number = 1e-10;

        // A slope may be less steep than a fall needs by this fraction, because its normal has rounding errors.
        private static const STEEPNESS_ROUNDING:Number = 1e-6;

        /** The remaining motion. Read only. */
        public var motion:Vector3D = new Vector3D();

        /** The length of the way so far. Read only. */
        public var travelled:Number = 0;

        // The desired motion, how far it may go on the ground plane at most, and the least slope of a fall.
        private var _desired:Vector3D = new Vector3D();
        private var _maxHorizontal:Number = Infinity;
        private var _fallSlope:Number = NO_FALL;

        // Finds the shortest displacement from the end of the desired motion out of the planes.
        private var _halfSpaces:HalfSpaceSolver = new HalfSpaceSolver();

        /**
         * Begins a slide.
         *
         * @param maxHorizontal how far it may go on the ground plane
         * @param fallSlope the least slope on which a fall goes on, as a tangent, or NO_FALL. In each corner a fall begins straight down again. So
         *     it has no momentum, and never goes up
         */
        public function begin(desired:Vector3D, maxHorizontal:Number, fallSlope:Number):void
        {
            _maxHorizontal = maxHorizontal;
            _fallSlope = fallSlope;
            _desired.copyFrom(desired);
            motion.copyFrom(desired);
            travelled = 0;
            shorten();
        }

        /** Begins a corner: the remaining motion becomes the desired one, except of a fall. */
        public function beginCorner():void
        {
            if (_fallSlope == NO_FALL)
            {
                _desired.copyFrom(motion);
            }
        }

        /** Moves a place by a fraction of the remaining motion, from 0 to 1, and takes this fraction off it. */
        public function advance(place:Vector3D, fraction:Number):void
        {
            travelled += fraction * motion.length;
            _maxHorizontal -= fraction * horizontalLength();
            place.x += fraction * motion.x;
            place.y += fraction * motion.y;
            place.z += fraction * motion.z;
            motion.scaleBy(1 - fraction);
            _desired.scaleBy(1 - fraction);
        }

        /** Makes the desired motion horizontal. */
        public function flatten():void
        {
            _desired.z = 0;
        }

        /** Makes the desired motion so steep that it does not cross a plane. Its way on the ground plane stays. */
        public function liftOverPlane(plane:ContactPoint):void
        {
            var rise:Number = -(plane.normalX * _desired.x + plane.normalY * _desired.y) / plane.normalZ;
            _desired.z = Math.max(rise, _desired.z);
        }

        /**
         * The motion that crosses no plane and is nearest to the desired one becomes the remaining motion. If this is hardly any motion, or a fall
         * that is not steep enough, none is left.
         *
         * @param without the index of a plane that does not count; -1 for none
         */
        public function project(planes:ContactList, without:int = -1):void
        {
            _halfSpaces.clear();
            for (var i:int = 0; i < planes.count; i++)
            {
                if (i != without)
                {
                    var plane:ContactPoint = planes.contacts[i];
                    _halfSpaces.add(plane.normalX, plane.normalY, plane.normalZ, -plane.along(_desired));
                }
            }
            // at a point of three planes no motion is left
            if (_halfSpaces.solve(2, PARALLEL_SINE * _desired.length))
            {
                motion.copyFrom(_desired);
                motion.incrementBy(_halfSpaces.displacement);
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
            var isTooLevel:Boolean = _fallSlope != NO_FALL && -motion.z < _fallSlope * wide * (1 - STEEPNESS_ROUNDING);
            if (wide > _maxHorizontal)
            {
                motion.scaleBy(Math.max(0, _maxHorizontal / wide));
            }
            if (isTooLevel || motion.length < STUCK * _desired.length)
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
