package starlogo.libraries
{
    import evaluation.pairs.SeededRandom;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import starlogo.GreatLand;
    import starlogo.fitting.Fitter;
    import starlogo.models.BuiltInModel;
    import starlogo.models.Model;
    import support.CountingFitter;
    import support.LibraryContents;
    import support.MemoryStorage;
    import support.Mutations;
    import support.PointSets;
    import support.assertThrows;
    import support.create;

    /** What is kept from one game to the next, and what happens where that does not go well. */
    public class FitStoreTest
    {
        private var _storage:MemoryStorage = new MemoryStorage();
        private var _store:FitStore = new FitStore(1e6, _storage);
        private var _fitter:CountingFitter = new CountingFitter();

        [Test]
        public function theSecondGameComputesNothing():void
        {
            var first:GreatLand = newGame(_store);
            first.addModel(BuiltInModel.cylinder());
            assertEquals(1, _fitter.count);
            assertEquals("one entry", 1, _storage.names.length);
            var second:GreatLand = newGame(new FitStore(1e6, _storage));
            second.addModel(BuiltInModel.cylinder());
            assertEquals("nothing is fitted", 1, _fitter.count);
            assertEquals(LibraryContents.of(first, "cylinder"), LibraryContents.of(second, "cylinder"));
            assertEquals("nothing is written", 1, _storage.names.length);
        }

        [Test]
        public function aStorageMayGiveItsCopiesAsItHasWrittenThem():void
        {
            _storage = new StorageOfFreshCopies();
            for (var game:int = 0; game < 2; game++)
            {
                newGame(new FitStore(1e6, _storage)).addModel(BuiltInModel.cylinder());
            }
            assertEquals("the second game fits nothing", 1, _fitter.count);
            assertTrue(new FitStore(1e6, _storage).length > 0);
        }

        [Test]
        public function itMayBeReadAndWrittenByHand():void
        {
            var settings:FitSettings = settingsOf(newGame(null));
            assertNull(_store.read(BuiltInModel.cube(), settings));
            newGame(_store).addModel(BuiltInModel.cube());
            var entry:ByteArray = _store.read(BuiltInModel.cube(), settings);
            var other:FitStore = new FitStore(1e6, new MemoryStorage());
            assertFalse("another model", other.write(BuiltInModel.sphere(), settings, entry));
            assertFalse("no entry", other.write(BuiltInModel.cube(), settings, new ByteArray()));
            assertTrue(other.write(BuiltInModel.cube(), settings, entry));
            assertEquals(entry.length, other.read(BuiltInModel.cube(), settings).length);
            var second:GreatLand = newGame(other);
            second.addModel(BuiltInModel.cube());
            assertEquals("nothing is fitted", 1, _fitter.count);
            assertNull("another model", other.read(BuiltInModel.sphere(), settings));
            other.clear();
            assertNull(other.read(BuiltInModel.cube(), settings));
            assertEquals(0, other.length);
            assertThrows(ArgumentError, /null/, _store.read, null, settings);
            assertThrows(ArgumentError, /null/, _store.read, BuiltInModel.cube(), null);
            assertThrows(ArgumentError, /null/, _store.write, BuiltInModel.cube(), settings, null);
            assertThrows(RangeError, /-1/, create, FitStore, -1);
            assertThrows(RangeError, /NaN/, create, FitStore, NaN);
        }

        [Test]
        public function damagedEntriesAreReplaced():void
        {
            var expected:String = null;
            var random:SeededRandom = new SeededRandom(19);
            for (var i:int = 0; i < 60; i++)
            {
                var game:GreatLand = newGame(_store);
                game.addModel(BuiltInModel.cube());
                expected ||= LibraryContents.of(game, "cube");
                assertEquals(expected, LibraryContents.of(game, "cube"));
                assertEquals("computed again, " + i, i + 1, _fitter.count);
                var name:String = _storage.names[0];
                var damaged:ByteArray = Mutations.ofBytes(_storage.entries[name], random);
                damaged[8 * random.integer(2, 5)] ^= 1;
                _storage.entries[name] = damaged;
            }
        }

        [Test]
        public function theLeastRecentlyUsedGoFirst():void
        {
            var models:Vector.<Model> = someModels(6);
            newGame(_store).addModel(models[0]);
            var size:int = _store.length;
            var small:FitStore = new FitStore(3.7 * size, _storage);
            for (var i:int = 0; i < 3; i++)
            {
                newGame(small).addModel(models[i]);
            }
            newGame(small).addModel(models[0]);
            newGame(small).addModel(models[3]);
            assertEquals("models 2, 0 and 3", 3, _storage.names.length);
            assertTrue(small.length <= small.capacity);
            _fitter.count = 0;
            newGame(small).addModel(models[0]);
            newGame(small).addModel(models[3]);
            newGame(small).addModel(models[2]);
            assertEquals("those are there", 0, _fitter.count);
            newGame(small).addModel(models[1]);
            assertEquals("this one was not used for longest", 1, _fitter.count);
        }

        [Test]
        public function whatIsLargerThanTheCapacityIsNotKept():void
        {
            newGame(new FitStore(100, _storage)).addModel(BuiltInModel.cube());
            assertEquals(0, _storage.names.length);
            newGame(new FitStore(0, _storage)).addModel(BuiltInModel.cube());
            assertEquals(0, _storage.names.length);
            newGame(_store).addModel(BuiltInModel.cube());
            var size:int = _store.length;
            _store.clear();
            newGame(new FitStore(size - 1, _storage)).addModel(BuiltInModel.cube());
            assertEquals("one byte too few", 0, _storage.names.length);
            newGame(new FitStore(size, _storage)).addModel(BuiltInModel.cube());
            assertEquals("as many as there are", 1, _storage.names.length);
        }

        [Test]
        public function whereThereIsLessRoomThanItWasToldOthersGo():void
        {
            var models:Vector.<Model> = someModels(5);
            newGame(_store).addModel(models[0]);
            _storage.room = 2.9 * _store.length;
            for each (var model:Model in models)
            {
                newGame(_store).addModel(model);
            }
            assertTrue("some were refused", _storage.refusalCount > 0);
            assertEquals("two have room", 2, _storage.names.length);
            _fitter.count = 0;
            newGame(_store).addModel(models[4]);
            newGame(_store).addModel(models[3]);
            assertEquals("the last two", 0, _fitter.count);
        }

        [Test]
        public function gamesWorkWhereNothingCanBeKept():void
        {
            _storage.room = 0;
            for each (var model:Model in someModels(3))
            {
                var game:GreatLand = newGame(_store);
                game.addModel(model);
                assertTrue(game.boundingStructures.has(model.name));
            }
            assertEquals(0, _storage.names.length);
            assertTrue("it is not tried for each", _storage.refusalCount < 8);
        }

        /** The player asks the user at each refusal. */
        [Test]
        public function aFullStorageRefusesOnce():void
        {
            var models:Vector.<Model> = someModels(12);
            newGame(_store).addModel(models[0]);
            _storage.room = 4.5 * _store.length;
            for (var i:int = 1; i < models.length; i++)
            {
                newGame(_store).addModel(models[i]);
            }
            assertTrue("it is full", _storage.names.length > 2);
            assertEquals(1, _storage.refusalCount);
        }

        [Test]
        public function whatIsTooLargeIsRefusedOnce():void
        {
            _storage = new StorageOfSmallEntries();
            _store = new FitStore(1e6, _storage);
            var large:Model = new Model("large", PointSets.cloud(new SeededRandom(21), 1000, 1, 1, 1));
            newGame(_store).addModel(large);
            newGame(_store).addModel(large);
            assertEquals(1, _storage.refusalCount);
        }

        [Test]
        public function anEntryThatTheStorageRefusesCostsNoOther():void
        {
            var models:Vector.<Model> = someModels(4);
            for (var i:int = 0; i < 3; i++)
            {
                newGame(_store).addModel(models[i]);
            }
            _storage.room = 3.9 * _store.length / 3;
            var large:Model = new Model("large", PointSets.cloud(new SeededRandom(21), 3000, 1, 1, 1));
            newGame(_store).addModel(large);
            assertTrue("it is refused", _storage.refusalCount > 0);
            assertEquals("the others stay", 3, _storage.names.length);
            assertEquals("and listed", 3, listedCount());
            _fitter.count = 0;
            newGame(_store).addModel(models[2]);
            newGame(_store).addModel(models[1]);
            assertEquals("whole", 0, _fitter.count);
            newGame(_store).addModel(models[3]);
            _fitter.count = 0;
            newGame(_store).addModel(models[3]);
            assertEquals("smaller ones are still stored", 0, _fitter.count);
        }

        [Test]
        public function anEntryThatIsAlwaysRefusedCostsNoMoreThanItsOwnRoom():void
        {
            _storage = new StorageOfSmallEntries();
            _store = new FitStore(1e6, _storage);
            for each (var model:Model in someModels(30))
            {
                newGame(_store).addModel(model);
            }
            var before:Number = sizeOfEntries();
            newGame(_store).addModel(new Model("large", PointSets.cloud(new SeededRandom(21), 1000, 1, 1, 1)));
            assertTrue("it is refused", _storage.refusalCount > 0);
            assertEquals("the others are listed", sizeOfEntries(), _store.length);
            assertTrue("and most stay", sizeOfEntries() > before - StorageOfSmallEntries.LONGEST - before / 2);
        }

        [Test]
        public function whatWasRefusedIsStoredWhenThereIsRoom():void
        {
            _storage.room = 10;
            newGame(_store).addModel(BuiltInModel.cube());
            assertEquals(0, _storage.names.length);
            _storage.room = Infinity;
            _store.clear();
            newGame(_store).addModel(BuiltInModel.cube());
            assertEquals(1, _storage.names.length);
        }

        /** An entry that is not listed never counts, is never removed to make room, and stays when the store is cleared. */
        [Test]
        public function whereverTheRoomEndsEachEntryIsListed():void
        {
            var models:Vector.<Model> = someModels(5);
            newGame(_store).addModel(models[0]);
            var size:int = _store.length;
            for (var room:int = 0; room < 4 * size; room += 7)
            {
                _storage = new MemoryStorage(room);
                _store = new FitStore(1e6, _storage);
                for each (var model:Model in models.concat(models))
                {
                    newGame(_store).addModel(model);
                    assertEquals("room " + room, sizeOfEntries(), _store.length);
                }
                _store.clear();
                assertEquals("room " + room, 0, sizeOfEntries());
            }
        }

        [Test]
        public function anEntryThatMakesTheListTooLongCostsOnlyTheOldest():void
        {
            var models:Vector.<Model> = someModels(3);
            newGame(_store).addModel(models[0]);
            newGame(_store).addModel(models[1]);
            // another game writes the list as it was before the third entry came
            var before:ByteArray = _storage.read("index");
            newGame(_store).addModel(models[2]);
            _storage.write("index", before);
            _storage.room = sizeOfEntries() + before.length;
            newGame(_store).addModel(models[2]);
            assertEquals(2, listedCount());
            assertEquals(sizeOfEntries(), _store.length);
        }

        [Test]
        public function whatCannotBeReadAgainIsNotStored():void
        {
            _fitter = new CountingFitter(null);
            for each (var hasHierarchy:Boolean in [false, true])
            {
                _storage.writeCount = 0;
                for (var i:int = 0; i < 3; i++)
                {
                    var game:GreatLand = newGame(_store);
                    game.loadHierarchies = hasHierarchy;
                    game.addModel(BuiltInModel.cube());
                }
                assertEquals("its hierarchy alone, once", hasHierarchy ? 1 : 0, _storage.names.length);
                assertEquals(hasHierarchy ? 1 : 0, _storage.writeCount);
            }
        }

        [Test]
        public function aFitMuchLargerThanTheModelIsFoundEachTime():void
        {
            for (var i:int = 0; i < 3; i++)
            {
                var game:GreatLand = new GreatLand();
                game.boundingStructures.fitters = new <Fitter>[new LargeFitter()];
                game.fitStore = _store;
                game.loadHierarchies = false;
                game.addModel(BuiltInModel.cube());
                assertTrue(game.boundingStructures.tightestFit("cube").volume > 1000000);
            }
            assertEquals("its entry, once", 1, _storage.writeCount);
        }

        [Test]
        public function theCallersBytesKeepTheirByteOrder():void
        {
            newGame(_store).addModel(BuiltInModel.cube());
            var settings:FitSettings = settingsOf(newGame(null));
            var bytes:ByteArray = _store.read(BuiltInModel.cube(), settings);
            bytes.endian = Endian.BIG_ENDIAN;
            assertTrue(_store.write(BuiltInModel.cube(), settings, bytes));
            assertEquals(Endian.BIG_ENDIAN, bytes.endian);
        }

        [Test]
        public function anEntryWithoutAHierarchyNeedsLittleRoom():void
        {
            var small:FitStore = new FitStore(900, _storage);
            var model:Model = new Model("large", PointSets.cloud(new SeededRandom(22), 1000, 1, 1, 1));
            for (var i:int = 0; i < 2; i++)
            {
                var game:GreatLand = newGame(small);
                game.loadHierarchies = false;
                game.addModel(model);
            }
            assertEquals(1, _storage.names.length);
            assertEquals("computed once", 1, _fitter.count);
            newGame(small).addModel(model);
            assertEquals("with a hierarchy it is too large", 1, _storage.names.length);
        }

        [Test]
        public function aDamagedListOfEntriesLosesNone():void
        {
            var models:Vector.<Model> = someModels(3);
            for each (var model:Model in models)
            {
                newGame(_store).addModel(model);
            }
            for each (var damage:Function in [clear, truncate, spoil, overwrite])
            {
                damage();
                _fitter.count = 0;
                for each (model in models)
                {
                    newGame(_store).addModel(model);
                }
                assertEquals("they are found all the same", 0, _fitter.count);
                assertTrue("and listed again", listedCount() >= 3);
            }
        }

        [Test]
        public function twoGamesAtOnceLoseAndMixNothing():void
        {
            // what one has written of the list, the other overwrites
            var models:Vector.<Model> = someModels(8);
            for (var i:int = 0; i < models.length; i += 2)
            {
                var before:ByteArray = _storage.read("index");
                newGame(new FitStore(1e6, _storage)).addModel(models[i]);
                if (before != null)
                {
                    _storage.write("index", before);
                }
                newGame(new FitStore(1e6, _storage)).addModel(models[i + 1]);
            }
            assertTrue("the list misses some", listedCount() < 8);
            _fitter.count = 0;
            for each (var model:Model in models)
            {
                var game:GreatLand = newGame(_store);
                game.addModel(model);
                var alone:GreatLand = newGame(null);
                alone.addModel(model);
                assertEquals(LibraryContents.of(alone, model.name), LibraryContents.of(game, model.name));
            }
            assertEquals("none is lost", models.length, _fitter.count);
            assertEquals("and all are listed", 8, listedCount());
        }

        [Test]
        public function theMachinesOwnStorage():void
        {
            var storage:SharedFitStorage = new SharedFitStorage();
            var name:String = "0123456789abcdef0123456789abcdef";
            storage.remove(name);
            assertNull(storage.read(name));
            var bytes:ByteArray = new ByteArray();
            for (var i:int = 0; i < 1000; i++)
            {
                bytes.writeByte(i);
            }
            if (!storage.write(name, bytes))
            {
                // there is none: so it is in Node
                assertNull(storage.read(name));
                return;
            }
            bytes[0] = 77;
            var back:ByteArray = storage.read(name);
            assertEquals(1000, back.length);
            assertEquals("a copy", 0, back[0]);
            assertEquals(999 & 255, back[999]);
            back[1] = 77;
            assertEquals("a copy again", 1, storage.read(name)[1]);
            storage.remove(name);
            assertNull(storage.read(name));
        }

        private function newGame(store:FitStore):GreatLand
        {
            var game:GreatLand = new GreatLand();
            game.boundingStructures.fitters.push(_fitter);
            game.fitStore = store;
            return game;
        }

        private function sizeOfEntries():Number
        {
            var sum:Number = 0;
            for each (var name:String in _storage.names)
            {
                sum += _storage.entries[name].length;
            }
            return sum;
        }

        private static function settingsOf(game:GreatLand):FitSettings
        {
            return new FitSettings(game.boundingStructures, game.hierarchies);
        }

        private static function someModels(count:int):Vector.<Model>
        {
            var models:Vector.<Model> = new Vector.<Model>();
            var random:SeededRandom = new SeededRandom(20);
            for (var i:int = 0; i < count; i++)
            {
                models.push(new Model("model " + i, PointSets.cloud(random, 30, 1, 1, 1)));
            }
            return models;
        }

        private function listedCount():int
        {
            var list:ByteArray = _storage.read("index");
            return list.readUTFBytes(list.length).split("\n").length - 1;
        }

        private function clear():void
        {
            _storage.remove("index");
        }

        private function truncate():void
        {
            _storage.entries["index"].length -= 3;
        }

        private function overwrite():void
        {
            var bytes:ByteArray = new ByteArray();
            for (var i:int = 0; i < 1024; i++)
            {
                bytes.writeByte(255 - i);
            }
            _storage.entries["index"] = bytes;
        }

        private function spoil():void
        {
            _storage.entries["index"][5] ^= 4;
        }
    }
}

import flash.geom.Vector3D;
import flash.utils.ByteArray;
import starlogo.bounding.BoundingStructure;
import starlogo.bounding.Sphere;
import starlogo.fitting.Fit;
import starlogo.fitting.FitSession;
import starlogo.fitting.Fitter;
import support.MemoryStorage;

/** Finds a sphere that is much larger than any model. */
class LargeFitter extends Fitter
{
    /** @inheritDoc */
    override public function get signature():String
    {
        return "large";
    }

    /** @inheritDoc */
    override public function fitting(session:FitSession):Fit
    {
        return new Fit(session, function(session:FitSession):BoundingStructure
            {
                return new Sphere(new Vector3D(), 100);
            });
    }
}

/** Refuses long entries, whatever room there is. */
class StorageOfSmallEntries extends MemoryStorage
{
    public static const LONGEST:int = 1500;

    /** @inheritDoc */
    override public function write(name:String, bytes:ByteArray):Boolean
    {
        if (bytes.length > LONGEST)
        {
            refusalCount++;
            return false;
        }
        return super.write(name, bytes);
    }
}

/** Its copies stand at their end, as bytes do that were just written. */
class StorageOfFreshCopies extends MemoryStorage
{
    /** @inheritDoc */
    override public function read(name:String):ByteArray
    {
        var copy:ByteArray = super.read(name);
        if (copy != null)
        {
            copy.position = copy.length;
        }
        return copy;
    }
}
