package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.RelativeMotion;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * The core of a body on one motion, and the tolerances of this motion. The core is the body, made smaller by a slop about the middle of its
     * extents. So it does not touch what the body only touches.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class BodyCore
    {
        /** An overlap is shallow if it is at most this part of the larger extent. */
        public static const SHALLOW:Number = 1000 * Tolerances.SEPARATION;

        // The slop has four parts: fractions of the body's extent, of the largest extent near it, of the coordinates, and of the motion and a cell of
        // the ground. An eighth of it is wider than the gap across which a sweep touches.
        private static const SLOP_OF_EXTENT:Number = 0.4 * Tolerances.SEPARATION;
        private static const SLOP_OF_OTHERS:Number = 0.02 * Tolerances.SEPARATION;
        private static const SLOP_OF_PLACES:Number = 16 * Tolerances.PLACES;
        private static const SLOP_OF_MOTION:Number = 24 * Tolerances.ROUNDING;

        // The least half-extent of the body loses a slop, and the others lose in proportion. For a slim body, a tenth of its largest half-extent
        // takes the place of the least one. So no half-extent loses more than ten slops. The body loses at most half of its size.
        private static const MOST_SLIMNESS:Number = 10;
        private static const MOST_SHRINK:Number = 0.5;

        // The factor by which the inset grows until the core is free.
        private static const NARROWING:Number = 4;

        // A body is flat if its core's nearest faces are behind its own by less than this fraction of a slop. A sweep may touch across a wider gap.
        private static const FLAT_SLOPS:Number = 0.01;

        private static const NO_MOTION:Vector3D = new Vector3D();

        /** The whole body. Read only. */
        public var moving:MovingBody;

        /**
         * The slop of the motion, in patches: how far the core's nearest faces are behind the body's own. They are less far behind if the body is slim, or
         * if its least half-extent is less than two slops. A narrower core does not change the slop. Read only.
         */
        public var slop:Number = 0;

        /** How far before a touch a slide ends, in patches. It is less than the slop, so the body can enter a place as wide as itself. Read only. */
        public var clearance:Number = 0;

        /** The part of its size that the core loses. Read only. */
        public var shrink:Number = 0;

        /** Whether the body is too flat for its core to be narrower. Read only. */
        public var isFlat:Boolean = false;

        // How much of its least half-extent the core should lose: a slop at first. A slim or small body loses less.
        private var _inset:Number = 0;

        // The largest inset that the motion may have. With it the core is free of every shallow overlap.
        private var _mostInset:Number = 0;

        // The core where it was asked for last, and this place.
        private var _core:Body = new Body();
        private var _place:Vector3D = new Vector3D();

        // A smaller copy of a row's body.
        private var _smaller:Body = new Body();

        /**
         * Becomes the core of a body on a motion, with an inset of a slop, and finds the motion's tolerances.
         *
         * @param body the whole body
         * @param rows the rows that may be in the way
         * @param from where the motion begins
         * @param motion the whole motion
         */
        public function begin(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D):void
        {
            var extent:Number = body.extent;
            var largest:Number = extent;
            var cell:Number = 0;
            moving = body;
            for (var i:int = 0; i < rows.count; i++)
            {
                var other:Body = body.bodyOf(rows.numbers[i]);
                if (other.form == ModelShape.GROUND)
                {
                    cell = other.shape.grid.cellWidth;
                }
                largest = Math.max(largest, 2 * other.largestHalf);
            }
            slop = SLOP_OF_EXTENT * extent + SLOP_OF_OTHERS * largest + SLOP_OF_PLACES * (Math.abs(from.x) + Math.abs(from.y) + Math.abs(from.z))
                + SLOP_OF_MOTION * (cell + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            clearance = slop / 4;
            _mostInset = slop + SHALLOW * largest;
            setInset(slop);
            isFlat = shrink * body.whole.leastHalf < FLAT_SLOPS * slop;
        }

        /** Becomes the core of a body that stands at a place, among its rows. */
        public function beginStanding(body:MovingBody, place:Vector3D):void
        {
            begin(body, body.rows, place, NO_MOTION);
        }

        /**
         * Makes the core narrower for this motion, if it is free of a row then. It becomes no narrower than it has to be, up to a factor, because the
         * motion can lead the body into other rows as deep as its core is narrow.
         *
         * @return whether the core is free of the row
         */
        public function narrow(row:int, place:Vector3D):Boolean
        {
            var inset:Number = _inset;
            while (_inset < _mostInset)
            {
                setInset(Math.min(NARROWING * _inset, _mostInset));
                if (!coreTouches(row, place))
                {
                    return true;
                }
            }
            setInset(inset);
            return false;
        }

        private function setInset(width:Number):void
        {
            _inset = width;
            shrink = shrinkOf(moving.whole, width);
            _core.copyFrom(moving.whole);
            _core.shrink(shrink);
        }

        /** Moves the core to where it is when the body stands at a place. Returns the core, which stays there until the next call. */
        public function moveTo(place:Vector3D):Body
        {
            var whole:Body = moving.whole;
            _place.setTo(place.x + shrink * whole.offsetX, place.y + shrink * whole.offsetY, place.z + shrink * whole.offsetZ);
            _core.moveTo(_place);
            return _core;
        }

        /** Whether the extents of a body, the whole one or its core, come within a slop of a row's on a motion that ends where it is. */
        public function isNear(moved:Body, other:Body, motion:RelativeMotion):Boolean
        {
            if (other.form == ModelShape.GROUND)
            {
                return true;
            }
            var x:Number = motion.x / 2;
            var y:Number = motion.y / 2;
            var z:Number = motion.z / 2;
            return Math.abs(moved.middleX - x - other.middleX) <= moved.halfX + other.halfX + Math.abs(x) + slop
                && Math.abs(moved.middleY - y - other.middleY) <= moved.halfY + other.halfY + Math.abs(y) + slop
                && Math.abs(moved.middleZ - z - other.middleZ) <= moved.halfZ + other.halfZ + Math.abs(z) + slop;
        }

        /** Whether the whole body touches a row when it stands at a place. It compares their extents first. */
        public function bodyTouches(row:int, place:Vector3D):Boolean
        {
            return isNear(moving.moveTo(place), moving.bodyOf(row), RelativeMotion.NONE) && moving.touches(row, place);
        }

        /** Whether the core touches a row when the body stands at a place. The whole body is tested first, because mostly it does not touch either. */
        public function coreTouches(row:int, place:Vector3D):Boolean
        {
            return bodyTouches(row, place) && moving.narrowPhase.areTouching(moveTo(place), moving.bodyOf(row));
        }

        /**
         * Whether the whole body overlaps a row that the core touches. If a concave body has something exactly between two of its sides, the core may
         * touch that, but the body does not overlap it. So the row is made smaller instead, and must touch the body then. In the ground, a part of
         * the body must be deep.
         */
        public function bodyOverlaps(row:int, place:Vector3D):Boolean
        {
            var other:Body = moving.bodyOf(row);
            var whole:Body = moving.moveTo(place);
            if (other.form == ModelShape.GROUND)
            {
                return moving.narrowPhase.groundTestsOf(other).isDeeper(whole, other, slop);
            }
            _smaller.copyFrom(other);
            _smaller.shrink(shrinkOf(other, slop));
            return moving.narrowPhase.areTouching(whole, _smaller);
        }

        // The part of its size that a body loses with an inset.
        private static function shrinkOf(body:Body, inset:Number):Number
        {
            var taken:Number = inset / Math.max(body.leastHalf, body.largestHalf / MOST_SLIMNESS);
            return taken < MOST_SHRINK ? taken : MOST_SHRINK;
        }
    }
}
