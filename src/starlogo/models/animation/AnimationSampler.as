package starlogo.models.animation
{
    import starlogo.data.areFinite;
    import starlogo.data.lastAtMost;
    import starlogo.geometry.Trigonometry;
    import starlogo.models.ModelError;
    import starlogo.models.files.refuseModelIf;

    /**
     * A sampler of an animation: numbers that change with time, as keys and the interpolation between them. The readers of formats make it.
     *
     * @private
     */
    public final class AnimationSampler
    {
        /** The interpolation in a straight line. That of quaternions is along the arc. */
        public static const LINEAR:String = "LINEAR";

        /** The interpolation that stays at a key until the next one. All others are curves. */
        public static const STEP:String = "STEP";

        private static const BISECTIONS:int = 52;

        // Quaternions closer than this are mixed in a straight line: the cosine of half of the angle.
        private static const STRAIGHT:Number = 1 - 1e-9;

        private var _modelName:String;
        private var _place:Object;
        private var _times:Vector.<Number>;
        private var _values:Vector.<Number>;
        private var _interpolations:Array;
        private var _areRotations:Boolean;

        // The control points of curves after each key and before it: a value for each number, or a time and a value. Null if there is no curve.
        private var _outControls:Vector.<Number>;
        private var _inControls:Vector.<Number>;

        /**
         * @param modelName the model's name
         * @param place the keys' place in the file, for errors
         * @param times the time of each key, at least one
         * @param values the numbers of each key
         * @param interpolations from each key to the next; or one for all keys
         * @param outControls the control points of curves after each key: a value for each number, at a third of the time to the next key; or for
         * each number the point's time and its value. Null if there is no curve
         * @param inControls those before each key, in the same form
         * @param areRotations whether each key is a quaternion
         * @throws ModelError if a time is not finite, or the times go back
         */
        public function AnimationSampler(modelName:String, place:Object, times:Vector.<Number>, values:Vector.<Number>, interpolations:Array,
                outControls:Vector.<Number> = null, inControls:Vector.<Number> = null, areRotations:Boolean = false)
        {
            _modelName = modelName;
            _place = place;
            _times = times;
            _values = values;
            _interpolations = interpolations;
            _outControls = outControls;
            _inControls = inControls;
            _areRotations = areRotations;
            for (var i:int = 0; i < times.length; i++)
            {
                if (!isFinite(times[i]) || i > 0 && times[i] < times[i - 1])
                {
                    throw new ModelError(modelName, String(place), "its times must be finite and not go back, but found " + times[i]);
                }
            }
        }

        /** How many numbers a key has. */
        public function get componentCount():int
        {
            return _values.length / _times.length;
        }

        /** The time of the last key. */
        public function get end():Number
        {
            return _times[_times.length - 1];
        }

        /**
         * The numbers at a time, in a new list. Before the first key and after the last one they stay.
         *
         * @param time seconds
         * @throws ModelError if one is not finite
         */
        public function numbersAt(time:Number):Vector.<Number>
        {
            var key:int = lastAtMost(_times, time);
            var next:int = Math.min(key + 1, _times.length - 1);
            var length:Number = _times[next] - _times[key];
            var fraction:Number = time > _times[key] && length > 0 ? (time - _times[key]) / length : 0;
            var interpolation:String = _interpolations[Math.min(key, _interpolations.length - 1)];
            var result:Vector.<Number> = valuesOf(key);
            var isBetween:Boolean = fraction > 0 && interpolation != STEP;
            if (isBetween && interpolation != LINEAR)
            {
                followCurves(result, valuesOf(next), key, fraction);
            }
            else if (isBetween && _areRotations)
            {
                slerp(result, valuesOf(next), fraction);
            }
            else if (isBetween)
            {
                lerp(result, valuesOf(next), fraction);
            }
            refuseModelIf(!areFinite(result), _modelName, "its numbers at " + time + " seconds are not finite", _place);
            return result;
        }

        private function valuesOf(key:int):Vector.<Number>
        {
            return _values.slice(key * componentCount, (key + 1) * componentCount);
        }

        // Interpolates numbers to the next key. By the differences, so that equal numbers stay exactly as they are.
        private static function lerp(numbers:Vector.<Number>, to:Vector.<Number>, fraction:Number):void
        {
            for (var i:int = 0; i < numbers.length; i++)
            {
                numbers[i] += fraction * (to[i] - numbers[i]);
            }
        }

        // Interpolates a quaternion to the next one along the shorter arc.
        private static function slerp(from:Vector.<Number>, to:Vector.<Number>, fraction:Number):void
        {
            // those of integers are rounded
            normaliseQuaternion(from);
            normaliseQuaternion(to);
            var cosine:Number = from[0] * to[0] + from[1] * to[1] + from[2] * to[2] + from[3] * to[3];
            var sign:Number = cosine < 0 ? -1 : 1;
            var ofFrom:Number = 1 - fraction;
            var ofTo:Number = fraction;
            if (sign * cosine < STRAIGHT)
            {
                var sine:Number = Math.sqrt(1 - cosine * cosine);
                var angle:Number = Trigonometry.arctangent(sine, sign * cosine);
                ofFrom = Trigonometry.sine(ofFrom * angle) / sine;
                ofTo = Trigonometry.sine(fraction * angle) / sine;
            }
            for (var i:int = 0; i < 4; i++)
            {
                from[i] = ofFrom * from[i] + sign * ofTo * to[i];
            }
        }

        // Interpolates numbers along the curves from a key to the next one. The parameter of a curve at a time is found by bisection.
        private function followCurves(numbers:Vector.<Number>, to:Vector.<Number>, key:int, fraction:Number):void
        {
            var start:Number = _times[key];
            var length:Number = _times[key + 1] - start;
            var hasTimes:Boolean = _outControls.length > _values.length;
            for (var i:int = 0; i < numbers.length; i++)
            {
                var atKey:int = key * componentCount + i;
                var atNext:int = atKey + componentCount;
                var at:Number = hasTimes ? bezierParameter(fraction, (_outControls[2 * atKey] - start) / length, (_inControls[2 * atNext] - start) / length) : fraction;
                numbers[i] = bezier(numbers[i], _outControls[hasTimes ? 2 * atKey + 1 : atKey], _inControls[hasTimes ? 2 * atNext + 1 : atNext], to[i], at);
            }
        }

        // The parameter of a curve at a time. All times are fractions of the time from key to key. The curve does not go back in time.
        private static function bezierParameter(time:Number, outTime:Number, inTime:Number):Number
        {
            outTime = Math.max(0, Math.min(outTime, 1));
            inTime = Math.max(0, Math.min(inTime, 1));
            var at:Number = 0;
            var step:Number = 0.5;
            for (var i:int = 0; i < BISECTIONS; i++)
            {
                at += bezier(0, outTime, inTime, 1, at + step) <= time ? step : 0;
                step /= 2;
            }
            return at;
        }

        // By the differences from the first number, so that four equal numbers give exactly this number. A matrix keeps its last row.
        private static function bezier(a:Number, b:Number, c:Number, d:Number, at:Number):Number
        {
            var rest:Number = 1 - at;
            return a + 3 * rest * rest * at * (b - a) + 3 * rest * at * at * (c - a) + at * at * at * (d - a);
        }
    }
}
