package starlogo.solid
{
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.intersection.ClosestTriangles;
    import starlogo.intersection.triangleTriangle;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * Finds the parts of a surface, in steps. Pieces that touch are one part.
     *
     * <p>A figure often consists of pieces that overlap. They are inside of another model together or not at all. So fewer parts mean fewer
     * points to test for each pair of agents. The tree is compared with itself.</p>
     */
    internal final class PartFinder extends StepSequence
    {
        private static const PAIRS_PER_STEP:int = 800;
        private static const RUNS_PER_STEP:int = 5000;

        // The most pairs of triangles to compare. After that, remaining pieces stay separate parts, and the answers are the same.
        private static const MOST_PAIRS:int = 100000;

        private var _solid:Solid;
        private var _surface:Surface;
        private var _order:Vector.<int>;
        private var _touching:Number;
        private var _closest:ClosestTriangles = new ClosestTriangles();
        private var _pairs:int = 0;

        // The pieces that are one part, the number of parts left, and the pairs of nodes still to compare.
        private var _sets:DisjointSets;
        private var _partCount:int;
        private var _stack:Vector.<HierarchyNode>;

        // For each triangle in the order, the index of the next one of another piece.
        private var _runEnds:Vector.<int>;
        private var _runEnd:int;

        /**
         * @param root the node around all triangles
         * @param solid has their corners and extents
         * @param surface has their pieces; after the last step, it has the parts instead
         * @param order the triangles' indices in the hierarchy's order
         */
        public function PartFinder(root:HierarchyNode, solid:Solid, surface:Surface, order:Vector.<int>)
        {
            _solid = solid;
            _surface = surface;
            _order = order;
            _touching = 2 * Tolerances.SURFACES * root.radius;
            _closest.reach = _touching;
            _stack = new <HierarchyNode>[root, root];
            _partCount = surface.partCount;
            _sets = new DisjointSets(_partCount);
            _runEnd = order.length;
            _runEnds = new Vector.<int>(order.length, true);
            slices(order.length, RUNS_PER_STEP, findRuns).repeat(compareSome).call(numberParts);
        }

        /** Whether all pairs were compared, so that parts with different numbers do not touch. */
        public function get isComplete():Boolean
        {
            return _pairs < MOST_PAIRS;
        }

        /** The part of a triangle, given by its index in the hierarchy's order. A part has the number of one of its pieces. */
        public function partOf(triangle:int):int
        {
            return _sets.rootOf(_surface.parts[_order[triangle]]);
        }

        private function compareSome():Boolean
        {
            var end:int = Math.min(_pairs + PAIRS_PER_STEP, MOST_PAIRS);
            while (_pairs < end && _stack.length > 0 && _partCount > 1)
            {
                var b:HierarchyNode = _stack.pop();
                var a:HierarchyNode = _stack.pop();
                _pairs++;
                if (areOnePart(a, b))
                {
                    continue;
                }
                if (a === b && a.low != null)
                {
                    _stack.push(a.low, a.low, a.high, a.high, a.low, a.high);
                }
                else if (a === b || doOverlap(a, b))
                {
                    compare(a, b);
                }
            }
            return _pairs < MOST_PAIRS && _stack.length > 0 && _partCount > 1;
        }

        // Whether the pieces of two nodes are one part already. Then they need not be compared.
        private function areOnePart(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            var part:int = partOf(a.first);
            return isOfPart(a, part) && (a === b || isOfPart(b, part));
        }

        private function isOfPart(node:HierarchyNode, part:int):Boolean
        {
            for (var i:int = node.first; i < node.end; i = _runEnds[i])
            {
                if (partOf(i) != part)
                {
                    return false;
                }
            }
            return true;
        }

        private function compare(a:HierarchyNode, b:HierarchyNode):void
        {
            if (a.low != null && (b.low == null || a.radius >= b.radius))
            {
                _stack.push(a.low, b, a.high, b);
            }
            else if (b.low != null)
            {
                _stack.push(a, b.low, a, b.high);
            }
            else
            {
                joinLeaves(a, b);
            }
        }

        private static function doOverlap(a:HierarchyNode, b:HierarchyNode):Boolean
        {
            return Math.abs(a.x - b.x) <= a.halfX + b.halfX && Math.abs(a.y - b.y) <= a.halfY + b.halfY
                && Math.abs(a.z - b.z) <= a.halfZ + b.halfZ;
        }

        private function joinLeaves(a:HierarchyNode, b:HierarchyNode):void
        {
            for (var i:int = a.first; i < a.end && _pairs < MOST_PAIRS; i++)
            {
                var part:int = partOf(i);
                for (var k:int = a === b ? i + 1 : b.first; k < b.end; k++)
                {
                    _pairs++;
                    var other:int = partOf(k);
                    if (part != other && doTouch(i, k))
                    {
                        joinParts(i, k);
                    }
                }
            }
        }

        private function joinParts(i:int, k:int):void
        {
            _sets.join(_surface.parts[_order[i]], _surface.parts[_order[k]]);
            _partCount--;
        }

        private function doTouch(i:int, k:int):Boolean
        {
            var extents:Vector.<Number> = _solid.extents;
            for (var axis:int = 0; axis < 3; axis++)
            {
                if (extents[6 * i + axis] > extents[6 * k + 3 + axis] + _touching
                        || extents[6 * k + axis] > extents[6 * i + 3 + axis] + _touching)
                {
                    return false;
                }
            }
            return triangleTriangle(_solid.corners, 9 * i, _solid.corners, 9 * k, _closest);
        }

        private function numberParts():void
        {
            var parts:Vector.<int> = _surface.parts;
            for (var i:int = 0; i < parts.length; i++)
            {
                parts[i] = _sets.rootOf(parts[i]);
            }
        }

        // Goes from the last triangle to the first.
        private function findRuns(first:int, end:int):void
        {
            var last:int = _order.length - 1;
            for (var i:int = last - first; i > last - end; i--)
            {
                _runEnds[i] = _runEnd;
                if (i > 0 && _surface.parts[_order[i]] != _surface.parts[_order[i - 1]])
                {
                    _runEnd = i;
                }
            }
        }
    }
}
