package starlogo.search.pairs
{
    import flash.geom.Vector3D;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.search.Body;
    import starlogo.search.TreeLimits;
    import starlogo.solid.ModelTree;

    use namespace engine;

    /**
     * Finds the farthest point of a body's shape in a direction. For a tree, the shape is the nodes at which a test ends, or the triangles if
     * they decide. A node reaches only as far as every node above it does, because a test visits it only if those touch.
     *
     * <p>It takes the time of a few branches of the tree: a branch that cannot support farther than the best node so far is left out.</p>
     *
     * @private
     */
    public final class SupportSearch
    {
        private var _limits:TreeLimits;

        // The nodes still to visit, the next one last, and an upper bound of the support of each. Trees may be too deep for recursion.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _upperBounds:Vector.<Number> = new Vector.<Number>();

        // A structure that is no tree.
        private var _shape:ConvexShape = new ConvexShape();

        // The direction in the model's space.
        private var _direction:Vector3D = new Vector3D();

        // The sum of the points of the present part that count as the farthest, and their number.
        private var _sum:Vector3D = new Vector3D();
        private var _count:int = 0;

        /** @param limits how far trees are tested */
        public function SupportSearch(limits:TreeLimits)
        {
            _limits = limits;
        }

        /**
         * Finds how far a body reaches in a direction.
         *
         * @param direction a unit vector in the world
         * @param out receives the support
         */
        public function findSupport(body:Body, direction:Vector3D, out:SupportPoint):void
        {
            turnIntoModel(direction, body.placement, _direction);
            if (body.shape.tree == null)
            {
                body.shape.structure.shapeInto(_shape);
                findOfShape(_shape, _direction, out);
            }
            else
            {
                findOfTree(body, _direction, out);
            }
            bringSupportBack(direction, body.placement, out);
        }

        /**
         * Finds the farthest point too. If several are as far, it is the mean of a structure's corners. A tree's point is one of its own: the mean of
         * the corners of one triangle, or the middle of one node's side, nearest to the middle of the tree. The mean of all may belong to nothing: it is
         * between the legs of a table.
         *
         * @param direction as in findSupport
         * @param out receives the support and the point
         */
        public function findPoint(body:Body, direction:Vector3D, out:SupportPoint):void
        {
            var at:Placement = body.placement;
            turnIntoModel(direction, at, _direction);
            if (body.shape.tree == null)
            {
                body.shape.structure.shapeInto(_shape);
                findOfShape(_shape, _direction, out);
                takeFarthestOfShape(_shape, _direction, out.support - Tolerances.SEPARATION * body.largestHalf / at.size, out);
            }
            else
            {
                findOfTree(body, _direction, out);
                takeFarthestOfTree(body, _direction, out.support, out);
            }
            bringSupportBack(direction, at, out);
            bringPointBack(at, out);
        }

        // Turns a point in the model's space into one in the world.
        private static function bringPointBack(at:Placement, out:SupportPoint):void
        {
            var x:Number = at.size * out.x;
            var y:Number = at.size * out.y;
            var z:Number = at.size * out.z;
            out.x = at.x + at.r00 * x + at.r01 * y + at.r02 * z;
            out.y = at.y + at.r10 * x + at.r11 * y + at.r12 * z;
            out.z = at.z + at.r20 * x + at.r21 * y + at.r22 * z;
        }

        private static function turnIntoModel(direction:Vector3D, at:Placement, out:Vector3D):void
        {
            out.x = at.r00 * direction.x + at.r10 * direction.y + at.r20 * direction.z;
            out.y = at.r01 * direction.x + at.r11 * direction.y + at.r21 * direction.z;
            out.z = at.r02 * direction.x + at.r12 * direction.y + at.r22 * direction.z;
        }

        // Turns a support in the model's space into one in the world.
        private static function bringSupportBack(direction:Vector3D, at:Placement, out:SupportPoint):void
        {
            out.support = at.x * direction.x + at.y * direction.y + at.z * direction.z + at.size * out.support;
        }

        // A body's triangles if they decide; otherwise null.
        private function trianglesOf(body:Body):TriangleMesh
        {
            var tree:ModelTree = body.shape.tree;
            return _limits.exact && tree.hasTriangles ? tree.mesh : null;
        }

        // The depth to which a body's tree is visited.
        private function depthOf(body:Body, mesh:TriangleMesh):int
        {
            return mesh != null ? BoxTree.EXACT : _limits.depthOf(body);
        }

        // Finds how far a body's tree reaches in the model's space.
        private function findOfTree(body:Body, direction:Vector3D, out:SupportPoint):void
        {
            var tree:BoxTree = body.shape.tree.boxTree;
            var mesh:TriangleMesh = trianglesOf(body);
            var depth:int = depthOf(body, mesh);
            out.support = -Infinity;
            _nodes[0] = 0;
            _upperBounds[0] = Infinity;
            for (var top:int = 0; top >= 0; top--)
            {
                var node:int = _nodes[top];
                var upperBound:Number = Math.min(_upperBounds[top], supportOfNode(tree.boxes, 6 * node, direction));
                if (upperBound <= out.support)
                {
                    continue;
                }
                if (tree.endsUpToDepth[node] < depth)
                {
                    var left:int = tree.left[node];
                    var axis:int = tree.axisOf(node);
                    var along:Number = axis == 0 ? direction.x : axis == 1 ? direction.y : direction.z;
                    _nodes[top] = along > 0 ? left : left + 1;
                    _nodes[top + 1] = along > 0 ? left + 1 : left;
                    _upperBounds[top] = _upperBounds[top + 1] = upperBound;
                    top += 2;
                }
                else if (mesh == null)
                {
                    out.support = upperBound;
                }
                else
                {
                    findOfTriangles(mesh, tree.first[node], tree.end[node], direction, out);
                }
            }
        }

        private static function findOfShape(shape:ConvexShape, direction:Vector3D, out:SupportPoint):void
        {
            var p:Vector.<Number> = shape.points;
            var i:int = shape.support(direction, 1);
            out.support = (shape.x + p[i]) * direction.x + (shape.y + p[int(i + 1)]) * direction.y + (shape.z + p[int(i + 2)]) * direction.z + shape.radius;
        }

        // How far a node's box reaches. Its numbers begin at an index: the middle, and the half-extents.
        private static function supportOfNode(boxes:Vector.<Number>, at:int, direction:Vector3D):Number
        {
            return boxes[at] * direction.x + boxes[int(at + 1)] * direction.y + boxes[int(at + 2)] * direction.z
                + boxes[int(at + 3)] * Math.abs(direction.x) + boxes[int(at + 4)] * Math.abs(direction.y) + boxes[int(at + 5)] * Math.abs(direction.z);
        }

        private static function findOfTriangles(mesh:TriangleMesh, first:int, end:int, direction:Vector3D, out:SupportPoint):void
        {
            var vertices:Vector.<Number> = mesh.vertices;
            var farthest:Number = out.support;
            for (var i:int = 3 * first; i < 3 * end; i++)
            {
                var at:int = mesh.corners[i];
                farthest = Math.max(farthest, vertices[at] * direction.x + vertices[int(at + 1)] * direction.y + vertices[int(at + 2)] * direction.z);
            }
            out.support = farthest;
        }

        // Finds the mean of the corners of a shape that reach as far as a support.
        private function takeFarthestOfShape(shape:ConvexShape, direction:Vector3D, least:Number, out:SupportPoint):void
        {
            var p:Vector.<Number> = shape.points;
            var x:Number = shape.x + shape.radius * direction.x;
            var y:Number = shape.y + shape.radius * direction.y;
            var z:Number = shape.z + shape.radius * direction.z;
            beginPart();
            for (var i:int = 0; i < shape.pointsEnd; i += 3)
            {
                addIfAsFar(x + p[i], y + p[int(i + 1)], z + p[int(i + 2)], direction, least);
            }
            out.x = _sum.x / _count;
            out.y = _sum.y / _count;
            out.z = _sum.z / _count;
        }

        // Finds the point of the parts of a tree that reach as far as a support in the model's space.
        private function takeFarthestOfTree(body:Body, direction:Vector3D, least:Number, out:SupportPoint):void
        {
            var tree:BoxTree = body.shape.tree.boxTree;
            var mesh:TriangleMesh = trianglesOf(body);
            var depth:int = depthOf(body, mesh);
            // any point is nearer
            out.x = out.y = out.z = Infinity;
            _nodes[0] = 0;
            for (var top:int = 0; top >= 0; top--)
            {
                var node:int = _nodes[top];
                if (supportOfNode(tree.boxes, 6 * node, direction) < least)
                {
                    continue;
                }
                if (tree.endsUpToDepth[node] < depth)
                {
                    _nodes[top] = tree.left[node] + 1;
                    _nodes[top + 1] = tree.left[node];
                    top += 2;
                }
                else if (mesh == null)
                {
                    addNode(tree.boxes, 6 * node, direction, out);
                }
                else
                {
                    for (var triangle:int = tree.first[node]; triangle < tree.end[node]; triangle++)
                    {
                        addTriangle(tree.boxes, mesh, triangle, direction, least, out);
                    }
                }
            }
        }

        // Adds the mean of the corners of a triangle that reach as far as a support.
        private function addTriangle(boxes:Vector.<Number>, mesh:TriangleMesh, slot:int, direction:Vector3D, least:Number, out:SupportPoint):void
        {
            var vertices:Vector.<Number> = mesh.vertices;
            beginPart();
            for (var i:int = 3 * slot; i < 3 * slot + 3; i++)
            {
                var at:int = mesh.corners[i];
                addIfAsFar(vertices[at], vertices[int(at + 1)], vertices[int(at + 2)], direction, least);
            }
            if (_count > 0)
            {
                takeIfNearer(boxes, out);
            }
        }

        // Adds the farthest point of a node's box. If an edge or a face is across the direction, it is the middle of that.
        private function addNode(boxes:Vector.<Number>, at:int, direction:Vector3D, out:SupportPoint):void
        {
            _count = 1;
            _sum.setTo(boxes[at] + sideOf(direction.x) * boxes[int(at + 3)], boxes[int(at + 1)] + sideOf(direction.y) * boxes[int(at + 4)],
                    boxes[int(at + 2)] + sideOf(direction.z) * boxes[int(at + 5)]);
            takeIfNearer(boxes, out);
        }

        private function beginPart():void
        {
            _sum.setTo(0, 0, 0);
            _count = 0;
        }

        private function addIfAsFar(x:Number, y:Number, z:Number, direction:Vector3D, least:Number):void
        {
            if (x * direction.x + y * direction.y + z * direction.z >= least)
            {
                _sum.setTo(_sum.x + x, _sum.y + y, _sum.z + z);
                _count++;
            }
        }

        // Takes the mean of a part if it is nearer to the middle of the tree, whose box is the first.
        private function takeIfNearer(boxes:Vector.<Number>, out:SupportPoint):void
        {
            var x:Number = _sum.x / _count;
            var y:Number = _sum.y / _count;
            var z:Number = _sum.z / _count;
            if (squaredFromMiddle(boxes, x, y, z) < squaredFromMiddle(boxes, out.x, out.y, out.z))
            {
                out.x = x;
                out.y = y;
                out.z = z;
            }
        }

        private static function squaredFromMiddle(boxes:Vector.<Number>, x:Number, y:Number, z:Number):Number
        {
            var toX:Number = x - boxes[0];
            var toY:Number = y - boxes[1];
            var toZ:Number = z - boxes[2];
            return toX * toX + toY * toY + toZ * toZ;
        }

        // Whether an axis points along the direction (1), against it (-1) or across it (0). The cosine of their angle is given.
        private static function sideOf(cosine:Number):int
        {
            return Math.abs(cosine) <= Tolerances.SEPARATION ? 0 : cosine > 0 ? 1 : -1;
        }
    }
}
