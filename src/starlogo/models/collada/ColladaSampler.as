package starlogo.models.collada
{
    import starlogo.data.lastNotAfter;
    import starlogo.models.files.shortened;

    /** Numbers over time: the keys of a COLLADA sampler, and what is between them. */
    internal final class ColladaSampler
    {
        private static const INTERPOLATIONS:Array = ["LINEAR", "STEP", "BEZIER"];
        private static const HALVINGS:int = 52;

        /** How many numbers a key has. */
        public var width:int;

        private var _element:ColladaElement;
        private var _times:Vector.<Number>;
        private var _values:Vector.<Number>;

        // The interpolation from each key to the next. Null if all are linear.
        private var _interpolations:Array = null;

        // The control points of curves after each key and before it. Null if there is no curve.
        private var _out:ColladaAccessor = null;
        private var _in:ColladaAccessor = null;

        /**
         * @param sampler the sampler's element
         * @throws ModelError if it is wrong
         */
        public function ColladaSampler(sampler:ColladaElement)
        {
            _element = sampler;
            _times = listOf("INPUT", ColladaAccessor.NUMBERS).numbers;
            var outputs:ColladaAccessor = listOf("OUTPUT", ColladaAccessor.NUMBERS);
            width = outputs.width;
            _values = outputs.numbers;
            requireKeys("OUTPUT", outputs);
            for (var i:int = 1; i < _times.length; i++)
            {
                if (_times[i] < _times[i - 1])
                {
                    throw sampler.error("its times must not go back, but " + _times[i] + " comes after " + _times[i - 1]);
                }
            }
            if (sampler.child("input", "INTERPOLATION") != null)
            {
                readInterpolations(listOf("INTERPOLATION", ColladaAccessor.NAMES));
            }
        }

        /** The time of the last key. */
        public function get end():Number
        {
            return _times[_times.length - 1];
        }

        /** The numbers at a time. Before the first key and after the last one they stay. @throws ModelError if one is not finite */
        public function valueAt(time:Number):Vector.<Number>
        {
            var key:int = lastNotAfter(_times, time);
            var next:int = Math.min(key + 1, _times.length - 1);
            var share:Number = time > _times[key] && next > key ? (time - _times[key]) / (_times[next] - _times[key]) : 0;
            var interpolation:String = _interpolations == null ? "LINEAR" : _interpolations[key];
            var result:Vector.<Number> = new Vector.<Number>(width);
            var differences:Number = 0;
            for (var i:int = 0; i < width; i++)
            {
                var from:Number = _values[key * width + i];
                var to:Number = _values[next * width + i];
                // equal numbers stay exactly as they are
                result[i] = share == 0 || interpolation == "STEP" ? from :
                    (interpolation == "LINEAR" ? from + share * (to - from) : curve(key, i, share, from, to));
                differences += result[i] - result[i];
            }
            _element.refuseIf(differences != 0, "its numbers at " + time + " seconds are not finite");
            return result;
        }

        // A number on the curve from a key to the next one. Where the curve is at a time is found by halving.
        private function curve(key:int, index:int, share:Number, from:Number, to:Number):Number
        {
            var start:Number = _times[key];
            var length:Number = _times[key + 1] - start;
            var out:int = key * width + index;
            var into:int = out + width;
            var hasTimes:Boolean = _out.width > width;
            // the control points' times; the curve does not go back in time
            var first:Number = hasTimes ? inside((_out.numbers[2 * out] - start) / length) : 1 / 3;
            var second:Number = hasTimes ? inside((_in.numbers[2 * into] - start) / length) : 2 / 3;
            var at:Number = 0;
            var step:Number = 0.5;
            for (var i:int = 0; i < HALVINGS; i++)
            {
                at += bezier(0, first, second, 1, at + step) <= share ? step : 0;
                step /= 2;
            }
            return bezier(from, _out.numbers[hasTimes ? 2 * out + 1 : out], _in.numbers[hasTimes ? 2 * into + 1 : into], to, at);
        }

        private static function inside(share:Number):Number
        {
            return Math.max(0, Math.min(share, 1));
        }

        // By the differences from the first number, so that four equal numbers give exactly this number. A matrix keeps its last row.
        private static function bezier(a:Number, b:Number, c:Number, d:Number, at:Number):Number
        {
            var rest:Number = 1 - at;
            return a + 3 * rest * rest * at * (b - a) + 3 * rest * at * at * (c - a) + at * at * at * (d - a);
        }

        private function readInterpolations(list:ColladaAccessor):void
        {
            requireKeys("INTERPOLATION", list);
            _element.refuseIf(list.width != 1, "expected one interpolation for each key");
            for each (var name:String in list.words)
            {
                if (INTERPOLATIONS.indexOf(name) < 0)
                {
                    throw _element.error("expected LINEAR, STEP or BEZIER, but found \"" + shortened(name) + "\"");
                }
            }
            _interpolations = list.words;
            if (list.words.indexOf("BEZIER") >= 0)
            {
                _out = controlPoints("OUT_TANGENT");
                _in = controlPoints("IN_TANGENT");
                _element.refuseIf(_in.width != _out.width, "its tangents are of different kinds");
            }
        }

        // A control point has a time and a value for each number, or the value alone. Then its times are at thirds.
        private function controlPoints(semantic:String):ColladaAccessor
        {
            var list:ColladaAccessor = listOf(semantic, ColladaAccessor.NUMBERS);
            requireKeys(semantic, list);
            _element.refuseIf(list.width != width && list.width != 2 * width, "expected " + width + " or " + 2 * width + " numbers in each " + semantic +
                    ", but found " + list.width);
            return list;
        }

        private function listOf(semantic:String, arrays:Array):ColladaAccessor
        {
            return ColladaAccessor.read(_element, semantic, arrays, _element.parent);
        }

        private function requireKeys(semantic:String, list:ColladaAccessor):void
        {
            _element.refuseIf(list.count != _times.length || list.count == 0, "expected as many of " + semantic + " as of INPUT, at least one, but found " +
                    list.count + " and " + _times.length);
        }
    }
}
