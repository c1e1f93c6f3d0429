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
     * A body on one motion, made smaller about the middle of its extents, and the tolerances of this motion. So it does not touch what the full
     * body only touches.
     *
     * <p>docs/mover.md derives the quantities.</p>
     *
     * @private
     */
    public final class ShrunkBody
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
        private static const MAX_SLIMNESS:Number = 10;
        private static const MAX_SHRINK:Number = 0.5;

        // The factor by which the shrink grows until the shrunk body is free.
        private static const SHRINK_GROWTH:Number = 4;

        // A body is flat if the shrunk body's nearest faces are behind its own by less than this fraction of a slop. A sweep may touch across a wider
        // gap.
        private static const FLAT_SLOPS:Number = 0.01;

        /** Has the full body. Read only. */
        public var body:MovingBody;

        /**
         * The slop of the motion, in patches: how far the shrunk body's nearest faces are behind the body's own. They are less far behind if the body
         * is slim, or if its least half-extent is less than two slops. It stays the same if the shrunk body gets smaller. Read only.
         */
        public var slop:Number = 0;

        /**
         * How far before a touch a slide ends, and beyond an overlap a push leads, in patches. It is less than the slop, so the body can enter a place as
         * wide as itself. Read only.
         */
        public var clearance:Number = 0;

        /** The part of its size that the shrunk body loses. At first, its least half-extent loses a slop. A slim or small body loses less. Read only. */
        public var shrink:Number = 0;

        /** Whether the body is so flat that the shrunk body is hardly any thinner. Read only. */
        public var isFlat:Boolean = false;

        // How much its least half-extent may lose on this motion. With it the shrunk body is free of every shallow overlap.
        private var _maxLoss:Number = 0;

        // The shrunk body where it was asked for last, and this place.
        private var _shrunk:Body = new Body();
        private var _place:Vector3D = new Vector3D();

        // A smaller copy of a row's body.
        private var _smaller:Body = new Body();

        /**
         * Becomes the shrunk body on a motion, smaller by a slop, and finds the motion's tolerances.
         *
         * @param body has the full body
         * @param rows the rows that may be in the way
         * @param from where the motion begins
         * @param motion the whole motion
         */
        public function begin(body:MovingBody, rows:IntList, from:Vector3D, motion:Vector3D):void
        {
            var largest:Number = body.largestExtentAmong(rows);
            // the ground is the last row if it is near
            var last:Body = rows.count > 0 ? body.bodyOf(rows.values[rows.count - 1]) : null;
            var cell:Number = last != null && last.kind == ModelShape.GROUND ? last.shape.grid.cellWidth : 0;
            this.body = body;
            slop = slopOf(body.extent, largest, from, cell + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            clearance = slop / 4;
            _maxLoss = slop + SHALLOW * largest;
            setShrink(shrinkOf(body.fullBody, slop));
            isFlat = shrink * body.fullBody.minHalf < FLAT_SLOPS * slop;
        }

        /**
         * The slop of a motion.
         *
         * @param extent the extent of the body
         * @param largest the largest extent of the body and of the rows near its way
         * @param from where the motion begins
         * @param way the sum of its parts along the axes, and a cell of the ground
         */
        public static function slopOf(extent:Number, largest:Number, from:Vector3D, way:Number):Number
        {
            return SLOP_OF_EXTENT * extent + SLOP_OF_OTHERS * largest + SLOP_OF_PLACES * (Math.abs(from.x) + Math.abs(from.y) + Math.abs(from.z))
                + SLOP_OF_MOTION * way;
        }

        /**
         * Makes the shrunk body smaller for this motion, if it is free of a row then. It gets no smaller than it has to be, up to a factor, because the
         * motion can lead the body into other rows as deep.
         *
         * @return whether the shrunk body is free of the row
         */
        public function shrinkUntilFree(row:int, place:Vector3D):Boolean
        {
            var tried:Number = shrink;
            var most:Number = shrinkOf(body.fullBody, _maxLoss);
            setShrink(most);
            if (touches(row, place))
            {
                setShrink(tried);
                return false;
            }
            do
            {
                tried = Math.min(SHRINK_GROWTH * tried, most);
                setShrink(tried);
            }
            while (shrink < most && touches(row, place));
            return true;
        }

        private function setShrink(value:Number):void
        {
            shrink = value;
            _shrunk.copyFrom(body.fullBody);
            _shrunk.shrink(shrink);
        }

        /** Moves the shrunk body to where it is when the body stands at a place. Returns the shrunk body, which stays there until the next call. */
        public function moveTo(place:Vector3D):Body
        {
            var fullBody:Body = body.fullBody;
            _place.x = place.x + shrink * fullBody.offsetX;
            _place.y = place.y + shrink * fullBody.offsetY;
            _place.z = place.z + shrink * fullBody.offsetZ;
            _shrunk.moveTo(_place);
            return _shrunk;
        }

        /** Whether the extents of a body, the full one or the shrunk one, come within a slop of a row's on a motion that ends where it is. */
        public function isNear(moved:Body, other:Body, motion:RelativeMotion):Boolean
        {
            if (other.kind == ModelShape.GROUND)
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

        /** Whether the full body touches a row when it stands at a place. It compares their extents first. */
        public function fullBodyTouches(row:int, place:Vector3D):Boolean
        {
            return isNear(body.moveTo(place), body.bodyOf(row), RelativeMotion.NONE) && body.touches(row, place);
        }

        /** Whether the shrunk body touches a row when the body stands at a place. The full body is tested first, because mostly it does not touch either. */
        public function touches(row:int, place:Vector3D):Boolean
        {
            return fullBodyTouches(row, place) && body.narrowPhase.areTouching(moveTo(place), body.bodyOf(row));
        }

        /**
         * Whether the full body overlaps a row that the shrunk body touches. If a concave body has something exactly between two of its sides, the
         * shrunk body may touch that, but the body does not overlap it. So the row is made smaller instead, and must touch the body then. In the
         * ground, a part of the body must be deep.
         */
        public function fullBodyOverlaps(row:int, place:Vector3D):Boolean
        {
            var other:Body = body.bodyOf(row);
            var fullBody:Body = body.moveTo(place);
            if (other.kind == ModelShape.GROUND)
            {
                return body.narrowPhase.groundTestsOf(other).isDeeper(fullBody, other, slop);
            }
            _smaller.copyFrom(other);
            _smaller.shrink(shrinkOf(other, slop));
            return body.narrowPhase.areTouching(fullBody, _smaller);
        }

        // The part of its size that a body loses if its least half-extent loses a length.
        private static function shrinkOf(body:Body, length:Number):Number
        {
            var taken:Number = length / Math.max(body.minHalf, body.maxHalf / MAX_SLIMNESS);
            return taken < MAX_SHRINK ? taken : MAX_SHRINK;
        }
    }
}
