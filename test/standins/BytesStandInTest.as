package standins
{
    import flash.errors.EOFError;
    import flash.events.Event;
    import flash.events.IOErrorEvent;
    import flash.events.ProgressEvent;
    import flash.events.TimerEvent;
    import flash.net.URLLoader;
    import flash.net.URLLoaderDataFormat;
    import flash.net.URLRequest;
    import flash.utils.ByteArray;
    import flash.utils.Endian;
    import flash.utils.Timer;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertFalse;
    import org.flexunit.asserts.assertNull;
    import org.flexunit.asserts.assertTrue;
    import org.flexunit.async.Async;
    import org.flexunit.internals.AssumptionViolatedException;
    import standin.Machine;
    import support.assertThrows;

    /**
     * ByteArray and URLLoader as far as the engine uses them: the same calls and results with the player's own classes and, where the
     * engine runs without a player, with what stands in for them there.
     */
    public class BytesStandInTest
    {
        private static const FILE:String = "/assets/palette.mtl";

        private var _bytes:ByteArray;
        private var _events:Array = [];

        [Before]
        public function setUp():void
        {
            _bytes = new ByteArray();
        }

        [Test]
        public function numbersHaveTwoOrders():void
        {
            assertEquals(Endian.BIG_ENDIAN, _bytes.endian);
            _bytes.writeInt(-2);
            _bytes.writeUnsignedInt(0x01020304);
            _bytes.endian = Endian.LITTLE_ENDIAN;
            _bytes.writeShort(-3);
            _bytes.writeFloat(1.1);
            _bytes.writeDouble(1.1);
            _bytes.writeByte(300);
            _bytes.writeBoolean(true);
            assertEquals("255,255,255,254,1,2,3,4,253,255,205,204,140,63,154,153,153,153,153,153,241,63,44,1", listOf(_bytes));
            _bytes.position = 4;
            assertEquals(0x04030201, _bytes.readUnsignedInt());
            assertEquals(0xFFFD, _bytes.readUnsignedShort());
            assertEquals(1.100000023841858, _bytes.readFloat());
            assertEquals(1.1, _bytes.readDouble());
            assertEquals(44, _bytes.readByte());
            assertTrue(_bytes.readBoolean());
            _bytes.endian = Endian.BIG_ENDIAN;
            _bytes.position = 0;
            assertEquals(-2, _bytes.readInt());
            assertEquals(0x01020304, _bytes.readInt());
        }

        [Test]
        public function growsAndShrinks():void
        {
            assertEquals(undefined, _bytes[0]);
            _bytes[3] = 258;
            assertEquals("0,0,0,2", listOf(_bytes));
            assertEquals(0, _bytes.position);
            assertEquals(4, _bytes.bytesAvailable);
            // what was beyond the end comes back in Adobe's VM when writing goes there, and nowhere else
            _bytes[3] = 0;
            _bytes.position = 4;
            _bytes.length = 2;
            assertEquals(2, _bytes.position);
            _bytes.length = 3;
            assertEquals("0,0,0", listOf(_bytes));
            _bytes.position = 5;
            assertEquals(0, _bytes.bytesAvailable);
            _bytes.writeByte(7);
            assertEquals("0,0,0,0,0,7", listOf(_bytes));
        }

        [Test]
        public function readsNothingBeyondTheEnd():void
        {
            _bytes.writeByte(1);
            assertThrows(EOFError, /^Error #2030/, _bytes.readByte);
            assertEquals(1, _bytes.position);
            _bytes.position = 0;
            assertThrows(EOFError, /^Error #2030/, _bytes.readUnsignedShort);
            assertEquals(0, _bytes.position);
        }

        [Test]
        public function copiesBytes():void
        {
            for (var i:int = 0; i < 5; i++)
            {
                _bytes.writeByte(i);
            }
            var copy:ByteArray = new ByteArray();
            copy.writeBytes(_bytes, 3);
            copy.writeBytes(_bytes, 1, 2);
            assertEquals("3,4,1,2", listOf(copy));
            assertEquals(4, copy.position);
        }

        [Test]
        public function textHasEncodings():void
        {
            _bytes.writeUTFBytes("\u00E4\u20AC");
            assertEquals("195,164,226,130,172", listOf(_bytes));
            _bytes.position = 0;
            assertEquals("\u00E4\u20AC", _bytes.readUTFBytes(5));
            assertEquals("", new ByteArray().readUTFBytes(0));
        }

        [Test]
        public function textHasOtherEncodings():void
        {
            // as in Adobe's shell
            _bytes.writeByte(0x61);
            _bytes.position = 0;
            if (_bytes.readMultiByte(1, "iso-8859-1") == "")
            {
                throw new AssumptionViolatedException("readMultiByte does nothing here");
            }
            _bytes.clear();
            _bytes.writeUTFBytes("\u00E4");
            _bytes.position = 0;
            assertEquals("\u00C3\u00A4", _bytes.readMultiByte(2, "iso-8859-1"));
            _bytes.clear();
            _bytes.writeByte(0xE4);
            _bytes.writeByte(0);
            _bytes.position = 0;
            assertEquals("\u00E4", _bytes.readMultiByte(2, "utf-16"));
        }

        [Test(async, timeout="150000")]
        public function loadsAFileWithEvents():void
        {
            var loader:URLLoader = newLoader();
            loader.dataFormat = URLLoaderDataFormat.BINARY;
            Async.handleEvent(this, loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    var bytes:ByteArray = loader.data;
                    assertTrue(bytes.length > 100);
                    assertEquals(0, bytes.position);
                    assertEquals(bytes.length, loader.bytesLoaded);
                    assertEquals(ProgressEvent.PROGRESS, _events[0]);
                    assertEquals(Event.COMPLETE, _events[_events.length - 1]);
                    assertFalse(_events.indexOf(IOErrorEvent.IO_ERROR) >= 0);
                }, 120000);
            loader.load(new URLRequest(FILE));
            assertNull(loader.data);
            assertEquals(0, _events.length);
        }

        [Test(async, timeout="150000")]
        public function loadsText():void
        {
            var loader:URLLoader = newLoader();
            assertEquals(URLLoaderDataFormat.TEXT, loader.dataFormat);
            Async.handleEvent(this, loader, Event.COMPLETE, function(event:Event, data:Object):void
                {
                    assertTrue(loader.data is String);
                    assertTrue(loader.data.indexOf("newmtl") > 0);
                }, 120000);
            loader.load(new URLRequest(FILE));
        }

        [Test(async, timeout="150000")]
        public function saysThatThereIsNoFile():void
        {
            var loader:URLLoader = newLoader();
            Async.handleEvent(this, loader, IOErrorEvent.IO_ERROR, function(event:IOErrorEvent, data:Object):void
                {
                    assertTrue(event.text, event.text.indexOf("Error #2032") == 0);
                    assertFalse(_events.indexOf(Event.COMPLETE) >= 0);
                }, 120000);
            loader.load(new URLRequest("/assets/nothing"));
        }

        [Test(async, timeout="150000")]
        public function saysNothingMoreOnceItIsClosed():void
        {
            // only Adobe's shell names its player; the module's stand-in has no such field
            if ("player" in Machine && Machine["player"] == null)
            {
                throw new AssumptionViolatedException("Ruffle's close() does nothing");
            }
            var loader:URLLoader = newLoader();
            var timer:Timer = new Timer(100, 1);
            loader.addEventListener(ProgressEvent.PROGRESS, function(event:Event):void
                {
                    loader.close();
                    timer.start();
                });
            Async.handleEvent(this, timer, TimerEvent.TIMER_COMPLETE, function(event:Event, data:Object):void
                {
                    assertEquals(ProgressEvent.PROGRESS, _events.join());
                }, 120000);
            loader.load(new URLRequest(FILE));
        }

        private function newLoader():URLLoader
        {
            var loader:URLLoader = new URLLoader();
            for each (var type:String in [ProgressEvent.PROGRESS, Event.COMPLETE, IOErrorEvent.IO_ERROR])
            {
                loader.addEventListener(type, function(event:Event):void
                    {
                        _events.push(event.type);
                    });
            }
            return loader;
        }

        private static function listOf(bytes:ByteArray):String
        {
            var all:Array = [];
            for (var i:int = 0; i < bytes.length; i++)
            {
                all.push(bytes[i]);
            }
            return all.join(",");
        }
    }
}
