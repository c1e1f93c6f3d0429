package evaluation.literal
{
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;

    /**
     * The oriented box of thesis §3.4.2, written literally. Every vertex is rotated by every rotation. For each rotation the axis-aligned
     * box of the rotated vertices is found and rotated back. The smallest box is kept.
     *
     * <p>Vertices are Vector3D objects, as in §3.3. The times of Figure 6-2 agree with this: about a microsecond for each vertex and
     * rotation, on a player with a compiler. BulkOrientedBoxFit does the same without objects.</p>
     */
    public final class LiteralOrientedBoxFit
    {
        /** The volume of the smallest box. */
        public var volume:Number = Number.MAX_VALUE;

        /** The smallest box's centre. */
        public var center:Vector3D;

        /** The smallest box's axes. */
        public var axes:Vector.<Vector3D>;

        /** The smallest box's half-extents along its axes. */
        public var halfExtents:Vector3D;

        /**
         * @param vertices x, y, z each
         * @param degIncrement step of the rotations about each axis, in degrees
         * @param endX limit of the rotations about x, in degrees, not included
         */
        public function LiteralOrientedBoxFit(vertices:Vector.<Number>, degIncrement:Number, endX:Number = 90)
        {
            for (var x:Number = 0; x < endX; x += degIncrement)
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
            var min:Vector3D = new Vector3D(Number.MAX_VALUE, Number.MAX_VALUE, Number.MAX_VALUE);
            var max:Vector3D = new Vector3D(-Number.MAX_VALUE, -Number.MAX_VALUE, -Number.MAX_VALUE);
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                var rotated:Vector3D = matrix.transformVector(new Vector3D(vertices[i], vertices[i + 1], vertices[i + 2]));
                min.x = Math.min(min.x, rotated.x);
                min.y = Math.min(min.y, rotated.y);
                min.z = Math.min(min.z, rotated.z);
                max.x = Math.max(max.x, rotated.x);
                max.y = Math.max(max.y, rotated.y);
                max.z = Math.max(max.z, rotated.z);
            }
            var size:Vector3D = max.subtract(min);
            if (size.x * size.y * size.z < volume)
            {
                volume = size.x * size.y * size.z;
                halfExtents = new Vector3D(size.x / 2, size.y / 2, size.z / 2);
                matrix.invert();
                center = matrix.transformVector(new Vector3D((min.x + max.x) / 2, (min.y + max.y) / 2, (min.z + max.z) / 2));
                axes = new <Vector3D>[matrix.transformVector(Vector3D.X_AXIS), matrix.transformVector(Vector3D.Y_AXIS),
                        matrix.transformVector(Vector3D.Z_AXIS)];
            }
        }
    }
}
