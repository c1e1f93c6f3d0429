package starlogo.fitting
{
    import flash.geom.Matrix3D;
    import starlogo.geometry.ConvexHull;
    import starlogo.geometry.Tolerances;

    /**
     * The brute-force search of thesis §3.4.2: turns a hull by every rotation of a discrete set, and keeps the one whose
     * axis-aligned box is the smallest.
     *
     * <p>The player transforms the whole hull natively. What it costs to find the six extreme corners is kept down by starting
     * from those of the rotation before and climbing from neighbour to neighbour; on a convex body the first corner without a
     * better neighbour is the best. A rotation about z leaves the extent along z as it was. The search ends early if a box is as small as the hull
     * itself.</p>
     */
    public final class RotationSearch
    {
        private var _hull:ConvexHull;
        private var _turned:Vector.<Number>;
        private var _firstNeighbor:Vector.<int>;
        private var _neighbors:Vector.<int>;
        private var _matrix:Matrix3D = new Matrix3D();
        private var _raw:Vector.<Number> = new <Number>[1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];
        private var _axes:Vector.<Number> = new Vector.<Number>(9);

        /**
         * @param hull of the vertices
         */
        public function RotationSearch(hull:ConvexHull)
        {
            _hull = hull;
            _turned = new Vector.<Number>(hull.points.length);
            _firstNeighbor = hull.firstNeighbor;
            _neighbors = hull.neighbors;
        }

        /**
         * Checks an increment.
         *
         * @return the increment
         * @throws ArgumentError if it is not a positive, finite number
         */
        public static function checkIncrement(degrees:Number):Number
        {
            if (!(degrees > 0 && degrees < Infinity))
            {
                throw new ArgumentError("the increment must be a positive number of degrees: " + degrees);
            }
            return degrees;
        }

        /**
         * The axes of the smallest box: the rotations go about x first, then y, then z, each from 0 up to below 90 degrees. Of
         * boxes of the same volume the first counts.
         *
         * @param stepX degrees
         * @param stepY degrees
         * @param stepZ degrees
         * @return three unit vectors, nine numbers
         */
        public function smallestBox(stepX:Number, stepY:Number, stepZ:Number):Vector.<Number>
        {
            var best:Vector.<Number> = null;
            var least:Number = Infinity;
            var enough:Number = _hull.volume * (1 + Tolerances.FIT_TIE);
            var highX:int = 0;
            var highY:int = 0;
            var highZ:int = 0;
            var lowX:int = 0;
            var lowY:int = 0;
            var lowZ:int = 0;
            for (var aboutX:Number = 0; aboutX < 90; aboutX += stepX)
            {
                for (var aboutY:Number = 0; aboutY < 90; aboutY += stepY)
                {
                    for (var aboutZ:Number = 0; aboutZ < 90; aboutZ += stepZ)
                    {
                        turn(aboutX, aboutY, aboutZ);
                        if (aboutZ == 0)
                        {
                            highZ = climb(highZ, 2, 1);
                            lowZ = climb(lowZ, 2, -1);
                        }
                        highX = climb(highX, 0, 1);
                        lowX = climb(lowX, 0, -1);
                        highY = climb(highY, 1, 1);
                        lowY = climb(lowY, 1, -1);
                        var volume:Number = (_turned[3 * highX] - _turned[3 * lowX])
                            * (_turned[3 * highY + 1] - _turned[3 * lowY + 1]) * (_turned[3 * highZ + 2] - _turned[3 * lowZ + 2]);
                        if (best == null || volume < least * (1 - Tolerances.FIT_TIE))
                        {
                            least = volume;
                            best = _axes.concat();
                            if (least <= enough)
                            {
                                return best;
                            }
                        }
                    }
                }
            }
            return best;
        }

        // The rows of Rz Ry Rx are the box's axes; the matrix takes them by columns.
        private function turn(degreesX:Number, degreesY:Number, degreesZ:Number):void
        {
            var cosX:Number = Math.cos(degreesX * Math.PI / 180);
            var sinX:Number = Math.sin(degreesX * Math.PI / 180);
            var cosY:Number = Math.cos(degreesY * Math.PI / 180);
            var sinY:Number = Math.sin(degreesY * Math.PI / 180);
            var cosZ:Number = Math.cos(degreesZ * Math.PI / 180);
            var sinZ:Number = Math.sin(degreesZ * Math.PI / 180);
            _raw[0] = _axes[0] = cosZ * cosY;
            _raw[4] = _axes[1] = cosZ * sinY * sinX - sinZ * cosX;
            _raw[8] = _axes[2] = cosZ * sinY * cosX + sinZ * sinX;
            _raw[1] = _axes[3] = sinZ * cosY;
            _raw[5] = _axes[4] = sinZ * sinY * sinX + cosZ * cosX;
            _raw[9] = _axes[5] = sinZ * sinY * cosX - cosZ * sinX;
            _raw[2] = _axes[6] = -sinY;
            _raw[6] = _axes[7] = cosY * sinX;
            _raw[10] = _axes[8] = cosY * cosX;
            _matrix.copyRawDataFrom(_raw);
            _matrix.transformVectors(_hull.points, _turned);
        }

        // The corner with the greatest coordinate (x, y, z: 0, 1, 2), or for direction -1 with the least.
        private function climb(corner:int, coordinate:int, direction:int):int
        {
            var turned:Vector.<Number> = _turned;
            var best:Number = direction * turned[int(3 * corner + coordinate)];
            var from:int;
            do
            {
                from = corner;
                var end:int = _firstNeighbor[int(from + 1)];
                for (var i:int = _firstNeighbor[from]; i < end; i++)
                {
                    var neighbor:int = _neighbors[i];
                    var value:Number = direction * turned[int(3 * neighbor + coordinate)];
                    if (value > best)
                    {
                        best = value;
                        corner = neighbor;
                    }
                }
            }
            while (corner != from);
            return corner;
        }
    }
}
