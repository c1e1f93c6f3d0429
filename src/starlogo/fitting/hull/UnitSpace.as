package starlogo.fitting.hull
{
    import starlogo.fitting.EnclosingStructures;
    import starlogo.geometry.hull.ConvexHull;

    /**
     * A space in which the hull of vertices is 1 long along each of three axes, around the origin. It is not scaled uniformly, so thin hulls
     * have as many digits there as others. Hulls in a plane have no length along the third axis.
     *
     * @private
     */
    public final class UnitSpace
    {
        /** The corners of the box around the hull. */
        public static const BOX:Vector.<Number> = new <Number>[-0.5, -0.5, -0.5, 0.5, -0.5, -0.5, -0.5, 0.5, -0.5, 0.5, 0.5, -0.5,
                -0.5, -0.5, 0.5, 0.5, -0.5, 0.5, -0.5, 0.5, 0.5, 0.5, 0.5, 0.5];

        private var _axes:Vector.<Number>;
        private var _middle:Vector.<Number> = new Vector.<Number>();
        private var _lengths:Vector.<Number> = new Vector.<Number>();

        /** @param hull of at least two dimensions */
        public function UnitSpace(hull:ConvexHull)
        {
            _axes = hull.axes;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var extent:Vector.<Number> = EnclosingStructures.extentAlong(hull.points, _axes[3 * axis], _axes[3 * axis + 1], _axes[3 * axis + 2]);
                _middle.push(extent[0]);
                _lengths.push(axis < hull.dimension ? 2 * extent[1] : 0);
            }
        }

        /** Takes points of the hull's space to this one. */
        public function toUnit(points:Vector.<Number>):Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < points.length; i += 3)
            {
                for (var axis:int = 0; axis < 3; axis++)
                {
                    result.push(_lengths[axis] == 0 ? 0 : (alongAxis(points, i, axis) - _middle[axis]) / _lengths[axis]);
                }
            }
            return result;
        }

        /** Takes points of this space to the hull's. */
        public function fromUnit(points:Vector.<Number>):Vector.<Number>
        {
            var result:Vector.<Number> = new Vector.<Number>(points.length);
            for (var i:int = 0; i < points.length; i++)
            {
                var along:Number = _middle[i % 3] + points[i] * _lengths[i % 3];
                for (var k:int = 0; k < 3; k++)
                {
                    result[i - i % 3 + k] += along * _axes[3 * (i % 3) + k];
                }
            }
            return result;
        }

        private function alongAxis(points:Vector.<Number>, i:int, axis:int):Number
        {
            return points[i] * _axes[3 * axis] + points[i + 1] * _axes[3 * axis + 1] + points[i + 2] * _axes[3 * axis + 2];
        }
    }
}
