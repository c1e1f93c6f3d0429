package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.NodeVisitor;
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
    public final class TreeRayQuery extends NodeVisitor
    {
        // The factor on a node's half-extents. Nodes are enlarged as it is. A node that is only touched would be entered before a larger node around it.
        private static const NOT_WIDENED:Number = 1;

        // What visit() does with a leaf of the search: it finds the triangle or the box that the ray meets first, or adds all crossings with them.
        private static const FIRST_TRIANGLE:int = 0;
        private static const FIRST_BOX:int = 1;
        private static const ALL_TRIANGLES:int = 2;
        private static const ALL_BOXES:int = 3;

        // One of these.
        private var _wanted:int = FIRST_TRIANGLE;

        private var _search:BoxSearch = new BoxSearch();
        private var _ray:Ray = null;
        private var _start:Vector3D = new Vector3D();

        // Receives all crossings, if they are wanted.
        private var _all:RayCrossings = null;

        // The triangle's index, or the node, that the ray meets first so far, or -1.
        private var _first:int = -1;

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
            _all = out;
            search(model, depth, ray, isExact ? ALL_TRIANGLES : ALL_BOXES);
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
            if (depth != BoxTree.EXACT)
            {
                search(model, depth, ray, FIRST_BOX);
                return _first >= 0 && enters(model.boxTree, _first, out);
            }
            search(model, depth, ray, FIRST_TRIANGLE);
            if (_first >= 0)
            {
                model.boxTree.readTriangle(_first, _corners);
                _shearedRay.writeFirst(_corners, model.boxTree.primitives[_first], out);
            }
            return _first >= 0;
        }

        // Visits what the ray may meet.
        private function search(model:ModelTree, depth:int, ray:Ray, wanted:int):void
        {
            var tree:BoxTree = model.treeFor(depth);
            _ray = ray;
            _wanted = wanted;
            _first = -1;
            limit = ray.to;
            if (depth == BoxTree.EXACT)
            {
                _shearedRay.setTo(ray, tree.radiusAboutOrigin);
            }
            _search.visitAlong(ray, tree, depth, this);
        }

        /** @inheritDoc */
        override public function visit(tree:BoxTree, node:int):void
        {
            switch (_wanted)
            {
                case FIRST_TRIANGLE:
                    findFirstTriangle(tree, node);
                    break;
                case FIRST_BOX:
                    findFirstBox(tree, node);
                    break;
                case ALL_TRIANGLES:
                    addTriangles(tree, node);
                    break;
                default:
                    addBox(tree, node);
                    break;
            }
        }

        // Finds whether the ray meets a triangle of a node earlier than those before.
        private function findFirstTriangle(tree:BoxTree, node:int):void
        {
            var points:Vector.<Number> = tree.vertices;
            var corners:Vector.<int> = tree.cornerOffsets;
            var end:int = tree.endPrimitive[node];
            for (var i:int = tree.firstPrimitive[node]; i < end; i++)
            {
                if (_shearedRay.findEarlier(points, corners[int(3 * i)], corners[int(3 * i + 1)], corners[int(3 * i + 2)]))
                {
                    _first = i;
                    limit = _shearedRay.first.distance;
                }
            }
        }

        // Finds whether the ray enters the box of a node earlier than those before.
        private function findFirstBox(tree:BoxTree, node:int):void
        {
            if (enters(tree, node, _entry) && (_entry.distance < limit || _first < 0))
            {
                _first = node;
                limit = _entry.distance;
                if (!(limit > _ray.from))
                {
                    // no node can be met before the ray's beginning
                    endSearch();
                }
            }
        }

        // Adds all crossings with the triangles of a node.
        private function addTriangles(tree:BoxTree, node:int):void
        {
            for (var i:int = tree.firstPrimitive[node]; i < tree.endPrimitive[node]; i++)
            {
                tree.readTriangle(i, _corners);
                _shearedRay.addCrossing(_corners, tree.primitives[i], _all);
            }
        }

        // Adds where the ray enters and leaves the box of a node.
        private function addBox(tree:BoxTree, node:int):void
        {
            if (SpanFinder.findInBox(_ray, tree.boxOf(node), NOT_WIDENED, _span))
            {
                _all.addSpan(_ray, _span, Tolerances.ROUNDING * tree.radiusAboutOrigin);
            }
        }

        // Finds where the ray enters the box of a node. Returns whether it does.
        private function enters(tree:BoxTree, node:int, out:RayCrossing):Boolean
        {
            return SpanFinder.findInBox(_ray, tree.boxOf(node), NOT_WIDENED, _span) && out.setToEntry(_ray, _span);
        }
    }
}
