package starlogo.queries.motion
{
    import flash.geom.Vector3D;
    import starlogo.convex.ContactPoint;
    import starlogo.engine;
    import starlogo.search.ModelShape;

    use namespace engine;

    /**
     * Pushes a body out of what it overlaps deeply, where a walk begins. The deepest overlap comes first. A push is a slide, so it leads through nothing
     * else. All pushes together are as long as the depths of all overlaps at the beginning.
     *
     * @private
     */
    public final class OverlapPush
    {
        private static const MOST_PUSHES:int = 8;

        private var _slider:Slider = new Slider();
        private var _slid:SlideResult = new SlideResult();

        // The core of the body where it stands.
        private var _core:BodyCore = new BodyCore();

        // A push, and the contact of an overlap.
        private var _motion:Vector3D = new Vector3D();
        private var _overlap:ContactPoint = new ContactPoint();

        /**
         * Pushes a body out of what it overlaps at a place, which is more than nothing: see <code>findDepth()</code>.
         *
         * @param place the place of the body, which changes
         * @param depth the sum of the depths of all overlaps there, which is how far the body is pushed at most
         * @param deepest the contact of the deepest overlap there, which changes
         */
        public function pushOut(body:MovingBody, place:Vector3D, depth:Number, deepest:ContactPoint):void
        {
            var left:Number = depth;
            var pushes:int = 0;
            do
            {
                var length:Number = Math.min(left, deepest.depth);
                left -= length;
                _motion.setTo(0, 0, 0);
                deepest.push(_motion, length);
                _slider.slide(body, body.rows, place, _motion, SlideLimits.NONE, _slid);
                place.copyFrom(_slid.place);
                pushes++;
            }
            while (pushes < MOST_PUSHES && left > 0 && findDepth(body, place, deepest) > 0);
        }

        /**
         * Finds how deep a body overlaps others at a place.
         *
         * @param deepest receives the contact of the deepest overlap, with the depth 0 if there is no overlap
         * @return the sum of the depths of all overlaps
         */
        public function findDepth(body:MovingBody, place:Vector3D, deepest:ContactPoint):Number
        {
            var sum:Number = 0;
            deepest.depth = 0;
            _core.beginStanding(body, body.rows, place);
            for (var i:int = 0; i < body.rows.count; i++)
            {
                if (findOverlap(_core, body.rows.numbers[i], place, _overlap))
                {
                    sum += _overlap.depth;
                    if (_overlap.depth > deepest.depth)
                    {
                        deepest.copyFrom(_overlap);
                    }
                }
            }
            return sum;
        }

        // Finds how a body overlaps a row. A push along the contact's normal by its depth leads a clearance out of the row. Returns whether the overlap
        // counts. It does not if it is shallow, if the row is one-way, or if the way out of a tree is too long.
        private static function findOverlap(core:BodyCore, row:int, place:Vector3D, out:ContactPoint):Boolean
        {
            var body:MovingBody = core.body;
            if (body.isOneWay(row) || !core.touches(row, place))
            {
                return false;
            }
            body.findSeparatingContact(row, place, out);
            if (body.isShallow(row, out) || !core.bodyOverlaps(row, place))
            {
                return false;
            }
            body.warnIfInside(row, out);
            out.depth += core.clearance;
            // the shortest way out of a tree may lead through a wall of the tree if it is longer than the way to the middle of the body
            return body.bodyOf(row).form != ModelShape.TREE || out.depth <= body.whole.halfAlong(out);
        }
    }
}
