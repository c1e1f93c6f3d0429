package starlogo.models
{
    import flash.events.ErrorEvent;
    import flash.events.Event;
    import flash.events.ProgressEvent;
    import flash.net.URLLoader;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.models.loading.CookedManifest;
    import starlogo.models.loading.FileDownload;
    import starlogo.models.loading.ModelLoad;
    import support.CountingFitter;
    import support.LibraryContents;
    import support.OfferingURLLoader;
    import support.SteppedModels;
    import support.encoded;
    import support.whenComplete;

    /** A ModelLoader and cooked files, by themselves and by a manifest. */
    public class CookedLoadingTest
    {
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        private static const BUDGET:int = 8;
        private static const OBJ:String = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0.2 0.3 1\nf 1 2 3\nf 1 2 4\n";
        private static const MANIFEST:String = "{\"models\": {\"a\": {\"hasOwnProperty\": 1, \"cooked\": \"a\"}, \"bear.obj\": {\"cooked\": \"bear.obj.cooked\"}, \"deep/bear.obj\": {\"cooked\": \"x/y\"}}}";

        private var _greatLand:GreatLand;
        private var _loader:TestedLoader;
        private var _fitter:CountingFitter;
        private var _errors:Array;

        [Before]
        public function setUp():void
        {
            _fitter = new CountingFitter();
            _greatLand = newGame();
            _errors = [];
            _loader = watched(new TestedLoader(_greatLand, 1000)) as TestedLoader;
        }

        [After]
        public function tearDown():void
        {
            _loader.cancel();
        }

        [Test]
        public function withoutAManifestNothingElseIsAskedFor():void
        {
            assertEquals(null, _loader.manifest);
            _loader.load("bear", "bear.obj");
            assertEquals("bear.obj", askedFor());
        }

        [Test]
        public function theManifestIsAskedForOnce():void
        {
            _loader.manifest = "a/manifest.json";
            _loader.load("bear", "a/bear.obj");
            _loader.load("bear 2", "a/bear.obj");
            assertEquals("a/manifest.json", _loader.manifest);
            assertEquals("a/manifest.json", askedFor());
            _loader.load("data", "data:text/plain,v");
            assertEquals("which is beside nothing", "a/manifest.json,data:text/plain,v", askedFor());
        }

        [Test(async, timeout="150000")]
        public function whatItNamesIsTakenAndNothingElseRead():void
        {
            var made:Model = new ObjModel("bear", OBJ);
            var other:GreatLand = newGame();
            other.addModel(made);
            var offering:ModelLoader = offer({"http://h/a/m.json?k": encoded(MANIFEST), "http://h/a/bear.obj.cooked?v=2#x": newGame().cook(made),
                        "http://h/a/x/y": newGame().cook(made)}, "http://h/a/m.json?k");
            _fitter.count = 0;
            offering.load("bear", "http://h/a/bear.obj?v=2#x");
            offering.load("deep", "http://h/a/deep/bear.obj");
            whenComplete(this, offering, function():void
                {
                    assertEquals("nothing is fitted", 0, _fitter.count);
                    assertEquals("", _errors.join());
                    assertEquals(LibraryContents.of(other, "bear"), LibraryContents.of(_greatLand, "bear"));
                    assertTrue(_greatLand.hasModel("deep"));
                });
        }

        [Test(async, timeout="150000")]
        public function whereThereIsNoneItIsReadWithoutError():void
        {
            var cooked:ByteArray = newGame().cook(new ObjModel("bear", OBJ));
            var damaged:ByteArray = new ByteArray();
            damaged.writeBytes(cooked);
            damaged[100] ^= 1;
            var nothing:Object = {};
            var ways:Array = [nothing, {"m.json": encoded("no JSON")}, {"m.json": encoded("null")}, {"m.json": encoded("{\"models\": 3}")},
                    {"m.json": encoded("{\"models\": {\"bear.obj\": null}}")}, {"m.json": encoded("{\"models\": {\"bear.obj\": {\"cooked\": 1}}}")}, {"m.json": encoded(MANIFEST)},
                    {"m.json": encoded(MANIFEST), "bear.obj.cooked": damaged}, {"m.json": encoded(MANIFEST), "bear.obj.cooked": encoded("<html>404</html>")}];
            var left:int = ways.length;
            _fitter.count = 0;
            var done:TestedLoader = _loader;
            for (var i:int = 0; i < ways.length; i++)
            {
                ways[i]["bear.obj"] = encoded(OBJ);
                var offering:ModelLoader = offer(ways[i], "m.json");
                offering.addEventListener(Event.COMPLETE, function(event:Event):void
                    {
                        if (--left == 0)
                        {
                            done.dispatchEvent(new Event(Event.COMPLETE));
                        }
                    });
                offering.load("bear " + i, "bear.obj");
            }
            whenComplete(this, _loader, function():void
                {
                    assertEquals("", _errors.join());
                    assertEquals(ways.length, _fitter.count);
                    for (i = 0; i < ways.length; i++)
                    {
                        assertTrue(_greatLand.hasModel("bear " + i));
                    }
                });
        }

        [Test(async, timeout="150000")]
        public function forOtherArgumentsTheSourceIsRead():void
        {
            var cooked:ByteArray = newGame().cook(new ObjModel("bear", OBJ));
            var offering:ModelLoader = offer({"m.json": encoded(MANIFEST), "bear.obj.cooked": cooked, "bear.obj": encoded(OBJ)}, "m.json");
            _fitter.count = 0;
            offering.load("z", "bear.obj");
            offering.load("y", "bear.obj", "y");
            offering.load("volume", "bear.obj", "z", Model.VOLUME);
            offering.load("turned", "bear.obj", ModelTransform.fromText("rotate 0 0 45"));
            whenComplete(this, offering, function():void
                {
                    assertEquals("", _errors.join());
                    assertEquals(3, _fitter.count);
                    for each (var model:Model in [new ObjModel("y", OBJ, "y"), new ObjModel("volume", OBJ, "z", Model.VOLUME),
                                new ObjModel("turned", OBJ, ModelTransform.fromText("rotate 0 0 45"))])
                    {
                        var land:GreatLand = newGame();
                        land.addModel(model);
                        assertEquals(LibraryContents.of(land, model.name), LibraryContents.of(_greatLand, model.name));
                    }
                });
        }

        [Test]
        public function aCookedFileThatIsRefusedLeavesTheProgress():void
        {
            var files:Object = {"m.json": encoded(MANIFEST), "bear.obj.cooked": newGame().cook(new ObjModel("bear", OBJ)), "bear.obj": encoded(OBJ)};
            var load:ModelLoad = new ModelLoad("y", "y", Model.FOOTPRINT, _greatLand, function():URLLoader
                {
                    return new OfferingURLLoader(files);
                });
            load.fetch("bear.obj", false, new CookedManifest("m.json"));
            var progress:Array = [0];
            do
            {
                progress.push(load.progress);
                assertTrue(progress.join(), progress[progress.length - 1] >= progress[progress.length - 2]);
            }
            while (load.isReady && load.step());
            assertTrue(progress.join(), progress.indexOf(0.2) > 0 && progress[progress.length - 1] == 0.5);
        }

        [Test(async, timeout="150000")]
        public function aTransformBesideTheModelIsCookedWithIt():void
        {
            var transform:ModelTransform = ModelTransform.fromText("rotate 0 90 0\nscale 1 2 3");
            var made:Model = new ObjModel("bear", OBJ, transform);
            var files:Object = {"m.json": encoded(MANIFEST), "bear.obj.cooked": newGame().cook(made, "z", true), "bear.obj": encoded(OBJ)};
            var offering:ModelLoader = offer(files, "m.json");
            offering.usesTransforms = true;
            _fitter.count = 0;
            offering.load("bear", "bear.obj");
            whenComplete(this, offering, function():void
                {
                    assertEquals(0, _fitter.count);
                    var land:GreatLand = newGame();
                    land.addModel(made);
                    assertEquals(LibraryContents.of(land, "bear"), LibraryContents.of(_greatLand, "bear"));
                });
        }

        [Test(async, timeout="150000")]
        public function aCookedFileIsAModelByItself():void
        {
            var cooked:ByteArray = newGame().cook(new ObjModel("bear", OBJ));
            var damaged:ByteArray = new ByteArray();
            damaged.writeBytes(cooked);
            damaged[damaged.length - 20] ^= 1;
            _fitter.count = 0;
            _loader.loadBytes("bear", cooked);
            _loader.loadBytes("damaged", damaged);
            whenComplete(this, _loader, function():void
                {
                    assertEquals(0, _fitter.count);
                    assertTrue(_greatLand.hasModel("bear"));
                    assertFalse(_greatLand.hasModel("damaged"));
                    assertEquals(1, _errors.length);
                    assertTrue(_errors[0], /model "damaged".*cooked file is damaged/.test(_errors[0]));
                });
        }

        [Test(async, timeout="330000")]
        public function aGamesModelsKeepToTheBudget():void
        {
            var files:Object = {};
            var names:Object = {};
            for each (var model:Model in SteppedModels.twelve())
            {
                for each (var file:String in SteppedModels.FIXTURES)
                {
                    if (SteppedModels.nameOf(file) == model.name)
                    {
                        files[file + ".c"] = _greatLand.cook(model);
                        names[file] = {cooked: file + ".c"};
                    }
                }
            }
            files["m"] = encoded(JSON.stringify({models: names}));
            _fitter.count = 0;
            var offering:ModelLoader = new OfferingLoader(_greatLand, BUDGET, files);
            offering.manifest = "m";
            for each (file in SteppedModels.FIXTURES)
            {
                offering.load(SteppedModels.nameOf(file), file);
            }
            var frames:int = 0;
            offering.addEventListener(ProgressEvent.PROGRESS, function(event:ProgressEvent):void
                {
                    frames++;
                });
            whenComplete(this, offering, function():void
                {
                    trace("  nine cooked models in " + frames + " frames: the longest " + offering.longestFrame + " ms of " + BUDGET +
                            ", the longest step " + offering.longestStep + " ms");
                    assertEquals("nothing is fitted", 0, _fitter.count);
                    assertTrue(_greatLand.hasModel("dragon") && _greatLand.hasModel("kelp"));
                    assertTrue("it stops when the budget is spent", offering.longestFrame <= BUDGET + offering.longestStep);
                });
        }

        [Test]
        public function aManifestNamesNothingOutsideItsFolder():void
        {
            for each (var address:String in ["x", "../x", "//other.host/x", "ht\ntps://x", "%2e%2e/x", "/x", "bear.obj/../../x", "bear.obj"])
            {
                var manifest:CookedManifest = new CookedManifest("a/m.json");
                fetch(manifest, address);
                assertEquals(address, address == "x" ? "a/x?v=1" : null, manifest.addressFor("a/bear.obj?v=1"));
            }
        }

        [Test]
        public function aManifestThatHasNotComeNamesNothingYet():void
        {
            var manifest:CookedManifest = new CookedManifest("a/m.json");
            assertEquals(null, manifest.addressFor("a/bear.obj"));
            fetch(manifest, "x");
            assertEquals("a/x", manifest.addressFor("a/bear.obj"));
        }

        [Test]
        public function anEntryThatIsNoObjectHidesNoOther():void
        {
            var manifest:CookedManifest = new CookedManifest("m.json");
            manifest.download = new FileDownload("m.json", new OfferingURLLoader({"m.json": encoded("{\"models\": {\"a.obj\": \"x\", \"b.obj\": 3, \"c.obj\": null, \"bear.obj\": {\"cooked\": \"x\"}}}")}));
            for each (var file:String in ["a.obj", "b.obj", "c.obj"])
            {
                assertEquals(null, manifest.addressFor(file));
            }
            assertEquals("x", manifest.addressFor("bear.obj"));
        }

        // Has a list come in which the bear's cooked file has an address.
        private static function fetch(manifest:CookedManifest, cooked:String):void
        {
            manifest.download = new FileDownload("a/m.json", new OfferingURLLoader({"a/m.json": encoded(JSON.stringify({models: {"bear.obj": {cooked: cooked}}}))}));
        }

        private function askedFor():String
        {
            var addresses:Array = [];
            for (var i:int = 0; i < _loader.fetches.length; i++)
            {
                addresses.push(_loader.fetches[i].addresses);
            }
            return addresses.join();
        }

        private function offer(files:Object, manifest:String):ModelLoader
        {
            var loader:ModelLoader = watched(new OfferingLoader(_greatLand, 1000, files));
            loader.manifest = manifest;
            return loader;
        }

        private function watched(loader:ModelLoader):ModelLoader
        {
            loader.addEventListener(ErrorEvent.ERROR, function(event:ErrorEvent):void
                {
                    _errors.push(event.text);
                });
            return loader;
        }

        private function newGame():GreatLand
        {
            var game:GreatLand = new GreatLand();
            game.boundingStructures.fitters.push(_fitter);
            return game;
        }
    }
}
