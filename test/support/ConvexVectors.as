package support
{
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.convex.ConvexShape;
    import starlogo.convex.RelativeMotion;
    import starlogo.engine;

    use namespace engine;

    /** Reads test/fixtures/convex: pairs of convex shapes of all kinds, with their exact distances and times. manifest.json says what is in it. */
    public final class ConvexVectors
    {
        /** The files that a test of these pairs has to load. */
        public static const FIXTURES:Array = ["/fixtures/convex/manifest.json", "/fixtures/convex/pairs.bin"];

        /** The pair that was read last. */
        public var a:ConvexShape;

        /** @copy #a */
        public var b:ConvexShape;

        /** The signed distance: below 0 the depth. */
        public var distance:Number;

        /** The motion of a. */
        public var motion:RelativeMotion = new RelativeMotion(0);

        /** The earliest and the latest time that is right for the first touch; 2 if there is none. */
        public var earliest:Number;

        /** @copy #earliest */
        public var latest:Number;

        /** The name of the family, and a text that says which pair it is. */
        public var family:String;

        /** @copy #family */
        public var what:String;

        /** The pair's place in the file, from 0. */
        public var index:int = -1;

        private var _manifest:Object;
        private var _bytes:ByteArray;

        public function ConvexVectors()
        {
            _manifest = JSON.parse(Fixtures.text(FIXTURES[0]));
            _bytes = Fixtures.bytes(FIXTURES[1]);
        }

        /** The families' names, and the counts of their pairs. */
        public function get families():Array
        {
            return _manifest.families;
        }

        /** Reads the next pair; false at the end. */
        public function next():Boolean
        {
            if (_bytes.bytesAvailable == 0)
            {
                return false;
            }
            index++;
            family = families[_bytes.readUnsignedByte()].name;
            var kindA:String = _manifest.kinds[_bytes.readUnsignedByte()];
            var countA:int = _bytes.readUnsignedByte();
            var kindB:String = _manifest.kinds[_bytes.readUnsignedByte()];
            var countB:int = _bytes.readUnsignedByte();
            what = family + ", " + kindA + "-" + kindB + ", pair " + index;
            a = shapeOf(kindA, readNumbers(countA));
            b = shapeOf(kindB, readNumbers(countB));
            distance = _bytes.readDouble();
            motion.startX = _bytes.readFloat();
            motion.startY = _bytes.readFloat();
            motion.startZ = _bytes.readFloat();
            motion.x = _bytes.readFloat();
            motion.y = _bytes.readFloat();
            motion.z = _bytes.readFloat();
            earliest = _bytes.readDouble();
            latest = _bytes.readDouble();
            return true;
        }

        private function readNumbers(count:int):Vector.<Number>
        {
            var numbers:Vector.<Number> = new Vector.<Number>(count);
            for (var i:int = 0; i < count; i++)
            {
                numbers[i] = _bytes.readDouble();
            }
            return numbers;
        }

        private static function shapeOf(kind:String, n:Vector.<Number>):ConvexShape
        {
            var shape:ConvexShape = new ConvexShape();
            switch (kind)
            {
                case "sphere":
                    new Sphere(vector(n, 0), n[3]).setShape(shape);
                    break;
                case "capsule":
                    new Capsule(vector(n, 0), vector(n, 3), n[6]).setShape(shape);
                    break;
                case "box":
                    new Box(vector(n, 0), vector(n, 3), vector(n, 6), vector(n, 9), n[12], n[13], n[14]).setShape(shape);
                    break;
                case "triangle":
                    shape.setTriangle(n, 0);
                    break;
                case "hull":
                    assertEquals("corners", n.length / 3 - 1, setHull(shape, vector(n, 0), n.slice(3)));
                    break;
                default:
                    throw new ArgumentError("unknown kind: " + kind);
            }
            return shape;
        }

        private static function vector(numbers:Vector.<Number>, at:int):Vector3D
        {
            return new Vector3D(numbers[at], numbers[at + 1], numbers[at + 2]);
        }
    }
}
