package starlogo
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.ProgressEvent;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import starlogo.agents.Agent;
    import starlogo.collision.BinCollider;
    import starlogo.collision.CollisionSystem;
    import starlogo.collision.CombinationCollider;
    import starlogo.collision.HierarchicalCollider;
    import starlogo.collision.TightestFitCollider;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import starlogo.models.ModelEvent;
    import starlogo.models.ModelLoader;
    import support.LibraryContents;
    import support.SteppedModels;
    import support.assertThrows;
    import support.landOf;

    /** GreatLand and ModelLoader together. */
    public class GreatLandLoadingTest
    {
        private static const BUDGET:int = 8;
        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\n";

        private var _greatLand:GreatLand = new GreatLand();
        private var _loader:ModelLoader = new ModelLoader(_greatLand, BUDGET);

        [Test(async, timeout="330000")]
        public function twelveModelsLoadWhileTheGameRuns():void
        {
            var frames:int = 0;
            var loaded:Array = [];
            _loader.addEventListener(ProgressEvent.PROGRESS, function(event:ProgressEvent):void
                {
                    frames++;
                });
            _loader.addEventListener(ModelEvent.LOADED, function(event:ModelEvent):void
                {
                    loaded.push(event.model);
                });
            for each (var model:Model in SteppedModels.builtIn())
            {
                _loader.loadText(model.name, SteppedModels.objText(model));
            }
            for each (var file:String in SteppedModels.FIXTURES)
            {
                _loader.load(SteppedModels.nameOf(file), file);
            }
            whenComplete(function():void
                {
                    trace("  12 models of a game in " + frames + " frames: the longest " + _loader.longestFrame + " ms of "
                            + BUDGET + ", the longest step " + _loader.longestStep + " ms");
                    assertEquals(12, loaded.length);
                    assertTrue("it stops when the budget is spent", _loader.longestFrame <= BUDGET + _loader.longestStep);
                    // what is there is what addModel would have put there
                    var dragon:Model = loaded.filter(isDragon)[0];
                    var other:GreatLand = landOf(dragon);
                    assertEquals(LibraryContents.of(other, "dragon"), LibraryContents.of(_greatLand, "dragon"));
                }, 300000);
        }

        [Test(async, timeout="150000")]
        public function anAgentWhoseModelIsLoadingTakesNoPart():void
        {
            var agent:Agent = new Agent("bear");
            var cube:Agent = new Agent("cube");
            _greatLand.addModel(BuiltInModel.cube());
            assertSays(agent, cube, /there is no model "bear"/);
            _loader.loadText("bear", OBJ);
            assertTrue(_greatLand.isLoading("bear"));
            for each (var collider:CollisionSystem in systems())
            {
                assertFalse(collider.areColliding(agent, cube) || collider.areColliding(cube, agent));
                assertEquals(0, collider.findCollisions(new <Agent>[agent, cube]).length);
                assertEquals("of two", "2 1 0", [collider.statistics.agents, collider.statistics.agentsLoading, collider.statistics.agentsSkipped].join(" "));
                assertEquals("the others do", 2, collider.findCollisions(new <Agent>[cube, agent, new Agent("cube")]).length);
            }
            _loader.cancel();
            assertSays(agent, cube, /there is no model "bear"/);
            _loader.loadText("bear", "v 1");
            _loader.loadText("bear", OBJ);
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    // the second one is still to come
                    assertTrue(_greatLand.isLoading("bear"));
                });
            whenComplete(function():void
                {
                    assertFalse(_greatLand.isLoading("bear"));
                    for each (var system:CollisionSystem in systems())
                    {
                        assertTrue(system.areColliding(agent, cube));
                    }
                });
        }

        [Test(async, timeout="150000")]
        public function oneThatIsAddedMeanwhileServesUntilThen():void
        {
            var agent:Agent = new Agent("bear");
            var cube:Agent = new Agent("cube");
            cube.moveTo(0, 0, 0.5);
            _greatLand.addModel(BuiltInModel.cube());
            _loader.loadText("bear", OBJ);
            _greatLand.addModel(new Model("bear", BuiltInModel.sphere().vertices));
            assertTrue(_greatLand.isLoading("bear"));
            var system:CollisionSystem = new TightestFitCollider(_greatLand);
            assertTrue(system.areColliding(agent, cube));
            whenComplete(function():void
                {
                    // the triangle lies on the ground, below the cube
                    assertFalse(system.areColliding(agent, cube));
                });
        }

        [Test(async, timeout="150000")]
        public function aFitterThatFailsIsReported():void
        {
            var problem:String = null;
            _greatLand.boundingStructures.fitters.push(null);
            _loader.loadText("bear", OBJ);
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    problem = event.text;
                });
            whenComplete(function():void
                {
                    assertTrue(problem, /model "bear".*fitter must not be null/.test(problem));
                    assertFalse(_greatLand.hasModel("bear"));
                    assertFalse(_greatLand.isLoading("bear"));
                });
        }

        [Test]
        public function anErrorAboutAnAgentSaysThatItsLoadWasCancelled():void
        {
            _loader.loadText("bear", OBJ);
            _loader.cancel("bear");
            assertSays(new Agent("bear", "bears"), new Agent("bear"), /there is no model "bear", because its load failed: it was cancelled/);
        }

        [Test(async, timeout="330000")]
        public function anErrorAboutAnAgentSaysWhyItsModelDidNotLoad():void
        {
            var agent:Agent = new Agent("bear", "bears");
            _loader.loadText("bear", "v 0 0 north");
            _loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    assertSays(agent, new Agent("bear"), new RegExp("there is no model \"bear\", because its load failed: " + event.text.substr(0, 20)));
                });
            whenComplete(function():void
                {
                    assertSays(agent, new Agent("bear"), /because its load failed: model "bear"/);
                    _loader.loadText("bear", OBJ);
                    whenComplete(function():void
                        {
                            assertTrue(_greatLand.hasModel("bear"));
                            _greatLand.removeModel("bear");
                            assertSays(agent, new Agent("bear"), /there is no model "bear"; add it/);
                        });
                });
        }

        [Test]
        public function aLoadThatEndsWithoutABeginningChangesNothing():void
        {
            var other:GreatLand = new GreatLand();
            other.expectNoMore("bear");
            other.expect("bear");
            assertTrue("of a name that was unknown", other.isLoading("bear"));
            other.expectNoMore("bear");
            other.expectNoMore("bear");
            assertFalse(other.isLoading("bear"));
            other.expect("bear");
            assertTrue("of one that was known", other.isLoading("bear"));
        }

        private function systems():Array
        {
            return [new BinCollider(_greatLand), new TightestFitCollider(_greatLand), new HierarchicalCollider(_greatLand),
                    new CombinationCollider(_greatLand)];
        }

        private function assertSays(agent:Agent, other:Agent, message:RegExp):void
        {
            for each (var system:CollisionSystem in systems())
            {
                assertThrows(ArgumentError, message, system.areColliding, agent, other);
                assertThrows(ArgumentError, message, system.findCollisions, new <Agent>[other, agent]);
            }
        }

        private function whenComplete(check:Function, timeout:int = 120000):void
        {
            Async.handleEvent(this, _loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    check();
                }, timeout);
        }

        private static function isDragon(model:Model, index:int, all:Array):Boolean
        {
            return model.name == "dragon";
        }
    }
}
