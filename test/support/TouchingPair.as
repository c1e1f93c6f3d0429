package support
{
    import evaluation.pairs.SeededRandom;
    import starlogo.agents.Agent;

    /**
     * Two spheres or cubes, or one of each, whose sizes and positions are decimals, and which touch exactly as far as decimals go: that is right but for the
     * rounding of Numbers. All is counted in whole steps of a fraction of a patch.
     */
    public final class TouchingPair
    {
        /** The names that a pair may have as its shapes. */
        public static const SHAPES:Array = ["sphere", "cube", "sphere and cube"];

        /** Both are such, or the first is a sphere and the second a cube. */
        public var shape:String;

        /** Whether they touch where spheres, cubes and meshes of both do: along an axis, middle to middle. */
        public var isAlongAxis:Boolean;

        /** How far they are apart, in patches, instead of touching. */
        public var gap:Number = 0;

        // steps a patch, of half a size; where the middles are, and the way from a to b
        private var _scale:Number;
        private var _halfA:Number;
        private var _halfB:Number;
        private var _middle:Array;
        private var _way:Array;
        private var _along:Array;
        private var _aside:Array;
        private var _drift:Array;

        /**
         * @param shape one of SHAPES
         * @param offset how far from the origin, in whole patches
         * @param axes along which, of 1 for x, 2 for y and 4 for z
         */
        public function TouchingPair(shape:String, random:SeededRandom, offset:Number = 0, axes:int = 0)
        {
            this.shape = shape;
            var digits:int = random.pick([10, 10, 100]);
            _scale = 2 * digits;
            // 15 is for both of (3, 4, 0) / 5 and (1, 2, 2) / 3
            var reach:Number = 15 * random.integer(1, 4 * digits / 15 + 1);
            _halfA = random.chance() ? reach / 2 : random.integer(1, reach - 1);
            _halfA = Math.floor(_halfA);
            _halfB = reach - _halfA;
            _middle = [];
            for (var k:int = 0; k < 3; k++)
            {
                _middle[k] = random.integer(-20 * digits, 20 * digits) + ((axes >> k) & 1) * offset * _scale;
            }
            choose(random, reach);
            _drift = [random.integer(-90, 90), random.integer(-90, 90), random.integer(-90, 90)];
        }

        /** How large the two are together, in patches. */
        public function get size():Number
        {
            return 2 * Math.max(_halfA, _halfB) / _scale;
        }

        /** The largest coordinate. */
        public function get distance():Number
        {
            return Math.max(Math.abs(_middle[0]), Math.abs(_middle[1]), Math.abs(_middle[2])) / _scale;
        }

        /** Gives two agents their sizes. */
        public function resize(a:Agent, b:Agent):void
        {
            a.shape = shape == "cube" ? "cube" : "sphere";
            b.shape = shape == "sphere" ? "sphere" : "cube";
            a.size = 2 * _halfA / _scale;
            b.size = 2 * _halfB / _scale;
        }

        /**
         * Puts one of the two where it touches the other, or beside that.
         *
         * @param agent goes there
         * @param isB whether it is the second
         * @param along so many times the way between the two is it away from the other
         * @param aside so many times as far as they reach is it beside
         * @param drift so many times a way of its own is it behind
         * @param jumps whether no way leads there
         */
        public function place(agent:Agent, isB:Boolean, along:int, aside:int, drift:int, jumps:Boolean):void
        {
            var sign:int = isB ? 1 : -1;
            var at:Vector.<Number> = new <Number>[0, 0, 0];
            for (var k:int = 0; k < 3; k++)
            {
                var steps:Number = _middle[k] + (isB ? _way[k] : 0) + sign * along * _way[k] + aside * _aside[k] - drift * _drift[k];
                if (k == 2)
                {
                    // agents stand on their feet
                    steps -= isB ? _halfB : _halfA;
                }
                at[k] = steps / _scale;
                if (isB && gap > 0)
                {
                    at[k] += gap * _along[k];
                }
            }
            if (jumps)
            {
                agent.jumpTo(at[0], at[1], at[2]);
            }
            else
            {
                agent.moveTo(at[0], at[1], at[2]);
            }
        }

        /** What it is: how tests name it. */
        public function toString():String
        {
            return shape + " of sizes " + 2 * _halfA / _scale + " and " + 2 * _halfB / _scale + " at " + scaled(_middle) + ", " + scaled(_way) + " apart"
                + (gap > 0 ? " with a gap of " + gap : "");
        }

        private function scaled(steps:Array):String
        {
            return "(" + [steps[0] / _scale, steps[1] / _scale, steps[2] / _scale].join(" ") + ")";
        }

        // Where the second is from the first, and which way is beside both.
        private function choose(random:SeededRandom, reach:Number):void
        {
            var axis:int = random.integer(0, 2);
            var sign:int = random.pick([-1, 1]);
            var kind:int = random.integer(0, shape == "sphere and cube" ? 1 : 2);
            isAlongAxis = kind < 2;
            _way = [0, 0, 0];
            _along = [0, 0, 0];
            _aside = [0, 0, 0];
            _way[axis] = sign * reach;
            _along[axis] = sign;
            _aside[(axis + 1) % 3] = random.pick([-4, 4]) * reach;
            if (!isAlongAxis && shape == "cube")
            {
                // two faces, or edges or corners
                _way[(axis + 1) % 3] = random.pick([-reach, reach, random.integer(-reach, reach)]);
                _way[(axis + 2) % 3] = random.pick([0, -reach, reach, random.integer(-reach, reach)]);
            }
            else if (kind == 2)
            {
                var turned:Array = random.pick([[3, 4, 0, 5], [-4, 3, 0, 5], [0, 3, -4, 5], [4, 0, 3, 5], [1, 2, 2, 3], [-2, 2, 1, 3], [2, -1, 2, 3]]);
                for (var k:int = 0; k < 3; k++)
                {
                    _way[k] = turned[k] * reach / turned[3];
                    _along[k] = turned[k] / turned[3];
                }
                // at right angles to it
                _aside = [[0, -4, 4], [4, 4, 0], [-4, 0, 4], [0, 0, 4], [4, 0, 0], [0, 4, 0]].filter(function(each:Array, ...rest):Boolean
                    {
                        return each[0] * turned[0] + each[1] * turned[1] + each[2] * turned[2] == 0;
                    })[0];
                _aside = [_aside[0] * reach, _aside[1] * reach, _aside[2] * reach];
            }
        }
    }
}
