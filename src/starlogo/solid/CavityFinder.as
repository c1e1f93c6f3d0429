package starlogo.solid
{
    import starlogo.convex.TrianglePlane;
    import starlogo.steps.StepSequence;

    /**
     * Finds which shells of a surface bound cavities, in steps. A shell bounds a cavity if it lies inside of a solid shell, has the opposite
     * orientation, and no other cavity of that solid shell contains it. Only surfaces with shells of both orientations are searched.
     */
    internal final class CavityFinder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 25;

        // After so many windings of shells for each triangle, one point decides about each shell. Only models with very many nested shells reach
        // this limit.
        private static const WINDINGS_PER_TRIANGLE:int = 20;

        // How far inside of its shell a point is tested, as a fraction of the shell's extent. Smaller: rounding decides where shells touch.
        // Larger: it may be outside of a thin shell.
        private static const INWARDS:Number = 1e-7;

        // How much larger a shell has to be to have the other one inside, as a fraction.
        private static const LARGER:Number = 1e-9;

        /** For each shell, its state with the cavities, when no step is left: see <code>SurfaceTopology.shellStates</code>. */
        public var states:Vector.<int>;

        private var _windingCounter:WindingCounter;
        private var _surface:SurfaceTopology;
        private var _items:Vector.<int>;
        private var _balances:Vector.<int>;

        // For each shell: its outermost points; one more than the index of the corner from which its volume is measured, or 0 if it has none; six times
        // the volume; and 1 or -1 for its orientation, or 0 without a volume.
        private var _extremes:PartExtremes;
        private var _origins:Vector.<int>;
        private var _volumes:Vector.<Number>;
        private var _orientations:Vector.<int>;

        // For each shell, the larger shells that enclose all of its points tested so far. Null before the first point.
        private var _enclosing:Vector.<Vector.<int>>;

        // The shells that enclose the last point, and for each shell whether it does.
        private var _enclosingPoint:Vector.<int> = new Vector.<int>();
        private var _enclosesPoint:Vector.<Boolean>;

        private var _plane:TrianglePlane = new TrianglePlane();
        private var _windingCount:int = 0;
        private var _mostWindings:int;

        /**
         * @param windingCounter of the surface, which has the shells
         * @param balances for each shell, the number of its triangles that are not reversed, minus the number of those that are
         */
        public function CavityFinder(windingCounter:WindingCounter, balances:Vector.<int>)
        {
            var shells:int = balances.length;
            _windingCounter = windingCounter;
            _surface = windingCounter.surface;
            _items = windingCounter.mesh.tree.items;
            _mostWindings = WINDINGS_PER_TRIANGLE * _items.length;
            states = _surface.shellStates.concat();
            _balances = balances;
            if (shells > 1)
            {
                _extremes = new PartExtremes(windingCounter.mesh.corners, shells);
                _origins = new Vector.<int>(shells, true);
                _volumes = new Vector.<Number>(shells, true);
                _orientations = new Vector.<int>(shells, true);
                _enclosing = new Vector.<Vector.<int>>(shells, true);
                _enclosesPoint = new Vector.<Boolean>(shells, true);
                slices(_items.length, 40 * TRIANGLES_PER_STEP, addVolumes).call(orient);
            }
        }

        private function isSolid(shell:int):Boolean
        {
            return shell >= 0 && states[shell] == SurfaceTopology.SOLID;
        }

        private function addVolumes(first:int, end:int):void
        {
            var corners:Vector.<Number> = _windingCounter.mesh.corners;
            for (var slot:int = first; slot < end; slot++)
            {
                var shell:int = _surface.shellOf(_items[slot]);
                if (!isSolid(shell))
                {
                    continue;
                }
                _origins[shell] ||= 9 * slot + 1;
                _extremes.add(shell, slot);
                _plane.setTriangle(corners, 9 * slot);
                var from:int = _origins[shell] - 1;
                var volume:Number = _plane.doubleArea * (_plane.normal.x * (corners[9 * slot] - corners[from])
                        + _plane.normal.y * (corners[9 * slot + 1] - corners[from + 1]) + _plane.normal.z * (corners[9 * slot + 2] - corners[from + 2]));
                _volumes[shell] += _surface.isReversed(_items[slot]) ? -volume : volume;
            }
        }

        // A shell has the orientation of most of its triangles. If both are equally frequent, its triangles face outwards.
        private function orient():void
        {
            var isFound:Vector.<Boolean> = new Vector.<Boolean>(3, true);
            for (var shell:int = 0; shell < _balances.length; shell++)
            {
                var sign:int = _volumes[shell] > 0 ? 1 : (_volumes[shell] < 0 ? -1 : 0);
                _orientations[shell] = _balances[shell] > 0 ? sign : (_balances[shell] < 0 ? -sign : sign * sign);
                isFound[_orientations[shell] + 1] = true;
            }
            if (isFound[0] && isFound[2])
            {
                slices(_items.length, TRIANGLES_PER_STEP, testSome).call(decide);
            }
        }

        // Tests four points of each triangle: its middle, and points near its corners. Triangles that count as segments have no inner side.
        private function testSome(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                _plane.setTriangle(_windingCounter.mesh.corners, 9 * slot);
                if (_plane.isFlat)
                {
                    continue;
                }
                var shell:int = _surface.shellOf(_items[slot]);
                for (var corner:int = 3; corner >= 0 && isSolid(shell) && isUndecided(shell); corner--)
                {
                    findEnclosing(shell, slot, corner);
                    keepEnclosing(shell);
                }
            }
        }

        // Whether more points decide about a shell.
        private function isUndecided(shell:int):Boolean
        {
            return _enclosing[shell] == null || _enclosing[shell].length > 0 && _windingCount < _mostWindings;
        }

        // Finds the shells that enclose a point of a triangle, which is _plane. The point is a little inside of its shell.
        private function findEnclosing(shell:int, slot:int, corner:int):void
        {
            var corners:Vector.<Number> = _windingCounter.mesh.corners;
            var at:int = 9 * slot;
            var inwards:Number = INWARDS * _extremes.extentAt(_extremes.pointsAt[shell]);
            inwards = _surface.isReversed(_items[slot]) == _volumes[shell] > 0 ? inwards : -inwards;
            var share:Number = corner == 3 ? 1 / 3 : 0.01;
            var point:Vector.<Number> = new <Number>[inwards * _plane.normal.x, inwards * _plane.normal.y, inwards * _plane.normal.z];
            for (var axis:int = 0; axis < 3; axis++)
            {
                point[axis] += share * (corners[at + axis] + corners[at + 3 + axis] + corners[at + 6 + axis])
                    + (corner == 3 ? 0 : 0.97 * corners[at + 3 * corner + axis]);
            }
            _windingCount += _windingCounter.findAround(point[0], point[1], point[2], _enclosingPoint);
        }

        // Keeps those of the shells around a shell that enclose the last point too; after its first point, all larger shells that do. Keeps none if all
        // of them have the orientation of this shell.
        private function keepEnclosing(shell:int):void
        {
            var before:Vector.<int> = _enclosing[shell];
            var kept:Vector.<int> = new Vector.<int>();
            var hasOpposite:Boolean = false;
            for each (var found:int in _enclosingPoint)
            {
                _enclosesPoint[found] = true;
            }
            for each (var other:int in before || _enclosingPoint)
            {
                if (before == null ? isLarger(other, shell) : _enclosesPoint[other])
                {
                    kept.push(other);
                    hasOpposite ||= _orientations[other] == -_orientations[shell];
                }
            }
            for each (found in _enclosingPoint)
            {
                _enclosesPoint[found] = false;
            }
            kept.length = hasOpposite ? kept.length : 0;
            _enclosing[shell] = kept;
        }

        // Whether a shell may have another one inside.
        private function isLarger(outer:int, inner:int):Boolean
        {
            var points:Vector.<Number> = _extremes.points;
            var isAround:Boolean = isSolid(outer) && Math.abs(_volumes[outer]) > (1 + LARGER) * Math.abs(_volumes[inner]);
            for (var axis:int = 0; axis < 3 && isAround; axis++)
            {
                var a:int = _extremes.pointsAt[outer] + 7 * axis;
                var b:int = _extremes.pointsAt[inner] + 7 * axis;
                var rounding:Number = LARGER * (points[b + 3] - points[b]);
                isAround = points[a] <= points[b] + rounding && points[a + 3] >= points[b + 3] - rounding;
            }
            return isAround;
        }

        // Decides about the largest shells first. A shell that encloses another one is larger.
        private function decide():void
        {
            var sizes:Array = [];
            for each (var volume:Number in _volumes)
            {
                sizes.push(-Math.abs(volume));
            }
            for each (var shell:int in sizes.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY))
            {
                var innermost:int = -1;
                for each (var outer:int in _enclosing[shell] || new Vector.<int>())
                {
                    if (innermost < 0 || sizes[outer] > sizes[innermost])
                    {
                        innermost = outer;
                    }
                }
                if (isSolid(innermost) && _orientations[innermost] == -_orientations[shell])
                {
                    states[shell] = innermost;
                }
            }
        }
    }
}
