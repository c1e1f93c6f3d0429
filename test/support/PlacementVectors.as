package support
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;

    /**
     * Pairs of real models that stand in the world somehow, and whether their surfaces meet (test/oracle/placements.py).
     * The manifest beside the records describes them.
     */
    public final class PlacementVectors
    {
        /** What a test that reads them has to list in its FIXTURES, RealModels' apart. */
        public static const FIXTURES:Array = ["/fixtures/placements/manifest.json", "/fixtures/placements/placements.bin"];

        /** The names of the models. */
        public var models:Vector.<String> = new Vector.<String>();

        /** How many pairs there are. */
        public var count:int;

        /** The first agent of the pair that was read last. */
        public var a:Agent;

        /** The second agent. */
        public var b:Agent;

        /** Whether a triangle of one meets a triangle of the other. */
        public var surfacesMeet:Boolean;

        /** Whether the surfaces do not meet, but a piece of one is inside of the other. */
        public var isInside:Boolean;

        private var _manifest:Object;
        private var _records:ByteArray;
        private var _agentsA:Vector.<Agent> = new Vector.<Agent>();
        private var _agentsB:Vector.<Agent> = new Vector.<Agent>();

        public function PlacementVectors()
        {
            _manifest = JSON.parse(Fixtures.text(FIXTURES[0]));
            _records = Fixtures.bytes(FIXTURES[1]);
            count = _manifest.count;
            for each (var model:Object in _manifest.models)
            {
                models.push(model.name);
                _agentsA.push(new Agent(model.name));
                _agentsB.push(new Agent(model.name));
            }
        }

        /** Reads a pair: its agents are those of all pairs of these models. */
        public function read(index:int):void
        {
            _records.position = index * _manifest.recordBytes;
            a = _agentsA[_records.readUnsignedByte()];
            b = _agentsB[_records.readUnsignedByte()];
            readTraits(a);
            readTraits(b);
            surfacesMeet = _records.readBoolean();
            isInside = _records.readBoolean();
        }

        private function readTraits(agent:Agent):void
        {
            var x:Number = _records.readFloat();
            var y:Number = _records.readFloat();
            var z:Number = _records.readFloat();
            agent.moveTo(x, y, z);
            agent.heading = _records.readFloat();
            agent.pitch = _records.readFloat();
            agent.roll = _records.readFloat();
            agent.size = _records.readFloat();
        }
    }
}
