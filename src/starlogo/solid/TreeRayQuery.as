package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.intersection.ray.Ray;
    import starlogo.intersection.ray.RayCrossing;
    import starlogo.intersection.ray.RayCrossings;
    import starlogo.intersection.ray.RaySpan;
    import starlogo.intersection.ray.ShearedRay;
    import starlogo.intersection.ray.SpanFinder;

    use namespace engine;

    /**
     * Finds where a ray first meets a model, or all places where it crosses the surface: of the model's tree, visited to a depth, or of its triangles. A ray
     * that begins inside of a closed surface meets the model at once.
     *
     * <p>The first places are nested: no depth finds a hit farther away than a greater depth or the triangles do. The inside is tested at every
     * depth, because the nodes cover only the surface. Nothing is allocated once the stacks have grown and the model's triangles are
     * prepared.</p>
     *
     * @private
     */
    public final class TreeRayQuery
    {
        private var _search:BoxSearch = new BoxSearch();
        private var _start:Vector3D = new Vector3D();

        // If triangles decide: the ray for them, and the corners of the current one.
        private var _shearedRay:ShearedRay = new ShearedRay();
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);

        // If nodes decide: the part of the ray in the current one, and where it enters that.
        private var _span:RaySpan = new RaySpan();
        private var _entry:RayCrossing = new RayCrossing();

        /**
         * Finds where a ray first meets a model.
         *
         * @param model the model
         * @param depth how many of its levels are visited; BoxTree.EXACT if its triangles decide
         * @param ray in the model's space
         * @param out receives the distance, the normal and the triangle
         * @return whether there is a hit
         */
        public function find(model:ModelTree, depth:int, ray:Ray, out:RayCrossing):Boolean
        {
            out.setToStart(ray);
            return beginsInside(model, ray) || findOnSurface(model, depth, ray, out);
        }

        /**
         * Adds all crossings. The parameters are those of <code>find()</code>.
         *
         * @param out the crossings are added to it
         * @return whether they are those of triangles, otherwise those of nodes
         */
        public function findAll(model:ModelTree, depth:int, ray:Ray, out:RayCrossings):Boolean
        {
            if (beginsInside(model, ray))
            {
                out.addInside(ray);
            }
            var isExact:Boolean = depth == BoxTree.EXACT;
            if (isExact)
            {
                addTriangleCrossings(model.treeFor(depth), ray, out);
            }
            else
            {
                addBoxCrossings(model.boxTree, depth, ray, out);
            }
            return isExact;
        }

        private function beginsInside(model:ModelTree, ray:Ray):Boolean
        {
            _start.setTo(ray.origin.x + ray.from * ray.direction.x, ray.origin.y + ray.from * ray.direction.y, ray.origin.z + ray.from * ray.direction.z);
            return model.isInside(_start, 0);
        }

        /** Finds where a ray first meets the surface, wherever it begins. The parameters are those of <code>find()</code>. */
        internal function findOnSurface(model:ModelTree, depth:int, ray:Ray, out:RayCrossing):Boolean
        {
            return depth == BoxTree.EXACT ? findFirstTriangle(model.treeFor(depth), ray, out) : findFirstBox(model.boxTree, depth, ray, out);
        }

        // Finds where the ray first meets a triangle. Returns whether it does.
        private function findFirstTriangle(tree:BoxTree, ray:Ray, out:RayCrossing):Boolean
        {
            var points:Vector.<Number> = tree.vertices;
            var corners:Vector.<int> = tree.cornerOffsets;
            var first:int = -1;
            _shearedRay.setTo(ray, tree.radiusAboutOrigin);
            _search.beginAlong(tree, BoxTree.EXACT, ray);
            for (var leaf:int = _search.nextMet(); leaf >= 0; leaf = _search.nextMet())
            {
                var end:int = tree.endPrimitive[leaf];
                for (var i:int = tree.firstPrimitive[leaf]; i < end; i++)
                {
                    if (_shearedRay.findEarlier(points, corners[int(3 * i)], corners[int(3 * i + 1)], corners[int(3 * i + 2)]))
                    {
                        first = i;
                        _search.limit = _shearedRay.first.distance;
                    }
                }
            }
            if (first >= 0)
            {
                tree.readTriangle(first, _corners);
                _shearedRay.writeFirst(_corners, tree.primitives[first], out);
            }
            return first >= 0;
        }

        // Finds where the ray first enters the box of a leaf. Returns whether it does.
        private function findFirstBox(tree:BoxTree, depth:int, ray:Ray, out:RayCrossing):Boolean
        {
            var isMet:Boolean = false;
            _search.beginAlong(tree, depth, ray);
            for (var leaf:int = _search.nextMet(); leaf >= 0; leaf = _search.nextMet())
            {
                if (findSpan(tree, leaf, ray) && _entry.setToEntry(ray, _span) && (!isMet || _entry.distance < out.distance))
                {
                    isMet = out.setToEntry(ray, _span);
                    _search.limit = out.distance;
                    if (!(out.distance > ray.from))
                    {
                        // no box is entered before the ray's beginning
                        break;
                    }
                }
            }
            return isMet;
        }

        // Adds all crossings with triangles.
        private function addTriangleCrossings(tree:BoxTree, ray:Ray, out:RayCrossings):void
        {
            _shearedRay.setTo(ray, tree.radiusAboutOrigin);
            _search.beginAlong(tree, BoxTree.EXACT, ray);
            for (var leaf:int = _search.nextMet(); leaf >= 0; leaf = _search.nextMet())
            {
                for (var i:int = tree.firstPrimitive[leaf]; i < tree.endPrimitive[leaf]; i++)
                {
                    tree.readTriangle(i, _corners);
                    _shearedRay.addCrossing(_corners, tree.primitives[i], out);
                }
            }
        }

        // Adds where the ray enters and leaves the boxes of leaves.
        private function addBoxCrossings(tree:BoxTree, depth:int, ray:Ray, out:RayCrossings):void
        {
            _search.beginAlong(tree, depth, ray);
            for (var leaf:int = _search.nextMet(); leaf >= 0; leaf = _search.nextMet())
            {
                if (findSpan(tree, leaf, ray))
                {
                    out.addSpan(ray, _span, Tolerances.ROUNDING * tree.radiusAboutOrigin);
                }
            }
        }

        // Finds which part of the ray's line is in the box of a node. Returns whether any is. The box has margins already, so its factor is 1: were it
        // widened, a node that is only touched would be entered before a larger node around it.
        private function findSpan(tree:BoxTree, node:int, ray:Ray):Boolean
        {
            return SpanFinder.findInBox(ray, tree.boxOf(node), 1, _span);
        }
    }
}
