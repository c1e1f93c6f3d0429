package docs
{
    import org.flexunit.asserts.assertEquals;
    import starlogo.fitting.Fitter;

    /** For the ASDoc of Fitter. */
    public class FitterPage extends Page
    {
        public static const FIXTURES:Array = Page.FIXTURES;

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            greatLand.boundingStructures.fitters = new <Fitter>[new OriginSphereFitter()];
            greatLand.addModel(cube());
            assertEquals(Math.PI * Math.sqrt(6), greatLand.boundingStructures.tightestFit("cube").volume);
        }
    }
}
