package starlogo.solid
{
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ContactPoint;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.BoxTree;
    import starlogo.hierarchy.TreeCounts;
    import starlogo.libraries.HierarchiesLibrary;
    import support.assertClose;

    use namespace engine;

    /** A touch that only the test at the end of the motion sees has the contact of what touches there. */
    public class ImpactQueryTest
    {
        // The gap between the walls is 1.2 wide. What stands in its middle is 0.4 wide.
        private static const TRAVEL:Number = 0.4;

        private var _counts:TreeCounts = new TreeCounts();
        private var _trees:TreeTreeQuery = new TreeTreeQuery(_counts);
        private var _treeAndStructure:TreeStructureQuery = new TreeStructureQuery(_counts);

        [Test]
        public function trianglesOfTwoTrees():void
        {
            checkEnds(treeOf("block", block(-0.2, 0.2, 0.2, [])), null, true);
        }

        [Test]
        public function trianglesAndAStructure():void
        {
            checkEnds(null, new Sphere(new Vector3D(), 0.2), true);
        }

        [Test]
        public function nodesAndAStructure():void
        {
            checkEnds(null, new Sphere(new Vector3D(), 0.2), false);
        }

        [Test]
        public function noTimeIsAfterTheLatest():void
        {
            checkLatest(treeOf("block", block(-0.2, 0.2, 0.2, [])), null, true);
            checkLatest(treeOf("block", block(-0.2, 0.2, 0.2, [])), null, false);
            checkLatest(null, new Sphere(new Vector3D(), 0.2), true);
            checkLatest(null, new Sphere(new Vector3D(), 0.2), false);
        }

        /** Triangles begin to be swept where their planes are met. That time is not that of the next question. */
        [Test]
        public function eachQuestionBeginsAtItsOwnTime():void
        {
            var walls:ModelTree = treeOf("walls", block(0.6, 1, 0.3, block(-1, -0.6, 0.3, [])));
            var ends:Placement = new Placement();
            ends.x = -0.6;
            var motion:RelativeMotion = new RelativeMotion();
            motion.endAfter(-0.6, 0, 0);
            queryOf(walls, ends, null, new Sphere(new Vector3D(), 0.2), true).findImpactOfSurfaces(motion, null);
            assertClose(2 / 3, motion.time, 1e-9);
            queryOf(walls, ends, null, new Hull(Vector.<Number>(block(-0.3, 0.3, 0.3, []))), false).findImpactOfSurfaces(motion, null);
            assertClose(0.5, motion.time, 1e-9);
        }

        // The right wall moves into what stands between them, and touches it after 2/3 of the motion.
        private function checkLatest(b:ModelTree, structure:BoundingStructure, isExact:Boolean):void
        {
            var walls:ModelTree = treeOf("walls", block(0.6, 1, 0.3, block(-1, -0.6, 0.3, [])));
            var motion:RelativeMotion = new RelativeMotion();
            motion.endAfter(-0.6, 0, 0);
            for each (var latest:Number in [0.1, 0.5, 0.66, 0.67, 0.9, 1])
            {
                for each (var testsEnds:Boolean in [false, true])
                {
                    var ends:Placement = new Placement();
                    ends.x = -0.6;
                    var query:TreeQuery = queryOf(walls, ends, b, structure, isExact);
                    motion.latestTime = latest;
                    if (testsEnds)
                    {
                        query.findFirstTouch(motion, null);
                    }
                    else
                    {
                        query.findImpactOfSurfaces(motion, null);
                    }
                    var what:String = "exact " + isExact + ", latest " + latest;
                    assertTrue(what + ": " + motion.time, latest < 2 / 3 ? motion.time == RelativeMotion.NEVER : Math.abs(motion.time - 2 / 3) < 1e-9);
                }
            }
        }

        // Two walls move to the left, until the right one almost touches what stands between them.
        private function checkEnds(b:ModelTree, structure:BoundingStructure, isExact:Boolean):void
        {
            var walls:ModelTree = treeOf("walls", block(0.6, 1, 0.3, block(-1, -0.6, 0.3, [])));
            var motion:RelativeMotion = new RelativeMotion();
            var contact:ContactPoint = new ContactPoint();
            var found:int = 0;
            for (var step:int = -100; step < 1500; step++)
            {
                var travel:Number = TRAVEL - step * Math.pow(2, -51);
                var ends:Placement = new Placement();
                ends.x = -travel;
                var query:TreeQuery = queryOf(walls, ends, b, structure, isExact);
                motion.endAfter(-travel, 0, 0);
                query.findFirstTouch(motion, contact);
                if (motion.time == RelativeMotion.NEVER)
                {
                    continue;
                }
                found++;
                assertClose(1, motion.time, 1e-9, "time " + step);
                assertClose(1, contact.normalX, 1e-9, "normal " + step);
                assertClose(0, contact.depth, 1e-9, "depth " + step);
                assertClose(0.2, contact.x, 1e-9, "place " + step);
            }
            assertTrue("at the end: " + found, found > 100 && found < 1600);
        }

        // The second model is a tree or a structure, and stands at the origin.
        private function queryOf(a:ModelTree, at:Placement, b:ModelTree, structure:BoundingStructure, isExact:Boolean):TreeQuery
        {
            var depth:int = isExact ? BoxTree.EXACT : BoxTree.LEAVES;
            return b != null ? _trees.setTo(a, at, depth, b, new Placement(), depth)
                : _treeAndStructure.setTo(a, at, depth, structure, new Placement());
        }

        // Adds the corners of a block to a list.
        private static function block(left:Number, right:Number, half:Number, corners:Array):Array
        {
            for each (var x:Number in [left, right])
            {
                corners.push(x, -half, -half, x, half, -half, x, half, half, x, -half, half);
            }
            return corners;
        }

        private static function treeOf(name:String, corners:Array):ModelTree
        {
            var library:HierarchiesLibrary = new HierarchiesLibrary();
            var triangles:Vector.<uint> = new Vector.<uint>();
            for (var first:int = 0; first < corners.length / 3; first += 8)
            {
                for each (var face:Array in [[0, 3, 2, 1], [4, 5, 6, 7], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]])
                {
                    triangles.push(first + face[0], first + face[1], first + face[2], first + face[0], first + face[2], first + face[3]);
                }
            }
            library.add(name, Vector.<Number>(corners), triangles);
            return library.treeOf(name);
        }
    }
}
