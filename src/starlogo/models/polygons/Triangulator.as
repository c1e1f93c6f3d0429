package starlogo.models.polygons
{
    import starlogo.models.files.FileBudget;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Triangulates polygons in space. They may be concave and have holes.
     *
     * <p>A triangle stays as it is, and a quad is cut along a diagonal: the one inside it, unless the quad is smaller than 1e-150. Other polygons become rings in a plane (PolygonRings). If their first
     * corner sees all others, as in a convex polygon without corners in a straight line, they are cut from there. Otherwise their holes are
     * joined to the outline (HoleBridges), and ears are cut off (EarClipper). Outlines may cross or cover themselves. Every triangle that is
     * cut from a ring has an area in the plane. A ring without area has no triangles.</p>
     *
     * <p>Cost: linear for convex polygons, otherwise up to quadratic in the corners, but at most the tests of corners that the file's limits
     * allow. Beyond that, corners are cut off without a test, and holes are filled.</p>
     *
     * @private
     */
    public final class Triangulator
    {
        private static const POLYGONS_PER_STEP:int = 100;

        // The areas in quads with shorter diagonals are multiplied by a power of two, which rounds nothing: ENLARGING is 2^600.
        private static const TINY:Number = 1e-60;
        private static const ENLARGING:Number = 4.149515568880993e180;

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
         * The work that adds numbered polygons, some in each step. A large polygon takes several steps.
         *
         * @param count the number of polygons
         * @param add <code>function(index:int):Steps</code>; adds one polygon by <code>addPolygon()</code> and returns what that returns, or adds
         * triangles and returns null
         */
        public function addingEach(count:int, add:Function):Steps
        {
            var next:int = 0;
            var rest:Steps = null;
            return new StepSequence().repeat(function():Boolean
                {
                    var end:int = Math.min(next + POLYGONS_PER_STEP, count);
                    rest = rest != null && rest.step() ? rest : null;
                    while (rest == null && next < end)
                    {
                        rest = add(next++);
                    }
                    return rest != null || next < count;
                });
        }

        /**
         * Triangulates a polygon, or begins to do so with a large one.
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
            var start:int = rings.addLoop(outline, true);
            if (!hasHoles && isFan(rings))
            {
                for (var i:int = 2; i < outline.length; i++)
                {
                    addTriangle(rings.vertex[0], rings.vertex[int(i - 1)], rings.vertex[i]);
                }
                return null;
            }
            var nodes:Vector.<int> = new Vector.<int>();
            for each (var hole:Vector.<uint> in holes)
            {
                if (hole.length > 2)
                {
                    nodes.push(rings.addLoop(hole, false));
                }
            }
            var clipper:EarClipper = new EarClipper(rings, start, triangles);
            var rest:Steps = nodes.length == 0 ? clipper : new StepSequence().add(new HoleBridges(rings, start, nodes)).add(clipper);
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

        // Adds an outline of three or four corners. A quad is cut along the diagonal inside it.
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
            if (!isDiagonal(a, b, c, d) && isDiagonal(b, c, d, a))
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

        // Whether ac cuts the quad into two triangles of the same direction.
        private function isDiagonal(a:uint, b:uint, c:uint, d:uint):Boolean
        {
            var vertices:Vector.<Number> = _vertices;
            var start:int = 3 * a;
            var x:Number = vertices[start];
            var y:Number = vertices[int(start + 1)];
            var z:Number = vertices[int(start + 2)];
            start = 3 * b;
            var bx:Number = vertices[start] - x;
            var by:Number = vertices[int(start + 1)] - y;
            var bz:Number = vertices[int(start + 2)] - z;
            start = 3 * c;
            var cx:Number = vertices[start] - x;
            var cy:Number = vertices[int(start + 1)] - y;
            var cz:Number = vertices[int(start + 2)] - z;
            start = 3 * d;
            var dx:Number = vertices[start] - x;
            var dy:Number = vertices[int(start + 1)] - y;
            var dz:Number = vertices[int(start + 2)] - z;
            // the products of four lengths of a tiny or huge quad would be 0 or infinite
            var size:Number = Math.abs(cx) + Math.abs(cy) + Math.abs(cz);
            var scale:Number = size < TINY ? ENLARGING : (size > 1 / TINY ? 1 / ENLARGING : 1);
            return scale * (by * cz - bz * cy) * (scale * (cy * dz - cz * dy)) + scale * (bz * cx - bx * cz) * (scale * (cz * dx - cx * dz)) +
                scale * (bx * cy - by * cx) * (scale * (cx * dy - cy * dx)) > 0;
        }

        // Whether the ring turns left as seen from its first corner, as a convex polygon without corners in a straight line does.
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
