package starlogo.models
{
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Trigonometry;

    use namespace engine;

    /**
     * The shapes that need no file: a sphere, a cube and a cylinder, with the vertex counts of the thesis (Figure 6-2), and capsules and
     * boxes of given sizes. Their surfaces are closed, and their triangles are counter-clockwise seen from outside.
     */
    public final class BuiltInModel extends Model
    {
        private static const SPHERE_SEGMENTS:int = 16;
        private static const SPHERE_RINGS:int = 13;
        private static const CAPSULE_SEGMENTS:int = 16;
        private static const CAPSULE_RINGS:int = 6;
        private static const CYLINDER_SEGMENTS:int = 32;
        private static const CYLINDER_SIDE_RINGS:int = 8;
        private static const CYLINDER_HEIGHT:Number = 1.1314;

        // The corners of a square, counter-clockwise seen from the end of the axis.
        private static const SQUARE_U:Vector.<Number> = new <Number>[-0.5, 0.5, 0.5, -0.5];
        private static const SQUARE_V:Vector.<Number> = new <Number>[-0.5, -0.5, 0.5, 0.5];

        /**
         * Use <code>sphere()</code>, <code>cube()</code>, <code>cylinder()</code>, <code>capsule()</code> or <code>box()</code> instead.
         *
         * @param name as for Model
         * @param vertices as for Model
         * @param triangles as for Model
         * @param scaling as for Model
         */
        public function BuiltInModel(name:String, vertices:Vector.<Number>, triangles:Vector.<uint>, scaling:String = FOOTPRINT)
        {
            super(name, vertices, triangles, scaling);
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

            joinRings(triangles, SPHERE_RINGS, SPHERE_SEGMENTS + 1, SPHERE_SEGMENTS);
            return new BuiltInModel("sphere", vertices, triangles);
        }

        /**
         * A cube of edge 1, named "cube". Each of its 6 faces has 4 vertices of its own and 2 triangles, so the cube has 24 vertices and 12
         * triangles.
         */
        public static function cube():Model
        {
            var triangles:Vector.<uint> = new Vector.<uint>();
            var vertices:Vector.<Number> = new Vector.<Number>();
            addCube(vertices, triangles);
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

        /**
         * An upright capsule for a character. The middle of its lowest point is the model's origin, so an agent of size 1 at height 0 stands
         * on the ground. The model is not scaled: an agent of size 2 is twice as large. It has 194 vertices: two poles and 12 rings of 16. If
         * the height is twice the radius it is a sphere of 178 vertices.
         *
         * @param radius in patches, positive, at most Agent.LARGEST_COORDINATE
         * @param height the whole height in patches, caps included; at least twice the radius, at most Agent.LARGEST_COORDINATE
         * @param name what agents call the shape; capsules of several sizes need several names
         * @throws RangeError if radius or height is not in its range
         * @throws ModelError if the name is empty
         */
        public static function capsule(radius:Number, height:Number, name:String = "capsule"):Model
        {
            requireSize(name, "a capsule's radius", radius);
            requireSize(name, "a capsule's height", height);
            if (height < 2 * radius)
            {
                throw new RangeError("a capsule's height includes its caps, so it must be at least twice its radius of " + radius + ", not " + height);
            }
            var vertices:Vector.<Number> = new <Number>[0, 0, 0];
            var triangles:Vector.<uint> = new Vector.<uint>();
            addCap(vertices, radius, radius, 1, CAPSULE_RINGS);
            // a sphere has one equator
            addCap(vertices, radius, height - radius, height > 2 * radius ? CAPSULE_RINGS : CAPSULE_RINGS + 1, 2 * CAPSULE_RINGS - 1);
            vertices.push(0, 0, height);

            joinRings(triangles, (vertices.length / 3 - 2) / CAPSULE_SEGMENTS, CAPSULE_SEGMENTS, CAPSULE_SEGMENTS);
            return new BuiltInModel(name, vertices, triangles, AS_GIVEN);
        }

        /**
         * A box with edges along the axes. The middle of its lowest face is the model's origin. The model is not scaled: an agent of size 2
         * is twice as large. It has 24 vertices and 12 triangles, as the cube.
         *
         * @param x the length along the x axis in patches, positive, at most Agent.LARGEST_COORDINATE
         * @param y the same along the y axis
         * @param z the same along the z axis
         * @param name what agents call the shape; boxes of several sizes need several names
         * @throws RangeError if a length is not in its range
         * @throws ModelError if the name is empty
         */
        public static function box(x:Number, y:Number, z:Number, name:String = "box"):Model
        {
            requireSize(name, "a box's x", x);
            requireSize(name, "a box's y", y);
            requireSize(name, "a box's z", z);
            var vertices:Vector.<Number> = new Vector.<Number>();
            var triangles:Vector.<uint> = new Vector.<uint>();
            addCube(vertices, triangles);
            for (var i:int = 0; i < vertices.length; i += 3)
            {
                vertices[i] *= x;
                vertices[i + 1] *= y;
                vertices[i + 2] = (vertices[i + 2] + 0.5) * z;
            }
            return new BuiltInModel(name, vertices, triangles, AS_GIVEN);
        }

        private static function requireSize(name:String, what:String, value:Number):void
        {
            if (!(value > 0 && value <= Placement.LARGEST_COORDINATE))
            {
                throw new RangeError("model \"" + name + "\": " + what + " must be positive and at most " + Placement.LARGEST_COORDINATE + ", not " + value);
            }
        }

        // Adds some of the rings of a sphere at a height; a ring's number counts the equal angles from below.
        private static function addCap(vertices:Vector.<Number>, radius:Number, middle:Number, first:int, last:int):void
        {
            for (var ring:int = first; ring <= last; ring++)
            {
                var angle:Number = 90 * ring / CAPSULE_RINGS;
                addRing(vertices, CAPSULE_SEGMENTS, radius * Trigonometry.sine(angle), middle - radius * Trigonometry.cosine(angle));
            }
        }

        // Adds a cube of edge 1 around the origin.
        private static function addCube(vertices:Vector.<Number>, triangles:Vector.<uint>):void
        {
            vertices.length = 72;
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
        }

        // Adds a horizontal circle of vertices around the z axis. It begins at +x and is counter-clockwise seen from above.
        private static function addRing(vertices:Vector.<Number>, segments:int, radius:Number, z:Number):void
        {
            for (var segment:int = 0; segment < segments; segment++)
            {
                var angle:Number = 360 * segment / segments;
                vertices.push(radius * Trigonometry.cosine(angle), radius * Trigonometry.sine(angle), z);
            }
        }

        // Joins the first vertex to the first ring, the rings to each other, and the last ring to the last vertex.
        private static function joinRings(triangles:Vector.<uint>, ringCount:int, ringSize:int, segments:int):void
        {
            var lastRing:int = 1 + (ringCount - 1) * ringSize;
            for (var segment:int = 0; segment < segments; segment++)
            {
                var next:int = (segment + 1) % ringSize;
                triangles.push(0, 1 + next, 1 + segment);
                triangles.push(lastRing + ringSize, lastRing + segment, lastRing + next);
            }
            addBands(triangles, 1, ringCount - 1, ringSize, segments);
        }

        // Joins each ring of vertices to the next ring with triangles. The rings follow one another, and the first ring begins at vertex first.
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
