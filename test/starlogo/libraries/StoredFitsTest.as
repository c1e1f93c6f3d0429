package starlogo.libraries
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNotNull;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Sphere;
    import starlogo.collision.Collider;
    import starlogo.data.Fingerprint;
    import starlogo.data.areSameNumbers;
    import starlogo.engine;
    import starlogo.fitting.Fitter;
    import starlogo.fitting.HullFitter;
    import starlogo.fitting.MinimalCapsuleFitter;
    import starlogo.libraries.cooked.CookedStructures;
    import starlogo.libraries.cooked.CookedTree;
    import starlogo.models.BuiltInModel;
    import starlogo.models.CookedModel;
    import starlogo.models.Model;
    import starlogo.models.ModelError;
    import starlogo.models.ModelTransform;
    import starlogo.models.ObjModel;
    import starlogo.models.cooked.CookedFile;
    import starlogo.models.cooked.CookedReader;
    import starlogo.queries.AgentQueries;
    import starlogo.solid.SolidContents;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;
    import starlogo.steps.finish;
    import support.CountingFitter;
    import support.EachCollider;
    import support.Effort;
    import support.FrameByFrame;
    import support.LibraryContents;
    import support.Mutations;
    import support.PointSets;
    import support.SteppedModels;
    import support.Surfaces;
    import support.assertThrows;

    use namespace engine;

    /** Models and fits that were written down and read again are those that were computed; whatever else is read is not taken for them. */
    public class StoredFitsTest
    {
        public static const FIXTURES:Array = SteppedModels.FIXTURES;

        // What the twelve models' fits come to. Where it changes, raise FitSettings.REVISION: what players have kept is void.
        private static const FINGERPRINT:String = "7a61db0270c71d0e";

        // The same of their hulls, and of that of a turned cube with many vertices on its sides.
        private static const HULLS:String = "2bee007cdcd1a6fd";

        private var _greatLand:GreatLand = new GreatLand();

        [Test]
        public function whatIsReadIsWhatWasComputed():void
        {
            for each (var model:Model in SteppedModels.twelve().concat(SteppedModels.odd()))
            {
                // large ones, where the player interprets, in anotherAlgorithmIsAnotherRevision alone
                if (!Effort.isInterpreted || model.vertices.length < 3000)
                {
                    assertReadAsComputed(model, model.name);
                }
            }
        }

        [Test]
        public function aModelAboveTheFloorStaysThere():void
        {
            // No form restores a mirror image but the one with the model's own vertices.
            var transform:ModelTransform = new ModelTransform(null, new Vector3D(-1, 1, 1), new Vector3D(0, 0, 5));
            var mirror:Model = new ObjModel("mirror", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", transform, Model.VOLUME);
            var posed:Model = new Model("posed", mirror.vertices, mirror.triangles, Model.VOLUME);
            var raised:Vector.<Number> = mirror.vertices.slice();
            raised[2] += 1 / 3;
            raised[5] += 1 / 3;
            raised[8] += 1 / 3;
            posed.pose(raised);
            for each (var model:Model in [mirror, posed])
            {
                assertTrue(model.name, Surfaces.bounds(model.vertices)[2] > 0.1);
                assertEquals(model.vertices.join(), CookedModel.fromBytes(model.name, _greatLand.cook(model)).vertices.join());
            }
        }

        [Test]
        public function bothSidesOfAMirrorImageKeepTheirMaterials():void
        {
            var text:String = "v 0 0 0\nv 1 0 0\nv 0 0 1\nusemtl front\no one\nf 1 2 3\nusemtl back\no two\nf 3 2 1\n";
            for each (var x:Number in [-1, 1])
            {
                var model:Model = new ObjModel("sign", text, new ModelTransform(null, new Vector3D(x, 1, 1)));
                var read:Model = CookedModel.fromBytes("sign", _greatLand.cook(model));
                assertSameModel(model, read);
                assertEquals("0,1", model.materials.join());
                assertEquals(model.materials.join(), read.materials.join());
                assertEquals(model.meshes.join(), read.meshes.join());
            }
        }

        // A step is a call of a game's frame.
        [Test]
        public function materialsAreReadInSteps():void
        {
            var triangles:Vector.<uint> = new Vector.<uint>();
            var numbers:Vector.<int> = new Vector.<int>();
            var names:Vector.<String> = new Vector.<String>();
            for (var i:int = 0; i < 20000; i++)
            {
                triangles.push(0, 1, 2);
                numbers.push(i);
                names.push(i % 3 == 0 ? null : "n" + i);
            }
            var model:Model = new Model("striped", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0], triangles);
            var plain:int = stepsOf(new CookedReader("striped", _greatLand.cook(model)).building());
            model.setMaterials(numbers, names);
            var bytes:ByteArray = _greatLand.cook(model);
            assertTrue(stepsOf(new CookedReader("striped", bytes).building()) - plain > 20);
            var read:Model = CookedModel.fromBytes("striped", bytes);
            assertEquals(numbers.join(), read.materials.join());
            assertEquals(names.join(), read.materialNames.join());
            assertNull(read.meshes);
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

        [Test]
        public function aModelWithoutAPlaceInItsSourceIsNotCooked():void
        {
            // the unit of the model is too small for the inverse to be a number
            var model:Model = new Model("small", new <Number>[0, 0, 0, 1e-310, 0, 0]);
            assertThrows(ModelError, /"small".*its place in its source/, _greatLand.cook, model);
        }

        [Test]
        public function aModelsOwnVerticesHaveNoTransform():void
        {
            // No form of a mirror image but the one with the model's own vertices restores it.
            var mirror:Model = new ObjModel("mirror", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", new ModelTransform(null, new Vector3D(-1, 1, 1)));
            var bytes:ByteArray = rewritten(mirror, function(index:int, section:ByteArray):ByteArray
                {
                    if (index == CookedFile.MODEL)
                    {
                        // whether a transform follows stands after the scaling and the form; 2 is the VarInt of 1
                        section.position = 2;
                        section.writeByte(2);
                        section.position = 0;
                    }
                    return section;
                });
            assertThrows(ModelError, "wrong number: 1", CookedModel.fromBytes, "mirror", bytes);
        }

        [Test]
        public function theUnitOfAModelsSourceIsPositive():void
        {
            var mirror:Model = new ObjModel("mirror", "v 0 0 0\nv 1 0 0\nv 0 0 1\nf 1 2 3\n", new ModelTransform(null, new Vector3D(-1, 1, 1)));
            for each (var unit:Number in [2, 0, -1, Infinity, NaN])
            {
                var bytes:ByteArray = rewritten(mirror, function(index:int, section:ByteArray):ByteArray
                    {
                        if (index == CookedFile.MODEL)
                        {
                            // after five VarInts of a byte, and the matrix and the offset: twelve numbers
                            section.position = 5 + 12 * 8;
                            section.writeDouble(unit);
                            section.position = 0;
                        }
                        return section;
                    });
                if (unit == 2)
                {
                    assertEquals(unit, CookedModel.fromBytes("mirror", bytes).source.unit);
                }
                else
                {
                    assertThrows(ModelError, "place in its source", CookedModel.fromBytes, "mirror", bytes);
                }
            }
        }

        [Test]
        public function everySettingThatMattersCounts():void
        {
            var model:Model = bear();
            var cooked:ByteArray = _greatLand.cook(model);
            assertTrue("the same", isTaken(model, cooked, true) && isTaken(model, cooked, false));
            _greatLand.orientedBoxDegIncrement = 15;
            assertTrue("another increment", !isTaken(model, cooked, true) && isTaken(model, cooked, false));
            _greatLand.orientedBoxDegIncrement = 10;
            _greatLand.boundingStructures.fitters.push(new MinimalCapsuleFitter());
            assertFalse("another fitter", isTaken(model, cooked, true));
            _greatLand.boundingStructures.fitters.pop();
            _greatLand.hierarchies.minVerticesToSplit = 6;
            assertTrue("fewer leaves", isTaken(model, cooked, true) && !isTaken(model, cooked, false));
            _greatLand.hierarchies.minVerticesToSplit = 5;
            _greatLand.hierarchies.maxDepth = 9;
            assertFalse("fewer levels", isTaken(model, cooked, false));
            var ofFewLevels:ByteArray = _greatLand.cook(model);
            _greatLand.hierarchies.maxDepth = 10;
            assertFalse("more levels", isTaken(model, ofFewLevels, false));
            _greatLand.hierarchies.splitByMean = true;
            assertFalse("split elsewhere", isTaken(model, cooked, false));
            _greatLand.hierarchies.splitByMean = false;
            assertTrue("the same again", isTaken(model, cooked, true) && isTaken(model, cooked, false));
        }

        [Test]
        public function hullsAreKeptBesideTheOtherStructures():void
        {
            var model:Model = bear();
            var plain:ByteArray = _greatLand.cook(model);
            _greatLand.loadHulls = true;
            assertFalse("without a hull", isTaken(model, plain, true));
            var cooked:ByteArray = _greatLand.cook(model);
            assertTrue("with a hull", isTaken(model, cooked, true));
            _greatLand.boundingStructures.hullFitter = new HullFitter(24);
            assertFalse("another hull", isTaken(model, cooked, true));
            _greatLand.loadHulls = false;
            assertTrue("no hull is wanted", isTaken(model, cooked, true));
            take(_greatLand, model, cooked);
            assertThrows(ArgumentError, "loadHulls", _greatLand.boundingStructures.hull, "bear");
        }

        [Test]
        public function aSphereInTheHullsPlaceIsReadAsSuch():void
        {
            _greatLand.loadHulls = true;
            var ball:Model = BuiltInModel.sphere();
            _greatLand.addModel(ball);
            assertTrue(_greatLand.boundingStructures.hull("sphere") is Sphere);
            var land:GreatLand = new GreatLand();
            land.loadHulls = true;
            take(land, ball, _greatLand.cook(ball));
            assertTrue(land.boundingStructures.hull("sphere") is Sphere);
            assertEquals(LibraryContents.of(_greatLand, "sphere"), LibraryContents.of(land, "sphere"));
        }

        [Test]
        public function filesOfOtherVersionsAreRefused():void
        {
            var cooked:ByteArray = _greatLand.cook(bear());
            for each (var version:int in [1, 2, 3, 5])
            {
                cooked[4] = version;
                assertThrows(ModelError, /"bear".*another version of the engine: cook it again/, CookedModel.fromBytes, "bear", cooked);
            }
        }

        [Test]
        public function whatAFitterWithoutSignatureFindsIsNotKept():void
        {
            _greatLand.boundingStructures.fitters.push(new CountingFitter(null));
            var cooked:ByteArray = _greatLand.cook(bear());
            assertFalse("structures", isTaken(bear(), cooked, true));
            assertTrue("its hierarchy is", isTaken(bear(), cooked, false));
        }

        [Test]
        public function otherSignaturesAreOtherSettings():void
        {
            var texts:Array = [];
            for each (var signatures:Array in [["a", "b"], ["a, b"], ["a,", "b"], ["a", ",b"], ["a,, b"], ["a,b"], ["ab"]])
            {
                var library:BoundingStructuresLibrary = new BoundingStructuresLibrary();
                library.fitters.length = 0;
                for each (var signature:String in signatures)
                {
                    library.fitters.push(new Fitter(signature));
                }
                var text:String = new FitSettings(library, null).toString();
                assertEquals(signatures.join("; "), -1, texts.indexOf(text));
                texts.push(text);
            }
            library.fitters[0] = new Fitter("");
            assertNull("an empty one is none", new FitSettings(library, null).keysWith(null)[CookedFile.STRUCTURES]);
        }

        [Test(async, timeout="3600000")]
        public function damagedFilesAreRefused():void
        {
            var models:Vector.<Model> = new <Model>[BuiltInModel.cube(), tetrahedron(), points()];
            var cooked:Vector.<ByteArray> = new Vector.<ByteArray>();
            for each (var model:Model in models)
            {
                cooked.push(_greatLand.cook(model));
            }
            var random:SeededRandom = new SeededRandom(15);
            var count:int = Effort.choose(600, 10000);
            var i:int = 0;
            var unchanged:int = 0;
            var damaging:StepSequence = new StepSequence().repeat(function():Boolean
                {
                    var index:int = i % models.length;
                    var damaged:ByteArray = damage(cooked, index, random);
                    if (areSame(damaged, cooked[index]) || areSame(damaged, cooked[(index + 1) % cooked.length]))
                    {
                        unchanged++;
                    }
                    else
                    {
                        assertThrows(ModelError, /cooked file/, CookedModel.fromBytes, "damaged", damaged);
                    }
                    return ++i < count + unchanged;
                });
            FrameByFrame.run(this, damaging, 20, function():void
                {
                    trace("  " + count + " files damaged, each refused; " + unchanged + " came out as they or another were");
                    assertTrue(unchanged < count / 50);
                });
        }

        // Of sections that were changed before the file was sealed.
        [Test(async, timeout="3600000")]
        public function forgedFilesAreRefusedOrCanBePlayedWith():void
        {
            _greatLand.loadHulls = true;
            var models:Vector.<Model> = new <Model>[BuiltInModel.cube(), tetrahedron(), points(), BuiltInModel.cylinder(), bear()];
            var random:SeededRandom = new SeededRandom(19);
            var refused:int = 0;
            var played:int = 0;
            var count:int = Effort.choose(200, 10000, 120);
            var forging:Steps = new StepSequence().slices(count, 1, function(first:int, end:int):void
                {
                    var land:GreatLand = new GreatLand();
                    land.loadHulls = true;
                    try
                    {
                        var read:Model = take(land, models[first % models.length], forged(models[first % models.length], random));
                    }
                    catch (error:Error)
                    {
                        assertTrue(error.message, error is ModelError || /coordinates must be at most/.test(error.message));
                        refused++;
                        return;
                    }
                    played++;
                    assertPlayable(land, read, random);
                });
            FrameByFrame.run(this, forging, 10, function():void
                {
                    trace("  " + refused + " forged files refused, " + played + " that make a model");
                    assertTrue(Math.min(refused, played) > count / 8);
                });
        }

        [Test]
        public function dividesAsUsualIfAnItemComesTwice():void
        {
            var model:Model = BuiltInModel.cube();
            _greatLand.addModel(model);
            var computed:String = contentsOf(_greatLand, model);
            var bytes:ByteArray = rewritten(model, function(index:int, section:ByteArray):ByteArray
                {
                    if (index == CookedFile.HIERARCHY)
                    {
                        // the order of the twelve triangles comes first, a byte each
                        section.position = 10;
                        section.writeByte(section.readByte());
                        section.position = 0;
                    }
                    return section;
                });
            assertFalse(isTaken(model, bytes, false));
            take(_greatLand, model, bytes);
            assertEquals(computed, contentsOf(_greatLand, model));
        }

        [Test]
        public function aMaterialMustBeOneThatThereIs():void
        {
            var model:Model = BuiltInModel.cube();
            model.setMaterials(new Vector.<int>(model.triangles.length / 3), new <String>["red"]);
            for each (var number:int in [-2, -1, 0, 1])
            {
                var bytes:ByteArray = rewritten(model, function(index:int, section:ByteArray):ByteArray
                    {
                        if (index == CookedFile.MODEL)
                        {
                            // the number of the only run stands before the two counts of the meshes; a VarInt has the sign in its last bit
                            section.position = section.length - 3;
                            section.writeByte(number < 0 ? -2 * number - 1 : 2 * number);
                            section.position = 0;
                        }
                        return section;
                    });
                if (number == -2 || number == 1)
                {
                    assertThrows(ModelError, "wrong number: " + number, CookedModel.fromBytes, "cube", bytes);
                }
                else
                {
                    assertEquals(number, CookedModel.fromBytes("cube", bytes).data.materials.labelOf(0));
                }
            }
        }

        private function forged(model:Model, random:SeededRandom):ByteArray
        {
            var forgedOne:int = random.integer(0, 2 * CookedFile.SECTION_COUNT);
            return rewritten(model, function(index:int, section:ByteArray):ByteArray
                {
                    return index == forgedOne || forgedOne >= CookedFile.SECTION_COUNT && index == 0 ? Mutations.ofBytes(section, random) : section;
                });
        }

        // A cooked file whose sections were changed before it was sealed.
        private function rewritten(model:Model, change:Function):ByteArray
        {
            var file:CookedFile = new CookedFile(_greatLand.cook(model));
            finish(file);
            var settings:FitSettings = new FitSettings(_greatLand.boundingStructures, _greatLand.hierarchies);
            var sections:Vector.<ByteArray> = new Vector.<ByteArray>();
            for (var i:int = 0; i < CookedFile.SECTION_COUNT; i++)
            {
                sections.push(change(i, file.section(i, null) || CookedFile.newBytes()));
            }
            return CookedFile.write(settings.keysWith(new Fingerprint()), sections);
        }

        // Agents of a model that was forged much larger would be, or would be moved, beyond the largest coordinate, as those of any such model.
        private static function isOfAUsualSize(model:Model):Boolean
        {
            return model.vertices.every(function(coordinate:Number, index:int, all:Vector.<Number>):Boolean
                {
                    return Math.abs(coordinate) < 1000;
                });
        }

        // Whatever a forged record says, each frame of a game with its model ends, and each question has an answer.
        private static function assertPlayable(land:GreatLand, model:Model, random:SeededRandom):void
        {
            if (!isOfAUsualSize(model))
            {
                return;
            }
            var agents:Vector.<Agent> = new Vector.<Agent>();
            for (var i:int = 0; i < 3; i++)
            {
                var agent:Agent = new Agent(model.name);
                agent.moveTo(random.between(-0.3, 0.3), random.between(-0.3, 0.3), random.between(-0.3, 0.3));
                agent.heading = random.between(0, 360);
                agent.hierarchical = i > 0;
                agents.push(agent);
            }
            for each (var name:String in EachCollider.ALL_NAMES)
            {
                var collider:Collider = EachCollider.make(name, land);
                var pairs:Vector.<Agent> = collider.findCollisions(agents);
                if (pairs.length > 0)
                {
                    assertNotNull(name, collider.contactOf(pairs[0], pairs[1]));
                }
            }
            var queries:AgentQueries = new AgentQueries(collider);
            queries.update(agents);
            queries.cast(new Vector3D(-3, 0, 0.1), Vector3D.X_AXIS);
            queries.distance(agents[0], agents[1]);
            queries.slide(agents[2], 0.2, 0.1, 0);
        }

        private static function assertSameModel(expected:Model, read:Model):void
        {
            assertTrue("vertices", areSameNumbers(expected.vertices, read.vertices));
            assertEquals(String(expected.triangles), String(read.triangles));
            assertEquals(String(expected.source.matrix.rawData), String(read.source.matrix.rawData));
            assertEquals(expected.source.unit, read.source.unit);
        }

        private static function take(land:GreatLand, model:Model, bytes:ByteArray):Model
        {
            var read:Model = CookedModel.fromBytes(model.name, bytes);
            land.addModel(read);
            return read;
        }

        [Test]
        public function impossibleStructuresAreNotTaken():void
        {
            var model:Model = bear();
            _greatLand.addModel(model);
            var fit:Box = Box(_greatLand.boundingStructures.tightestFit("bear"));
            var longer:Vector3D = fit.axisX.clone();
            longer.scaleBy(1.000001);
            for each (var wrong:Array in [["halfX", NaN], ["halfX", Infinity], ["halfZ", -1], ["center", new Vector3D(0, NaN, 0)], ["axisX", longer],
                        ["axisX", fit.axisY]])
            {
                var box:Box = Box(fit.clone());
                box[wrong[0]] = wrong[1];
                var land:GreatLand = new GreatLand();
                take(land, model, rewritten(model, function(index:int, section:ByteArray):ByteArray
                        {
                            return index == CookedFile.STRUCTURES ? CookedStructures.write(new <BoundingStructure>[box]) : section;
                        }));
                assertEquals(LibraryContents.of(_greatLand, "bear"), LibraryContents.of(land, "bear"));
            }
        }

        [Test]
        public function anotherAlgorithmIsAnotherRevision():void
        {
            var all:Fingerprint = new Fingerprint();
            for each (var model:Model in SteppedModels.twelve())
            {
                var file:CookedFile = new CookedFile(_greatLand.cook(model));
                finish(file);
                for (var i:int = CookedFile.STRUCTURES; i <= CookedFile.SURFACE; i++)
                {
                    var section:ByteArray = file.section(i, null);
                    section.length = section.length + 7 & ~7;
                    all.addGroups(section, section.length / Fingerprint.LENGTH);
                }
            }
            trace("  fits of the twelve models: " + all);
            assertEquals(FINGERPRINT, all.toString());
        }

        [Test]
        public function anotherHullIsAnotherRevision():void
        {
            var all:Fingerprint = new Fingerprint();
            _greatLand.loadHulls = true;
            _greatLand.loadHierarchies = false;
            var cube:Vector.<Number> = PointSets.turned(PointSets.box(0.5, 0.5, 0.5, 12), new SeededRandom(3));
            var models:Vector.<Model> = SteppedModels.twelve();
            models.push(new Model("cube", cube));
            for each (var model:Model in models)
            {
                var file:CookedFile = new CookedFile(_greatLand.cook(model));
                finish(file);
                var section:ByteArray = file.section(CookedFile.HULL, null);
                section.length = section.length + 7 & ~7;
                all.addGroups(section, section.length / Fingerprint.LENGTH);
            }
            assertEquals(HULLS, all.toString());
        }

        private function assertReadAsComputed(model:Model, message:String):void
        {
            for each (var isExact:Boolean in [false, true])
            {
                _greatLand.prepareExact = isExact;
                _greatLand.loadHulls = isExact;
                _greatLand.addModel(model);
                var computed:String = contentsOf(_greatLand, model);
                var cooked:ByteArray = _greatLand.cook(model);
                assertSameModel(model, CookedModel.fromBytes(model.name, cooked));
                assertTrue(message, isTaken(model, cooked, true) && isTaken(model, cooked, false));
                take(_greatLand, model, cooked);
                assertEquals(message, computed, contentsOf(_greatLand, model));
            }
        }

        private static function contentsOf(land:GreatLand, model:Model):String
        {
            return LibraryContents.of(land, model.name) + "\n" + SolidContents.of(land, model.name);
        }

        // Whether the structures, or the hierarchy, are taken from a cooked file.
        private function isTaken(model:Model, cooked:ByteArray, structures:Boolean):Boolean
        {
            var read:Model = CookedModel.fromBytes(model.name, cooked);
            var builder:CollisionDataBuilder = _greatLand.newDataBuilder(read, null);
            if (structures)
            {
                return builder.structures.tightest != null;
            }
            var restoring:CookedTree = CookedTree(builder.tree.restoring);
            builder.tree.finishBuilding();
            return restoring != null && !restoring.isRefused;
        }

        private static function damage(cooked:Vector.<ByteArray>, index:int, random:SeededRandom):ByteArray
        {
            switch (random.integer(0, 3))
            {
                case 0:
                    return bitTurned(cooked[index], random);
                case 1:
                    return crossed(cooked[index], cooked[(index + 1) % cooked.length], random);
                default:
                    return Mutations.ofBytes(cooked[index], random);
            }
        }

        private static function bitTurned(bytes:ByteArray, random:SeededRandom):ByteArray
        {
            var copy:ByteArray = new ByteArray();
            copy.writeBytes(bytes);
            copy[random.integer(0, copy.length - 1)] ^= 1 << random.integer(0, 7);
            return copy;
        }

        private static function crossed(a:ByteArray, b:ByteArray, random:SeededRandom):ByteArray
        {
            var copy:ByteArray = new ByteArray();
            var at:int = random.integer(0, Math.min(a.length, b.length));
            if (at > 0)
            {
                copy.writeBytes(a, 0, at);
            }
            if (at < b.length)
            {
                copy.writeBytes(b, at);
            }
            return copy;
        }

        private static function areSame(a:ByteArray, b:ByteArray):Boolean
        {
            for (var i:int = 0; i < a.length && a.length == b.length; i++)
            {
                if (a[i] != b[i])
                {
                    return false;
                }
            }
            return a.length == b.length;
        }

        private static function bear():Model
        {
            return SteppedModels.twelve().filter(function(model:Model, index:int, all:Vector.<Model>):Boolean
                {
                    return model.name == "bear";
                })[0];
        }

        private static function tetrahedron():Model
        {
            return new Model("tetrahedron", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1], new <uint>[0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3]);
        }

        private static function points():Model
        {
            return new Model("points", new <Number>[0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 0.3, 0.3, 0.3, 0.2, 0.7, 0.1, 0.9, 0.1, 0.4]);
        }
    }
}
