package starlogo.search.pairs
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ConvexShape;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
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

        // A box around the points that count as the farthest, the last of them, and a point that may be one.
        private var _low:Vector3D = new Vector3D();
        private var _high:Vector3D = new Vector3D();
        private var _last:Vector3D = new Vector3D();
        private var _added:Vector3D = new Vector3D();

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
            findInModel(body, _direction, out);
            bringSupportBack(direction, body.placement, out);
        }

        /**
         * Finds the farthest point too. Points are equally far if their distances differ by less than a small part of the body's largest extent.
         *
         * @param direction as in findSupport
         * @param out receives the support and the point
         */
        public function findPoint(body:Body, direction:Vector3D, out:SupportPoint):void
        {
            var at:Placement = body.placement;
            turnIntoModel(direction, at, _direction);
            findInModel(body, _direction, out);
            // addFarthest reads from out how far points have to be
            var farthest:Number = out.support;
            out.support -= Tolerances.SEPARATION * body.largestHalf / at.size;
            addFarthest(body, _direction, out);
            out.support = farthest;
            bringSupportBack(direction, at, out);
            bringPointBack((_low.x + _high.x) / 2, (_low.y + _high.y) / 2, (_low.z + _high.z) / 2, at, out);
        }

        /**
         * Finds the farthest point of a tree too. If several points are as far, it is one of them, which is the tree's own. The middle may be none: it
         * is between the legs of a table.
         *
         * @param direction as in findSupport
         * @param out receives the support and the point
         */
        public function findPointOfTree(tree:Body, direction:Vector3D, out:SupportPoint):void
        {
            turnIntoModel(direction, tree.placement, _direction);
            findInModel(tree, _direction, out);
            addFarthest(tree, _direction, out);
            bringSupportBack(direction, tree.placement, out);
            bringPointBack(_last.x, _last.y, _last.z, tree.placement, out);
        }

        // Turns a point in the model's space into one in the world.
        private static function bringPointBack(modelX:Number, modelY:Number, modelZ:Number, at:Placement, out:SupportPoint):void
        {
            var x:Number = at.size * modelX;
            var y:Number = at.size * modelY;
            var z:Number = at.size * modelZ;
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

        // The corners of a body's triangles if they decide; otherwise null.
        private function cornersOf(body:Body):Vector.<Number>
        {
            var tree:ModelTree = body.shape.hierarchy;
            return _limits.exact && tree.hasTriangles ? tree.mesh.corners : null;
        }

        // The depth to which a body's tree is visited.
        private function depthOf(body:Body, corners:Vector.<Number>):int
        {
            return corners != null ? BoxTree.EXACT : _limits.depthOf(body);
        }

        // Finds how far a body's shape reaches in the model's space.
        private function findInModel(body:Body, direction:Vector3D, out:SupportPoint):void
        {
            if (body.shape.hierarchy == null)
            {
                findOfStructure(body.shape.structure, direction, out);
                return;
            }
            var tree:BoxTree = body.shape.hierarchy.boxTree;
            var corners:Vector.<Number> = cornersOf(body);
            var depth:int = depthOf(body, corners);
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
                else if (corners == null)
                {
                    out.support = upperBound;
                }
                else
                {
                    findOfCorners(corners, tree.first[node], tree.end[node], direction, out);
                }
            }
        }

        // Finds how far a structure reaches, and sets _shape to it.
        private function findOfStructure(structure:BoundingStructure, direction:Vector3D, out:SupportPoint):void
        {
            structure.shapeInto(_shape);
            var p:Vector.<Number> = _shape.points;
            var i:int = _shape.support(direction, 1);
            out.support = (_shape.x + p[i]) * direction.x + (_shape.y + p[int(i + 1)]) * direction.y + (_shape.z + p[int(i + 2)]) * direction.z
                + _shape.radius;
        }

        // How far a node's box reaches. Its numbers begin at an index: the middle, and the half-extents.
        private static function supportOfNode(boxes:Vector.<Number>, at:int, direction:Vector3D):Number
        {
            return boxes[at] * direction.x + boxes[int(at + 1)] * direction.y + boxes[int(at + 2)] * direction.z
                + boxes[int(at + 3)] * Math.abs(direction.x) + boxes[int(at + 4)] * Math.abs(direction.y) + boxes[int(at + 5)] * Math.abs(direction.z);
        }

        private static function findOfCorners(corners:Vector.<Number>, first:int, end:int, direction:Vector3D, out:SupportPoint):void
        {
            var farthest:Number = out.support;
            for (var i:int = 9 * first; i < 9 * end; i += 3)
            {
                farthest = Math.max(farthest, corners[i] * direction.x + corners[int(i + 1)] * direction.y + corners[int(i + 2)] * direction.z);
            }
            out.support = farthest;
        }

        // Finds the box around the points of a body's shape that count as the farthest: those that reach as far as a support in the model's space.
        private function addFarthest(body:Body, direction:Vector3D, least:SupportPoint):void
        {
            _low.setTo(Infinity, Infinity, Infinity);
            _high.setTo(-Infinity, -Infinity, -Infinity);
            if (body.shape.hierarchy == null)
            {
                addFarthestOfStructure(direction, least);
                return;
            }
            var tree:BoxTree = body.shape.hierarchy.boxTree;
            var corners:Vector.<Number> = cornersOf(body);
            var depth:int = depthOf(body, corners);
            _nodes[0] = 0;
            for (var top:int = 0; top >= 0; top--)
            {
                var node:int = _nodes[top];
                if (supportOfNode(tree.boxes, 6 * node, direction) < least.support)
                {
                    continue;
                }
                if (tree.endsUpToDepth[node] < depth)
                {
                    _nodes[top] = tree.left[node] + 1;
                    _nodes[top + 1] = tree.left[node];
                    top += 2;
                }
                else if (corners == null)
                {
                    addFarthestOfNode(tree.boxes, 6 * node, direction);
                }
                else
                {
                    addCorners(corners, tree.first[node], tree.end[node], direction, least);
                }
            }
        }

        private function addCorners(corners:Vector.<Number>, first:int, end:int, direction:Vector3D, least:SupportPoint):void
        {
            for (var i:int = 9 * first; i < 9 * end; i += 3)
            {
                _added.setTo(corners[i], corners[int(i + 1)], corners[int(i + 2)]);
                if (_added.x * direction.x + _added.y * direction.y + _added.z * direction.z >= least.support)
                {
                    addPoint(_added);
                }
            }
        }

        // Adds the points of _shape, which findOfStructure() has set.
        private function addFarthestOfStructure(direction:Vector3D, least:SupportPoint):void
        {
            var p:Vector.<Number> = _shape.points;
            var x:Number = _shape.x + _shape.radius * direction.x;
            var y:Number = _shape.y + _shape.radius * direction.y;
            var z:Number = _shape.z + _shape.radius * direction.z;
            var leastOfCore:Number = least.support - (x * direction.x + y * direction.y + z * direction.z);
            for (var i:int = 0; i < _shape.end; i += 3)
            {
                if (p[i] * direction.x + p[int(i + 1)] * direction.y + p[int(i + 2)] * direction.z >= leastOfCore)
                {
                    _added.setTo(x + p[i], y + p[int(i + 1)], z + p[int(i + 2)]);
                    addPoint(_added);
                }
            }
        }

        // Adds the farthest point of a node's box. If an edge or a face is across the direction, it is the middle of that.
        private function addFarthestOfNode(boxes:Vector.<Number>, at:int, direction:Vector3D):void
        {
            _added.x = boxes[at] + sideOf(direction.x) * boxes[int(at + 3)];
            _added.y = boxes[int(at + 1)] + sideOf(direction.y) * boxes[int(at + 4)];
            _added.z = boxes[int(at + 2)] + sideOf(direction.z) * boxes[int(at + 5)];
            addPoint(_added);
        }

        // Whether an axis points along the direction (1), against it (-1) or across it (0). The cosine of their angle is given.
        private static function sideOf(cosine:Number):int
        {
            return Math.abs(cosine) <= Tolerances.SEPARATION ? 0 : cosine > 0 ? 1 : -1;
        }

        private function addPoint(point:Vector3D):void
        {
            _last.copyFrom(point);
            _low.setTo(Math.min(_low.x, point.x), Math.min(_low.y, point.y), Math.min(_low.z, point.z));
            _high.setTo(Math.max(_high.x, point.x), Math.max(_high.y, point.y), Math.max(_high.z, point.z));
        }
    }
}
