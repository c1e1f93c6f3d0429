package starlogo.queries.trees
{
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Trigonometry;

    /**
     * Tests whether places are in a cone. The cone's axis is the x axis of a placement. Places at the cone's tip are in the cone.
     *
     * @private
     */
    public final class Cone
    {
        private var _placement:Placement;

        // The sine and cosine of the angle between the axis and the border.
        private var _sine:Number = 0;
        private var _cosine:Number = 1;

        /**
         * Sets the cone.
         *
         * @param placement the place and the rotation of the cone
         * @param halfAngle the angle between the axis and the border, in degrees below 180
         * @return this cone
         */
        public function setTo(placement:Placement, halfAngle:Number):Cone
        {
            _placement = placement;
            _sine = Trigonometry.sine(halfAngle);
            _cosine = Trigonometry.cosine(halfAngle);
            return this;
        }

        /** Whether a place is in the cone: three numbers of a list, from an index on. */
        public function contains(places:Vector.<Number>, index:int):Boolean
        {
            var axisX:Number = _placement.r00;
            var axisY:Number = _placement.r10;
            var axisZ:Number = _placement.r20;
            var toX:Number = places[index] - _placement.x;
            var toY:Number = places[int(index + 1)] - _placement.y;
            var toZ:Number = places[int(index + 2)] - _placement.z;
            var acrossX:Number = axisY * toZ - axisZ * toY;
            var acrossY:Number = axisZ * toX - axisX * toZ;
            var acrossZ:Number = axisX * toY - axisY * toX;
            var across:Number = Math.sqrt(acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
            var along:Number = axisX * toX + axisY * toY + axisZ * toZ;
            // the left side is the sine of the angle beyond the border. It is 0 half a turn away too. So in a narrow cone, with an angle below 45 degrees, places
            // behind the tip are excluded
            return across * _cosine - along * _sine <= Tolerances.CONE * (across + Math.abs(along)) && (along >= 0 || _sine >= _cosine);
        }
    }
}
