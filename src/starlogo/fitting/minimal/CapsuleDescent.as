package starlogo.fitting.minimal
{
    import flash.geom.Vector3D;
    import starlogo.bounding.Capsule;
    import starlogo.engine;
    import starlogo.fitting.EnclosingStructures;

    use namespace engine;

    /**
     * Searches all directions for the smallest capsule. It measures many directions, and descends from the best of them: it moves the
     * capsule's ends until no small move makes it smaller while it encloses all points. It is a part of MinimalCapsuleFitter.
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
    public final class CapsuleDescent
    {
        private static const STARTS:int = 6;
        private static const STEPS:int = 60;
        private static const SWEEPS:int = 60;
        // A point cannot matter in one step if its distance is less than the radius by more than this share of the radius.
        private static const ACTIVE:Number = 0.15;
        private static const MOST_ACTIVE:int = 48;
        private static const GAIN:Number = 1e-7;

        // The radii to try, as multiples of the circle's radius.
        private static const RADII:Vector.<Number> = new <Number>[1, 1.02, 1.05, 1.1, 1.2, 1.35];

        /** The smallest capsule so far. */
        public var best:Capsule;

        private var _vertices:Vector.<Number>;
        private var _points:Vector.<Number>;

        // by point: the square of its distance from the segment that was measured last
        private var _squares:Vector.<Number>;

        /**
         * @param vertices x, y, z of each
         * @param points the vertices on the hull
         * @param best a capsule around the vertices
         */
        public function CapsuleDescent(vertices:Vector.<Number>, points:Vector.<Number>, best:Capsule)
        {
            this.best = best;
            _vertices = vertices;
            _points = points;
            _squares = new Vector.<Number>(points.length / 3);
        }

        /**
         * Measures directions, and descends from the best ones.
         *
         * @param directions unit vectors, x, y, z of each; opposite ones count as one
         * @param apart the smallest angle between two directions to descend from: radians, small
         */
        public function search(directions:Vector.<Number>, apart:Number):void
        {
            var all:Vector.<Vector3D> = new Vector.<Vector3D>();
            var volumes:Array = [];
            var i:int;
            for (i = 0; i < directions.length; i += 3)
            {
                var direction:Vector3D = new Vector3D(directions[i], directions[i + 1], directions[i + 2]);
                all.push(direction);
                volumes.push(capsuleAlong(direction).volume);
            }
            var order:Array = volumes.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY);
            var starts:Vector.<Vector3D> = new Vector.<Vector3D>();
            for (i = 0; i < order.length && starts.length < STARTS; i++)
            {
                direction = all[order[i]];
                if (!isNear(starts, direction, apart))
                {
                    starts.push(direction);
                    descendFrom(capsuleAlong(direction));
                }
            }
        }

        // Moves a capsule's ends until nothing is gained.
        private function descendFrom(start:Capsule):void
        {
            // x, y, z of each
            var ends:Vector.<Number> = start.numbers();
            ends.length = 6;
            var stepSize:Number = 0.1;
            var radius:Number = measure(ends);
            var volume:Number = volumeOf(ends, radius);
            for (var step:int = 0; step < STEPS && stepSize > 1e-7; step++)
            {
                var trial:Vector.<Number> = solve(ends, radius, tangentsAt(ends, radius), stepSize);
                for (var i:int = 0; i < 6; i++)
                {
                    trial[i] += ends[i];
                }
                var trialRadius:Number = measure(trial);
                var trialVolume:Number = volumeOf(trial, trialRadius);
                if (trialVolume < volume)
                {
                    stepSize *= trialVolume < volume * (1 - GAIN) ? 2 : 0.5;
                    volume = trialVolume;
                    radius = trialRadius;
                    ends = trial;
                }
                else
                {
                    stepSize *= 0.3;
                }
            }
            keepAround(ends, radius);
        }

        // Keeps the smallest capsule around the line through the ends, if it is smaller than the best.
        private function keepAround(ends:Vector.<Number>, least:Number):void
        {
            var from:Vector3D = new Vector3D(ends[0], ends[1], ends[2]);
            var axis:Vector3D = new Vector3D(ends[3] - ends[0], ends[4] - ends[1], ends[5] - ends[2]);
            if (axis.normalize() == 0)
            {
                axis.setTo(1, 0, 0);
            }
            var radius:Number = Math.max(least, EnclosingStructures.distanceFromLine(_vertices, from, axis));
            var capsule:Capsule = EnclosingStructures.capsule(_vertices, from, axis, Infinity, -Infinity, radius);
            if (capsule.volume < best.volume)
            {
                best = capsule;
            }
        }

        private static function isNear(others:Vector.<Vector3D>, direction:Vector3D, angle:Number):Boolean
        {
            for each (var other:Vector3D in others)
            {
                if (direction.crossProduct(other).lengthSquared < angle * angle)
                {
                    return true;
                }
            }
            return false;
        }

        // Finds the best capsule along a unit vector, trying several radii. Its axis goes through the smallest circle around the points as
        // seen along the vector.
        private function capsuleAlong(axis:Vector3D):Capsule
        {
            var seen:Vector.<Number> = new Vector.<Number>(_points.length);
            for (var i:int = 0; i < _points.length; i += 3)
            {
                var along:Number = _points[i] * axis.x + _points[i + 1] * axis.y + _points[i + 2] * axis.z;
                seen[i] = _points[i] - along * axis.x;
                seen[i + 1] = _points[i + 1] - along * axis.y;
                seen[i + 2] = _points[i + 2] - along * axis.z;
            }
            var circle:SmallestEnclosingBall = new SmallestEnclosingBall(seen);
            var center:Vector3D = new Vector3D(circle.x, circle.y, circle.z);
            var smallest:Capsule = null;
            for each (var multiple:Number in RADII)
            {
                var capsule:Capsule = EnclosingStructures.capsule(_points, center, axis, Infinity, -Infinity, multiple * circle.radius);
                if (smallest == null || capsule.volume < smallest.volume)
                {
                    smallest = capsule;
                }
            }
            return smallest;
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

        // Writes the squared distance of each point from the segment. Returns the largest distance.
        private function measure(ends:Vector.<Number>):Number
        {
            var startX:Number = ends[0];
            var startY:Number = ends[1];
            var startZ:Number = ends[2];
            var alongX:Number = ends[3] - startX;
            var alongY:Number = ends[4] - startY;
            var alongZ:Number = ends[5] - startZ;
            var lengthSquared:Number = alongX * alongX + alongY * alongY + alongZ * alongZ;
            var scale:Number = lengthSquared > 0 ? 1 / lengthSquared : 0;
            var most:Number = 0;
            var count:int = _squares.length;
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
                var square:Number = x * x + y * y + z * z;
                _squares[i] = square;
                most = square > most ? square : most;
            }
            return Math.sqrt(most);
        }

        // Eight numbers for each point that may become the farthest: the tangent of its distance minus the radius, by the ends' coordinates
        // and the radius; then the radius minus its distance.
        private function tangentsAt(ends:Vector.<Number>, radius:Number):Vector.<Number>
        {
            var tangents:Vector.<Number> = new Vector.<Number>();
            measure(ends);
            var least:Number = activeFrom(radius);
            var alongX:Number = ends[3] - ends[0];
            var alongY:Number = ends[4] - ends[1];
            var alongZ:Number = ends[5] - ends[2];
            var square:Number = alongX * alongX + alongY * alongY + alongZ * alongZ;
            for (var i:int = 0; i < _squares.length; i++)
            {
                if (_squares[i] < least || _squares[i] == 0)
                {
                    continue;
                }
                var x:Number = _points[3 * i] - ends[0];
                var y:Number = _points[3 * i + 1] - ends[1];
                var z:Number = _points[3 * i + 2] - ends[2];
                var t:Number = square > 0 ? (x * alongX + y * alongY + z * alongZ) / square : 0;
                t = t < 0 ? 0 : (t > 1 ? 1 : t);
                var distance:Number = Math.sqrt(_squares[i]);
                // Moving the segment's nearest point towards the point shortens the distance.
                x = (t * alongX - x) / distance;
                y = (t * alongY - y) / distance;
                z = (t * alongZ - z) / distance;
                tangents.push((1 - t) * x, (1 - t) * y, (1 - t) * z, t * x, t * y, t * z, -1, radius - distance);
            }
            return tangents;
        }

        // The smallest squared distance of an active point. It is increased if too many points are active.
        private function activeFrom(radius:Number):Number
        {
            var share:Number = ACTIVE;
            do
            {
                var least:Number = radius * (1 - share);
                least *= least;
                var count:int = 0;
                for (var i:int = 0; i < _squares.length; i++)
                {
                    count += _squares[i] >= least ? 1 : 0;
                }
                share /= 2;
            }
            while (count > MOST_ACTIVE && share > 1e-4);
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
            for (var sweep:int = 0; sweep < SWEEPS; sweep++)
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
