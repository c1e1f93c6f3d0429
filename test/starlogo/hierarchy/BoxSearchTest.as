package starlogo.hierarchy
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.convex.RelativeMotion;
    import starlogo.intersection.ray.Ray;
    import starlogo.steps.finish;

    /** A search of one tree, beside a test of all its nodes. */
    public class BoxSearchTest
    {
        private static const POINTS:int = 300;

        private var _random:SeededRandom = new SeededRandom(31);
        private var _tree:BoxTree;
        private var _search:BoxSearch = new BoxSearch();
        private var _motion:RelativeMotion = new RelativeMotion();
        private var _isFound:Object = {};

        // A box: minX, maxX, minY, ...
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);

        [Before]
        public function setUp():void
        {
            var vertices:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < 3 * POINTS; i++)
            {
                vertices.push(_random.between(-5, 5));
            }
            _tree = new BoxTree(vertices, null);
            finish(new BoxTreeBuilder(_tree, 2, 30, false));
        }

        [Test]
        public function aMovingBoxMeetsLeaves():void
        {
            for (var i:int = 0; i < 300; i++)
            {
                setBox();
                _motion.x = i % 3 == 0 ? 0 : _random.between(-6, 6);
                _motion.y = i % 5 == 0 ? 0 : _random.between(-6, 6);
                _motion.z = i % 7 == 0 ? 0 : _random.between(-6, 6);
                _motion.latestTime = i % 4 == 0 ? 0 : 1;
                _search.beginMet(_tree, BoxTree.LEAVES, _motion);
                findAll(_search.nextMet);
                forLeaves(function(leaf:int, at:int):void
                    {
                        var isMet:Boolean = timeOf(at) <= _motion.latestTime;
                        assertEquals("leaf " + leaf + " of search " + i, isMet, leaf in _isFound);
                    });
            }
        }

        [Test]
        public function aLoweredLimitLeavesOutLaterLeaves():void
        {
            for (var i:int = 0; i < 300; i++)
            {
                setBox();
                _motion.x = _random.between(-9, 9);
                _motion.y = _random.between(-9, 9);
                _motion.z = i % 3 == 0 ? 0 : _random.between(-9, 9);
                var first:Number = Infinity;
                forLeaves(function(leaf:int, at:int):void
                    {
                        first = Math.min(first, timeOf(at));
                    });
                var found:Number = Infinity;
                _search.beginMet(_tree, BoxTree.LEAVES, _motion);
                for (var node:int = _search.nextMet(); node >= 0; node = _search.nextMet())
                {
                    found = Math.min(found, timeOf(6 * node));
                    assertTrue("no later leaf", timeOf(6 * node) <= _search.limit + 1e-6);
                    _search.limit = Math.min(_search.limit, found);
                }
                assertTrue("the first leaf", first > 1 ? found > 1 : Math.abs(found - first) < 1e-6);
            }
        }

        [Test]
        public function aRayEndsAtItsEnd():void
        {
            var ray:Ray = new Ray();
            // towards the middle of the last leaf
            var last:int = _tree.boxes.length - 6;
            var origin:Vector3D = new Vector3D(_tree.boxes[last] - 20, _tree.boxes[last + 1], _tree.boxes[last + 2]);
            ray.aim(origin, Vector3D.X_AXIS);
            ray.to = 5;
            assertEquals("before the tree", 0, countAlong(ray));
            ray.to = Infinity;
            assertTrue("through the tree", countAlong(ray) > 0);
            ray.from = 50;
            assertEquals("after the tree", 0, countAlong(ray));
            ray.from = 0;
            ray.to = 0;
            assertEquals("no length", 0, countAlong(ray));
            _search.setCube(origin.x, origin.y, origin.z, 0);
            _search.beginAlongAxis(_tree, 0, 1);
            assertTrue("along the axis", _search.nextMet() >= 0);
            _search.beginAlongAxis(_tree, 0, -1);
            assertEquals("the other way", -1, _search.nextMet());
        }

        [Test]
        public function leavesNearABox():void
        {
            for (var i:int = 0; i < 300; i++)
            {
                setBox();
                var limit:Number = _random.between(0, 4);
                _search.beginNear(_tree, BoxTree.LEAVES);
                _search.limit = limit;
                findAll(_search.nextNear);
                forLeaves(function(leaf:int, at:int):void
                    {
                        assertEquals("leaf " + leaf + " of search " + i, distanceOf(at) <= limit, leaf in _isFound);
                    });
            }
        }

        [Test]
        public function theRoundingOfALargeBoxHidesNoLeaf():void
        {
            var large:Number = 1e9;
            _search.setCube(_tree.boxes[0] + _tree.boxes[3] + large + 0.1, 0, 0, large);
            _search.beginNear(_tree, BoxTree.LEAVES);
            _search.limit = 0.01;
            assertTrue(_search.nextNear() >= 0);
        }

        [Test]
        public function aSearchThatHasEndedFindsNothing():void
        {
            _search.setCube(0, 0, 0, 20);
            _search.beginMet(_tree, BoxTree.LEAVES, _motion);
            findAll(_search.nextMet);
            assertEquals("met", -1, _search.nextMet());
            _search.beginNear(_tree, BoxTree.LEAVES);
            findAll(_search.nextNear);
            assertEquals("near", -1, _search.nextNear());
        }

        [Test]
        public function aSearchThatIsLeftHalfDoneIsForgotten():void
        {
            _search.setCube(0, 0, 0, 20);
            _search.beginMet(_tree, BoxTree.LEAVES, _motion);
            _search.nextMet();
            _search.setCube(90, 0, 0, 1);
            _search.beginMet(_tree, BoxTree.LEAVES, _motion);
            assertEquals(-1, _search.nextMet());
        }

        // Sets the search's box, and the extents of the same.
        private function setBox():void
        {
            for (var axis:int = 0; axis < 6; axis += 2)
            {
                _extents[axis] = _random.between(-8, 8);
                _extents[axis + 1] = _extents[axis] + _random.between(0, 1);
            }
            _search.setExtents(_extents);
        }

        private function findAll(next:Function):void
        {
            _isFound = {};
            for (var leaf:int = next(); leaf >= 0; leaf = next())
            {
                assertFalse("found twice", leaf in _isFound);
                assertTrue("a leaf", _tree.isLeafOrBelow(leaf));
                _isFound[leaf] = true;
            }
        }

        private function countAlong(ray:Ray):int
        {
            var count:int = 0;
            _search.beginAlong(_tree, BoxTree.LEAVES, ray);
            for (var leaf:int = _search.nextMet(); leaf >= 0; leaf = _search.nextMet())
            {
                count++;
            }
            return count;
        }

        // Calls a function for each leaf, with the index of its box.
        private function forLeaves(call:Function):void
        {
            for (var node:int = 0; node < _tree.left.length; node++)
            {
                if (_tree.left[node] == 0)
                {
                    call(node, 6 * node);
                }
            }
        }

        // When the box first meets the box of a node; Infinity if never.
        private function timeOf(at:int):Number
        {
            var enter:Number = 0;
            var leave:Number = Infinity;
            var along:Vector.<Number> = new <Number>[_motion.x, _motion.y, _motion.z];
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:Number = _tree.boxes[at + axis] - _tree.boxes[at + axis + 3] - _extents[2 * axis + 1];
                var high:Number = _tree.boxes[at + axis] + _tree.boxes[at + axis + 3] - _extents[2 * axis];
                if (along[axis] == 0)
                {
                    leave = low > 0 || high < 0 ? -1 : leave;
                    continue;
                }
                enter = Math.max(enter, Math.min(low / along[axis], high / along[axis]));
                leave = Math.min(leave, Math.max(low / along[axis], high / along[axis]));
            }
            return enter <= leave ? enter : Infinity;
        }

        // How far the box is from the box of a node.
        private function distanceOf(at:int):Number
        {
            var squared:Number = 0;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:Number = _tree.boxes[at + axis] - _tree.boxes[at + axis + 3] - _extents[2 * axis + 1];
                var high:Number = _tree.boxes[at + axis] + _tree.boxes[at + axis + 3] - _extents[2 * axis];
                var gap:Number = Math.max(0, low, -high);
                squared += gap * gap;
            }
            return Math.sqrt(squared);
        }
    }
}
