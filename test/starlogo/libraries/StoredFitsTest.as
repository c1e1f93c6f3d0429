package starlogo.libraries
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import flash.utils.getTimer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.engine;
    import starlogo.hierarchy.SolidContents;
    import starlogo.models.Model;
    import starlogo.steps.finish;
    import support.LibraryContents;
    import support.SteppedModels;

    use namespace engine;

    /** Fits that were written and read again are those that were computed. */
    public class StoredFitsTest
    {
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        [Test]
        public function whatIsReadIsWhatWasComputed():void
        {
            var all:Vector.<Model> = SteppedModels.twelve().concat(SteppedModels.odd());
            for each (var model:Model in all)
            {
                var computed:GreatLand = new GreatLand();
                computed.prepareExact = true;
                computed.loadAllBoundingStructures = true;
                computed.addModel(model);
                var bytes:ByteArray = computed.bake(model);
                var read:GreatLand = new GreatLand();
                read.prepareExact = true;
                read.loadAllBoundingStructures = true;
                finish(read.receiveWithFits(model, bytes));
                assertEquals(model.name, LibraryContents.of(computed, model.name), LibraryContents.of(read, model.name));
                assertEquals(model.name, SolidContents.of(computed, model.name), SolidContents.of(read, model.name));
            }
        }

        [Test]
        public function timing():void
        {
            var all:Vector.<Model> = SteppedModels.twelve();
            var baked:Vector.<ByteArray> = new Vector.<ByteArray>();
            var land:GreatLand = new GreatLand();
            var sizes:int = 0;
            for each (var model:Model in all)
            {
                baked.push(land.bake(model));
                trace(model.name, model.triangles.length / 3, baked[baked.length - 1].length);
                sizes += baked[baked.length - 1].length;
            }
            trace("all", sizes);
            for each (var exact:Boolean in [false])
            {
                land.prepareExact = exact;
                for (var round:int = 0; round < 4; round++)
                {
                    var t0:int = getTimer();
                    for (var i:int = 0; i < all.length; i++)
                    {
                        land.addModel(all[i]);
                    }
                    var t1:int = getTimer();
                    for (var k:int = 0; k < 10; k++)
                    {
                        for (i = 0; i < all.length; i++)
                        {
                            finish(land.receiveWithFits(all[i], baked[i]));
                        }
                    }
                    var t2:int = getTimer();
                    trace(exact, t1 - t0, (t2 - t1) / 10, (t1 - t0) / (t2 - t1) * 10);
                }
            }
        }
    }
}
