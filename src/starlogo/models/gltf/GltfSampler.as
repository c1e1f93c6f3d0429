package starlogo.models.gltf
{
    import starlogo.data.lastNotAfter;
    import starlogo.geometry.Trigonometry;
    import starlogo.steps.StepSequence;

    /** A property of a node over time: the keys of an animation's sampler, and what is between them. */
    internal final class GltfSampler extends StepSequence
    {
        private static const INTERPOLATIONS:Array = ["LINEAR", "STEP", "CUBICSPLINE"];
        private static const LINEAR:int = 0;
        private static const CUBIC:int = 2;

        // Quaternions closer than this are mixed in a straight line: the cosine of half of the angle.
        private static const STRAIGHT:Number = 1 - 1e-9;

        private var _times:GltfAccessor;
        private var _values:GltfAccessor;
        private var _interpolation:int;
        private var _isRotation:Boolean;

        /**
         * @param file the file
         * @param sampler the sampler
         * @param path "translation", "rotation", "scale" or "weights"
         */
        public function GltfSampler(file:GltfFile, sampler:GltfJson, path:String)
        {
            var input:int = sampler.reference("input", "accessors");
            var output:int = sampler.reference("output", "accessors");
            sampler.refuseIf(input < 0 || output < 0, "expected input and output");
            _interpolation = sampler.has("interpolation") ? INTERPOLATIONS.indexOf(sampler.value.interpolation) : LINEAR;
            sampler.refuseIf(_interpolation < 0, "expected LINEAR, STEP or CUBICSPLINE", "interpolation");
            _isRotation = path == "rotation";
            _times = file.accessor(input, "SCALAR");
            _values = file.accessor(output, path == "weights" ? "SCALAR" : (_isRotation ? "VEC4" : "VEC3"));
            var perKey:int = _interpolation == CUBIC ? 3 : 1;
            var wanted:Number = Number(_times.count) * perKey;
            _values.json.refuseIf(_times.count == 0 || _values.count < wanted || _values.count % wanted != 0 || path != "weights" && _values.count != wanted,
                    "it has " + _values.count + " elements for " + _times.count + " keys");
            file.limits.countNumbers(_times.count, sampler.place);
            add(_times).add(_values).call(checkTimes);
        }

        /** The time of the last key. */
        public function get end():Number
        {
            return _times.numbers[int(_times.count - 1)];
        }

        /** The value at a time, in seconds. Before the first key and after the last one it stays. @throws ModelError if it is not finite */
        public function valueAt(time:Number):Vector.<Number>
        {
            var times:Vector.<Number> = _times.numbers;
            var last:int = _times.count - 1;
            var low:int = lastNotAfter(times, time);
            var next:int = low < last ? low + 1 : last;
            var length:Number = times[next] - times[low];
            var share:Number = time > times[low] && length > 0 ? (time - times[low]) / length : 0;
            var value:Vector.<Number> = _interpolation == CUBIC ? cubic(low, next, share, length) : (_interpolation == LINEAR ? linear(low, next, share) : partOfKey(low, 0));
            var differences:Number = 0;
            for each (var number:Number in value)
            {
                differences += number - number;
            }
            _values.json.refuseIf(differences != 0, "its numbers at " + time + " seconds are not finite");
            if (_isRotation)
            {
                normalise(value);
            }
            return value;
        }

        private function checkTimes():void
        {
            var before:Number = -Infinity;
            for each (var time:Number in _times.numbers)
            {
                if (!(time >= before && time - time == 0))
                {
                    throw _times.json.error("its times must be finite and not go back, but found " + time);
                }
                before = time;
            }
        }

        // A part of a key: 0 the value; of a cubic spline 0 the tangent before it, 1 the value, 2 the tangent after it.
        private function partOfKey(key:int, part:int):Vector.<Number>
        {
            var width:int = _values.numbers.length / _times.count;
            var length:int = _interpolation == CUBIC ? width / 3 : width;
            var from:int = key * width + part * length;
            return _values.numbers.slice(from, from + length);
        }

        private function linear(low:int, high:int, share:Number):Vector.<Number>
        {
            var a:Vector.<Number> = partOfKey(low, 0);
            var b:Vector.<Number> = partOfKey(high, 0);
            var ofA:Number = 1 - share;
            var ofB:Number = share;
            if (_isRotation)
            {
                // those of integers are rounded
                normalise(a);
                normalise(b);
                var cosine:Number = a[0] * b[0] + a[1] * b[1] + a[2] * b[2] + a[3] * b[3];
                var sign:Number = cosine < 0 ? -1 : 1;
                if (sign * cosine < STRAIGHT)
                {
                    var sine:Number = Math.sqrt(1 - cosine * cosine);
                    var angle:Number = Trigonometry.arctangent(sine, sign * cosine);
                    ofA = Trigonometry.sine(ofA * angle) / sine;
                    ofB = Trigonometry.sine(share * angle) / sine;
                }
                ofB *= sign;
            }
            for (var i:int = 0; i < a.length; i++)
            {
                a[i] = ofA * a[i] + ofB * b[i];
            }
            return a;
        }

        // The Hermite spline of the glTF specification, appendix C.
        private function cubic(low:int, high:int, share:Number, length:Number):Vector.<Number>
        {
            var a:Vector.<Number> = partOfKey(low, 1);
            var b:Vector.<Number> = partOfKey(high, 1);
            var out:Vector.<Number> = partOfKey(low, 2);
            var into:Vector.<Number> = partOfKey(high, 0);
            var square:Number = share * share;
            var cube:Number = square * share;
            for (var i:int = 0; i < a.length; i++)
            {
                a[i] = (2 * cube - 3 * square + 1) * a[i] + length * (cube - 2 * square + share) * out[i]
                    + (3 * square - 2 * cube) * b[i] + length * (cube - square) * into[i];
            }
            return a;
        }

        private static function normalise(turn:Vector.<Number>):void
        {
            var length:Number = Math.sqrt(turn[0] * turn[0] + turn[1] * turn[1] + turn[2] * turn[2] + turn[3] * turn[3]);
            for (var i:int = 0; i < 4 && length > 0; i++)
            {
                turn[i] /= length;
            }
        }
    }
}
