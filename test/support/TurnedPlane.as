package support
{
    /** Places points of a plane somewhere in space, in doubles on every player. */
    public final class TurnedPlane
    {
        // how far it is turned about (1, 2, 3) at a time, in radians
        private static const STEP:Number = 1.3439;

        /** What coordinates are rounded to, relative to their size: 0 leaves them, 1e-7 is as single precision does. */
        public var precision:Number = 0;

        private var _turns:int = 0;

        public function TurnedPlane()
        {
        }

        /** Goes on to another place. */
        public function turnOn():void
        {
            _turns++;
        }

        /** The points, x, y, z each, where they are in space. */
        public function place(points:Vector.<Number>):Vector.<Number>
        {
            var length:Number = Math.sqrt(14);
            var x:Number = 1 / length;
            var y:Number = 2 / length;
            var z:Number = 3 / length;
            var s:Number = Math.sin(_turns * STEP);
            var c:Number = Math.cos(_turns * STEP);
            var t:Number = 1 - c;
            var placed:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < points.length; i += 3)
            {
                var px:Number = points[i];
                var py:Number = points[i + 1];
                var pz:Number = points[i + 2];
                placed.push(rounded((t * x * x + c) * px + (t * x * y - s * z) * py + (t * x * z + s * y) * pz + _turns));
                placed.push(rounded((t * x * y + s * z) * px + (t * y * y + c) * py + (t * y * z - s * x) * pz - 2 * _turns));
                placed.push(rounded((t * x * z - s * y) * px + (t * y * z + s * x) * py + (t * z * z + c) * pz + _turns / 2));
            }
            return placed;
        }

        private function rounded(value:Number):Number
        {
            if (precision == 0 || value == 0)
            {
                return value;
            }
            var unit:Number = precision * Math.pow(2, Math.ceil(Math.log(Math.abs(value)) * Math.LOG2E));
            return Math.round(value / unit) * unit;
        }
    }
}
