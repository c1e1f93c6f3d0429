package starlogo.fitting.minimal
{
    import flash.geom.Vector3D;
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

        /** The capsule so far: the smallest around its segment. */
        public var capsule:Capsule;

        private var _points:Vector.<Number>;

        /**
         * @param points x, y, z of each
         * @param start its segment is the first
         */
        public function CapsuleDescent(points:Vector.<Number>, start:Capsule)
        {
            _points = points;
            capsule = capsuleAround(start.start, start.end);
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
            var volume:Number = capsule.volume;
            if (volume == 0)
            {
                // the points are on a line, and nothing is smaller than a segment
                return 0;
            }
            var change:Vector.<Number> = solve(tangents(), stepSize);
            var trial:Capsule = capsuleAround(capsule.start.add(new Vector3D(change[0], change[1], change[2])),
                    capsule.end.add(new Vector3D(change[3], change[4], change[5])));
            if (!(trial.volume < volume))
            {
                return 0.3 * stepSize;
            }
            capsule = trial;
            return (trial.volume < volume * (1 - GAIN) ? 2 : 0.5) * stepSize;
        }

        private function capsuleAround(start:Vector3D, end:Vector3D):Capsule
        {
            var most:Number = 0;
            for each (var square:Number in squaresFrom(start, end))
            {
                most = square > most ? square : most;
            }
            return new Capsule(start, end, Math.sqrt(most));
        }

        // The squared distance of each point from a segment.
        private function squaresFrom(start:Vector3D, end:Vector3D):Vector.<Number>
        {
            var alongX:Number = end.x - start.x;
            var alongY:Number = end.y - start.y;
            var alongZ:Number = end.z - start.z;
            var lengthSquared:Number = alongX * alongX + alongY * alongY + alongZ * alongZ;
            var scale:Number = lengthSquared > 0 ? 1 / lengthSquared : 0;
            var count:int = _points.length / 3;
            var squares:Vector.<Number> = new Vector.<Number>(count);
            for (var i:int = 0; i < count; i++)
            {
                var at:int = 3 * i;
                var x:Number = _points[at] - start.x;
                var y:Number = _points[at + 1] - start.y;
                var z:Number = _points[at + 2] - start.z;
                var t:Number = (x * alongX + y * alongY + z * alongZ) * scale;
                t = t < 0 ? 0 : (t > 1 ? 1 : t);
                x -= t * alongX;
                y -= t * alongY;
                z -= t * alongZ;
                squares[i] = x * x + y * y + z * z;
            }
            return squares;
        }

        // Eight numbers for each point that may become the farthest: the tangent of its distance minus the radius, by the ends' coordinates
        // and the radius; then the radius minus its distance.
        private function tangents():Vector.<Number>
        {
            var found:Vector.<Number> = new Vector.<Number>();
            var start:Vector3D = capsule.start;
            var squares:Vector.<Number> = squaresFrom(start, capsule.end);
            var least:Number = activeFrom(squares);
            var alongX:Number = capsule.end.x - start.x;
            var alongY:Number = capsule.end.y - start.y;
            var alongZ:Number = capsule.end.z - start.z;
            var square:Number = alongX * alongX + alongY * alongY + alongZ * alongZ;
            for (var i:int = 0; i < squares.length; i++)
            {
                if (squares[i] < least || squares[i] == 0)
                {
                    continue;
                }
                var x:Number = _points[3 * i] - start.x;
                var y:Number = _points[3 * i + 1] - start.y;
                var z:Number = _points[3 * i + 2] - start.z;
                var t:Number = square > 0 ? (x * alongX + y * alongY + z * alongZ) / square : 0;
                t = t < 0 ? 0 : (t > 1 ? 1 : t);
                var distance:Number = Math.sqrt(squares[i]);
                // Moving the segment's nearest point towards the point shortens the distance.
                x = (t * alongX - x) / distance;
                y = (t * alongY - y) / distance;
                z = (t * alongZ - z) / distance;
                found.push((1 - t) * x, (1 - t) * y, (1 - t) * z, t * x, t * y, t * z, -1, capsule.radius - distance);
            }
            return found;
        }

        // The smallest squared distance of an active point. It is increased if too many points are active.
        private function activeFrom(squares:Vector.<Number>):Number
        {
            var fraction:Number = ACTIVE;
            do
            {
                var least:Number = capsule.radius * (1 - fraction);
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
        private function solve(tangents:Vector.<Number>, stepSize:Number):Vector.<Number>
        {
            var change:Vector.<Number> = new Vector.<Number>(7);
            var gradient:Vector.<Number> = gradientOfVolume();
            var scale:Number = stepSize * capsule.radius / gradient[6];
            for (var k:int = 0; k < 7; k++)
            {
                change[k] = -scale * gradient[k];
            }
            var count:int = tangents.length / 8;
            var multipliers:Vector.<Number> = new Vector.<Number>(count);
            for (var round:int = 0; round < MAX_ROUNDS; round++)
            {
                var most:Number = 0;
                for (var i:int = 0; i < count; i++)
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
                if (most < 1e-6 * stepSize * capsule.radius)
                {
                    break;
                }
            }
            return change;
        }

        private function gradientOfVolume():Vector.<Number>
        {
            var radius:Number = capsule.radius;
            var along:Vector3D = capsule.end.subtract(capsule.start);
            var length:Number = along.length;
            var area:Number = length > 0 ? Math.PI * radius * radius / length : 0;
            along.scaleBy(area);
            return new <Number>[-along.x, -along.y, -along.z, along.x, along.y, along.z, 2 * Math.PI * radius * (length + 2 * radius)];
        }
    }
}
