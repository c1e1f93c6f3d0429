package starlogo
{
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.fitting.AxisAlignedBoxFitter;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.CylinderFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.MinimalSphereFitter;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.queries.LevelShapes;
    import starlogo.steps.Steps;
    import support.CountingFitter;
    import support.FailingFitter;
    import support.LibraryContents;
    import support.PointSets;
    import support.assertThrows;

    public class GreatLandReceiveTest
    {
        [Test]
        public function theSettingsAreThoseOfTheBeginning():void
        {
            var greatLand:GreatLand = withFlags(7);
            var intake:Steps = greatLand.receive(turnedBox());
            greatLand.loadTightestFit = false;
            greatLand.loadHierarchies = false;
            greatLand.loadAllBoundingStructures = false;
            greatLand.orientedBoxDegIncrement = 45;
            greatLand.boundingStructures.fitters.length = 1;
            greatLand.hierarchies.maxDepth = 1;
            greatLand.hierarchies.splitByMean = true;
            finish(intake);
            var expected:GreatLand = withFlags(7);
            expected.addModel(turnedBox());
            assertEquals(LibraryContents.of(expected, "turned"), LibraryContents.of(greatLand, "turned"));
        }

        [Test]
        public function whatIsTooLargeIsNamedWhateverIsComputed():void
        {
            var huge:Model = new Model("huge", new <Number>[0, 0, 0, 1e61, 0, 0], null, Model.AS_GIVEN);
            for (var flags:int = 1; flags < 8; flags++)
            {
                assertThrows(ArgumentError, /^shape "huge": coordinates must be at most 1e\+60/, withFlags(flags).addModel, huge);
            }
            assertThrows(ArgumentError, /^shape "huge": coordinates must be at most 1e\+60/, new LevelShapes().addModel, huge);
        }

        [Test]
        public function nothingShowsBeforeTheLastStep():void
        {
            var count:int = finish(withFlags(7).receive(turnedBox()));
            assertTrue(count + " steps", count > 80);
            var greatLand:GreatLand = withFlags(7);
            // cancelled after each number of steps
            for (var done:int = 0; done < count; done++)
            {
                var intake:Steps = greatLand.receive(turnedBox());
                for (var i:int = 0; i < done; i++)
                {
                    assertTrue(intake.step());
                }
                assertUntouched(greatLand, "after " + done + " steps");
            }
            // and with another model of the name
            greatLand.addModel(new Model("turned", BuiltInModel.cube().vertices));
            var before:String = LibraryContents.of(greatLand, "turned");
            intake = greatLand.receive(turnedBox());
            while (intake.step())
            {
                assertEquals(before, LibraryContents.of(greatLand, "turned"));
            }
            assertFalse(before == LibraryContents.of(greatLand, "turned"));
        }

        [Test]
        public function aFailingStepLeavesNothing():void
        {
            for (var place:int = 0; place < 4; place++)
            {
                for each (var fitter:Fitter in [new CylinderFitter(new AxisAlignedBoxFitter()), new CapsuleFitter(new MinimalSphereFitter()), new FailingFitter(new ArgumentError("no"))])
                {
                    var greatLand:GreatLand = withFlags(7);
                    greatLand.boundingStructures.fitters.splice(place, 0, fitter);
                    var intake:Steps = greatLand.receive(turnedBox());
                    assertThrows(ArgumentError, /shape "turned": /, finish, intake);
                    assertUntouched(greatLand, fitter + " at " + place);
                    assertThrows(ArgumentError, /shape "turned": /, greatLand.addModel, turnedBox());
                }
            }
            assertThrows(ArgumentError, /null/, greatLand.receive, null);
        }

        [Test]
        public function aFitterWithoutStepsIsOneStep():void
        {
            var greatLand:GreatLand = new GreatLand();
            var counting:CountingFitter = new CountingFitter();
            greatLand.boundingStructures.fitters = new <Fitter>[counting, new CapsuleFitter(counting)];
            greatLand.loadHierarchies = false;
            var intake:Steps = greatLand.receive(turnedBox());
            assertEquals(0, counting.count);
            finish(intake);
            assertEquals(1, counting.count);
            assertTrue(greatLand.boundingStructures.has("turned"));
        }

        [Test]
        public function theModelThatIsThereLastCounts():void
        {
            var greatLand:GreatLand = new GreatLand();
            var intake:Steps = greatLand.receive(turnedBox());
            intake.step();
            greatLand.addModel(new Model("turned", BuiltInModel.cube().vertices));
            assertTrue(Math.abs(greatLand.boundingStructures.tightestFit("turned").volume - 1) < 1e-12);
            finish(intake);
            assertTrue(greatLand.boundingStructures.tightestFit("turned").volume < 0.9);
        }

        private static function finish(intake:Steps):int
        {
            var count:int = 1;
            while (intake.step())
            {
                count++;
            }
            return count;
        }

        private static function withFlags(flags:int):GreatLand
        {
            var greatLand:GreatLand = new GreatLand();
            greatLand.loadTightestFit = (flags & 1) != 0;
            greatLand.loadHierarchies = (flags & 2) != 0;
            greatLand.loadAllBoundingStructures = (flags & 4) != 0;
            return greatLand;
        }

        private static function assertUntouched(greatLand:GreatLand, when:String):void
        {
            assertFalse(when, greatLand.hasModel("turned"));
            assertFalse(when, greatLand.boundingStructures.has("turned"));
            assertFalse(when, greatLand.hierarchies.has("turned"));
        }

        // A cube on its edge, 45 degrees about x, its sides of many vertices.
        private static function turnedBox():Model
        {
            var points:Vector.<Number> = PointSets.box(0.7, 0.5, 0.5, 4);
            for (var i:int = 0; i < points.length; i += 3)
            {
                var y:Number = points[i + 1];
                points[i + 1] = (y - points[i + 2]) * Math.SQRT1_2;
                points[i + 2] = (y + points[i + 2]) * Math.SQRT1_2;
            }
            return new Model("turned", points);
        }
    }
}
