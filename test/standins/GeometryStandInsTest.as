package standins
{
    import evaluation.pairs.SeededRandom;
    import flash.geom.Matrix3D;
    import flash.geom.Vector3D;
    import flash.utils.ByteArray;
    import org.flexunit.asserts.assertEquals;
    import org.flexunit.asserts.assertTrue;
    import standin.SinglePrecision;
    import standin.flash.geom.Matrix3D;
    import standin.flash.geom.Vector3D;
    import support.Transcript;

    /**
     * The stand-ins for flash.geom, under another package's name, against the player's own: the same seeded calls on both.
     */
    public class GeometryStandInsTest
    {
        private static const PLAYER:Object = {Matrix3D: flash.geom.Matrix3D, Vector3D: flash.geom.Vector3D, isPlayer: true};
        private static const STAND_IN:Object = {Matrix3D: standin.flash.geom.Matrix3D, Vector3D: standin.flash.geom.Vector3D, isPlayer: false};

        // of the larger number, or of 1: other orders of the same sums, and Ruffle's matrices are of single precision
        private static const ROUNDING:Number = 1e-12;
        private static const SINGLE_ROUNDING:Number = 1e-5;

        private var _random:SeededRandom;

        [Before]
        public function seed():void
        {
            standin.flash.geom.Matrix3D.isSingle = false;
        }

        [After]
        public function double():void
        {
            standin.flash.geom.Matrix3D.isSingle = false;
        }

        [Test]
        public function vectors():void
        {
            compare(vectorCalls, ROUNDING, 300);
        }

        [Test]
        public function matrices():void
        {
            compare(matrixCalls, SINGLE_ROUNDING, 300);
        }

        [Test]
        public function partsOfMatrices():void
        {
            compare(partCalls, SINGLE_ROUNDING, 100);
        }

        [Test]
        public function degenerateInput():void
        {
            assertTrue("some throw", compare(degenerateCalls, SINGLE_ROUNDING, 1).thrown > 10);
        }

        private static function moved(axis:standin.flash.geom.Vector3D, degrees:Number, size:Number, x:Number):standin.flash.geom.Matrix3D
        {
            var matrix:standin.flash.geom.Matrix3D = new standin.flash.geom.Matrix3D();
            matrix.appendScale(size, size, 2);
            matrix.appendRotation(degrees, axis);
            matrix.appendTranslation(x, 3, 0);
            return matrix;
        }

        // single precision

        [Test]
        public function singlePrecisionIsThatOfMemory():void
        {
            _random = new SeededRandom(8);
            var ties:int = 0;
            for (var i:int = 0; i < 4000; i++)
            {
                var exponent:int = _random.integer(0, 299) - 160;
                var isTie:Boolean = i % 4 == 0;
                var x:Number = isTie ? Math.floor(_random.between(1 << 23, 1 << 24)) + 0.5 : _random.between(-1, 1);
                assertSingle(x * Math.pow(2, exponent));
                ties += isTie ? 1 : 0;
            }
            assertTrue(ties > 900);
            var largest:Number = Math.pow(2, 128) - Math.pow(2, 104);
            for each (x in [0, -0, 1, -1, NaN, Infinity, -Infinity, largest, -largest, largest + Math.pow(2, 102), largest + Math.pow(2, 103),
                        Math.pow(2, 128), Math.pow(2, -126), Math.pow(2, -149), Math.pow(2, -150), 1.5 * Math.pow(2, -149), -Math.pow(2, -151)])
            {
                assertSingle(x);
            }
        }

        private static function assertSingle(x:Number):void
        {
            var bytes:ByteArray = new ByteArray();
            bytes.writeFloat(x);
            bytes.position = 0;
            var kept:Number = bytes.readFloat();
            var got:Number = SinglePrecision.round(x);
            assertTrue(x + ": " + got + " and " + kept, (got == kept && 1 / got == 1 / kept) || (isNaN(got) && isNaN(kept)));
        }

        [Test]
        public function singleMatricesKeepFloats():void
        {
            standin.flash.geom.Matrix3D.isSingle = true;
            _random = new SeededRandom(9);
            var changed:int = 0;
            for (var i:int = 0; i < 50; i++)
            {
                var matrix:standin.flash.geom.Matrix3D = moved(vector(STAND_IN), _random.between(0, 360), 3, _random.between(-9, 9));
                matrix.invert();
                matrix.append(moved(vector(STAND_IN), 30, 2, 1));
                var points:Vector.<Number> = new <Number>[0.1, 0.2, 0.3];
                matrix.transformVectors(points, points);
                var point:standin.flash.geom.Vector3D = matrix.transformVector(vector(STAND_IN));
                for each (var number:Number in matrix.rawData.concat(points, new <Number>[point.x, point.y, point.z, point.w]))
                {
                    assertEquals(number, SinglePrecision.round(number));
                    changed += number != 0 && number != 1 ? 1 : 0;
                }
            }
            assertTrue(changed > 500);
        }

        // the calls

        private function compare(calls:Function, tolerance:Number, rounds:int):Transcript
        {
            var players:Transcript = new Transcript();
            var ours:Transcript = new Transcript();
            for each (var classes:Object in [PLAYER, STAND_IN])
            {
                _random = new SeededRandom(4);
                for (var i:int = 0; i < rounds; i++)
                {
                    calls(classes, classes.isPlayer ? players : ours);
                }
            }
            assertTrue("calls", ours.length > rounds);
            players.assertAlike(ours, tolerance);
            return ours;
        }

        private function number():Number
        {
            return _random.pick([0, 1, -1, 0.5]) + (_random.integer(0, 2) == 0 ? 0 : _random.between(-4, 4));
        }

        private function vector(of:Object):*
        {
            return new of["Vector3D"](_random.between(-4, 4), _random.between(-4, 4), _random.between(-4, 4), _random.between(-2, 2));
        }

        private function numbers(count:int):Vector.<Number>
        {
            var list:Vector.<Number> = new Vector.<Number>();
            for (var i:int = 0; i < count; i++)
            {
                list.push(number());
            }
            return list;
        }

        private function vectorCalls(of:Object, to:Transcript):void
        {
            var a:* = new of["Vector3D"](number(), number(), number(), number());
            var b:* = new of["Vector3D"](number(), number(), number(), number());
            var s:Number = number();
            to.note("made", [a, b, new of["Vector3D"](), new of["Vector3D"](s), of.Vector3D.X_AXIS, of.Vector3D.Y_AXIS, of.Vector3D.Z_AXIS]);
            to.note("text", [a.toString(), String(b)]);
            to.note("angleBetween", of.Vector3D.angleBetween(a, b));
            to.note("distance", of.Vector3D.distance(a, b));
            to.note("length", [a.length, a.lengthSquared]);
            to.note("add, subtract", [a.add(b), a.subtract(b)]);
            to.note("products", [a.dotProduct(b), a.crossProduct(b)]);
            to.note("equals", [a.equals(b), a.equals(a.clone(), true), a.equals(new of["Vector3D"](a.x, a.y, a.z, s), true)]);
            to.note("nearEquals", [a.nearEquals(b, 1), a.nearEquals(b, 5), a.nearEquals(b, 5, true), a.nearEquals(a, 1, true)]);
            for each (var change:Array in [["incrementBy", b], ["decrementBy", b], ["scaleBy", s], ["copyFrom", b], ["setTo", 1, s, 3],
                        ["negate"], ["project"], ["normalize"]])
            {
                var changed:* = a.clone();
                to.note(change[0], [changed[change[0]].apply(changed, change.slice(1)), changed]);
            }
        }

        private function affine(of:Object):*
        {
            var matrix:* = new of["Matrix3D"]();
            matrix.appendScale(_random.between(0.2, 3), _random.between(0.2, 3), _random.pick([-1, 1, 2.5]));
            matrix.appendRotation(_random.between(-160, 160), vector(of));
            matrix.appendTranslation(number(), number(), number());
            return matrix;
        }

        private function matrixCalls(of:Object, to:Transcript):void
        {
            var matrix:* = _random.chance() ? affine(of) : new of["Matrix3D"](numbers(16));
            var other:* = affine(of);
            to.note("made", [matrix, new of["Matrix3D"](), matrix.position]);
            to.note("determinant", matrix.determinant);
            var axis:* = _random.pick([of.Vector3D.X_AXIS, of.Vector3D.Y_AXIS, of.Vector3D.Z_AXIS, vector(of)]);
            var pivot:* = _random.pick([null, vector(of)]);
            var degrees:Number = _random.pick([0, 90, 180, _random.between(-400, 400)]);
            for each (var change:Array in [["append", other], ["prepend", other], ["append", matrix], ["appendTranslation", 1, 2.5, -3],
                        ["prependTranslation", 1, 2.5, -3], ["appendScale", 2, -0.5, 3], ["prependScale", 2, -0.5, 3],
                        ["appendRotation", degrees, axis, pivot], ["prependRotation", degrees, axis, pivot], ["appendRotation", degrees, axis],
                        ["transpose"], ["copyFrom", other], ["identity"]])
            {
                var changed:* = matrix.clone();
                to.note(change[0], [changed[change[0]].apply(changed, change.slice(1)), changed]);
            }
            var inverse:* = other.clone();
            to.note("invert", [inverse.invert(), inverse]);
            var point:* = vector(of);
            to.note("transformVector", [matrix.transformVector(point), matrix.deltaTransformVector(point)]);
            var points:Vector.<Number> = numbers(_random.integer(0, 11));
            var out:Vector.<Number> = numbers(_random.integer(0, 11));
            to.note("transformVectors", [matrix.transformVectors(points, out), points, out]);
            to.note("in place", [matrix.transformVectors(points, points), points]);
            matrix.position = point;
            to.note("position", matrix);
        }

        private function partCalls(of:Object, to:Transcript):void
        {
            var isTransposed:Boolean = _random.chance();
            var index:int = _random.integer(0, 3);
            var matrix:* = new of["Matrix3D"](numbers(16));
            to.note("copyRawDataFrom", [matrix.copyRawDataFrom(numbers(16 + index), index, isTransposed), matrix]);
            var long:Vector.<Number> = numbers(20);
            to.note("copyRawDataTo", [matrix.copyRawDataTo(long, index, isTransposed), long, matrix]);
            var short:Vector.<Number> = numbers(index);
            to.note("copyRawDataTo a short one", [matrix.copyRawDataTo(short, index), short]);
            var copy:* = new of["Matrix3D"]();
            copy.rawData = numbers(16);
            var raw:Vector.<Number> = copy.rawData;
            raw[0] = 99;
            to.note("rawData", [copy, raw, matrix.clone()]);
        }

        private function degenerateCalls(of:Object, to:Transcript):void
        {
            var none:* = new of["Vector3D"]();
            var matrix:* = affine(of);
            for each (var length:int in [0, 3, 15, 17])
            {
                to.note("made of " + length, new of["Matrix3D"](numbers(length)));
            }
            for each (var change:Array in [["appendRotation", 30, none], ["prependRotation", 30, none, vector(of)],
                        ["appendRotation", NaN, vector(of)], ["appendRotation", 30, new of["Vector3D"](NaN, 0, 0)], ["append", null],
                        ["prepend", null], ["appendRotation", 30, null], ["copyFrom", null], ["copyRawDataFrom", null],
                        ["copyRawDataTo", null], ["copyRawDataFrom", numbers(15)], ["copyRawDataFrom", numbers(18), 3], ["copyRawDataFrom", numbers(2), 3],
                        ["copyRawDataTo", new Vector.<Number>(15, true)], ["appendScale", 0, 1, 1], ["prependScale", 1, 1, 0], ["appendScale", NaN, 1, 1],
                        ["transformVector", null],
                        ["deltaTransformVector", null], ["transformVectors", null, numbers(3)], ["transformVectors", numbers(3), null],
                        ["transformVectors", numbers(6), new Vector.<Number>(3, true)]])
            {
                var changed:* = matrix.clone();
                to.attempt(change[0] + change.slice(1), function():Array
                    {
                        return [changed[change[0]].apply(changed, change.slice(1))];
                    });
                to.note("after " + change[0], changed);
            }
            for each (var short:Vector.<Number> in [null, numbers(3), numbers(17)])
            {
                matrix.rawData = short;
                to.note("rawData of another length", matrix);
            }
            var flat:* = affine(of);
            flat.appendRotation(0, none);
            to.note("a flat one has no inverse", [flat.invert(), flat]);
            var notNumbers:* = new of["Matrix3D"]();
            notNumbers.appendScale(NaN, 1, 1);
            to.note("nor one of no numbers", [notNumbers.invert(), notNumbers]);
            for each (change in [["add", null], ["dotProduct", null], ["crossProduct", null], ["copyFrom", null], ["equals", null]])
            {
                to.attempt("vector " + change, function():*
                    {
                        return none[change[0]].apply(none, change.slice(1));
                    });
            }
            var lost:* = new of["Vector3D"](NaN, 1, 2);
            to.note("no number", [lost.normalize(), lost, lost.equals(lost), none.normalize(), none, String(lost)]);
            none.project();
            to.note("w = 0", none);
        }
    }
}
