package starlogo.fitting
{
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.hull.ConvexHull;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Trigonometry;
    import starlogo.geometry.scaleAndRotatePoints;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * The brute-force search of thesis §3.4.2: rotates a hull by every rotation of a discrete set, and keeps the rotation whose
     * axis-aligned box is the smallest. The rotations are about x first, then y, then z, each from 0 to below 90 degrees. The very first box is
     * the axis-aligned one. If several boxes have the same volume, the first one that is tried counts. A side shorter than the rounding error
     * counts as long as the rounding error. So around a flat hull, whose boxes have no volume, the box with the smallest area is the smallest.
     * A step tries all rotations about z that follow one rotation about x and y. Every second step tries them from the largest angle to the
     * smallest.
     *
     * <p>Three methods make the search faster. None changes the result, but for the rounding of the hull. First, the whole hull is rotated about x
     * and y once. The rotations about z that follow do not change the extent along z. The extents along x and y are found in the plane of x and y.
     * This is done in Numbers, because a Matrix3D's precision depends on the player. Second, a rotation is left if the box around the last extreme
     * corners alone is too large. Third, the search ends if a box is as small as the hull itself.</p>
     */
    internal final class RotationSearch extends StepSequence
    {
        // With a smaller increment, a step would take longer than some milliseconds, and rotations would be too many to count.
        private static const LEAST_INCREMENT:Number = 0.01;

        private var _hull:ConvexHull;
        private var _rotated:Vector.<Number>;

        // The indices of the corners' first numbers in the order in which they are tried: the four that were extreme at an earlier rotation, then all.
        private var _order:Vector.<int> = new Vector.<int>(4);

        // The best rotation so far.
        private var _leastVolume:Number = Infinity;
        private var _bestRotation:Placement = new Placement();

        /**
         * @param session the vertices; their hull may not exist before the first step
         * @param incrementXY degrees between the rotations about x and about y; 90 for rotations about z only
         * @param incrementZ degrees between the rotations about z
         */
        public function RotationSearch(session:FitSession, incrementXY:Number, incrementZ:Number)
        {
            var perAxis:int = Math.ceil(90 / incrementXY);
            var next:int = 0;
            var lowerBound:Number;
            call(function():void
                {
                    _hull = session.hull;
                    lowerBound = _hull.volume * (1 + Tolerances.FIT_TIE);
                    _rotated = new Vector.<Number>(_hull.points.length);
                    for (var i:int = 0; i < _rotated.length; i += 3)
                    {
                        _order.push(i);
                    }
                }).repeat(function():Boolean
                {
                    tryAboutZ(int(next / perAxis) * incrementXY, next % perAxis * incrementXY, incrementZ, next % 2 == 1);
                    next++;
                    return next < perAxis * perAxis && _leastVolume > lowerBound;
                });
        }

        /**
         * Checks degrees between rotations, and returns them.
         *
         * @throws ArgumentError if they are less than LEAST_INCREMENT or not finite
         */
        internal static function checkedIncrement(degrees:Number):Number
        {
            if (!(degrees >= LEAST_INCREMENT && degrees < Infinity))
            {
                throw new ArgumentError("the increment must be at least " + LEAST_INCREMENT + " degrees, and finite: " + degrees);
            }
            return degrees;
        }

        // Tries the rotations about z, backwards or not, that follow a rotation about x and y.
        private function tryAboutZ(aboutX:Number, aboutY:Number, increment:Number, isBackwards:Boolean):void
        {
            var rotation:Placement = new Placement();
            rotation.setRotation(0, aboutY, aboutX);
            scaleAndRotatePoints(rotation, _hull.points, _rotated);
            // the least length that counts for a side
            var shortest:Number = _hull.flatness;
            var thickness:Number = Math.max(2 * EnclosingStructures.extentAlong(_rotated, 0, 0, 1)[1], shortest);
            var count:int = Math.ceil(90 / increment);
            for (var i:int = 0; i < count; i++)
            {
                // the order decides which of several equally small boxes counts
                var aboutZ:Number = (isBackwards ? count - 1 - i : i) * increment;
                var limit:Number = _leastVolume * (1 - Tolerances.FIT_TIE);
                var volume:Number = thickness * areaAround(Trigonometry.cosine(aboutZ), Trigonometry.sine(aboutZ), shortest, limit / thickness);
                if (volume < limit)
                {
                    _leastVolume = volume;
                    _bestRotation.setRotation(aboutZ, aboutY, aboutX);
                }
            }
        }

        /** The smallest box of the rotations tried so far, around all vertices. */
        public function smallestBox(session:FitSession):Box
        {
            var axes:Vector.<Number> = new Vector.<Number>(9);
            _bestRotation.readRows(axes, 0);
            return EnclosingStructures.box(session.vertices, axes);
        }

        // The area of the rectangle around the rotated hull, seen along z, after a rotation about z; Infinity if four corners tell that it is not below
        // the limit. The search spends nearly all its time here.
        private function areaAround(cosine:Number, sine:Number, shortest:Number, limit:Number):Number
        {
            var rotated:Vector.<Number> = _rotated;
            var order:Vector.<int> = _order;
            var end:int = order.length;
            var minX:Number = Infinity;
            var maxX:Number = -Infinity;
            var minY:Number = Infinity;
            var maxY:Number = -Infinity;
            var left:int;
            var right:int;
            var lower:int;
            var upper:int;
            for (var k:int = 0; k < end; k++)
            {
                if (k == 4 && (maxX - minX) * (maxY - minY) >= limit)
                {
                    return Infinity;
                }
                var i:int = order[k];
                var x:Number = rotated[i];
                var y:Number = rotated[int(i + 1)];
                var along:Number = cosine * x - sine * y;
                var across:Number = sine * x + cosine * y;
                if (along < minX)
                {
                    minX = along;
                    left = i;
                }
                if (along > maxX)
                {
                    maxX = along;
                    right = i;
                }
                if (across < minY)
                {
                    minY = across;
                    lower = i;
                }
                if (across > maxY)
                {
                    maxY = across;
                    upper = i;
                }
            }
            order[0] = left;
            order[1] = right;
            order[2] = lower;
            order[3] = upper;
            return Math.max(maxX - minX, shortest) * Math.max(maxY - minY, shortest);
        }
    }
}
