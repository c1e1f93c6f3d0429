package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;

    use namespace engine;

    /**
     * The nine separating axes that are at right angles to an edge of each of two boxes: what is left to try of boxes that
     * their faces do not separate (Gottschalk, Lin and Manocha, "OBBTree", SIGGRAPH 1996).
     *
     * <p>Agents that are far apart or deep in each other never come to them, so the numbers are prepared when the first two
     * boxes do.</p>
     */
    internal final class EdgeAxes
    {
        private var _scale:Number;

        // The rows of the rotation, scaled, and their absolute values, those widened by a rounding error: it makes up for
        // cross products of nearly parallel edges, which cancel (Ericson, "Real-Time Collision Detection", §4.4.1).
        private var _m00:Number;
        private var _m01:Number;
        private var _m02:Number;
        private var _m10:Number;
        private var _m11:Number;
        private var _m12:Number;
        private var _m20:Number;
        private var _m21:Number;
        private var _m22:Number;
        private var _abs00:Number;
        private var _abs01:Number;
        private var _abs02:Number;
        private var _abs10:Number;
        private var _abs11:Number;
        private var _abs12:Number;
        private var _abs20:Number;
        private var _abs21:Number;
        private var _abs22:Number;
        private var _gap:Number;

        /** Without axes, until prepare is called. */
        public function EdgeAxes()
        {
        }

        /**
         * Takes over how the second model is turned and scaled.
         *
         * @param pose takes the second model into the space of the first
         */
        public function prepare(pose:RelativePose):void
        {
            var relative:Placement = pose.placement;
            _gap = pose.gap;
            var scale:Number = relative.size;
            _scale = scale;
            var widened:Number = Tolerances.ROUNDING * scale;
            _m00 = relative.r00 * scale;
            _m01 = relative.r01 * scale;
            _m02 = relative.r02 * scale;
            _m10 = relative.r10 * scale;
            _m11 = relative.r11 * scale;
            _m12 = relative.r12 * scale;
            _m20 = relative.r20 * scale;
            _m21 = relative.r21 * scale;
            _m22 = relative.r22 * scale;
            _abs00 = _m00 < 0 ? widened - _m00 : widened + _m00;
            _abs01 = _m01 < 0 ? widened - _m01 : widened + _m01;
            _abs02 = _m02 < 0 ? widened - _m02 : widened + _m02;
            _abs10 = _m10 < 0 ? widened - _m10 : widened + _m10;
            _abs11 = _m11 < 0 ? widened - _m11 : widened + _m11;
            _abs12 = _m12 < 0 ? widened - _m12 : widened + _m12;
            _abs20 = _m20 < 0 ? widened - _m20 : widened + _m20;
            _abs21 = _m21 < 0 ? widened - _m21 : widened + _m21;
            _abs22 = _m22 < 0 ? widened - _m22 : widened + _m22;
        }

        /**
         * Whether an axis separates two boxes.
         *
         * @param a a node of the first model, whose box counts
         * @param b a node of the second
         * @param x from the middle of a's box to that of b's, in the first model's space
         * @param y the same
         * @param z the same
         */
        public function separate(a:HierarchyNode, b:HierarchyNode, x:Number, y:Number, z:Number):Boolean
        {
            var scale:Number = _scale;
            var aX:Number = a.halfX + _gap;
            var aY:Number = a.halfY + _gap;
            var aZ:Number = a.halfZ + _gap;
            var bX:Number = b.halfX * scale;
            var bY:Number = b.halfY * scale;
            var bZ:Number = b.halfZ * scale;

            // all times the scale
            var along:Number = z * _m10 - y * _m20;
            var reach:Number = aY * _abs20 + aZ * _abs10 + bY * _abs02 + bZ * _abs01;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = z * _m11 - y * _m21;
            reach = aY * _abs21 + aZ * _abs11 + bZ * _abs00 + bX * _abs02;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = z * _m12 - y * _m22;
            reach = aY * _abs22 + aZ * _abs12 + bX * _abs01 + bY * _abs00;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = x * _m20 - z * _m00;
            reach = aZ * _abs00 + aX * _abs20 + bY * _abs12 + bZ * _abs11;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = x * _m21 - z * _m01;
            reach = aZ * _abs01 + aX * _abs21 + bZ * _abs10 + bX * _abs12;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = x * _m22 - z * _m02;
            reach = aZ * _abs02 + aX * _abs22 + bX * _abs11 + bY * _abs10;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = y * _m00 - x * _m10;
            reach = aX * _abs10 + aY * _abs00 + bY * _abs22 + bZ * _abs21;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = y * _m01 - x * _m11;
            reach = aX * _abs11 + aY * _abs01 + bZ * _abs20 + bX * _abs22;
            if (along > reach || along < -reach)
            {
                return true;
            }
            along = y * _m02 - x * _m12;
            reach = aX * _abs12 + aY * _abs02 + bX * _abs21 + bY * _abs20;
            return along > reach || along < -reach;
        }
    }
}
