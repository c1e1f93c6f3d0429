package support
{
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.convex.RelativeMotion;

    /** Reads a file of test/fixtures/motion, side by side with the pairs that move. manifest.json beside it says what is in it. */
    public final class MotionVectors
    {
        private static const FOLDER:String = "/fixtures/motion/";

        /** The way that was read last, of the pair's first structure. */
        public var way:RelativeMotion = new RelativeMotion();

        /** When they touch first; NaN if they do not. */
        public var time:Number;

        /** How deep they overlap, if at time 0. */
        public var depth:Number;

        /** The normal at that time; NaN where it is not certain. */
        public var normalX:Number;

        /** @copy #normalX */
        public var normalY:Number;

        /** @copy #normalX */
        public var normalZ:Number;

        /** The name of the way's family. */
        public var family:String;

        private var _pairs:PairVectors;
        private var _families:Array;
        private var _bytes:ByteArray;
        private var _index:int = 0;

        /**
         * @param name the pair's name, such as "sphere-box"
         */
        public function MotionVectors(name:String)
        {
            _pairs = new PairVectors(name);
            _families = JSON.parse(Fixtures.text(FOLDER + "manifest.json")).families;
            _bytes = Fixtures.bytes(FOLDER + name + ".bin");
        }

        /** The files that a test of these pairs has to load. */
        public static function fixtures(...names):Array
        {
            var files:Array = PairVectors.fixtures.apply(null, names);
            files.push(FOLDER + "manifest.json");
            for each (var name:String in names)
            {
                files.push(FOLDER + name + ".bin");
            }
            return files;
        }

        /** The pairs that move. */
        public function get pairs():PairVectors
        {
            return _pairs;
        }

        /** The structure that moves. */
        public function get a():BoundingStructure
        {
            return _pairs.a;
        }

        /** The other. */
        public function get b():BoundingStructure
        {
            return _pairs.b;
        }

        /** Reads the next; false at the end. */
        public function next():Boolean
        {
            if (!_pairs.next())
            {
                return false;
            }
            family = _families[_index % _families.length];
            _index++;
            way.startX = _bytes.readFloat();
            way.startY = _bytes.readFloat();
            way.startZ = _bytes.readFloat();
            way.x = _bytes.readFloat();
            way.y = _bytes.readFloat();
            way.z = _bytes.readFloat();
            time = _bytes.readDouble();
            if (time > 1)
            {
                time = NaN;
            }
            depth = _bytes.readDouble();
            normalX = _bytes.readFloat();
            normalY = _bytes.readFloat();
            normalZ = _bytes.readFloat();
            return true;
        }
    }
}
