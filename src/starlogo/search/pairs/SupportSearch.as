package starlogo.search.pairs
{
    import flash.geom.Vector3D;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
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
        // The depth to which the tree is visited. The triangles' corners if they decide; otherwise null.
        private var _depth:int;
        private var _corners:Vector.<Number>;

        // The nodes still to visit, the next one last, and how far each may reach. Trees may be too deep for recursion.
        private var _nodes:Vector.<int> = new Vector.<int>();
        private var _limits:Vector.<Number> = new Vector.<Number>();

        // The direction in the model's space, the farthest support so far, and the least support of points that count as the farthest.
        private var _direction:Vector3D = new Vector3D();
        private var _best:Number;
        private var _least:Number;

        // A box around the points that count as the farthest, and the point that is added to it.
        private var _low:Vector3D = new Vector3D();
        private var _high:Vector3D = new Vector3D();
        private var _added:Vector3D = new Vector3D();
        private var _box:Box = BoxTree.newBox();

        /**
         * Finds how far a body reaches in a direction.
         *
         * @param limits how far trees are tested
         * @param direction a unit vector in the world
         * @param out receives the support
         */
        public function findSupport(body:Body, limits:TreeLimits, direction:Vector3D, out:SupportPoint):void
        {
            var tree:ModelTree = body.shape.hierarchy;
            var at:Placement = body.placement;
            _corners = tree != null && limits.exact && tree.hasTriangles ? tree.prepareCorners() : null;
            _depth = _corners != null ? BoxTree.EXACT : limits.depthOf(body);
            _direction.x = at.r00 * direction.x + at.r10 * direction.y + at.r20 * direction.z;
            _direction.y = at.r01 * direction.x + at.r11 * direction.y + at.r21 * direction.z;
            _direction.z = at.r02 * direction.x + at.r12 * direction.y + at.r22 * direction.z;
            _best = -Infinity;
            if (tree == null)
            {
                _best = body.shape.structure.supportAlong(_direction);
            }
            else
            {
                findTreeSupport(tree.boxTree);
            }
            out.support = at.x * direction.x + at.y * direction.y + at.z * direction.z + at.size * _best;
        }

        /**
         * Finds the farthest point too.
         *
         * @param body as in findSupport
         * @param limits as in findSupport
         * @param direction as in findSupport
         * @param half half of the body's largest extent. Points are equally far if their distances differ by less than a small part of it
         * @param out receives the support and the point
         */
        public function findPoint(body:Body, limits:TreeLimits, direction:Vector3D, half:Number, out:SupportPoint):void
        {
            findSupport(body, limits, direction, out);
            _least = _best - Tolerances.SEPARATION * half / body.placement.size;
            _low.setTo(Infinity, Infinity, Infinity);
            _high.setTo(-Infinity, -Infinity, -Infinity);
            if (body.shape.hierarchy == null)
            {
                addFarthest(body.shape.structure);
            }
            else
            {
                addFarthestOfTree(body.shape.hierarchy.boxTree);
            }
            var at:Placement = body.placement;
            var x:Number = at.size * (_low.x + _high.x) / 2;
            var y:Number = at.size * (_low.y + _high.y) / 2;
            var z:Number = at.size * (_low.z + _high.z) / 2;
            out.x = at.x + at.r00 * x + at.r01 * y + at.r02 * z;
            out.y = at.y + at.r10 * x + at.r11 * y + at.r12 * z;
            out.z = at.z + at.r20 * x + at.r21 * y + at.r22 * z;
        }

        // Finds how far a tree reaches.
        private function findTreeSupport(tree:BoxTree):void
        {
            _nodes[0] = 0;
            _limits[0] = Infinity;
            for (var top:int = 0; top >= 0; top--)
            {
                var node:int = _nodes[top];
                var limit:Number = Math.min(_limits[top], tree.writeBox(node, _box).supportAlong(_direction));
                if (limit <= _best)
                {
                    continue;
                }
                if (tree.endsUpToDepth[node] < _depth)
                {
                    var left:int = tree.left[node];
                    var axis:int = tree.axisOf(node);
                    var along:Number = axis == 0 ? _direction.x : axis == 1 ? _direction.y : _direction.z;
                    _nodes[top] = along > 0 ? left : left + 1;
                    _nodes[top + 1] = along > 0 ? left + 1 : left;
                    _limits[top] = _limits[top + 1] = limit;
                    top += 2;
                }
                else if (_corners == null)
                {
                    _best = limit;
                }
                else
                {
                    findCornerSupport(tree.first[node], tree.end[node]);
                }
            }
        }

        private function findCornerSupport(first:int, end:int):void
        {
            var farthest:Number = _best;
            for (var i:int = 9 * first; i < 9 * end; i += 3)
            {
                farthest = Math.max(farthest, _corners[i] * _direction.x + _corners[int(i + 1)] * _direction.y + _corners[int(i + 2)] * _direction.z);
            }
            _best = farthest;
        }

        // Adds the farthest points of a tree.
        private function addFarthestOfTree(tree:BoxTree):void
        {
            _nodes[0] = 0;
            for (var top:int = 0; top >= 0; top--)
            {
                var node:int = _nodes[top];
                if (tree.writeBox(node, _box).supportAlong(_direction) < _least)
                {
                    continue;
                }
                if (tree.endsUpToDepth[node] < _depth)
                {
                    _nodes[top] = tree.left[node] + 1;
                    _nodes[top + 1] = tree.left[node];
                    top += 2;
                }
                else if (_corners == null)
                {
                    addFarthest(_box);
                }
                else
                {
                    addCorners(tree.first[node], tree.end[node]);
                }
            }
        }

        private function addCorners(first:int, end:int):void
        {
            for (var i:int = 9 * first; i < 9 * end; i += 3)
            {
                _added.setTo(_corners[i], _corners[int(i + 1)], _corners[int(i + 2)]);
                if (along(_added) >= _least)
                {
                    addPoint();
                }
            }
        }

        // Adds the farthest point of a structure, or the middle of several.
        private function addFarthest(structure:BoundingStructure):void
        {
            structure.farthestPoint(_direction, _least, _added);
            addPoint();
        }

        private function addPoint():void
        {
            _low.setTo(Math.min(_low.x, _added.x), Math.min(_low.y, _added.y), Math.min(_low.z, _added.z));
            _high.setTo(Math.max(_high.x, _added.x), Math.max(_high.y, _added.y), Math.max(_high.z, _added.z));
        }

        private function along(vector:Vector3D):Number
        {
            return vector.x * _direction.x + vector.y * _direction.y + vector.z * _direction.z;
        }
    }
}
