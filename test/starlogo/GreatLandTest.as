package starlogo
{
    import flash.errors.IllegalOperationError;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertStrictlyEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.Fitter;
    import starlogo.libraries.ModelTable;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ModelTransform;
    import support.assertThrows;
    import support.assign;

    use namespace engine;

    public class GreatLandTest
    {
        private var _greatLand:GreatLand = new GreatLand();

        [Test]
        public function flagsAreTheThesiss():void
        {
            assertTrue(_greatLand.loadTightestFit);
            assertFalse(_greatLand.loadAllBoundingStructures);
            assertFalse(_greatLand.loadHulls);
            assertTrue(_greatLand.loadHierarchies);
            assertEquals(5, _greatLand.hierarchies.minVerticesToSplit);
            assertEquals(10, _greatLand.hierarchies.maxDepth);
            assertEquals(10, _greatLand.orientedBoxDegIncrement);
        }

        [Test]
        public function keepsNothingOfUnknownNames():void
        {
            var table:ModelTable = _greatLand.models;
            assertFalse(_greatLand.hasModel("a") || _greatLand.isLoading("a") || _greatLand.boundingStructures.has("a") || _greatLand.hierarchies.has("a"));
            assertNull(_greatLand.modelOf("a"));
            assertFalse(_greatLand.removeModel("a"));
            assertStrictlyEquals(table.entryOf("a"), table.entryOf("b"));
            table.entryToWrite("a").expect();
            assertTrue(_greatLand.isLoading("a"));
            assertFalse(_greatLand.isLoading("b"));
        }

        [Test]
        public function addsWhatTheFlagsAskFor():void
        {
            var cube:Model = BuiltInModel.cube();
            _greatLand.addModel(cube);
            assertTrue(_greatLand.hasModel("cube"));
            assertStrictlyEquals(cube, _greatLand.modelOf("cube"));
            assertEquals(BoundingStructure.BOX, _greatLand.boundingStructures.tightestFit("cube").kind);
            assertThrows(ArgumentError, /loadAllBoundingStructures/, _greatLand.boundingStructures.sphere, "cube");

            _greatLand.loadAllBoundingStructures = true;
            _greatLand.addModel(BuiltInModel.sphere());
            assertTrue(_greatLand.boundingStructures.hasAll("sphere"));

            _greatLand.loadTightestFit = false;
            _greatLand.addModel(BuiltInModel.cylinder());
            assertTrue(_greatLand.hasModel("cylinder"));
            assertFalse(_greatLand.boundingStructures.has("cylinder"));
        }

        [Test]
        public function computesTheHierarchyOfALevelAlone():void
        {
            var cube:Model = BuiltInModel.cube();
            _greatLand.addModel(cube);
            _greatLand.loadHierarchies = false;
            _greatLand.addLevel(cube);
            assertStrictlyEquals(cube, _greatLand.modelOf("cube"));
            assertFalse(_greatLand.boundingStructures.has("cube"));
            assertEquals(12, _greatLand.hierarchies.root("cube").triangleCount);
            assertTrue(_greatLand.loadTightestFit);
            // in JavaScript null is no model
            assertThrows(ArgumentError, /model must (not be null|be a Model, not null)/, _greatLand.addLevel, null);
        }

        [Test]
        public function buildsHierarchiesIfAsked():void
        {
            _greatLand.addModel(BuiltInModel.cube());
            assertEquals(12, _greatLand.hierarchies.root("cube").triangleCount);
            _greatLand.loadHierarchies = false;
            _greatLand.addModel(BuiltInModel.sphere());
            assertFalse(_greatLand.hierarchies.has("sphere"));
            // the one of another model of the name would be wrong
            _greatLand.addModel(BuiltInModel.cube());
            assertFalse(_greatLand.hierarchies.has("cube"));
        }

        [Test]
        public function theDegreeIncrementReachesTheFitter():void
        {
            // a cube on its edge: 45 degrees about x
            var turned:Vector.<Number> = new <Number>[0, 0, 0, 0, 1, 1, 0, -1, 1, 0, 0, 2, 1.4, 0, 0, 1.4, 1, 1, 1.4, -1, 1, 1.4, 0, 2];
            _greatLand.orientedBoxDegIncrement = 20;
            _greatLand.addModel(new Model("coarse", turned));
            _greatLand.orientedBoxDegIncrement = 45;
            _greatLand.addModel(new Model("right", turned));
            assertTrue(_greatLand.boundingStructures.tightestFit("right").volume < 0.9 * _greatLand.boundingStructures.tightestFit("coarse").volume);
            assertThrows(ArgumentError, /0/, assign, _greatLand, "orientedBoxDegIncrement", 0);
        }

        [Test]
        public function cooksOnlyForAxesThatALoadTakes():void
        {
            for each (var wrong:* in ["Z", "", "rotate 0 0 0", "as given", 3, {}, null])
            {
                assertThrows(ModelError, /^model "cube": the up axis must be "x", "y" or "z", or a ModelTransform, not/, _greatLand.cook, BuiltInModel.cube(), wrong);
            }
            assertThrows(ModelError, /ModelTransform, not "Z"$/, _greatLand.cook, BuiltInModel.cube(), "Z");
            for each (var right:* in ["x", "y", "z", new ModelTransform()])
            {
                assertTrue(_greatLand.cook(BuiltInModel.cube(), right).length > 0);
            }
        }

        [Test]
        public function aFailedLoadLeavesNothing():void
        {
            assertThrows(ArgumentError, /null/, _greatLand.addModel, null);
            _greatLand.boundingStructures.fitters = new <Fitter>[new Fitter("unfinished")];
            assertThrows(IllegalOperationError, /implements neither/, _greatLand.addModel, BuiltInModel.cube());
            assertFalse(_greatLand.hasModel("cube"));
            assertFalse(_greatLand.boundingStructures.has("cube"));
        }

        [Test]
        public function anyNameWillDo():void
        {
            for each (var name:String in ["toString", "hasOwnProperty", "constructor", "__proto__", ":"])
            {
                assertFalse(name, _greatLand.hasModel(name));
                _greatLand.addModel(new Model(name, BuiltInModel.cube().vertices));
                assertTrue(name, _greatLand.hasModel(name));
            }
        }

        [Test]
        public function exactModeMayBePreparedAtOnce():void
        {
            assertFalse(_greatLand.prepareExact);
            _greatLand.addModel(BuiltInModel.sphere());
            assertFalse("not before it is needed", isPrepared("sphere"));
            _greatLand.prepareExact = true;
            _greatLand.addModel(BuiltInModel.cube());
            assertTrue(isPrepared("cube"));
        }

        [Test]
        public function aModelMayBeRemoved():void
        {
            assertFalse(_greatLand.removeModel("cube"));
            _greatLand.addModel(BuiltInModel.cube());
            _greatLand.addModel(BuiltInModel.sphere());
            assertTrue(_greatLand.removeModel("cube"));
            assertFalse(_greatLand.hasModel("cube") || _greatLand.boundingStructures.has("cube") || _greatLand.hierarchies.has("cube"));
            assertTrue(_greatLand.hasModel("sphere"));
            assertFalse(_greatLand.removeModel("cube"));
        }

        [Test]
        public function whatIsReplacedOrRemovedIsCounted():void
        {
            _greatLand.addModel(BuiltInModel.cube());
            var before:int = _greatLand.revision;
            _greatLand.addModel(BuiltInModel.cube());
            assertTrue(_greatLand.revision != before);
            before = _greatLand.revision;
            _greatLand.boundingStructures.add("cube", BuiltInModel.sphere().vertices);
            assertTrue(_greatLand.revision != before);
            before = _greatLand.revision;
            _greatLand.hierarchies.add("cube", BuiltInModel.sphere().vertices);
            assertTrue(_greatLand.revision != before);
            before = _greatLand.revision;
            _greatLand.removeModel("cube");
            assertTrue(_greatLand.revision != before);
        }

        private function isPrepared(name:String):Boolean
        {
            return _greatLand.hierarchies.treeOf(name).isExactPrepared;
        }
    }
}
