// The package solid says how a model meets another model, a structure or a ray, where the model's tree decides, or in exact tests its triangles.
// 
// who is asked       | about what             | who decides by boxes                                 | who decides by triangles
// TreeStructureQuery | a tree and a structure | who is asked                                         | StructureTriangleSearch
// TreeTreeQuery      | two trees              | OverlapTraversal, ImpactTraversal, DistanceTraversal | TrianglePairKernel, called by the three
// TreeRayQuery       | a tree and a ray       | who is asked                                         | who is asked, by a ShearedRay
// 
// A BoxSearch of the package hierarchy finds the leaves of one tree. A Traversal visits pairs of nodes of two trees. An Impact is when two
// first touch, and where: of two triangles, TriangleContactFinder finds the contact, and of boxes StructurePairs. A structure that stands is
// a motion of length 0. What is inside of a surface, all three ask ModelTree, and it asks the package solid.interior.
// 
// ImpactQuery, which TreeQuery extends, puts together when two first touch: standing tests at both ends, impacts of surfaces between. Of several triangles
// that are touched first, a FirstImpact says which one counts. Read ModelTree first, then TreeQuery and TreeTreeQuery, then TrianglePairKernel.

package starlogo.solid
{
    import flash.geom.Vector3D;
    import starlogo.engine;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxRefit;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.BoxTreeBuilder;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.solid.interior.Interior;
    import starlogo.solid.interior.SurfaceTopology;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;

    use namespace engine;

    /**
     * A model's tree, and what is inside of its triangles. Once the work that was begun has made or restored the tree's nodes, only <code>refit()</code>
     * changes them. The inside is prepared when it is first needed, or when the model is loaded. For the engine.
     *
     * @private
     */
    public final class ModelTree
    {
        // For hasClearRay().
        private static const SEARCH:BoxSearch = new BoxSearch();

        /** @private The tree of the model's triangles or vertices. */
        engine var boxTree:BoxTree;

        /** @private The surface that the triangles make; null before it is known. One that was stored may be set, so that it need not be found. */
        engine var surface:SurfaceTopology = null;

        /** @private The work that makes the nodes, which was begun. It may have no steps left. Null if there is none to do. */
        engine var building:Steps = null;

        /**
         * @private The beginning of that work: it makes the nodes from what is stored, if it can; otherwise they are built. Null for none. Set it before
         *     the first step.
         */
        engine var restoring:Steps = null;

        // Null before they are asked for: the root, as clients see it; what is inside of the triangles.
        private var _root:HierarchyNode = null;
        private var _interior:Interior = null;

        /** @param tree the tree of the model's triangles or vertices. <code>beginBuilding()</code> makes its nodes if it has none */
        public function ModelTree(tree:BoxTree)
        {
            boxTree = tree;
        }

        /**
         * @private Begins the work that makes the nodes. <code>finishBuilding()</code> does what is left of it.
         *
         * @param maxLeafVertices a node with at most this many vertices is a leaf
         * @param maxDepth a node on this level is a leaf
         * @param splitByMean whether to split at the mean, down to the leaves
         * @param preparesExact whether to prepare exact tests and rays of triangles now; otherwise the first of these does
         */
        engine function beginBuilding(maxLeafVertices:int, maxDepth:int, splitByMean:Boolean, preparesExact:Boolean):void
        {
            var work:StepSequence = new StepSequence().begin(function():Steps
                {
                    return restoring;
                }).begin(function():Steps
                {
                    return boxTree.isMade ? null : new BoxTreeBuilder(boxTree, maxLeafVertices, maxDepth, splitByMean);
                });
            building = preparesExact && hasTriangles ? work.begin(newInteriorWork) : work;
        }

        /** @private Does what is left of the work that was begun. */
        engine function finishBuilding():void
        {
            if (building != null)
            {
                finish(building);
                building = restoring = null;
            }
        }

        // The work that prepares what is inside of the triangles.
        private function newInteriorWork():Steps
        {
            var interior:Interior = new Interior(treeFor(BoxTree.EXACT), surface);
            return new StepSequence().add(interior).call(function():void
                {
                    _interior = interior;
                    surface = interior.surface;
                });
        }

        /** @private The root, as clients see it. */
        engine function get root():HierarchyNode
        {
            return _root ||= HierarchyNode.of(boxTree, 0);
        }

        /** @private Whether the tree is one of triangles; otherwise it is one of vertices. */
        engine function get hasTriangles():Boolean
        {
            return boxTree.hasTriangles;
        }

        /** @private Whether all that exact tests need is prepared. */
        engine function get isExactPrepared():Boolean
        {
            return _interior != null;
        }

        /** @private The tree for a search to a depth. For BoxTree.EXACT it has triangles, whose corners are listed: the first call lists them. */
        engine function treeFor(depth:int):BoxTree
        {
            if (depth == BoxTree.EXACT)
            {
                boxTree.listCorners();
            }
            return boxTree;
        }

        /** @private What is inside of the triangles; null if there are none. The first call prepares it, as exact tests need it, which is slow. */
        engine function preparedInterior():Interior
        {
            if (_interior == null && hasTriangles)
            {
                finish(newInteriorWork());
            }
            return _interior;
        }

        /**
         * Whether a ball is inside. The ball must not touch the surface. False if there are no triangles, or if no shell of the surface is
         * closed. The inside is only prepared if the ball is in the box around the model and no ray from it is clear.
         */
        internal function isInside(center:Vector3D, radius:Number):Boolean
        {
            var box:Vector.<Number> = boxTree.boxes;
            if (!hasTriangles || Math.abs(center.x - box[0]) > box[3] - radius || Math.abs(center.y - box[1]) > box[4] - radius
                    || Math.abs(center.z - box[2]) > box[5] - radius)
            {
                return false;
            }
            if (_interior == null && hasClearRay(center))
            {
                return false;
            }
            return preparedInterior().hasClosedShell && _interior.isInside(center);
        }

        // Whether a ray from a point along one of the six directions of the axes meets no node without children. Then no surface is around the point. This
        // needs nothing but the tree. It is asked before the inside of a model is known, because a level is mostly open to the sky.
        private function hasClearRay(point:Vector3D):Boolean
        {
            var boxes:Vector.<Number> = boxTree.boxes;
            // Corners may move when seams are welded.
            var slack:Number = 8 * Tolerances.WELDING * (boxTree.boundingRadius + Math.abs(boxes[0]) + Math.abs(boxes[1]) + Math.abs(boxes[2]));
            SEARCH.setCube(point.x, point.y, point.z, slack);
            for (var i:int = 5; i >= 0; i--)
            {
                SEARCH.beginAlongAxis(boxTree, i >> 1, (i & 1) == 0 ? -1 : 1);
                if (SEARCH.nextMet() < 0)
                {
                    return true;
                }
            }
            return false;
        }

        /**
         * @private Follows the vertices of the tree to their new places. The tree keeps its division, and each triangle its corners. The inside has to
         *     be prepared again, because it depends on which surfaces are closed and around which others. No building may be half done:
         *     CollisionDataBuilder refuses poses meanwhile.
         */
        engine function refit():void
        {
            surface = null;
            _interior = null;
            if (boxTree.isMade)
            {
                finish(new BoxRefit(boxTree));
            }
        }
    }
}
