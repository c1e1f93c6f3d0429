package starlogo.models
{
    import starlogo.geometry.Trigonometry;

    /**
     * The shapes that need no file: a sphere, a cube and a cylinder, with the vertex counts of the thesis (Figure 6-2). Their surfaces are
     * closed, and their triangles are counter-clockwise seen from outside.
     */
    public final class BuiltInModel extends Model
    {
        private static const SPHERE_SEGMENTS:int = 16;
        private static const SPHERE_RINGS:int = 13;
        private static const CYLINDER_SEGMENTS:int = 32;
        private static const CYLINDER_SIDE_RINGS:int = 8;
        private static const CYLINDER_HEIGHT:Number = 1.1314;

        // The corners of a square, counter-clockwise seen from the end of the axis.
        private static const SQUARE_U:Vector.<Number> = new <Number>[-0.5, 0.5, 0.5, -0.5];
        private static const SQUARE_V:Vector.<Number> = new <Number>[-0.5, -0.5, 0.5, 0.5];

        /**
         * Use <code>sphere()</code>, <code>cube()</code> or <code>cylinder()</code> instead.
         *
         * @param name as for Model
         * @param vertices as for Model
         * @param triangles as for Model
         */
        public function BuiltInModel(name:String, vertices:Vector.<Number>, triangles:Vector.<uint>)
        {
            super(name, vertices, triangles);
        }

        /**
         * A sphere of diameter 1, named "sphere". It has 223 vertices: two poles and 13 rings of 17 vertices (16 segments; the vertex at
         * the seam appears twice). It has 416 triangles.
         */
        public static function sphere():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            vertices.push(0, 0, 0);
            for (var ring:int = 1; ring <= SPHERE_RINGS; ring++)
            {
                var angle:Number = 180 * ring / (SPHERE_RINGS + 1);
                addRing(vertices, SPHERE_SEGMENTS, Trigonometry.sine(angle) / 2, (1 - Trigonometry.cosine(angle)) / 2);
                vertices.push(vertices[int(vertices.length - 3 * SPHERE_SEGMENTS)], 0, (1 - Trigonometry.cosine(angle)) / 2);
            }
            vertices.push(0, 0, 1);

            var ringSize:int = SPHERE_SEGMENTS + 1;
            var lastRing:int = 1 + (SPHERE_RINGS - 1) * ringSize;
            var topPole:int = lastRing + ringSize;
            for (var segment:int = 0; segment < SPHERE_SEGMENTS; segment++)
            {
                triangles.push(0, segment + 2, segment + 1);
                triangles.push(topPole, lastRing + segment, lastRing + segment + 1);
            }
            addBands(triangles, 1, SPHERE_RINGS - 1, ringSize, SPHERE_SEGMENTS);
            return new BuiltInModel("sphere", vertices, triangles);
        }

        /**
         * A cube of edge 1, named "cube". Each of its 6 faces has 4 vertices of its own and 2 triangles, so the cube has 24 vertices and 12
         * triangles.
         */
        public static function cube():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>(72);
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var face:int = 0; face < 6; face++)
            {
                var axis:int = face >> 1;
                var positive:Boolean = (face & 1) == 0;
                for (var corner:int = 0; corner < 4; corner++)
                {
                    var start:int = 3 * (4 * face + corner);
                    vertices[start + axis] = positive ? 0.5 : -0.5;
                    vertices[start + (axis + 1) % 3] = SQUARE_U[positive ? corner : 3 - corner];
                    vertices[start + (axis + 2) % 3] = SQUARE_V[positive ? corner : 3 - corner];
                }
                addQuad(triangles, 4 * face, 4 * face + 1, 4 * face + 2, 4 * face + 3);
            }
            return new BuiltInModel("cube", vertices, triangles);
        }

        /**
         * An upright cylinder of diameter 1 and height 1.1314, named "cylinder". Figure 6-1 prints the height as 1.131. It has 320 vertices
         * in 10 rings of 32: 8 rings on the side and one around each cap. It has 508 triangles.
         */
        public static function cylinder():Model
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            addRing(vertices, CYLINDER_SEGMENTS, 0.5, 0);
            for (var ring:int = 0; ring < CYLINDER_SIDE_RINGS; ring++)
            {
                addRing(vertices, CYLINDER_SEGMENTS, 0.5, CYLINDER_HEIGHT * ring / (CYLINDER_SIDE_RINGS - 1));
            }
            addRing(vertices, CYLINDER_SEGMENTS, 0.5, CYLINDER_HEIGHT);

            var topCap:int = CYLINDER_SEGMENTS * (CYLINDER_SIDE_RINGS + 1);
            for (var segment:int = 1; segment < CYLINDER_SEGMENTS - 1; segment++)
            {
                triangles.push(0, segment + 1, segment);
                triangles.push(topCap, topCap + segment, topCap + segment + 1);
            }
            addBands(triangles, CYLINDER_SEGMENTS, CYLINDER_SIDE_RINGS - 1, CYLINDER_SEGMENTS, CYLINDER_SEGMENTS);
            return new BuiltInModel("cylinder", vertices, triangles);
        }

        /** Adds a horizontal circle of vertices around the z axis. It begins at +x and is counter-clockwise seen from above. */
        private static function addRing(vertices:Vector.<Number>, segments:int, radius:Number, z:Number):void
        {
            for (var segment:int = 0; segment < segments; segment++)
            {
                var angle:Number = 360 * segment / segments;
                vertices.push(radius * Trigonometry.cosine(angle), radius * Trigonometry.sine(angle), z);
            }
        }

        /**
         * Joins each ring of vertices to the next ring with triangles. The rings follow one another, and the first ring begins at vertex
         * first.
         */
        private static function addBands(triangles:Vector.<uint>, first:int, count:int, ringSize:int, segments:int):void
        {
            for (var below:int = first; below < first + count * ringSize; below += ringSize)
            {
                for (var segment:int = 0; segment < segments; segment++)
                {
                    var next:int = (segment + 1) % ringSize;
                    addQuad(triangles, below + segment, below + next, below + ringSize + next, below + ringSize + segment);
                }
            }
        }

        private static function addQuad(triangles:Vector.<uint>, a:int, b:int, c:int, d:int):void
        {
            triangles.push(a, b, c, a, c, d);
        }
    }
}
