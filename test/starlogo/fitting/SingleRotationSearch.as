package starlogo.fitting
{
    import flash.geom.Matrix3D;
    import flash.utils.ByteArray;

    /** A search in a player whose Matrix3D holds single-precision numbers. */
    internal class SingleRotationSearch extends RotationSearch
    {
        private var _bytes:ByteArray = new ByteArray();

        public function SingleRotationSearch(session:FitSession, stepX:Number, stepY:Number, stepZ:Number)
        {
            super(session, stepX, stepY, stepZ);
        }

        override protected function transform(matrix:Matrix3D, points:Vector.<Number>, out:Vector.<Number>):void
        {
            matrix.rawData = rounded(matrix.rawData, new Vector.<Number>(16));
            matrix.transformVectors(points, out);
            rounded(out, out);
        }

        private function rounded(numbers:Vector.<Number>, out:Vector.<Number>):Vector.<Number>
        {
            _bytes.position = 0;
            var i:int;
            for (i = 0; i < numbers.length; i++)
            {
                _bytes.writeFloat(numbers[i]);
            }
            _bytes.position = 0;
            for (i = 0; i < numbers.length; i++)
            {
                out[i] = _bytes.readFloat();
            }
            return out;
        }
    }
}
