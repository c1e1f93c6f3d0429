package docs
{
    import game.CentredSphereFitter;
    import game.UprightCapsuleFitter;
    import org.flexunit.asserts.assertEquals;
    import starlogo.bounding.BoundingStructure;
    import starlogo.fitting.FitSession;
    import starlogo.libraries.BoundingStructuresLibrary;
    import starlogo.models.BuiltInModel;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;
    import starlogo.steps.Steps;
    import support.FitChecks;
    import support.Fixtures;

    /** For docs/adding-a-fitter.md: the table's volumes, and that the fitter encloses. */
    public class AddingAFitterPage extends Page
    {
        public static const FIXTURES:Array = ["/assets/person.dae", "/assets/fireman.dae", "/assets/bear.obj"];

        protected var personText:String = Fixtures.text("/assets/person.dae");

        /** @inheritDoc */
        override protected function check(shown:Object):void
        {
            assertEquals(BoundingStructure.CAPSULE, greatLand.boundingStructures.tightestFit("person").kind);
            var models:Array = [new ColladaModel("person", personText), new ColladaModel("fireman", Fixtures.text("/assets/fireman.dae")),
                    new ObjModel("bear", Fixtures.text("/assets/bear.obj")), BuiltInModel.sphere()];
            var volumes:Array = [];
            for each (var model:Model in models)
            {
                var capsule:BoundingStructure = new UprightCapsuleFitter().fit(model.vertices);
                assertEquals(model.name, "", FitChecks.outside(capsule, model.vertices));
                var library:BoundingStructuresLibrary = new BoundingStructuresLibrary();
                library.add(model.name, model.vertices);
                volumes.push(library.tightestFit(model.name).volume.toFixed(3), capsule.volume.toFixed(3));
            }
            assertEquals("0.187,0.620,1.853,2.638,1.835,2.490", volumes.slice(0, 6).join());
            var many:Vector.<Number> = new Vector.<Number>(9000);
            var ofSession:int = stepsOf(new FitSession(many));
            assertEquals("three thousand and the structure", 4, stepsOf(new CentredSphereFitter().fitting(new FitSession(many))) - ofSession);
            var sphere:BoundingStructure = new CentredSphereFitter().fit(models[0].vertices);
            assertEquals("", FitChecks.outside(sphere, models[0].vertices));
            assertEquals("a sphere where that is enough", "0.524", volumes[7]);
        }

        private static function stepsOf(work:Steps):int
        {
            var count:int = 1;
            while (work.step())
            {
                count++;
            }
            return count;
        }
    }
}
