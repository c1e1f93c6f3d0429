package starlogo.fitting
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.minimal.BoxDescent;
    import starlogo.fitting.minimal.DistinctDirections;
    import starlogo.geometry.ConvexHull;
    import starlogo.geometry.Trigonometry;

    /**
     * Finds the smallest bounding box in any direction (not in the thesis). There is no proof that it is the smallest, but it is within
     * 0.001 % of certified minima for the models and point sets of the project's tests.
     *
     * <p>It uses a theorem of O'Rourke ("Finding Minimal Enclosing Boxes", International Journal of Computer and Information Sciences
     * 14(3), 1985): some smallest box has two adjacent sides that each contain an edge of the hull. The normal of such a side is
     * perpendicular to the edge, and lies between the normals of the two triangles that meet there. For a given normal the best box is
     * known exactly. So the search is along one arc of directions for each edge of the hull.</p>
     *
     * <p>O'Rourke solves an equation for each pair of edges. This class samples the arcs. It starts at the best samples and descends from
     * arc to arc. Its steps shrink until nothing is gained.</p>
     *
     * <p>For points in a plane, the box is the smallest rectangle. For points on a line, it is a segment. For points in one place, it is
     * that point. The cost in WebAssembly is 0.1 seconds for ten corners of the hull, and one to two seconds for 500. Thousands of
     * corners are sampled more coarsely.</p>
     */
    public final class MinimalBoxFitter extends Fitter
    {
        // The largest number of samples. Many corners get a coarser net of directions instead of more samples.
        private static const SAMPLES:int = 2500;
        // Directions closer than this (radians) count as one start.
        private static const APART:Number = 0.06;
        // Samples of an arc are at most this far apart (degrees).
        private static const ARC_STEP:Number = 3.44;

        /** Creates a fitter of smallest boxes. */
        public function MinimalBoxFitter()
        {
            super("minimal box");
        }

        /** @inheritDoc */
        override protected function findStructure(session:FitSession):BoundingStructure
        {
            var hull:ConvexHull = session.hull;
            var descent:BoxDescent = new BoxDescent(hull);
            // The start for vertices in a plane is the plane's normal. For vertices on a line it is a direction perpendicular to the
            // line.
            descent.search(hull.dimension == 3 ? directionsOf(hull) : hull.axes.slice(6), APART);
            return EnclosingStructures.box(session.vertices, descent.axes);
        }

        private static function directionsOf(hull:ConvexHull):Vector.<Number>
        {
            var spacing:Number = 1e-7;
            var net:DistinctDirections;
            do
            {
                net = new DistinctDirections(spacing);
                addDirections(hull, net);
                spacing = Math.max(0.01, 1.4 * spacing);
            }
            while (net.directions.length > 3 * SAMPLES);
            return net.directions;
        }

        private static function addDirections(hull:ConvexHull, net:DistinctDirections):void
        {
            net.add(1, 0, 0);
            net.add(0, 1, 0);
            net.add(0, 0, 1);
            var normals:Vector.<Number> = normalsOf(hull);
            var i:int;
            for (i = 0; i < normals.length; i += 3)
            {
                net.add(normals[i], normals[i + 1], normals[i + 2]);
            }
            // The key is a triangle's side: its two corners. The value is three times the triangle's index.
            var t:Vector.<int> = hull.triangles;
            var corners:int = hull.indices.length;
            var triangleAt:Object = {};
            for (i = 0; i < t.length; i++)
            {
                var to:int = t[i % 3 == 2 ? i - 2 : i + 1];
                var across:String = String(to * corners + t[i]);
                if (across in triangleAt)
                {
                    addArc(normals, triangleAt[across], i - i % 3, net);
                }
                triangleAt[t[i] * corners + to] = i - i % 3;
            }
        }

        private static function addArc(normals:Vector.<Number>, a:int, b:int, net:DistinctDirections):void
        {
            var cosine:Number = normals[a] * normals[b] + normals[a + 1] * normals[b + 1] + normals[a + 2] * normals[b + 2];
            var angle:Number = Trigonometry.arctangent(Math.sqrt(Math.max(0, 1 - cosine * cosine)), cosine);
            var pieces:int = Math.ceil(angle / ARC_STEP);
            for (var i:int = 1; i < pieces; i++)
            {
                var toA:Number = Trigonometry.sine(angle * (pieces - i) / pieces);
                var toB:Number = Trigonometry.sine(angle * i / pieces);
                net.add(toA * normals[a] + toB * normals[b], toA * normals[a + 1] + toB * normals[b + 1],
                        toA * normals[a + 2] + toB * normals[b + 2]);
            }
        }

        private static function normalsOf(hull:ConvexHull):Vector.<Number>
        {
            var p:Vector.<Number> = hull.convexPoints;
            var t:Vector.<int> = hull.triangles;
            var normals:Vector.<Number> = new Vector.<Number>(t.length);
            for (var i:int = 0; i < t.length; i += 3)
            {
                var a:int = 3 * t[i];
                var b:int = 3 * t[i + 1];
                var c:int = 3 * t[i + 2];
                var x:Number = (p[b + 1] - p[a + 1]) * (p[c + 2] - p[a + 2]) - (p[b + 2] - p[a + 2]) * (p[c + 1] - p[a + 1]);
                var y:Number = (p[b + 2] - p[a + 2]) * (p[c] - p[a]) - (p[b] - p[a]) * (p[c + 2] - p[a + 2]);
                var z:Number = (p[b] - p[a]) * (p[c + 1] - p[a + 1]) - (p[b + 1] - p[a + 1]) * (p[c] - p[a]);
                var length:Number = Math.sqrt(x * x + y * y + z * z);
                normals[i] = length > 0 ? x / length : 0;
                normals[i + 1] = length > 0 ? y / length : 0;
                normals[i + 2] = length > 0 ? z / length : 1;
            }
            return normals;
        }
    }
}
