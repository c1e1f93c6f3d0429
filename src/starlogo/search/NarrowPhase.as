package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.ClosestPoints;
    import starlogo.engine;
    import starlogo.intersection.ray.ConvexSpanFinder;
    import starlogo.search.pairs.EdgePairTests;
    import starlogo.search.pairs.GroundPairTests;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.pairs.SpherePairTests;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.search.pairs.TreePairTests;

    use namespace engine;

    /**
     * Tests two bodies by their kinds: whether they touch, when they touch, and how. Each collider and each LevelShapes has one such object. It
     * also has the settings of that collider: the choice of shapes, and how far trees are tested.
     *
     * <p>The tests of each kind of pairs add themselves (<code>addTo()</code>), so a game loads only what it needs: the choice of shapes adds those of
     * its shapes, the ground and the edges of the world those of pairs with them, and questions those that the collider lacks.</p>
     *
     * @private
     */
    public final class NarrowPhase
    {
        /** Tests pairs of spheres. Every collider has it. It is null in a LevelShapes while only rays are asked for. */
        public var sphereTests:SpherePairTests = null;

        /** Tests pairs of structures that are not both spheres; null if the choice of shapes has only spheres, and no question needs them. */
        public var structureTests:StructurePairTests = null;

        /** Tests pairs of which at least one is a tree; null if none of the shapes is a tree, or only rays are asked for. */
        public var treeTests:TreePairTests = null;

        /** Answers for rays and further convex structures: see SpanFinder. It comes with structureTests. */
        public var convexSpans:ConvexSpanFinder = null;

        /** Tests pairs with the ground; null before the first such pair. */
        public var groundTests:GroundPairTests = null;

        /** Tests pairs with the edges of the world; null before the first such pair. */
        public var edgeTests:EdgePairTests = null;

        /** How far trees are tested. */
        public var treeLimits:TreeLimits = new TreeLimits();

        /** Counts the tests. */
        public var counts:SearchCounts = new SearchCounts();

        /** Says which shape each agent has. */
        public var shapeChoice:BaseShapeChoice;

        /** @param shapeChoice gives the agents their shapes */
        public function NarrowPhase(shapeChoice:BaseShapeChoice)
        {
            this.shapeChoice = shapeChoice;
        }

        /** Whether two bodies touch. They may come in either order, the ground and the edges of the world too. */
        public function areTouching(a:Body, b:Body):Boolean
        {
            if (a.isEnvironment)
            {
                return !b.isEnvironment && areTouching(b, a);
            }
            return pairTestsFor(a, b).areTouching(a, b);
        }

        /**
         * Finds the distance between two bodies, which is 0 if they touch. They may come in either order. Not both are of the environment.
         *
         * @param withPoints whether the closest points are needed if they touch
         * @param out receives the distance and the closest points, in the world
         */
        public function findClosest(a:Body, b:Body, withPoints:Boolean, out:ClosestPoints):void
        {
            var isTouching:Boolean = areTouching(a, b);
            if (isTouching && !withPoints)
            {
                out.distance = 0;
                return;
            }
            pairTestsFor(a, b).findClosest(a, b, isTouching, out);
        }

        /**
         * The tests for two bodies, by their kinds.
         *
         * @param a any body
         * @param b any body; not both are of the environment
         * @return the tests. They are null if nothing has added them: see sphereTests, structureTests and treeTests
         */
        public function pairTestsFor(a:Body, b:Body):PairTests
        {
            var last:int = a.kind > b.kind ? a.kind : b.kind;
            if (last >= ModelShape.GROUND)
            {
                return environmentTestsOf(a.kind > b.kind ? a : b);
            }
            if (last == ModelShape.TREE)
            {
                return treeTests;
            }
            return last == BoundingStructure.SPHERE ? sphereTests : structureTests;
        }

        /** The tests with the ground. */
        public function groundTestsOf(ground:Body):GroundPairTests
        {
            return GroundPairTests(environmentTestsOf(ground));
        }

        // The tests with the ground or the edges of the world. If this is the first such pair, the shape of the ground or the edges adds them.
        private function environmentTestsOf(body:Body):PairTests
        {
            var isGround:Boolean = body.kind == ModelShape.GROUND;
            if (isGround ? groundTests == null : edgeTests == null)
            {
                body.shape.addEnvironmentTests(this);
            }
            return isGround ? groundTests : edgeTests;
        }
    }
}
