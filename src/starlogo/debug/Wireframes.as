package starlogo.debug
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.hierarchy.HierarchyNode;

    /**
     * Structures, levels of hierarchies and triangles as lists of lines, to be drawn by a client.
     *
     * <p>A line is six numbers: x, y and z of one end, then of the other, in the structure's space. Ends lie on the
     * structure's surface. Lines without length are left out, so that a point has none.</p>
     *
     * <p>A box is its twelve edges; a sphere three circles; a capsule a circle and two half-circles at either end and four lines
     * between; a cylinder two circles and four lines.</p>
     */
    public final class Wireframes
    {
        /** All is static. */
        public function Wireframes()
        {
        }

        /**
         * The lines of a structure.
         *
         * @param structure in any space
         * @param out the lines are added to it; made if null
         * @return out
         * @throws ArgumentError if the structure is null, or none of the engine's
         */
        public static function ofStructure(structure:BoundingStructure, out:Vector.<Number> = null):Vector.<Number>
        {
            if (structure == null)
            {
                throw new ArgumentError("there is no structure to draw: null");
            }
            var pen:LinePen = new LinePen(out);
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    drawSphere(pen, Sphere(structure));
                    break;
                case BoundingStructure.BOX:
                    drawBox(pen, Box(structure));
                    break;
                case BoundingStructure.CAPSULE:
                    var capsule:Capsule = Capsule(structure);
                    drawRound(pen, capsule.start, capsule.end, capsule.radius, true);
                    break;
                case BoundingStructure.CYLINDER:
                    var cylinder:Cylinder = Cylinder(structure);
                    drawRound(pen, cylinder.start, cylinder.end, cylinder.radius, false);
                    break;
                default:
                    throw new ArgumentError("there are no lines for " + structure);
            }
            return pen.lines;
        }

        /**
         * The lines of what a collider looks at last when it visits so many levels of a hierarchy: the structures of the nodes on
         * that level, and of the leaves above it.
         *
         * @param root the node whose level is 1: a hierarchy's root, or any other
         * @param level from 1
         * @param out the lines are added to it; made if null
         * @return out
         * @throws ArgumentError if the root is null
         * @throws RangeError if the level is less than 1
         */
        public static function ofLevel(root:HierarchyNode, level:int, out:Vector.<Number> = null):Vector.<Number>
        {
            if (root == null)
            {
                throw new ArgumentError("there is no hierarchy to draw: null");
            }
            if (level < 1)
            {
                throw new RangeError("the root's level is 1: there is no level " + level);
            }
            if (level == 1 || root.isLeaf)
            {
                return ofStructure(root.bounds, out);
            }
            return ofLevel(root.right, level - 1, ofLevel(root.left, level - 1, out));
        }

        /**
         * The edges of triangles, each once.
         *
         * @param vertices x, y and z of each
         * @param triangles three vertex indices each
         * @param out the lines are added to it; made if null
         * @return out
         */
        public static function ofTriangles(vertices:Vector.<Number>, triangles:Vector.<uint>, out:Vector.<Number> = null):Vector.<Number>
        {
            var pen:LinePen = new LinePen(out);
            var drawn:Object = {};
            for (var i:int = 0; i < triangles.length; i++)
            {
                var a:int = triangles[i];
                var b:int = triangles[i % 3 == 2 ? i - 2 : i + 1];
                var key:Number = Math.min(a, b) * (vertices.length / 3) + Math.max(a, b);
                if (!drawn[key])
                {
                    drawn[key] = true;
                    pen.drawLine(vertices[3 * a], vertices[3 * a + 1], vertices[3 * a + 2], vertices[3 * b], vertices[3 * b + 1], vertices[3 * b + 2]);
                }
            }
            return pen.lines;
        }

        private static function drawSphere(pen:LinePen, sphere:Sphere):void
        {
            pen.moveTo(sphere.center);
            pen.setAxes(1, 0, 0, 0, 1, 0);
            pen.drawCircle(sphere.radius);
            pen.setAxes(0, 1, 0, 0, 0, 1);
            pen.drawCircle(sphere.radius);
            pen.setAxes(0, 0, 1, 1, 0, 0);
            pen.drawCircle(sphere.radius);
        }

        private static function drawBox(pen:LinePen, box:Box):void
        {
            pen.moveTo(box.center);
            for (var i:int = -1; i <= 1; i += 2)
            {
                for (var j:int = -1; j <= 1; j += 2)
                {
                    pen.drawEdge(box.axisX, box.halfX, box.axisY, i * box.halfY, box.axisZ, j * box.halfZ);
                    pen.drawEdge(box.axisY, box.halfY, box.axisZ, i * box.halfZ, box.axisX, j * box.halfX);
                    pen.drawEdge(box.axisZ, box.halfZ, box.axisX, i * box.halfX, box.axisY, j * box.halfY);
                }
            }
        }

        // A capsule, or a cylinder.
        private static function drawRound(pen:LinePen, start:Vector3D, end:Vector3D, radius:Number, isCapsule:Boolean):void
        {
            if (!pen.setAxesAcross(start, end) && !isCapsule)
            {
                return;
            }
            pen.drawSides(start, end, radius);
            pen.moveTo(start);
            pen.drawCircle(radius);
            if (isCapsule)
            {
                pen.drawDome(-radius);
            }
            pen.moveTo(end);
            pen.drawCircle(radius);
            if (isCapsule)
            {
                pen.drawDome(radius);
            }
        }
    }
}
