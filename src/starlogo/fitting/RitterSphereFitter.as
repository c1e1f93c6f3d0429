package starlogo.fitting
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;

    /**
     * Finds Ritter's bounding sphere (thesis §3.4.1; Ritter, "An Efficient Bounding Sphere", Graphics Gems, 1990). Its radius is usually 5
     * to 20 % above the smallest, and depends on the order of the vertices.
     *
     * <p>The sphere starts on two vertices that are far apart. For each vertex outside, it grows just enough to enclose the vertex and the
     * sphere so far. It takes a few passes over the hull's vertices, and one over all.</p>
     */
    public final class RitterSphereFitter extends Fitter
    {
        /** Start on the vertices that are farthest apart along x, y or z. */
        public static const WIDEST_DIMENSION:String = "widestDimension";

        /**
         * Start on a vertex and the vertex farthest from it. The thesis takes the first of them at random. Here it is the hull's first
         * vertex, so that a model always gets the same sphere.
         */
        public static const FARTHEST_FROM_FIRST:String = "farthestFromFirst";

        private var _start:String;

        /**
         * Creates a fitter of Ritter's spheres.
         *
         * @param start how to choose the first two vertices: WIDEST_DIMENSION or FARTHEST_FROM_FIRST
         * @throws ArgumentError if it is neither
         */
        public function RitterSphereFitter(start:String = WIDEST_DIMENSION)
        {
            super("Ritter sphere " + start);
            if (start != WIDEST_DIMENSION && start != FARTHEST_FROM_FIRST)
            {
                throw new ArgumentError("start must be WIDEST_DIMENSION or FARTHEST_FROM_FIRST: " + start);
            }
            _start = start;
        }

        /** How the first two vertices are chosen. */
        public function get start():String
        {
            return _start;
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var points:Vector.<Number> = session.hull.points;
            var a:int = 0;
            var b:int = _start == FARTHEST_FROM_FIRST ? EnclosingStructures.farthest(points, new Vector3D(points[0], points[1], points[2])) : 0;
            var widest:Number = 0;
            for (var axis:int = 0; axis < 3 && _start == WIDEST_DIMENSION; axis++)
            {
                var low:int = extreme(points, axis, -1);
                var high:int = extreme(points, axis, 1);
                var width:Number = points[high + axis] - points[low + axis];
                if (width > widest)
                {
                    widest = width;
                    a = low;
                    b = high;
                }
            }
            var center:Vector3D = new Vector3D((points[a] + points[b]) / 2, (points[a + 1] + points[b + 1]) / 2, (points[a + 2] + points[b + 2]) / 2);
            var radius:Number = Math.sqrt(EnclosingStructures.squaredDistance(points, a, center));
            for (var i:int = 0; i < points.length; i += 3)
            {
                var distance:Number = Math.sqrt(EnclosingStructures.squaredDistance(points, i, center));
                if (distance > radius)
                {
                    var shift:Number = (distance - radius) / 2 / distance;
                    center.x += shift * (points[i] - center.x);
                    center.y += shift * (points[i + 1] - center.y);
                    center.z += shift * (points[i + 2] - center.z);
                    radius = (distance + radius) / 2;
                }
            }
            return EnclosingStructures.sphere(session.vertices, center, radius);
        }

        // The index of the first point with the greatest coordinate along an axis, or the least if sign is -1.
        private static function extreme(points:Vector.<Number>, axis:int, sign:int):int
        {
            var farthest:int = 0;
            for (var i:int = 0; i < points.length; i += 3)
            {
                if (sign * points[i + axis] > sign * points[farthest + axis])
                {
                    farthest = i;
                }
            }
            return farthest;
        }
    }
}
