package starlogo.queries
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Trigonometry;
    import starlogo.search.AgentTable;

    use namespace engine;

    /**
     * Says which rows are in a cone, whose axis is the x axis of a placement; those at its tip are in it.
     *
     * @private
     */
    public final class Cone extends RowTest
    {
        private var _table:AgentTable;
        private var _test:RowTest;
        private var _placement:Placement;

        // Between the axis and the border, in degrees below 180; its sine and cosine.
        private var _angle:Number = 0;
        private var _sine:Number = 0;
        private var _cosine:Number = 1;

        /** No cone yet. */
        public function Cone()
        {
        }

        /**
         * Takes a cone.
         *
         * @param placement where it is
         * @param angle between its axis and its border, in degrees below 180
         * @param table has the rows
         * @param test says which rows of the cone count; null for all
         * @return this test
         */
        public function setTo(placement:Placement, angle:Number, table:AgentTable, test:RowTest):RowTest
        {
            _placement = placement;
            _table = table;
            _test = test;
            if (angle != _angle)
            {
                _angle = angle;
                _sine = Trigonometry.sine(angle);
                _cosine = Trigonometry.cosine(angle);
            }
            return this;
        }

        /** @inheritDoc */
        override public function accepts(row:int):Boolean
        {
            if (_test != null && !_test.accepts(row))
            {
                return false;
            }
            var axisX:Number = _placement.r00;
            var axisY:Number = _placement.r10;
            var axisZ:Number = _placement.r20;
            var toX:Number = _table.x[row] - _placement.x;
            var toY:Number = _table.y[row] - _placement.y;
            var toZ:Number = _table.z[row] - _placement.z;
            var acrossX:Number = axisY * toZ - axisZ * toY;
            var acrossY:Number = axisZ * toX - axisX * toZ;
            var acrossZ:Number = axisX * toY - axisY * toX;
            var across:Number = Math.sqrt(acrossX * acrossX + acrossY * acrossY + acrossZ * acrossZ);
            var along:Number = axisX * toX + axisY * toY + axisZ * toZ;
            // the sine of the angle by which it is beyond the border; that of half a turn is 0 too
            return across * _cosine - along * _sine <= Tolerances.CONE * (across + Math.abs(along)) && (along >= 0 || _angle >= 45);
        }
    }
}
