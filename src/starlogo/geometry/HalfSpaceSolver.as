package starlogo.geometry
{
    import flash.geom.Vector3D;

    /**
     * Finds the shortest displacement of a point out of half-spaces. A half-space requires that it goes at least a depth along its normal, so
     * a depth that is not greater than 0 requires none.
     *
     * <p>The shortest displacement ends on the planes of no half-space, or of one, two or three of them. It tries all of these. This takes few steps,
     * because a body touches few surfaces at once.</p>
     *
     * @private
     */
    public final class HalfSpaceSolver
    {
        // Two planes are parallel if the squared sine of their angle is less than this. Three have no common point if the squared volume of
        // their normals is.
        private static const DEGENERATE:Number = Tolerances.NEARLY_PARALLEL;

        // How much less than required a displacement may go along a normal, as a fraction of its length, because of rounding.
        private static const RELATIVE_SLACK:Number = 1e-12;

        /** The number of half-spaces. */
        public var count:int = 0;

        // By half-space: the normal, and the depth.
        private var _xs:Vector.<Number> = new Vector.<Number>();
        private var _ys:Vector.<Number> = new Vector.<Number>();
        private var _zs:Vector.<Number> = new Vector.<Number>();
        private var _depths:Vector.<Number> = new Vector.<Number>();

        // How much less than required every displacement may go, and the one that is tried.
        private var _slack:Number = 0;
        private var _tried:Vector3D = new Vector3D();

        /** Begins without half-spaces. */
        public function begin():void
        {
            count = 0;
        }

        /** Adds a half-space: a unit normal, and the depth along it. */
        public function add(x:Number, y:Number, z:Number, depth:Number):void
        {
            _xs[count] = x;
            _ys[count] = y;
            _zs[count] = z;
            _depths[count] = depth;
            count++;
        }

        /** Writes a half-space as four numbers: its normal, and the depth. */
        public function write(index:int, out:Vector.<Number>, at:int):void
        {
            out[at] = _xs[index];
            out[int(at + 1)] = _ys[index];
            out[int(at + 2)] = _zs[index];
            out[int(at + 3)] = _depths[index];
        }

        /**
         * Finds the shortest displacement.
         *
         * @param mostDeciding on how many planes it may end, from 1 to 3
         * @param slack how much less than required it may go along each normal
         * @param out receives it
         * @return whether there is one
         */
        public function solve(mostDeciding:int, slack:Number, out:ShortestExit):Boolean
        {
            _slack = slack;
            out.length = Infinity;
            out.deciding = 0;
            out.last = -1;
            _tried.setTo(0, 0, 0);
            if (leadsOut(0))
            {
                out.displacement.setTo(0, 0, 0);
                out.length = 0;
                return true;
            }
            for (var i:int = 0; i < count; i++)
            {
                _tried.setTo(_depths[i] * _xs[i], _depths[i] * _ys[i], _depths[i] * _zs[i]);
                keepShorter(1, i, 0, 0, out);
            }
            for (i = 1; i < count && mostDeciding > 1; i++)
            {
                for (var j:int = 0; j < i; j++)
                {
                    meetTwo(j, i, out);
                    for (var k:int = 0; k < j && mostDeciding > 2; k++)
                    {
                        meetThree(k, j, i, out);
                    }
                }
            }
            return out.length < Infinity;
        }

        // Tries the point of two planes that is nearest.
        private function meetTwo(i:int, j:int, out:ShortestExit):void
        {
            var cosine:Number = _xs[i] * _xs[j] + _ys[i] * _ys[j] + _zs[i] * _zs[j];
            var squaredSine:Number = 1 - cosine * cosine;
            if (squaredSine > DEGENERATE)
            {
                var first:Number = (_depths[i] - cosine * _depths[j]) / squaredSine;
                var second:Number = (_depths[j] - cosine * _depths[i]) / squaredSine;
                _tried.setTo(first * _xs[i] + second * _xs[j], first * _ys[i] + second * _ys[j], first * _zs[i] + second * _zs[j]);
                keepShorter(2, j, i, 0, out);
            }
        }

        // Tries the point of three planes.
        private function meetThree(i:int, j:int, k:int, out:ShortestExit):void
        {
            var volume:Number = _xs[i] * (_ys[j] * _zs[k] - _zs[j] * _ys[k]) + _ys[i] * (_zs[j] * _xs[k] - _xs[j] * _zs[k])
                + _zs[i] * (_xs[j] * _ys[k] - _ys[j] * _xs[k]);
            if (volume * volume > DEGENERATE)
            {
                _tried.setTo(0, 0, 0);
                addCross(_depths[i] / volume, j, k);
                addCross(_depths[j] / volume, k, i);
                addCross(_depths[k] / volume, i, j);
                keepShorter(3, k, j, i, out);
            }
        }

        // Adds a multiple of the cross product of two normals.
        private function addCross(factor:Number, i:int, j:int):void
        {
            _tried.x += factor * (_ys[i] * _zs[j] - _zs[i] * _ys[j]);
            _tried.y += factor * (_zs[i] * _xs[j] - _xs[i] * _zs[j]);
            _tried.z += factor * (_xs[i] * _ys[j] - _ys[i] * _xs[j]);
        }

        // Keeps the displacement that is tried if it is shorter and leads out of all half-spaces.
        private function keepShorter(deciding:int, last:int, second:int, third:int, out:ShortestExit):void
        {
            var length:Number = Math.sqrt(_tried.x * _tried.x + _tried.y * _tried.y + _tried.z * _tried.z);
            if (length < out.length && leadsOut(length))
            {
                out.displacement.copyFrom(_tried);
                out.length = length;
                out.deciding = deciding;
                out.last = last;
                out.second = second;
                out.third = third;
            }
        }

        private function leadsOut(length:Number):Boolean
        {
            var slack:Number = _slack + RELATIVE_SLACK * length;
            for (var i:int = 0; i < count; i++)
            {
                if (_tried.x * _xs[i] + _tried.y * _ys[i] + _tried.z * _zs[i] < _depths[i] - slack)
                {
                    return false;
                }
            }
            return true;
        }
    }
}
