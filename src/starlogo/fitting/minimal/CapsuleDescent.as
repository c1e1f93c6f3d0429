package starlogo.fitting.minimal
{
    import starlogo.bounding.Capsule;
    import starlogo.steps.StepSequence;

    /**
     * Descends from a capsule to a smaller one: it moves the ends until no small move makes the capsule smaller while it encloses all points.
     * Each step is a move. It is a part of CapsuleSearch.
     *
     * <p>The volume is a smooth function of the ends' six coordinates and the radius. But the radius is the largest of many distances, so
     * it is not smooth. Each step replaces the distances and the volume by their tangents. It finds the best change that keeps the points
     * inside that are nearly the farthest. The length of the change has a price. If the true volume shrinks, the change is kept. If not,
     * the price goes up (the minimax method of Pshenichny and Danilin, "Numerical Methods in Extremal Problems", 1978). The small
     * quadratic program is solved in its dual, one multiplier after the other (Hildreth, "A Quadratic Programming Procedure", Naval
     * Research Logistics Quarterly 4(1), 1957).</p>
     *
     * @private
     */
    public final class CapsuleDescent extends StepSequence
    {
        // The most moves, the step size at which the descent ends, and the most rounds over the multipliers in a move.
        private static const MAX_MOVES:int = 60;
        private static const SMALLEST_STEP:Number = 1e-7;
        private static const MAX_ROUNDS:int = 60;

        // A point cannot matter in one step if its distance is less than the radius by more than this share of the radius.
        private static const ACTIVE:Number = 0.15;
        private static const MAX_ACTIVE:int = 48;

        // After a move that gains less than this share of the volume, the steps become smaller.
        private static const GAIN:Number = 1e-7;

        /** The ends so far, x, y, z of each. */
        public var ends:Vector.<Number>;

        /** The radius so far: the largest distance of a point from the segment. */
        public var radius:Number;

        private var _points:Vector.<Number>;

        /**
         * @param points x, y, z of each
         * @param start a capsule
         */
        public function CapsuleDescent(points:Vector.<Number>, start:Capsule)
        {
            _points = points;
            ends = new <Number>[start.start.x, start.start.y, start.start.z, start.end.x, start.end.y, start.end.z];
            radius = radiusOf(squaresFrom(ends));
            var stepSize:Number = 0.1;
            var moveCount:int = 0;
            repeat(function():Boolean
                {
                    stepSize = move(stepSize);
                    moveCount++;
                    return moveCount < MAX_MOVES && stepSize > SMALLEST_STEP;
                });
        }

        // Moves the ends if that makes the capsule smaller. Returns the step size for the next move.
        private function move(stepSize:Number):Number
        {
            var trial:Vector.<Number> = solve(ends, radius, tangents(), stepSize);
            for (var i:int = 0; i < 6; i++)
            {
                trial[i] += ends[i];
            }
            var trialRadius:Number = radiusOf(squaresFrom(trial));
            var volume:Number = volumeOf(ends, radius);
            var trialVolume:Number = volumeOf(trial, trialRadius);
            if (!(trialVolume < volume))
            {
                return 0.3 * stepSize;
            }
            radius = trialRadius;
            ends = trial;
            return (trialVolume < volume * (1 - GAIN) ? 2 : 0.5) * stepSize;
        }

        private static function volumeOf(ends:Vector.<Number>, radius:Number):Number
        {
            return Math.PI * radius * radius * (lengthOf(ends) + 4 / 3 * radius);
        }

        private static function lengthOf(ends:Vector.<Number>):Number
        {
            var x:Number = ends[3] - ends[0];
            var y:Number = ends[4] - ends[1];
            var z:Number = ends[5] - ends[2];
            return Math.sqrt(x * x + y * y + z * z);
        }

        // The squared distance of each point from the segment between two ends.
        private function squaresFrom(ends:Vector.<Number>):Vector.<Number>
        {
            var startX:Number = ends[0];
            var startY:Number = ends[1];
            var startZ:Number = ends[2];
            var alongX:Number = ends[3] - startX;
            var alongY:Number = ends[4] - startY;
            var alongZ:Number = ends[5] - startZ;
            var lengthSquared:Number = alongX * alongX + alongY * alongY + alongZ * alongZ;
            var scale:Number = lengthSquared > 0 ? 1 / lengthSquared : 0;
            var count:int = _points.length / 3;
            var squares:Vector.<Number> = new Vector.<Number>(count);
            for (var i:int = 0; i < count; i++)
            {
                var at:int = 3 * i;
                var x:Number = _points[at] - startX;
                var y:Number = _points[at + 1] - startY;
                var z:Number = _points[at + 2] - startZ;
                var t:Number = (x * alongX + y * alongY + z * alongZ) * scale;
                t = t < 0 ? 0 : (t > 1 ? 1 : t);
                x -= t * alongX;
                y -= t * alongY;
                z -= t * alongZ;
                squares[i] = x * x + y * y + z * z;
            }
            return squares;
        }

        private static function radiusOf(squares:Vector.<Number>):Number
        {
            var most:Number = 0;
            for each (var square:Number in squares)
            {
                most = square > most ? square : most;
            }
            return Math.sqrt(most);
        }

        // Eight numbers for each point that may become the farthest: the tangent of its distance minus the radius, by the ends' coordinates
        // and the radius; then the radius minus its distance.
        private function tangents():Vector.<Number>
        {
            var found:Vector.<Number> = new Vector.<Number>();
            var squares:Vector.<Number> = squaresFrom(ends);
            var least:Number = activeFrom(squares);
            var alongX:Number = ends[3] - ends[0];
            var alongY:Number = ends[4] - ends[1];
            var alongZ:Number = ends[5] - ends[2];
            var square:Number = alongX * alongX + alongY * alongY + alongZ * alongZ;
            for (var i:int = 0; i < squares.length; i++)
            {
                if (squares[i] < least || squares[i] == 0)
                {
                    continue;
                }
                var x:Number = _points[3 * i] - ends[0];
                var y:Number = _points[3 * i + 1] - ends[1];
                var z:Number = _points[3 * i + 2] - ends[2];
                var t:Number = square > 0 ? (x * alongX + y * alongY + z * alongZ) / square : 0;
                t = t < 0 ? 0 : (t > 1 ? 1 : t);
                var distance:Number = Math.sqrt(squares[i]);
                // Moving the segment's nearest point towards the point shortens the distance.
                x = (t * alongX - x) / distance;
                y = (t * alongY - y) / distance;
                z = (t * alongZ - z) / distance;
                found.push((1 - t) * x, (1 - t) * y, (1 - t) * z, t * x, t * y, t * z, -1, radius - distance);
            }
            return found;
        }

        // The smallest squared distance of an active point. It is increased if too many points are active.
        private function activeFrom(squares:Vector.<Number>):Number
        {
            var fraction:Number = ACTIVE;
            do
            {
                var least:Number = radius * (1 - fraction);
                least *= least;
                var count:int = 0;
                for (var i:int = 0; i < squares.length; i++)
                {
                    count += squares[i] >= least ? 1 : 0;
                }
                fraction /= 2;
            }
            while (count > MAX_ACTIVE && fraction > 1e-4);
            return least;
        }

        // Returns the change of the ends' coordinates and the radius that minimises gradient * change + |change|^2 / (2 stepSize), with
        // tangents * change <= room. The units are the radius and its derivative, so that the step size is a share of the radius for models of
        // any size.
        private static function solve(ends:Vector.<Number>, radius:Number, tangents:Vector.<Number>, stepSize:Number):Vector.<Number>
        {
            var change:Vector.<Number> = new Vector.<Number>(7);
            var gradient:Vector.<Number> = gradientOfVolume(ends, radius);
            var scale:Number = stepSize * radius / gradient[6];
            var i:int;
            var k:int;
            for (k = 0; k < 7; k++)
            {
                change[k] = -scale * gradient[k];
            }
            var count:int = tangents.length / 8;
            var multipliers:Vector.<Number> = new Vector.<Number>(count);
            for (var round:int = 0; round < MAX_ROUNDS; round++)
            {
                var most:Number = 0;
                for (i = 0; i < count; i++)
                {
                    var at:int = 8 * i;
                    var excess:Number = -tangents[at + 7];
                    var square:Number = 0;
                    for (k = 0; k < 7; k++)
                    {
                        var tangent:Number = tangents[at + k];
                        excess += tangent * change[k];
                        square += tangent * tangent;
                    }
                    var multiplier:Number = multipliers[i] + excess / square;
                    multiplier = multiplier < 0 ? 0 : multiplier;
                    var difference:Number = multiplier - multipliers[i];
                    if (difference == 0)
                    {
                        continue;
                    }
                    multipliers[i] = multiplier;
                    for (k = 0; k < 7; k++)
                    {
                        change[k] -= difference * tangents[at + k];
                    }
                    most = Math.max(most, Math.abs(difference));
                }
                if (most < 1e-6 * stepSize * radius)
                {
                    break;
                }
            }
            return change;
        }

        private static function gradientOfVolume(ends:Vector.<Number>, radius:Number):Vector.<Number>
        {
            var length:Number = lengthOf(ends);
            var area:Number = length > 0 ? Math.PI * radius * radius / length : 0;
            var x:Number = area * (ends[3] - ends[0]);
            var y:Number = area * (ends[4] - ends[1]);
            var z:Number = area * (ends[5] - ends[2]);
            return new <Number>[-x, -y, -z, x, y, z, 2 * Math.PI * radius * (length + 2 * radius)];
        }
    }
}
