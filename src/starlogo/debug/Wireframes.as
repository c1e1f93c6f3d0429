// This room makes lines to draw. Wireframes has the lines of structures, trees, triangles and the ground, and CollisionLines those of what a
// collision system tests for an agent. Read this file first.
package starlogo.debug
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Cylinder;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ConvexShape;
    import starlogo.data.requireGiven;
    import starlogo.engine;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.vertices.PointTable;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.terrain.Terrain;
    import starlogo.terrain.TerrainSurface;

    use namespace engine;

    /**
     * Lists of lines to draw: structures, levels of hierarchies, triangles and the ground.
     *
     * <p>A line is six numbers: x, y and z of one end, then of the other, in the structure's space. The ends lie on the structure's
     * surface. Lines without length are left out, so a point has no lines. Lines are appended to <code>out</code>: set its length to 0 if it shall
     * have no others. Other calls of the engine overwrite theirs.</p>
     *
     * <p>A box has its twelve edges. A sphere has three circles. A capsule has a circle and two half-circles at each end, and four lines
     * between the ends. A cylinder has two circles and four lines. A hull has the edges between faces that are not in one plane.</p>
     */
    public final class Wireframes
    {
        // of a circle
        private static const SEGMENTS:int = 32;

        /** Has only static members. */
        public function Wireframes()
        {
        }

        /**
         * The lines of a structure.
         *
         * @param structure in any space
         * @param out the lines are appended to it; created if null
         * @return out
         * @throws ArgumentError if the structure is null, or of an unknown class
         */
        public static function ofStructure(structure:BoundingStructure, out:Vector.<Number> = null):Vector.<Number>
        {
            requireGiven("the structure to draw", structure);
            var lines:Vector.<Number> = out || new Vector.<Number>();
            switch (structure.kind)
            {
                case BoundingStructure.SPHERE:
                    drawArcs(lines, Sphere(structure).center, Vector3D.X_AXIS, Vector3D.Y_AXIS, Vector3D.Z_AXIS, Sphere(structure).radius, 360);
                    break;
                case BoundingStructure.BOX:
                    var box:Box = Box(structure);
                    drawEdges(lines, box.center, box.axisX, box.halfX, box.axisY, box.halfY, box.axisZ, box.halfZ);
                    drawEdges(lines, box.center, box.axisY, box.halfY, box.axisZ, box.halfZ, box.axisX, box.halfX);
                    drawEdges(lines, box.center, box.axisZ, box.halfZ, box.axisX, box.halfX, box.axisY, box.halfY);
                    break;
                case BoundingStructure.CAPSULE:
                    var capsule:Capsule = Capsule(structure);
                    drawRound(lines, capsule.start, capsule.end, capsule.radius, 180);
                    break;
                case BoundingStructure.HULL:
                    drawHull(lines, structure);
                    break;
                default:
                    var cylinder:Cylinder = structure as Cylinder;
                    if (cylinder == null)
                    {
                        throw new ArgumentError("this kind of structure can't be drawn: " + structure);
                    }
                    if (!cylinder.start.equals(cylinder.end))
                    {
                        drawRound(lines, cylinder.start, cylinder.end, cylinder.radius, 0);
                    }
            }
            return lines;
        }

        /**
         * The lines of the structures that a collider reaches if it visits only some levels of a hierarchy: of the nodes on the given
         * level, and of the leaves above it.
         *
         * @param root the node whose level is 1: a hierarchy's root, or any other node
         * @param level from 1
         * @param out the lines are appended to it; created if null
         * @return out
         * @throws ArgumentError if the root is null
         * @throws RangeError if the level is less than 1
         */
        public static function ofLevel(root:HierarchyNode, level:int, out:Vector.<Number> = null):Vector.<Number>
        {
            requireGiven("the hierarchy to draw", root);
            if (level < 1)
            {
                throw new RangeError("the level must be 1 (the root) or more, not " + level);
            }
            if (level == 1 || root.isLeaf)
            {
                return ofStructure(root.bounds, out);
            }
            return ofLevel(root.right, level - 1, ofLevel(root.left, level - 1, out));
        }

        /**
         * The edges of triangles. An edge that several triangles share appears once.
         *
         * @param vertices x, y and z of each vertex
         * @param triangles three vertex indices each
         * @param out the lines are appended to it; created if null
         * @return out
         * @throws ArgumentError if one is null
         * @throws RangeError if an index is that of no vertex; lines may then have been appended
         */
        public static function ofTriangles(vertices:Vector.<Number>, triangles:Vector.<uint>, out:Vector.<Number> = null):Vector.<Number>
        {
            requireGiven("vertices", vertices);
            requireGiven("triangles", triangles);
            var lines:Vector.<Number> = out || new Vector.<Number>();
            var drawn:Object = {};
            for (var i:int = 0; i < triangles.length; i++)
            {
                var a:int = triangles[i];
                var b:int = triangles[i % 3 == 2 ? i - 2 : i + 1];
                var key:Number = Math.min(a, b) * (vertices.length / 3) + Math.max(a, b);
                if (!drawn[key])
                {
                    drawn[key] = true;
                    drawLine(lines, vertexAt(vertices, a), vertexAt(vertices, b));
                }
            }
            return lines;
        }

        /**
         * The edges of the ground's triangles in a rectangle, as a TerrainSurface has them: of slopes, tops of blocks and walls. An edge that
         * several triangles share appears once.
         *
         * @param terrain the ground as it is now
         * @param minX the rectangle's least x; the rectangle may reach beyond the ground
         * @param minY its least y. All four numbers may be infinite
         * @param maxX its greatest x
         * @param maxY its greatest y
         * @param out the lines are added to it, in the world; made if null
         * @return out
         * @throws ArgumentError if the terrain is null
         */
        public static function ofTerrain(terrain:Terrain, minX:Number, minY:Number, maxX:Number, maxY:Number, out:Vector.<Number> = null):Vector.<Number>
        {
            var surface:TerrainSurface = new TerrainSurface(terrain, minX, minY, maxX, maxY);
            surface.update();
            var points:PointTable = new PointTable(surface.triangles.length);
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var i:int = 0; i < surface.vertices.length; i += 3)
            {
                triangles.push(points.add(surface.vertices[i], surface.vertices[i + 1], surface.vertices[i + 2]));
            }
            return ofTriangles(points.coordinates, triangles, out);
        }

        private static function vertexAt(vertices:Vector.<Number>, index:int):Vector3D
        {
            if (3 * index + 2 >= vertices.length)
            {
                throw new RangeError("there is no vertex " + index);
            }
            return new Vector3D(vertices[3 * index], vertices[3 * index + 1], vertices[3 * index + 2]);
        }

        // Draws the edges of a hull, without its radius.
        private static function drawHull(lines:Vector.<Number>, structure:BoundingStructure):void
        {
            var shape:ConvexShape = new ConvexShape();
            structure.setShape(shape);
            var center:Vector3D = shape.origin;
            for (var i:int = 0; i < shape.edges.length; i += 4)
            {
                drawLine(lines, center.add(vertexAt(shape.points, shape.edges[i] / 3)), center.add(vertexAt(shape.points, shape.edges[i + 1] / 3)));
            }
        }

        // Draws the four edges of a box that are parallel to axis a.
        private static function drawEdges(lines:Vector.<Number>, center:Vector3D, a:Vector3D, halfA:Number, b:Vector3D, halfB:Number, c:Vector3D, halfC:Number):void
        {
            for (var i:int = 0; i < 4; i++)
            {
                var edgeCenter:Vector3D = along(center, b, i < 2 ? halfB : -halfB, c, i % 2 == 0 ? halfC : -halfC);
                drawLine(lines, along(edgeCenter, a, -halfA, b, 0), along(edgeCenter, a, halfA, b, 0));
            }
        }

        // Draws a tube with round ends, which arcs of so many degrees show: a capsule, or a cylinder if the ends are flat.
        private static function drawRound(lines:Vector.<Number>, start:Vector3D, end:Vector3D, radius:Number, endDegrees:int):void
        {
            var w:Vector3D = end.subtract(start);
            // Divides by the largest coordinate first. Otherwise squares could become 0 or infinite.
            var largest:Number = Math.max(Math.abs(w.x), Math.abs(w.y), Math.abs(w.z));
            w = largest == 0 ? new Vector3D(0, 0, 1) : new Vector3D(w.x / largest, w.y / largest, w.z / largest);
            w.normalize();
            var u:Vector3D = (Math.abs(w.z) < 0.7 ? Vector3D.Z_AXIS : Vector3D.X_AXIS).crossProduct(w);
            u.normalize();
            var v:Vector3D = w.crossProduct(u);
            for (var i:int = 0; i < (radius > 0 ? 4 : 1); i++)
            {
                var across:Vector3D = i < 2 ? u : v;
                var distance:Number = i % 2 == 0 ? radius : -radius;
                drawLine(lines, along(start, across, distance, w, 0), along(end, across, distance, w, 0));
            }
            drawArcs(lines, start, u, v, w, -radius, endDegrees);
            drawArcs(lines, end, u, v, w, radius, endDegrees);
        }

        // Draws a circle in the plane of u and v, and arcs of so many degrees from u and from v towards w.
        private static function drawArcs(lines:Vector.<Number>, center:Vector3D, u:Vector3D, v:Vector3D, w:Vector3D, radius:Number, degrees:int):void
        {
            drawArc(lines, center, u, v, radius, 360);
            drawArc(lines, center, u, w, radius, degrees);
            drawArc(lines, center, v, w, radius, degrees);
        }

        // Draws a part of a circle, from direction a towards b. Both are unit vectors at right angles.
        private static function drawArc(lines:Vector.<Number>, center:Vector3D, a:Vector3D, b:Vector3D, radius:Number, degrees:int):void
        {
            var from:Vector3D = along(center, a, radius, b, 0);
            for (var i:int = 1; 360 * i <= degrees * SEGMENTS; i++)
            {
                var angle:Number = 360 * i / SEGMENTS;
                var to:Vector3D = along(center, a, radius * Trigonometry.cosine(angle), b, radius * Trigonometry.sine(angle));
                drawLine(lines, from, to);
                from = to;
            }
        }

        // Draws a line, if it has a length.
        private static function drawLine(lines:Vector.<Number>, from:Vector3D, to:Vector3D):void
        {
            if (!from.equals(to))
            {
                lines.push(from.x, from.y, from.z, to.x, to.y, to.z);
            }
        }

        // A point moved by atA along a, and by atB along b.
        private static function along(from:Vector3D, a:Vector3D, atA:Number, b:Vector3D, atB:Number):Vector3D
        {
            return new Vector3D(from.x + a.x * atA + b.x * atB, from.y + a.y * atA + b.y * atB, from.z + a.z * atA + b.z * atB);
        }
    }
}
