package starlogo.libraries
{
    import flash.errors.IllegalOperationError;
    import flash.geom.Vector3D;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Hull;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.fitting.AxisAlignedBoxFitter;
    import starlogo.fitting.CylinderFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.HullFitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.fitting.ZAlignedBoxFitter;
    import starlogo.geometry.Tolerances;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.FailingFitter;
    import support.PointSets;
    import support.assertThrows;
    import support.assign;

    use namespace engine;

    public class BoundingStructuresLibraryTest
    {
        private var _library:BoundingStructuresLibrary = new BoundingStructuresLibrary();
        private var _cube:Vector.<Number> = PointSets.box(0.5, 0.5, 0.5);
        private var _stick:Vector.<Number>;

        [Before]
        public function setUp():void
        {
            // a capsule of radius 0.2 and length 2
            _stick = PointSets.placed(PointSets.sphere(0.2, 16, 9), 1, 0, 0, -1).concat(
                    PointSets.placed(PointSets.sphere(0.2, 16, 9), 1, 0, 0, 1));
        }

        [Test]
        public function atEqualVolumeTheCheapestWins():void
        {
            _library.add("point", new <Number>[1, 2, 3]);
            assertTrue(_library.tightestFit("point") is Sphere);
        }

        [Test]
        public function keepsAllWhenAsked():void
        {
            _library.keepAll = true;
            _library.add("cube", _cube);
            assertTrue(_library.hasAll("cube"));
            assertNear(1, _library.box("cube").volume);
            assertTrue(Math.abs(_library.sphere("cube").volume - 2.721) < 0.001);
            assertTrue(Math.abs(_library.capsule("cube").volume - 3.052) < 0.001);
            _library.keepAll = false;
            _library.add("cube", _cube);
            assertFalse(_library.hasAll("cube"));
            assertThrows(ArgumentError, "loadAllBoundingStructures", _library.box, "cube");
        }

        [Test]
        public function keepsHullsWhenAsked():void
        {
            assertFalse(_library.keepHulls);
            _library.add("stick", _stick);
            assertThrows(ArgumentError, "loadHulls", _library.hull, "stick");
            assertThrows(ArgumentError, /^there is no bounding structure for shape "unknown": add its model to the GreatLand or to this library first(; it has "stick")?$/, _library.hull, "unknown");
            var tightest:BoundingStructure = _library.tightestFit("stick");
            _library.keepHulls = true;
            _library.add("stick", _stick);
            var hull:Hull = Hull(_library.hull("stick"));
            assertTrue(_library.hasHull("stick"));
            assertFalse(_library.hasHull("unknown"));
            assertEquals(16, hull.corners.length / 3);
            assertEquals("it takes no part in the tightest fit", tightest.kind, _library.tightestFit("stick").kind);
            _library.hullFitter = new HullFitter(32);
            _library.add("stick", _stick);
            assertEquals(32, Hull(_library.hull("stick")).corners.length / 3);
            assertThrows(ArgumentError, "hullFitter", assign, _library, "hullFitter", null);
            assertEquals(32, _library.hullFitter.maxCorners);
        }

        [Test]
        public function aSphereThatIsNotLargerTakesTheHullsPlace():void
        {
            _library.keepHulls = true;
            _library.add("ball", PointSets.sphere(0.5, 24, 12));
            assertTrue(_library.hull("ball") is Sphere);
            _library.add("point", new <Number>[1, 2, 3]);
            assertTrue(_library.hull("point") is Sphere);
            _library.add("cube", _cube);
            assertNear(1, Hull(_library.hull("cube")).volume);
        }

        [Test]
        public function aHullThatWasNotKeptIsFoundWhenItIsNeeded():void
        {
            _library.add("stick", _stick);
            var found:BoundingStructure = _library.findOrFit("stick", BoundingStructure.HULL);
            assertTrue(found is Hull);
            assertEquals(found, _library.findOrFit("stick", BoundingStructure.HULL));
            _library.keepHulls = true;
            _library.add("stick", _stick);
            assertEquals(Hull(found).toNumbers().join(), Hull(_library.hull("stick")).toNumbers().join());
        }

        /** As docs/poses.md advises for figures: vertices that enclose all poses. */
        [Test]
        public function aHullThatIsFoundLaterIsAroundTheVerticesThatWereAdded():void
        {
            var game:GreatLand = new GreatLand();
            game.addModel(BuiltInModel.cube());
            var wide:Vector.<Number> = PointSets.box(2, 0.5, 0.5);
            game.boundingStructures.add("cube", wide);
            wide[0] = 100;
            assertNear(4, game.boundingStructures.findOrFit("cube", BoundingStructure.HULL).volume);
        }

        [Test]
        public function theVerticesAreKeptOnlyWhileThereIsNoHull():void
        {
            _library.add("later", _cube);
            assertEquals(_cube.length, _library.models.entryOf("later").structures.vertices.length);
            _library.findOrFit("later", BoundingStructure.HULL);
            assertEquals(null, _library.models.entryOf("later").structures.vertices);
            _library.keepHulls = true;
            _library.add("now", _cube);
            assertEquals(null, _library.models.entryOf("now").structures.vertices);
        }

        [Test]
        public function aHullThatIsFoundLaterIsThatOfTheSettingsBefore():void
        {
            var early:BoundingStructuresLibrary = new BoundingStructuresLibrary();
            early.keepHulls = true;
            for each (var library:BoundingStructuresLibrary in [early, _library])
            {
                library.add("stick", _stick);
                library.hullFitter = new HullFitter(40);
            }
            assertEquals(Hull(early.hull("stick")).toNumbers().join(), Hull(_library.findOrFit("stick", BoundingStructure.HULL)).toNumbers().join());
        }

        [Test]
        public function errorsOfAHullThatIsFoundLaterNameTheShape():void
        {
            var game:GreatLand = new GreatLand();
            var model:Model = BuiltInModel.cube();
            game.addModel(model);
            model.pose(PointSets.placed(model.vertices, 1e-80));
            assertThrows(RangeError, /^shape "cube": /, function():void
                {
                    game.boundingStructures.findOrFit("cube", BoundingStructure.HULL);
                });
        }

        [Test]
        public function aKindThatNobodyFindsIsNotKept():void
        {
            _library.keepAll = true;
            _library.fitters = new <Fitter>[new NaiveSphereFitter()];
            _library.add("cube", _cube);
            assertTrue(_library.sphere("cube") is Sphere);
            assertFalse(_library.hasAll("cube"));
            assertThrows(ArgumentError, "no capsule", _library.capsule, "cube");
        }

        [Test]
        public function fittersMayChangeAtAnyTime():void
        {
            _library.fitters.splice(1, 2, new ZAlignedBoxFitter(10));
            _library.add("cube", _cube);
            assertEquals(1, Box(_library.tightestFit("cube")).axisZ.z);
            _library.fitters.length = 1;
            _library.add("cube", _cube);
            assertTrue(_library.tightestFit("cube") is Sphere);
        }

        [Test]
        public function aFailedAddChangesNothing():void
        {
            _library.keepAll = true;
            _library.add("cube", _cube);
            var before:BoundingStructure = _library.tightestFit("cube");
            assertThrows(ArgumentError, "cube", _library.add, "cube", new <Number>[1, 2, NaN]);
            assertThrows(ArgumentError, "cube", _library.add, "cube", new <Number>[1, 2]);
            assertThrows(ArgumentError, "cube", _library.add, "cube", null);
            assertThrows(ArgumentError, "other", _library.add, "other", new Vector.<Number>());
            _library.fitters = new <Fitter>[new NaiveSphereFitter(), new CylinderFitter(new AxisAlignedBoxFitter())];
            assertThrows(ArgumentError, "Cylinder", _library.add, "cube", _cube);
            _library.fitters.length = 0;
            assertThrows(ArgumentError, "fitters", _library.add, "cube", _cube);
            for each (var wrong:Vector.<Fitter> in [null, new Vector.<Fitter>(), new <Fitter>[null]])
            {
                assertThrows(ArgumentError, "must be", assign, _library, "fitters", wrong);
            }
            _library.fitters = new <Fitter>[new FailingFitter(new ArgumentError("failed"))];
            assertThrows(ArgumentError, "failed", _library.add, "cube", _cube);
            assertEquals(before, _library.tightestFit("cube"));
            assertTrue(_library.hasAll("cube"));
            assertFalse(_library.has("other"));
        }

        [Test]
        public function otherErrorsOfAFitterComeAsTheyAre():void
        {
            _library.fitters = new <Fitter>[new FailingFitter(new RangeError("mine"))];
            assertThrows(RangeError, /^shape "cube": mine$/, _library.add, "cube", _cube);
            _library.fitters = new <Fitter>[new FailingFitter(new IllegalOperationError("mine"))];
            assertThrows(IllegalOperationError, /^mine$/, _library.add, "cube", _cube);
        }

        [Test]
        public function aStructureThatDoesNotEncloseTheModelIsRefused():void
        {
            _library.fitters = new <Fitter>[new NaiveSphereFitter(), new FixedFitter(new Sphere(new Vector3D(0, 0, 0.5), 0.8))];
            assertThrows(ArgumentError, "shape \"cube\"", _library.add, "cube", _cube);
            assertThrows(ArgumentError, "Fixed", _library.add, "cube", _cube);
            assertThrows(ArgumentError, "vertex 0 at (", _library.add, "cube", _cube);
            assertFalse(_library.has("cube"));
            var greatLand:GreatLand = new GreatLand();
            greatLand.boundingStructures.fitters = _library.fitters;
            assertThrows(ArgumentError, "does not enclose", greatLand.addModel, BuiltInModel.cube());
            assertFalse(greatLand.hasModel("cube"));
            // each kind, too short in one direction alone
            var x:Vector3D = new Vector3D(1, 0, 0);
            var y:Vector3D = new Vector3D(0, 1, 0);
            var z:Vector3D = new Vector3D(0, 0, 1);
            for each (var half:Number in [0.5, 0.4999])
            {
                for (var axis:int = 0; axis < 3; axis++)
                {
                    var box:Box = new Box(new Vector3D(), x, y, z, axis == 0 ? half : 0.5, axis == 1 ? half : 0.5, axis == 2 ? half : 0.5);
                    _library.fitters = new <Fitter>[new FixedFitter(box)];
                    assertAccepted(half == 0.5);
                }
                var capsule:Capsule = new Capsule(new Vector3D(0, 0, half == 0.5 ? -0.5 : -0.49), new Vector3D(0, 0, 0.5), Math.SQRT1_2);
                _library.fitters = new <Fitter>[new FixedFitter(capsule)];
                assertAccepted(half == 0.5);
            }
        }

        [Test]
        public function howFarOutsideAVertexMayBeFollowsTheModelsSize():void
        {
            for each (var size:Number in [1e-3, 1, 1e3])
            {
                var vertices:Vector.<Number> = PointSets.box(0.5 * size, 0.5 * size, 0.5 * size);
                for each (var share:Number in [0.5, 4])
                {
                    var half:Number = size * (0.5 - share * Tolerances.CONTAINMENT);
                    _library.fitters = new <Fitter>[new FixedFitter(new Box(new Vector3D(), new Vector3D(1, 0, 0), new Vector3D(0, 1, 0), new Vector3D(0, 0, 1),
                                    half, half, half))];
                    if (share < 1)
                    {
                        _library.add("cube", vertices);
                    }
                    else
                    {
                        assertThrows(ArgumentError, "does not enclose", _library.add, "cube", vertices);
                    }
                }
            }
        }

        private function assertAccepted(isEnclosing:Boolean):void
        {
            if (isEnclosing)
            {
                _library.add("cube", _cube);
            }
            else
            {
                assertThrows(ArgumentError, "vertex", _library.add, "cube", _cube);
            }
        }

        [Test]
        public function optionsAreChecked():void
        {
            assertThrows(ArgumentError, "increment", assign, _library, "orientedBoxDegIncrement", 0);
            assertThrows(ArgumentError, "name", _library.add, null, _cube);
            assertThrows(ArgumentError, "name", _library.add, "", _cube);
            assertEquals(10, _library.orientedBoxDegIncrement);
        }

        // what is stored is wider than the fit by what surfaces that touch may be apart
        private static function assertNear(expected:Number, actual:Number):void
        {
            assertTrue(String(actual), actual >= expected && actual <= expected * (1 + 3e-13));
        }
    }
}

import starlogo.bounding.BoundingStructure;
import starlogo.fitting.FitSession;
import starlogo.fitting.Fitter;

class FixedFitter extends Fitter
{
    private var _structure:BoundingStructure;

    public function FixedFitter(structure:BoundingStructure)
    {
        _structure = structure;
    }

    override protected function findStructure(session:FitSession):BoundingStructure
    {
        return _structure;
    }
}
