package starlogo.models.polygons
{
    import starlogo.models.files.FileBudget;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Triangulates polygons in space. They may be concave and have holes.
     *
     * <p>A triangle stays as it is, and a quad is split along the diagonal inside it. Triangles that name a corner twice are left out. Other polygons
     * become rings in a plane (PolygonRings). If their first corner sees all others, as in a convex polygon without corners in a straight line,
     * they are a triangle fan around it. Otherwise HoleWelder welds holes where they touch, and PolygonRings clips ears. Outlines may cross or cover
     * themselves, and holes may touch them. Every ear has an area in the plane. A ring without area has no triangles.</p>
     *
     * <p>Cost: linear for convex polygons, otherwise up to quadratic in the corners, but at most the tests of corners that the file's limits
     * allow. Beyond that, corners are cut off without a test, and holes are filled.</p>
     *
     * @private
     */
    public final class Triangulator
    {
        /** How many polygons one step may add: see addPolygon(). */
        public static const POLYGONS_PER_STEP:int = 100;

        /** Three indices for each triangle, in the direction of its polygon. */
        public var triangles:Vector.<uint>;

        private var _budget:FileBudget;
        private var _vertices:Vector.<Number>;

        /**
         * @param budget limits the tests of corners
         * @param vertices x, y, z, ...; the polygons' corners are indices of these
         * @param triangles takes the triangles
         */
        public function Triangulator(budget:FileBudget, vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            _budget = budget;
            _vertices = vertices;
            this.triangles = triangles;
        }

        /**
         * Triangulates a polygon, or begins to do so with a large one. For StepSequence.beginEach().
         *
         * @param outline the corners of its outline; the vector is not kept
         * @param holes the corners of each hole, in either direction; null for none
         * @return the work on the rest of it, which must be done before other triangles are added; null if all is done
         */
        public function addPolygon(outline:Vector.<uint>, holes:Vector.<Vector.<uint>> = null):Steps
        {
            if (outline.length < 3)
            {
                return null;
            }
            var hasHoles:Boolean = holes != null && holes.length > 0;
            if (!hasHoles && outline.length <= 4)
            {
                addSmall(outline);
                return null;
            }
            var rings:PolygonRings = new PolygonRings(_budget, _vertices, outline);
            if (!rings.hasArea)
            {
                return null;
            }
            if (!hasHoles && isFan(rings))
            {
                for (var i:int = 2; i < outline.length; i++)
                {
                    addTriangle(rings.vertex[0], rings.vertex[int(i - 1)], rings.vertex[i]);
                }
                return null;
            }
            for each (var hole:Vector.<uint> in holes)
            {
                if (hole.length > 2)
                {
                    rings.addHole(hole);
                }
            }
            var rest:StepSequence = hasHoles ? new StepSequence().add(HoleWelder.welding(rings)) : new StepSequence();
            rest.repeat(function():Boolean
                {
                    return rings.clipEars(triangles);
                });
            return rest.step() ? rest : null;
        }

        /** Adds a triangle, if its three corners are different. */
        public function addTriangle(a:uint, b:uint, c:uint):void
        {
            if (a != b && b != c && c != a)
            {
                triangles.push(a, b, c);
            }
        }

        // Adds an outline of three or four corners. A quad is split along the diagonal inside it.
        private function addSmall(outline:Vector.<uint>):void
        {
            var a:uint = outline[0];
            var b:uint = outline[1];
            var c:uint = outline[2];
            if (outline.length == 3)
            {
                addTriangle(a, b, c);
                return;
            }
            var d:uint = outline[3];
            var scale:Number = unitScaleOf(_vertices, outline);
            if (!isDiagonal(a, b, c, d, scale) && isDiagonal(b, c, d, a, scale))
            {
                addTriangle(a, b, d);
                addTriangle(b, c, d);
            }
            else
            {
                addTriangle(a, b, c);
                addTriangle(a, c, d);
            }
        }

        // Whether ac is a diagonal inside the quad. The scale keeps the products of four lengths from being 0 or infinite.
        private function isDiagonal(a:uint, b:uint, c:uint, d:uint, scale:Number):Boolean
        {
            var vertices:Vector.<Number> = _vertices;
            var start:int = 3 * a;
            var x:Number = vertices[start];
            var y:Number = vertices[int(start + 1)];
            var z:Number = vertices[int(start + 2)];
            start = 3 * b;
            var bx:Number = (vertices[start] - x) * scale;
            var by:Number = (vertices[int(start + 1)] - y) * scale;
            var bz:Number = (vertices[int(start + 2)] - z) * scale;
            start = 3 * c;
            var cx:Number = (vertices[start] - x) * scale;
            var cy:Number = (vertices[int(start + 1)] - y) * scale;
            var cz:Number = (vertices[int(start + 2)] - z) * scale;
            start = 3 * d;
            var dx:Number = (vertices[start] - x) * scale;
            var dy:Number = (vertices[int(start + 1)] - y) * scale;
            var dz:Number = (vertices[int(start + 2)] - z) * scale;
            return (by * cz - bz * cy) * (cy * dz - cz * dy) + (bz * cx - bx * cz) * (cz * dx - cx * dz) + (bx * cy - by * cx) * (cx * dy - cy * dx) > 0;
        }

        // Whether all triangles from the first corner are counter-clockwise, as in a convex polygon without corners in a straight line.
        private static function isFan(rings:PolygonRings):Boolean
        {
            for (var i:int = 2; i < rings.vertex.length; i++)
            {
                if (!(rings.orient2d(0, i - 1, i) > 0))
                {
                    return false;
                }
            }
            return true;
        }
    }
}
