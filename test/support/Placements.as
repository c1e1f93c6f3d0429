package support
{
    import flash.utils.ByteArray;
    import starlogo.agents.Agent;
    import starlogo.models.ColladaModel;
    import starlogo.models.Model;
    import starlogo.models.ObjModel;

    /**
     * Reads test/fixtures/placements: where pairs of real models stand, and whether their surfaces meet. manifest.json beside
     * it says what is in it.
     */
    public final class Placements
    {
        /** What is read. */
        public static const FIXTURES:Array = ["/fixtures/placements/manifest.json", "/fixtures/placements/placements.bin",
                "/assimp/OBJ/spider.obj", "/assimp/OBJ/WusonOBJ.obj", "/assimp/OBJ/box.obj", "/assimp/Collada/duck.dae",
                "/assimp/Collada/teapot_instancenodes.DAE", "/assimp/Collada/sphere.dae", "/assimp/Collada/human.zae",
                "/models/bunny.obj", "/models/teapot.obj", "/models/dragon4.obj", "/models/dragon3.obj"];

        private static const RECORD_BYTES:int = 60;

        /** How the models are called. */
        public var names:Vector.<String> = new Vector.<String>();

        /** The name of the first model of the placement that was read last. */
        public var nameA:String;

        /** The name of the second model. */
        public var nameB:String;

        /** Whether the surfaces meet. */
        public var surfacesMeet:Boolean;

        /** Whether they do not, but a piece of one is inside of the other. */
        public var isInside:Boolean;

        private var _manifest:Object;
        private var _bytes:ByteArray;

        public function Placements()
        {
            _manifest = JSON.parse(Fixtures.text(FIXTURES[0]));
            _bytes = Fixtures.bytes(FIXTURES[1]);
            for each (var entry:Object in _manifest.models)
            {
                names.push(entry.name);
            }
        }

        /** Where a model is served, from its entry in the manifest. */
        public static function address(source:String, file:String):String
        {
            return (source == "assimp" ? "/assimp/" : "/models/") + file;
        }

        /** How many placements there are. */
        public function get count():int
        {
            return _manifest.count;
        }

        /** Whether a model's file is there. */
        public function hasModel(name:String):Boolean
        {
            var entry:Object = entryOf(name);
            return Fixtures.has(address(entry.source, entry.file));
        }

        /** Reads a model. */
        public function model(name:String):Model
        {
            var entry:Object = entryOf(name);
            var file:String = address(entry.source, entry.file);
            if (/\.obj$/.test(file))
            {
                return new ObjModel(name, Fixtures.text(file), entry.up);
            }
            return ColladaModel.fromBytes(name, Fixtures.bytes(file));
        }

        /** Reads a placement, and puts the agent of its first model and that of the second where it says. */
        public function read(index:int, agentsA:Object, agentsB:Object):void
        {
            _bytes.position = index * RECORD_BYTES;
            nameA = names[_bytes.readUnsignedByte()];
            nameB = names[_bytes.readUnsignedByte()];
            placeAgent(agentsA[nameA]);
            placeAgent(agentsB[nameB]);
            surfacesMeet = _bytes.readUnsignedByte() == 1;
            isInside = _bytes.readUnsignedByte() == 1;
        }

        private function placeAgent(agent:Agent):void
        {
            var x:Number = _bytes.readFloat();
            var y:Number = _bytes.readFloat();
            var z:Number = _bytes.readFloat();
            var heading:Number = _bytes.readFloat();
            var pitch:Number = _bytes.readFloat();
            var roll:Number = _bytes.readFloat();
            var size:Number = _bytes.readFloat();
            if (agent != null)
            {
                agent.moveTo(x, y, z);
                agent.heading = heading;
                agent.pitch = pitch;
                agent.roll = roll;
                agent.size = size;
            }
        }

        private function entryOf(name:String):Object
        {
            for each (var entry:Object in _manifest.models)
            {
                if (entry.name == name)
                {
                    return entry;
                }
            }
            throw new ArgumentError("the manifest has no model named " + name);
        }
    }
}
