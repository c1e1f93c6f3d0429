package support
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;

    /**
     * Reads a file of test/fixtures/pairs: pairs of structures with their exact signed distance. manifest.json beside the
     * files says what is in them.
     */
    public final class PairVectors
    {
        private static const FOLDER:String = "/fixtures/pairs/";

        /** The pair that was read last. */
        public var a:BoundingStructure;

        /** @copy #a */
        public var b:BoundingStructure;

        /** Whether it collides. */
        public var isHit:Boolean;

        /** How far it is apart; below 0, how deep it overlaps. */
        public var distance:Number;

        /** The name of its family. */
        public var family:String;

        private var _entry:Object;
        private var _bytes:ByteArray;
        private var _index:int = 0;
        private var _familyIndex:int = 0;
        private var _readsDoubles:Boolean;

        /**
         * @param name the pair's name in the manifest, such as "sphere-box"
         */
        public function PairVectors(name:String)
        {
            _entry = entryOf(name);
            _bytes = Fixtures.bytes(FOLDER + _entry.file);
            if (_bytes.length != _entry.recordBytes * _entry.count)
            {
                throw new ArgumentError(_entry.file + " has " + _bytes.length + " bytes, not what the manifest says");
            }
            _readsDoubles = _entry.numbers == "float64";
        }

        /** The files that a test of these pairs has to load. */
        public static function fixtures(...names):Array
        {
            var files:Array = [FOLDER + "manifest.json"];
            for each (var name:String in names)
            {
                files.push(FOLDER + name + ".bin");
            }
            return files;
        }

        /** How many pairs there are. */
        public function get count():int
        {
            return _entry.count;
        }

        /** Reads the next pair; false at the end. */
        public function next():Boolean
        {
            if (_index == _entry.count)
            {
                return false;
            }
            var families:Array = _entry.families;
            if (_familyIndex + 1 < families.length && families[_familyIndex + 1][1] <= _index)
            {
                _familyIndex++;
            }
            family = families[_familyIndex][0];
            a = readStructure(_entry.shapes[0]);
            b = readStructure(_entry.shapes[1]);
            distance = _bytes.readDouble();
            isHit = distance <= 0;
            _index++;
            return true;
        }

        private static function entryOf(name:String):Object
        {
            var manifest:Object = JSON.parse(Fixtures.text(FOLDER + "manifest.json"));
            for each (var entry:Object in manifest.files)
            {
                if (entry.name == name)
                {
                    return entry;
                }
            }
            throw new ArgumentError("the manifest has no pairs named " + name);
        }

        private function readStructure(shape:String):BoundingStructure
        {
            switch (shape)
            {
                case "sphere":
                    return new Sphere(readVector(), readNumber());
                case "capsule":
                    return new Capsule(readVector(), readVector(), readNumber());
                case "box":
                    return readBox();
                default:
                    throw new ArgumentError("unknown shape: " + shape);
            }
        }

        private function readBox():Box
        {
            var center:Vector3D = readVector();
            var w:Number = readNumber();
            var x:Number = readNumber();
            var y:Number = readNumber();
            var z:Number = readNumber();
            var length:Number = Math.sqrt(w * w + x * x + y * y + z * z);
            w /= length;
            x /= length;
            y /= length;
            z /= length;
            return new Box(center,
                    new Vector3D(1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)),
                    new Vector3D(2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)),
                    new Vector3D(2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)),
                    readNumber(), readNumber(), readNumber());
        }

        private function readVector():Vector3D
        {
            return new Vector3D(readNumber(), readNumber(), readNumber());
        }

        private function readNumber():Number
        {
            return _readsDoubles ? _bytes.readDouble() : _bytes.readFloat();
        }
    }
}
