package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.data.IntList;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.search.Body;
    import starlogo.search.ModelShape;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * The core of a body that moves, and the tolerances of the motion. The core is the body, made smaller by a slop about the middle of its extents. So
     * it does not touch what the body only touches.
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
        private static const OF_EXTENT:Number = 0.4 * Tolerances.SEPARATION;
        private static const OF_OTHERS:Number = 0.02 * Tolerances.SEPARATION;
        private static const OF_PLACES:Number = 16 * Tolerances.PLACES;
        private static const OF_MOTION:Number = 24 * Tolerances.ROUNDING;

        // The least half-extent of the body loses a slop, and the others lose in proportion. For a slim body, a tenth of its largest half-extent
        // takes the place of the least one. So no half-extent loses more than ten slops. The body loses at most half of its size.
        private static const SLIMMEST:Number = 10;
        private static const MOST_SHRINK:Number = 0.5;

        // The factor by which the inset grows until the core is free.
        private static const NARROWER:Number = 4;

        // A body is flat if its core's nearest faces are behind its own by less than this fraction of a slop. A sweep may touch across a wider gap.
        private static const FLAT:Number = 0.01;

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

        private var _source:Body;

        // How much of its least half-extent the core should lose: a slop at first. A slim or small body loses less.
        private var _inset:Number = 0;

        // The largest inset that the motion may have. With it the core is free of every shallow overlap.
        private var _mostInset:Number = 0;

        // The core at the place where it was asked for last; and this place, whose x is NaN if the core's size has changed.
        private var _core:Body = new Body();
        private var _place:Vector3D = new Vector3D();

        /** @param source the whole body. It may become another one between two motions */
        public function BodyCore(source:Body)
        {
            _source = source;
        }

        /**
         * Finds the tolerances of a motion, and begins with an inset of a slop.
         *
         * @param table has the bodies of the rows
         * @param rows the rows that may be in the way
         * @param from where the motion begins
         * @param motion the whole motion
         */
        public function begin(table:AgentTable, rows:IntList, from:Vector3D, motion:Vector3D):void
        {
            var extent:Number = 2 * _source.largestHalf;
            var largest:Number = extent;
            var cell:Number = 0;
            for (var i:int = 0; i < rows.count; i++)
            {
                var other:Body = table.bodyOf(rows.numbers[i]);
                if (other.form == ModelShape.GROUND)
                {
                    cell = 2 * other.largestHalf;
                }
                else
                {
                    largest = Math.max(largest, 2 * other.largestHalf);
                }
            }
            slop = OF_EXTENT * extent + OF_OTHERS * largest + OF_PLACES * (Math.abs(from.x) + Math.abs(from.y) + Math.abs(from.z))
                + OF_MOTION * (cell + Math.abs(motion.x) + Math.abs(motion.y) + Math.abs(motion.z));
            clearance = slop / 4;
            _mostInset = slop + SHALLOW * largest;
            setInset(slop);
            isFlat = shrink * _source.leastHalf < FLAT * slop;
        }

        /**
         * Makes the core narrower for this motion, if it is free of a row then. It becomes no narrower than it has to be, up to a factor, because the
         * motion can lead the body into other rows as deep as its core is narrow.
         *
         * @param body the body that has the core
         * @return whether the core is free of the row
         */
        public function narrow(body:MovingBody, row:int, place:Vector3D):Boolean
        {
            var inset:Number = _inset;
            setInset(_mostInset);
            if (body.coreTouches(row, place))
            {
                setInset(inset);
                return false;
            }
            do
            {
                inset = Math.min(NARROWER * inset, _mostInset);
                setInset(inset);
            }
            while (inset < _mostInset && body.coreTouches(row, place));
            return true;
        }

        private function setInset(width:Number):void
        {
            _inset = width;
            _place.x = NaN;
            shrink = shrinkOf(_source, width);
        }

        /** The core when the body stands at a place. It is valid until the next call. */
        public function at(place:Vector3D):Body
        {
            if (place.x != _place.x || place.y != _place.y || place.z != _place.z)
            {
                _core.readShrunk(_source, place, shrink);
                _place.copyFrom(place);
            }
            return _core;
        }

        /** The part of its size that a body loses with an inset. */
        public static function shrinkOf(body:Body, inset:Number):Number
        {
            var taken:Number = inset / Math.max(body.leastHalf, body.largestHalf / SLIMMEST);
            return taken < MOST_SHRINK ? taken : MOST_SHRINK;
        }
    }
}
