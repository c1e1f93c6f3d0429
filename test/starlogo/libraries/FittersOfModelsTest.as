package starlogo.libraries
{
    import org.flexunit.asserts.assertTrue;
    import starlogo.fitting.AxisAlignedBoxFitter;
    import starlogo.fitting.CapsuleFitter;
    import starlogo.fitting.CentredRitterSphereFitter;
    import starlogo.fitting.CylinderFitter;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.MinimalSphereFitter;
    import starlogo.fitting.NaiveSphereFitter;
    import starlogo.fitting.OrientedBoxFitter;
    import starlogo.fitting.RitterSphereFitter;
    import starlogo.fitting.ZAlignedBoxFitter;
    import starlogo.models.Model;
    import support.Fixtures;
    import support.SteppedModels;

    /** The volumes of every fit of the twelve models are the fixture's on every machine that runs the engine, but for rounding. */
    public class FittersOfModelsTest
    {
        public static const FIXTURES:Array = SteppedModels.FIXTURES.concat("/fixtures/models/fits.json");

        private static const EXPECTED:String = "/fixtures/models/fits.json";
        private static const LARGEST_DIFFERENCE:Number = 1e-13;

        [Test]
        public function volumesAreTheSameOnEveryMachine():void
        {
            var expected:Object = JSON.parse(Fixtures.text(EXPECTED));
            var largest:Number = 0;
            var count:int = 0;
            var lines:Array = [];
            var areKnown:Boolean = true;
            for each (var model:Model in SteppedModels.twelve())
            {
                var volumes:Array = volumesOf(model);
                lines.push("\t\"" + model.name + "\": [" + withDigitsOf(expected[model.name], volumes).join(", ") + "]");
                areKnown = areKnown && expected[model.name].length == volumes.length;
                for (var i:int = 0; areKnown && i < volumes.length; i++)
                {
                    var difference:Number = Math.abs(volumes[i] / expected[model.name][i] - 1);
                    assertTrue(model.name + ", fit " + i + ": " + volumes[i], difference <= LARGEST_DIFFERENCE);
                    largest = Math.max(largest, difference);
                    count++;
                }
            }
            assertTrue("Write to test/fixtures/models/fits.json what Node says (./antw module-test -Dtest=FittersOfModelsTest), not the "
                    + "player, because it has not as many volumes of each model as there are fitters here:\n{\n" + lines.join(",\n") + "\n}", areKnown);
            trace("  " + count + " volumes, the largest difference " + largest);
            assertTrue(count >= 12 * 9);
        }

        /** The volumes, with the digits of those that are in the fixture already: only what is new differs from it. */
        private static function withDigitsOf(expected:Array, volumes:Array):Array
        {
            var known:int = 0;
            var result:Array = [];
            for each (var volume:Number in volumes)
            {
                var isKnown:Boolean = known < expected.length && Math.abs(volume / expected[known] - 1) <= LARGEST_DIFFERENCE;
                result.push(isKnown ? expected[known++] : volume);
            }
            return result;
        }

        private static function volumesOf(model:Model):Array
        {
            var boxFitter:OrientedBoxFitter = new OrientedBoxFitter(15);
            var volumes:Array = [];
            for each (var fitter:Fitter in [new NaiveSphereFitter(), new RitterSphereFitter(), new CentredRitterSphereFitter(),
                        new MinimalSphereFitter(), new AxisAlignedBoxFitter(), new ZAlignedBoxFitter(15), boxFitter,
                        new CapsuleFitter(boxFitter), new CylinderFitter(boxFitter)])
            {
                volumes.push(fitter.fit(model.vertices).volume);
            }
            return volumes;
        }
    }
}
