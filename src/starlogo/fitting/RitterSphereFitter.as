package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;

    /**
     * Ritter's sphere (thesis §3.4.1; Ritter, "An Efficient Bounding Sphere", Graphics Gems, 1990): starts on two vertices far
     * from each other, and grows for each vertex outside just enough to hold it and the sphere so far. Usually 5 to 20 % above
     * the smallest radius; what it finds depends on the order of the vertices. Three passes over the hull's vertices.
     */
    public final class RitterSphereFitter extends Fitter
    {
        /** Start on the vertices that are farthest apart along x, y or z. */
        public static const WIDEST_DIMENSION:String = "widestDimension";

        /**
         * Start on a vertex and the one farthest from it. The thesis takes any vertex at random; here it is the hull's first,
         * so that a model always gets the same sphere.
         */
        public static const FARTHEST_FROM_FIRST:String = "farthestFromFirst";

        private var _start:String;

        /**
         * A fitter of Ritter's spheres.
         *
         * @param start WIDEST_DIMENSION or FARTHEST_FROM_FIRST: how to pick the first two vertices
         * @throws ArgumentError if it is neither
         */
        public function RitterSphereFitter(start:String = WIDEST_DIMENSION)
        {
            if (start != WIDEST_DIMENSION && start != FARTHEST_FROM_FIRST)
            {
                throw new ArgumentError("start must be WIDEST_DIMENSION or FARTHEST_FROM_FIRST: " + start);
            }
            _start = start;
        }

        /** How the first two vertices are picked. */
        public function get start():String
        {
            return _start;
        }

        /** @inheritDoc */
        override public function get signature():String
        {
            return "Ritter sphere " + _start;
        }

        /** @inheritDoc */
        override public function begin(session:FitSession):Fit
        {
            return new Fit(session, find);
        }

        private function find(session:FitSession):BoundingStructure
        {
            var points:Vector.<Number> = session.hull.points;
            var pair:Vector.<int> = _start == WIDEST_DIMENSION ? widest(points) : farthestFromFirst(points);
            var a:int = 3 * pair[0];
            var b:int = 3 * pair[1];
            var x:Number = (points[a] + points[b]) / 2;
            var y:Number = (points[a + 1] + points[b + 1]) / 2;
            var z:Number = (points[a + 2] + points[b + 2]) / 2;
            var radius:Number = Math.sqrt(square(points, a, x, y, z));
            for (var i:int = 0; i < points.length; i += 3)
            {
                var distance:Number = Math.sqrt(square(points, i, x, y, z));
                if (distance > radius)
                {
                    var shift:Number = (distance - radius) / 2 / distance;
                    x += shift * (points[i] - x);
                    y += shift * (points[i + 1] - y);
                    z += shift * (points[i + 2] - z);
                    radius = (distance + radius) / 2;
                }
            }
            return EnclosingStructures.sphere(session.vertices, x, y, z, radius);
        }

        private static function widest(points:Vector.<Number>):Vector.<int>
        {
            var box:ExtremePoints = new ExtremePoints(points);
            var x:Number = box.highX - box.lowX;
            var y:Number = box.highY - box.lowY;
            var z:Number = box.highZ - box.lowZ;
            if (x >= y && x >= z)
            {
                return new <int>[box.lowestX, box.highestX];
            }
            return y >= z ? new <int>[box.lowestY, box.highestY] : new <int>[box.lowestZ, box.highestZ];
        }

        private static function farthestFromFirst(points:Vector.<Number>):Vector.<int>
        {
            var farthest:int = 0;
            var most:Number = -1;
            for (var i:int = 0; i < points.length; i += 3)
            {
                var distance:Number = square(points, i, points[0], points[1], points[2]);
                if (distance > most)
                {
                    most = distance;
                    farthest = i / 3;
                }
            }
            return new <int>[0, farthest];
        }

        private static function square(points:Vector.<Number>, i:int, x:Number, y:Number, z:Number):Number
        {
            x -= points[i];
            y -= points[i + 1];
            z -= points[i + 2];
            return x * x + y * y + z * z;
        }
    }
}
