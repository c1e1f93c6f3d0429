package starlogo.collision.snapshots
{
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertNotNull;
    import starlogo.agents.Agent;
    import support.assertThrows;

    /** A snapshot's standings: each number that no game can have is refused. */
    public class SnapshotPlatformsTest
    {
        private static const AGENTS:int = 2;

        private var _agents:Vector.<Agent> = new <Agent>[new Agent("sphere"), new Agent("cube")];

        // Where the parts of a standing are: the number of standings, two indices, two places, a size, a rotation.
        private static const WALKER:int = 4;
        private static const ON:int = 8;
        private static const AT:int = 12;
        private static const BELOW:int = 36;
        private static const SIZE:int = 60;
        private static const ROTATION:int = 68;

        [Test]
        public function takesWhatAgentsCanHave():void
        {
            assertNotNull(SnapshotPlatforms.read(standing(), _agents));
            for each (var size:Number in [Agent.SMALLEST_SIZE, 1, Agent.LARGEST_SIZE])
            {
                assertNotNull("size " + size, SnapshotPlatforms.read(standing(SIZE, size), _agents));
            }
        }

        [Test]
        public function refusesNumbersThatNoAgentCanHave():void
        {
            var noPlace:Array = [NaN, Infinity, -2 * Agent.LARGEST_COORDINATE];
            var refused:Array = [[AT, noPlace], [AT + 8, noPlace], [AT + 16, noPlace], [BELOW, noPlace], [BELOW + 8, noPlace], [BELOW + 16, noPlace],
                    [SIZE, [NaN, Infinity, 0, -1, 0.5 * Agent.SMALLEST_SIZE, 2 * Agent.LARGEST_SIZE]], [ROTATION, [NaN, 0, 2, -1]]];
            for each (var each:Array in refused)
            {
                for each (var value:Number in each[1])
                {
                    assertThrows(RangeError, /place is not allowed/, SnapshotPlatforms.read, standing(each[0], value), _agents);
                }
            }
        }

        [Test]
        public function refusesIndicesAndCountsThatAreNotThere():void
        {
            for each (var each:Array in [[0, 2], [0, 3], [0, -1], [WALKER, AGENTS], [WALKER, 1], [WALKER, -1], [ON, AGENTS], [ON, 0]])
            {
                var bytes:ByteArray = standing();
                bytes.position = each[0];
                bytes.writeInt(each[1]);
                bytes.position = 0;
                // the bytes end before a standing that is counted
                assertThrows(each[0] == 0 ? Error : RangeError, "", SnapshotPlatforms.read, bytes, _agents);
            }
        }

        // The first agent stands on the second. The number at a place is another one.
        private static function standing(at:int = SIZE, value:Number = 2):ByteArray
        {
            var bytes:ByteArray = new ByteArray();
            for each (var index:int in [1, 0, 1])
            {
                bytes.writeInt(index);
            }
            for each (var number:Number in [3, 4, 5, 3, 4, 4, 2, 1, 0, 0, 0, 1, 0, 0, 0, 1])
            {
                bytes.writeDouble(number);
            }
            bytes.position = at;
            bytes.writeDouble(value);
            bytes.position = 0;
            return bytes;
        }
    }
}
