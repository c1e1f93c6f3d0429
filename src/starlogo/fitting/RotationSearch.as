package starlogo.fitting
{
    import starlogo.bounding.Box;
    import starlogo.engine;
    import starlogo.geometry.ConvexHull;
    import starlogo.geometry.Placement;
    import starlogo.geometry.Tolerances;
    import starlogo.geometry.Trigonometry;
    import starlogo.steps.StepSequence;

    use namespace engine;

    /**
     * The brute-force search of thesis §3.4.2: turns a hull by every rotation of a discrete set, and keeps the one whose
     * axis-aligned box is the smallest. The rotations go about x first, then y, then z, each from 0 up to below 90 degrees. Of
     * boxes of the same volume the first that is tried counts: the axis-aligned one is the very first. A step tries all rotations
     * about z that follow one about x and y.
     *
     * <p>What the thesis's search costs is kept down in four ways, none of which changes its result. The whole hull is turned about x and y at
     * once, in Numbers: a Matrix3D's precision depends on the player; the rotations about z that follow leave the extent along z as it is, and their extents
     * along x and y are looked for in the plane. The extreme corners of a rotation are found from those of the one before by
     * climbing from neighbour to neighbour: on a convex body the first corner without a better neighbour is the best. A rotation is
     * not measured if the extreme corners of earlier ones alone fill a box that is too large already. And the search ends
     * if a box is as small as the hull itself.</p>
     */
    internal class RotationSearch extends StepSequence
    {
        private static const MANY:int = 50;
        private static const RARELY:Number = 0.2;

        private var _session:FitSession;
        private var _hull:ConvexHull;
        private var _turned:Vector.<Number>;
        private var _firstNeighbor:Vector.<int>;
        private var _neighbors:Vector.<int>;
        private var _rotation:Placement = new Placement();

        // Extreme corners found last: those of the first rotation about z, then those of one half a right angle on.
        private var _landmarks:Vector.<int> = new Vector.<int>(8);
        private var _asked:int = 0;
        private var _answered:int = 0;

        // The search under way: the next rotation about x and y, and the best of all so far. Angles in degrees.
        private var _stepX:Number;
        private var _stepY:Number;
        private var _stepZ:Number;
        private var _aboutX:Number = 0;
        private var _aboutY:Number = 0;
        private var _isForth:Boolean = false;
        private var _cosines:Vector.<Number> = new Vector.<Number>();
        private var _sines:Vector.<Number> = new Vector.<Number>();
        private var _corners:Vector.<int> = new Vector.<int>(6);
        private var _enough:Number;
        private var _least:Number = Infinity;
        private var _bestX:Number = 0;
        private var _bestY:Number = 0;
        private var _bestZ:Number = 0;

        /**
         * @param session the vertices; their hull may not be there before the first step
         * @param stepX degrees between the rotations about x
         * @param stepY about y
         * @param stepZ about z
         */
        public function RotationSearch(session:FitSession, stepX:Number, stepY:Number, stepZ:Number)
        {
            _session = session;
            _stepX = stepX;
            _stepY = stepY;
            _stepZ = stepZ;
            call(prepare).repeat(tryNext);
        }

        // All rotations about z that follow the next one about x and y; false if there are no more.
        private function tryNext():Boolean
        {
            turn(_aboutX, _aboutY);
            var corners:Vector.<int> = _corners;
            corners[4] = climb(corners[4], 1, 0, 1);
            corners[5] = climb(corners[5], 1, 0, -1);
            var thickness:Number = _turned[3 * corners[4] + 2] - _turned[3 * corners[5] + 2];
            // back and forth: the corners found last are close to those looked for next
            _isForth = !_isForth;
            var count:int = _sines.length;
            for (var i:int = 0; i < count; i++)
            {
                var place:int = _isForth ? i : count - 1 - i;
                var cosine:Number = _cosines[place];
                var sine:Number = _sines[place];
                var mayBe:Number = _least * (1 - Tolerances.FIT_TIE);
                if (isTooLarge(thickness, cosine, sine, mayBe))
                {
                    continue;
                }
                var volume:Number = thickness * span(corners, 0, cosine, -sine) * span(corners, 2, sine, cosine);
                remember(corners, place * _stepZ);
                if (volume < mayBe)
                {
                    _least = volume;
                    _bestX = _aboutX;
                    _bestY = _aboutY;
                    _bestZ = place * _stepZ;
                    if (volume <= _enough)
                    {
                        return false;
                    }
                }
            }
            return goOn();
        }

        /** The smallest box of the rotations tried so far, around all vertices. */
        public function smallestBox(session:FitSession):Box
        {
            var axes:Vector.<Number> = new Vector.<Number>(9);
            _rotation.setRotation(_bestZ, _bestY, _bestX);
            _rotation.writeRotation(axes, 0);
            return EnclosingStructures.box(session.vertices, axes);
        }

        private function prepare():void
        {
            _hull = _session.hull;
            _turned = new Vector.<Number>(_hull.points.length);
            _firstNeighbor = _hull.firstNeighbor;
            _neighbors = _hull.neighbors;
            _enough = _hull.volume * (1 + Tolerances.FIT_TIE);
            var count:int = Math.ceil(90 / _stepZ);
            for (var i:int = 0; i < count; i++)
            {
                _cosines.push(Trigonometry.cosine(i * _stepZ));
                _sines.push(Trigonometry.sine(i * _stepZ));
            }
        }

        // Goes on to the next rotation about y, or about x; false if there is none.
        private function goOn():Boolean
        {
            _aboutY += _stepY;
            if (!(_aboutY < 90))
            {
                _aboutY = 0;
                _aboutX += _stepX;
            }
            return _aboutX < 90;
        }

        // Turns the hull about x, then about y.
        private function turn(aboutX:Number, aboutY:Number):void
        {
            _rotation.setRotation(0, aboutY, aboutX);
            var xx:Number = _rotation.r00;
            var xy:Number = _rotation.r01;
            var xz:Number = _rotation.r02;
            var yy:Number = _rotation.r11;
            var yz:Number = _rotation.r12;
            var zx:Number = _rotation.r20;
            var zy:Number = _rotation.r21;
            var zz:Number = _rotation.r22;
            var points:Vector.<Number> = _hull.points;
            var turned:Vector.<Number> = _turned;
            var end:int = points.length;
            for (var i:int = 0; i < end; i += 3)
            {
                var x:Number = points[i];
                var y:Number = points[i + 1];
                var z:Number = points[i + 2];
                turned[i] = xx * x + xy * y + xz * z;
                turned[i + 1] = yy * y + yz * z;
                turned[i + 2] = zx * x + zy * y + zz * z;
            }
        }

        // The extent in a direction of the plane; corners holds where it was last at the first index and the next.
        private function span(corners:Vector.<int>, index:int, alongX:Number, alongY:Number):Number
        {
            var high:int = corners[index] = climb(corners[index], 0, alongX, alongY);
            var low:int = corners[index + 1] = climb(corners[index + 1], 0, -alongX, -alongY);
            return (_turned[3 * high] - _turned[3 * low]) * alongX + (_turned[3 * high + 1] - _turned[3 * low + 1]) * alongY;
        }

        private function remember(corners:Vector.<int>, aboutZ:Number):void
        {
            var from:int = aboutZ < 22.5 || aboutZ > 67.5 ? 0 : 4;
            for (var i:int = 0; i < 4; i++)
            {
                _landmarks[from + i] = corners[i];
            }
        }

        // Whether the landmarks alone need a box that is too large; not asked any more where the answer rarely is yes.
        private function isTooLarge(thickness:Number, cosine:Number, sine:Number, limit:Number):Boolean
        {
            if (limit == Infinity || _asked > MANY && _answered < RARELY * _asked)
            {
                return false;
            }
            _asked++;
            var result:Boolean = thickness * areaOfLandmarks(cosine, sine) >= limit;
            if (result)
            {
                _answered++;
            }
            return result;
        }

        // The area of the landmarks' box in the plane: that of the hull's is no smaller.
        private function areaOfLandmarks(cosine:Number, sine:Number):Number
        {
            var turned:Vector.<Number> = _turned;
            var lowX:Number = Infinity;
            var highX:Number = -Infinity;
            var lowY:Number = Infinity;
            var highY:Number = -Infinity;
            for (var i:int = 0; i < 8; i++)
            {
                var at:int = 3 * _landmarks[i];
                var fromX:Number = turned[at];
                var fromY:Number = turned[at + 1];
                var x:Number = cosine * fromX - sine * fromY;
                var y:Number = sine * fromX + cosine * fromY;
                lowX = x < lowX ? x : lowX;
                highX = x > highX ? x : highX;
                lowY = y < lowY ? y : lowY;
                highY = y > highY ? y : highY;
            }
            return (highX - lowX) * (highY - lowY);
        }

        // The corner that is farthest in a direction of the plane of two coordinates that follow each other: 0 for x and y, 1 for
        // y and z. Nearly all of the search's time goes here, and the hull's support() reads a third coordinate of every neighbour.
        private function climb(corner:int, plane:int, alongFirst:Number, alongSecond:Number):int
        {
            var turned:Vector.<Number> = _turned;
            var neighbors:Vector.<int> = _neighbors;
            var firstNeighbor:Vector.<int> = _firstNeighbor;
            var at:int = 3 * corner + plane;
            var best:Number = alongFirst * turned[at] + alongSecond * turned[at + 1];
            var end:int = firstNeighbor[corner + 1];
            var i:int = firstNeighbor[corner];
            while (i < end)
            {
                var neighbor:int = neighbors[i];
                at = 3 * neighbor + plane;
                var value:Number = alongFirst * turned[at] + alongSecond * turned[at + 1];
                if (value > best)
                {
                    // goes on from there at once: looking for a better neighbour yet costs more than it gains
                    best = value;
                    corner = neighbor;
                    i = firstNeighbor[corner];
                    end = firstNeighbor[corner + 1];
                }
                else
                {
                    i++;
                }
            }
            return corner;
        }
    }
}
