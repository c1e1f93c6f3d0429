package evaluation.literal
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;

    /**
     * LiteralOrientedBoxFit without an object for each vertex. The player rotates all vertices in one native call. The result is the same.
     */
    public final class BulkOrientedBoxFit
    {
        /** The volume of the smallest box. */
        public var volume:Number = Number.MAX_VALUE;

        private var _rotated:Vector.<Number>;

        /**
         * @param vertices x, y, z each
         * @param degIncrement step of the rotations about each axis, in degrees
         */
        public function BulkOrientedBoxFit(vertices:Vector.<Number>, degIncrement:Number)
        {
            _rotated = new Vector.<Number>(vertices.length);
            for (var x:Number = 0; x < 90; x += degIncrement)
            {
                for (var y:Number = 0; y < 90; y += degIncrement)
                {
                    for (var z:Number = 0; z < 90; z += degIncrement)
                    {
                        tryRotation(vertices, x, y, z);
                    }
                }
            }
        }

        private function tryRotation(vertices:Vector.<Number>, x:Number, y:Number, z:Number):void
        {
            var matrix:Matrix3D = new Matrix3D();
            matrix.appendRotation(x, Vector3D.X_AXIS);
            matrix.appendRotation(y, Vector3D.Y_AXIS);
            matrix.appendRotation(z, Vector3D.Z_AXIS);
            matrix.transformVectors(vertices, _rotated);
            var min:Vector3D = new Vector3D(Number.MAX_VALUE, Number.MAX_VALUE, Number.MAX_VALUE);
            var max:Vector3D = new Vector3D(-Number.MAX_VALUE, -Number.MAX_VALUE, -Number.MAX_VALUE);
            for (var i:int = 0; i < _rotated.length; i += 3)
            {
                min.x = Math.min(min.x, _rotated[i]);
                min.y = Math.min(min.y, _rotated[i + 1]);
                min.z = Math.min(min.z, _rotated[i + 2]);
                max.x = Math.max(max.x, _rotated[i]);
                max.y = Math.max(max.y, _rotated[i + 1]);
                max.z = Math.max(max.z, _rotated[i + 2]);
            }
            volume = Math.min(volume, (max.x - min.x) * (max.y - min.y) * (max.z - min.z));
        }
    }
}
