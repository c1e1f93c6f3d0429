package starlogo.queries
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Trigonometry;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * Tests whether rows are in a cone. The cone's axis is the x axis of a placement. Rows at the cone's tip are in the cone.
     *
     * @private
     */
    public final class Cone
    {
        private var _table:AgentTable;
        private var _placement:Placement;

        // The angle between the axis and the border, in degrees below 180, with its sine and cosine.
        private var _angle:Number = 0;
        private var _sine:Number = 0;
        private var _cosine:Number = 1;

        /**
         * Sets the cone.
         *
         * @param placement the place and the rotation of the cone
         * @param angle the angle between the axis and the border, in degrees below 180
         * @param table has the rows
         * @return this cone
         */
        public function setTo(placement:Placement, angle:Number, table:AgentTable):Cone
        {
            _placement = placement;
            _table = table;
            if (angle != _angle)
            {
                _angle = angle;
                _sine = Trigonometry.sine(angle);
                _cosine = Trigonometry.cosine(angle);
            }
            return this;
        }

        /** Whether a row is in the cone. */
        public function contains(row:int):Boolean
        {
            var axisX:Number = _placement.r00;
            var axisY:Number = _placement.r10;
            var axisZ:Number = _placement.r20;
            var toX:Number = _table.now.x[row] - _placement.x;
            var toY:Number = _table.now.y[row] - _placement.y;
            var toZ:Number = _table.now.z[row] - _placement.z;
            var acrossX:Number = axisY * toZ - axisZ * toY;
            var acrossY:Number = axisZ * toX - axisX * toZ;
            var acrossZ:Number = axisX * toY - axisY * toX;
            var across:Number = Math.sqrt(acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
            var along:Number = axisX * toX + axisY * toY + axisZ * toZ;
            // the left side is the sine of the angle beyond the border. It is 0 half a turn away too, so the last condition excludes rows there
            return across * _cosine - along * _sine <= Tolerances.CONE * (across + Math.abs(along)) && (along >= 0 || _angle >= 45);
        }
    }
}
