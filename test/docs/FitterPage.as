package docs
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.fitting.Fitter;
    import starlogo.models.BuiltInModel;

    /** For the ASDoc of Fitter. */
    public class FitterPage extends Page
    {
        public static const FIXTURES:Array = [];

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            greatLand.boundingStructures.fitters = new <Fitter>[new OriginSphereFitter()];
            greatLand.addModel(BuiltInModel.cube());
            var volume:Number = greatLand.boundingStructures.tightestFit("cube").volume;
            assertEquals("out to a corner at the top", (Math.PI * Math.sqrt(6)).toFixed(9), volume.toFixed(9));
        }
    }
}
