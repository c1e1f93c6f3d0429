package starlogo.search
{
    import starlogo.bounding.BoundingStructure;
    import starlogo.broadphase.BinLevel;
    import starlogo.broadphase.Extents;
    import starlogo.convex.ClosestPoints;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.intersection.ray.ConvexRay;
    import starlogo.search.pairs.EdgePairTests;
    import starlogo.search.pairs.GroundPairTests;
    import starlogo.search.pairs.PairTests;
    import starlogo.search.pairs.SpherePairTests;
    import starlogo.search.pairs.StructurePairTests;
    import starlogo.search.pairs.TreePairTests;
    import starlogo.search.table.AgentTable;

    use namespace engine;

    /**
     * Tests two bodies by their forms: whether they touch, when they touch, and how. Each collider and each LevelShapes has one such object,
     * with its settings.
     *
     * <p>The tests of each kind of pairs add themselves (<code>addTo()</code>), so a game loads only what it needs: the choice of shapes adds those of
     * its shapes, the ground and the edges of the world those of pairs with them, and questions those that the collider lacks.</p>
     *
     * @private
     */
    public final class NarrowPhase
    {
        // In place of a form: none.
        private static const NONE:int = -1;

        /** Tests pairs of spheres. Every collider has it. It is null in a LevelShapes while only rays are asked for. */
        public var sphereTests:SpherePairTests = null;

        /** Tests pairs of structures that are not both spheres; null if the choice of shapes has only spheres, and no question needs them. */
        public var structureTests:StructurePairTests = null;

        /** Tests pairs of which at least one is a tree; null if none of the shapes is a tree, or only rays are asked for. */
        public var treeTests:TreePairTests = null;

        /** Tests rays and convex structures of a game's own; it comes with structureTests. */
        public var convexRay:ConvexRay = null;

        /** Tests pairs with the ground; null before the first such pair. */
        public var groundTests:GroundPairTests = null;

        /** Tests pairs with the edges of the world; null before the first such pair. */
        public var edgeTests:EdgePairTests = null;

        /** How far trees are tested. */
        public var treeLimits:TreeLimits = new TreeLimits();

        /** Says which shape each agent has. */
        public var choice:BaseShapeChoice;

        /** @param choice gives the rows their shapes */
        public function NarrowPhase(choice:BaseShapeChoice)
        {
            this.choice = choice;
        }

        /**
         * Keeps the candidates that touch a row, and moves them to the beginning of the list.
         *
         * @param level has the slack of the extents, in an object because V8 would box a Number
         * @param others the candidates. Their circles on the ground overlap the row's circle
         * @param count the number of candidates
         * @return the number of candidates that it keeps
         */
        public function keepTouching(table:AgentTable, level:BinLevel, row:int, others:Vector.<int>, count:int):int
        {
            if (table.areSpheres)
            {
                return sphereTests.keepTouching(table, level, row, others, count);
            }
            var body:Body = table.bodyOf(row);
            var extents:Extents = table.extents;
            var slack:Number = level.slack;
            // two spheres or two boxes need no test of their extents, except for the heights
            var quickForm:int = body.form == BoundingStructure.SPHERE || body.form == BoundingStructure.BOX ? body.form : NONE;
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                var other:int = others[i];
                var isNear:Boolean = table.shapes[other].form == quickForm ? areHeightsNear(extents, slack, row, other) : areNear(extents, slack, row, other);
                if (isNear && areTouching(body, table.bodyOf(other)))
                {
                    others[kept] = other;
                    kept++;
                }
            }
            return kept;
        }

        /**
         * Keeps the rows that touch the ground or the edges of the world, and moves them to the beginning of the list.
         *
         * @param worldRow the row of the ground or of the edges
         * @param others rows of agents
         * @param count the number of these rows
         * @return the number of rows that it keeps
         */
        public function keepTouchingWorld(table:AgentTable, worldRow:int, others:Vector.<int>, count:int):int
        {
            var world:Body = table.bodyOf(worldRow);
            var tests:PairTests = pairTestsForWorldAgent(world);
            var kept:int = 0;
            for (var i:int = 0; i < count; i++)
            {
                if (tests.areTouching(table.bodyOf(others[i]), world))
                {
                    others[kept] = others[i];
                    kept++;
                }
            }
            return kept;
        }

        /** Whether two bodies touch. They may come in either order, the ground and the edges of the world too. */
        public function areTouching(a:Body, b:Body):Boolean
        {
            if (a.isOfWorld)
            {
                return !b.isOfWorld && areTouching(b, a);
            }
            return pairTestsFor(a, b).areTouching(a, b);
        }

        /**
         * Finds the contact of two bodies where they are, which separates them.
         *
         * @param a is not the ground or the edges of the world
         * @param b may be the ground or the edges of the world: see PairTests
         * @param motion becomes none, at the time 1
         * @param out receives the contact. Its normal points from the second body to the first
         */
        public function findContact(a:Body, b:Body, motion:RelativeMotion, out:ContactPoint):void
        {
            motion.endAfter(0, 0, 0);
            motion.time = 1;
            var tests:PairTests = pairTestsFor(a, b);
            tests.findContactOfParts(a, b, motion, out);
            tests.separate(a, b, motion, out);
        }

        /**
         * Finds the distance between two bodies, which is 0 if they touch. They may come in either order. Not both are of the world.
         *
         * @param withPoints whether the closest points are needed if they touch
         * @param out receives the distance and the closest points, in the world
         */
        public function findClosest(a:Body, b:Body, withPoints:Boolean, out:ClosestPoints):void
        {
            if (isReversed(a, b))
            {
                findClosest(b, a, withPoints, out);
                out.swap();
                return;
            }
            var tests:PairTests = pairTestsFor(a, b);
            var areTouchingNow:Boolean = tests.areTouching(a, b);
            if (areTouchingNow && !withPoints)
            {
                out.distance = 0;
                return;
            }
            tests.findClosest(a, b, areTouchingNow, out);
        }

        /** Writes a collider's numbers of tests, and sets them to 0. */
        public function takeCounts(out:SearchCounts):void
        {
            sphereTests.takeCounts(out);
            if (structureTests != null)
            {
                structureTests.takeCounts(out);
            }
            if (treeTests != null)
            {
                treeTests.takeCounts(out);
            }
        }

        /**
         * Whether two bodies are in the reverse of the order in which tests take them. Tests have an order so that rounding errors are the same
         * however the bodies come: a tree before a structure, then by the agents' ranks, and the ground and the edges of the world last.
         */
        public static function isReversed(a:Body, b:Body):Boolean
        {
            if (a.isOfWorld || b.isOfWorld)
            {
                return a.isOfWorld;
            }
            var isTree:Boolean = a.form == ModelShape.TREE;
            if (isTree != (b.form == ModelShape.TREE))
            {
                return !isTree;
            }
            return a.rank > b.rank;
        }

        /**
         * Whether the extents of two rows overlap, or nearly do. The heights are compared first, because the bins have already compared the
         * circles on the ground.
         *
         * @param slack how far apart they may be
         */
        public static function areNear(extents:Extents, slack:Number, a:int, b:int):Boolean
        {
            if (!areHeightsNear(extents, slack, a, b))
            {
                return false;
            }
            var distance:Number = extents.x[a] - extents.x[b];
            var maxDistance:Number = extents.halfX[a] + extents.halfX[b] + slack;
            if (distance > maxDistance || distance < -maxDistance)
            {
                return false;
            }
            distance = extents.y[a] - extents.y[b];
            maxDistance = extents.halfY[a] + extents.halfY[b] + slack;
            return distance <= maxDistance && distance >= -maxDistance;
        }

        private static function areHeightsNear(extents:Extents, slack:Number, a:int, b:int):Boolean
        {
            var distance:Number = extents.z[a] - extents.z[b];
            var maxDistance:Number = extents.halfZ[a] + extents.halfZ[b] + slack;
            return distance <= maxDistance && distance >= -maxDistance;
        }

        /** The tests for two bodies, by their forms. The order of the two: see PairTests. */
        public function pairTestsFor(a:Body, b:Body):PairTests
        {
            var last:int = a.form > b.form ? a.form : b.form;
            if (last >= ModelShape.GROUND)
            {
                return pairTestsForWorldAgent(b);
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
            return GroundPairTests(pairTestsForWorldAgent(ground));
        }

        // The tests with the ground or the edges of the world. Its shape adds them.
        private function pairTestsForWorldAgent(body:Body):PairTests
        {
            var isGround:Boolean = body.form == ModelShape.GROUND;
            if (isGround ? groundTests == null : edgeTests == null)
            {
                body.shape.addTests(this);
            }
            return isGround ? groundTests : edgeTests;
        }
    }
}
