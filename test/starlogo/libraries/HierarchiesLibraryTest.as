package starlogo.libraries
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.engine;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.solid.ModelTree;
    import support.assertThrows;
    import support.assertWellFormed;

    use namespace engine;

    public class HierarchiesLibraryTest
    {
        private var _library:HierarchiesLibrary = new HierarchiesLibrary();

        [Test]
        public function anyNameDoes():void
        {
            var vertices:Vector.<Number> = new <Number>[0, 0, 0];
            for each (var name:String in ["toString", "hasOwnProperty", "constructor", "__proto__", "prototype", " ", "null", ":"])
            {
                assertFalse(name, _library.has(name));
                assertThrows(ArgumentError, /no hierarchy.*add its model/, _library.root, name);
                add(name, vertices);
                assertTrue(name, _library.has(name));
            }
        }

        [Test]
        public function anUnknownNameGetsTheKnownOnes():void
        {
            assertThrows(ArgumentError, /^there is no hierarchy for shape "baer": add its model to the GreatLand or to this library first(, which is empty)?$/, _library.root, "baer");
            add("bear", new <Number>[0, 0, 0]);
            assertThrows(ArgumentError, /^there is no hierarchy for shape "baer": add its model to the GreatLand or to this library first.*"bear"/, _library.root, "baer");
        }

        [Test]
        public function failsWithoutATrace():void
        {
            var good:Vector.<Number> = new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0];
            add("a", good);
            var root:HierarchyNode = _library.root("a");
            assertThrows(ArgumentError, /name/, _library.add, "", good);
            assertThrows(ArgumentError, /name/, _library.add, null, good);
            assertThrows(ArgumentError, /"a".*null/, _library.add, "a", null);
            assertThrows(ArgumentError, /"a".*0 numbers/, _library.add, "a", new Vector.<Number>());
            assertThrows(ArgumentError, /"a".*4 numbers/, _library.add, "a", new <Number>[0, 0, 0, 1]);
            assertThrows(ArgumentError, /"a".*y coordinate of vertex 1.*NaN/, _library.add, "a", new <Number>[0, 0, 0, 1, NaN, 0]);
            assertThrows(ArgumentError, /"a".*z coordinate of vertex 0.*Infinity/, _library.add, "a", new <Number>[0, 0, -Infinity]);
            assertThrows(ArgumentError, /"a".*must be at most/, _library.add, "a", new <Number>[-1.7e308, 0, 0, 1.7e308, 0, 0]);
            assertThrows(ArgumentError, /"a".*4 indices/, _library.add, "a", good, new <uint>[0, 1, 2, 0]);
            assertThrows(ArgumentError, /"a".*triangle 1.*vertex 3.*last one is 2/, _library.add, "a", good, new <uint>[0, 1, 2, 0, 1, 3]);
            assertStrictlyEquals(root, _library.root("a"));
        }

        [Test]
        public function settingsAreRefusedWhenTheyAreSet():void
        {
            for each (var value:int in [0, -3])
            {
                assertThrows(RangeError, new RegExp("maxDepth.*" + value), set , "maxDepth", value);
                assertThrows(RangeError, new RegExp("minVerticesToSplit.*" + value), set , "minVerticesToSplit", value);
            }
            assertEquals("10 5", [_library.maxDepth, _library.minVerticesToSplit].join(" "));
            _library.add("a", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0]);

            function set (name:String, value:int):void
            {
                _library[name] = value;
            }
        }

        [Test]
        public function preparesForExactTestsInSmallSteps():void
        {
            var model:Model = BuiltInModel.sphere();
            _library.add("at first need", model.vertices, model.triangles);
            _library.prepareExact = true;
            var plain:int = stepsOf(_library.newTree(model.vertices, null));
            _library.prepareExact = false;
            assertEquals("points have no surface", plain, stepsOf(_library.newTree(model.vertices, null)));
            plain = stepsOf(_library.newTree(model.vertices, model.triangles));
            assertFalse(_library.treeOf("at first need").isExactPrepared);
            _library.prepareExact = true;
            var tree:ModelTree = _library.newTree(model.vertices, model.triangles);
            assertTrue("many steps more", stepsOf(tree) > plain + 8);
            assertTrue(tree.isExactPrepared);
        }

        private function stepsOf(tree:ModelTree):int
        {
            var count:int = 1;
            while (tree.building.step())
            {
                count++;
            }
            return count;
        }

        private function add(name:String, vertices:Vector.<Number>, triangles:Vector.<uint> = null):void
        {
            _library.add(name, vertices, triangles);
            assertWellFormed(_library, name, vertices, triangles);
        }
    }
}
