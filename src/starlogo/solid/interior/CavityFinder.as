package starlogo.solid.interior
{
    import starlogo.convex.TrianglePlane;
    import starlogo.geometry.cubeRoot;
    import starlogo.hierarchy.TriangleMesh;
    import starlogo.steps.StepSequence;

    /**
     * Finds which shells of a surface bound cavities, in steps. A shell bounds a cavity if it lies inside of a closed shell, has the opposite
     * orientation, and no other cavity of that closed shell contains it. Only surfaces with shells of both orientations are searched. If a shell copies
     * another one, as in files that have triangles twice, it counts as open. Otherwise it would fill the other one's cavities.
     */
    internal final class CavityFinder extends StepSequence
    {
        private static const VOLUMES_PER_STEP:int = 1000;
        private static const TRIANGLES_PER_STEP:int = 25;

        // How far inside of its shell a point is tested, as a fraction of the cube root of six times the shell's volume. Smaller: rounding decides where shells touch.
        // Larger: it may be outside of a thin shell.
        private static const INWARDS:Number = 1e-7;

        // How much larger a shell has to be to have the other one inside, as a fraction. A shell of the same volume may be a copy.
        private static const LARGER:Number = 1e-9;

        // A point near a corner of a triangle is the sum of these shares: of each corner, and of that one once more.
        private static const SHARE_OF_EACH:Number = 0.01;
        private static const SHARE_OF_NEAREST:Number = 0.97;

        // In place of the number of a corner: the middle of the triangle.
        private static const MIDDLE:int = 3;

        private var _windingCounter:WindingCounter;
        private var _surface:SurfaceTopology;
        private var _mesh:TriangleMesh;
        private var _balances:Vector.<int>;

        // The shells that may bound cavities or have them, with null for the others.
        private var _shells:Vector.<ClosedShell>;

        // The shells that enclose the point that is tested.
        private var _enclosingPoint:Vector.<int> = new Vector.<int>();

        // The corners of a triangle, and its plane.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _plane:TrianglePlane = new TrianglePlane();

        // How many crossings were counted for the points so far.
        private var _countedCrossings:int = 0;

        /**
         * @param windingCounter of the surface, which has the shells and receives which of them bound cavities
         * @param balances for each shell, the number of its triangles that are not reversed, minus the number of those that are
         */
        public function CavityFinder(windingCounter:WindingCounter, balances:Vector.<int>)
        {
            _windingCounter = windingCounter;
            _surface = windingCounter.surface;
            _mesh = windingCounter.mesh;
            _balances = balances;
            if (balances.length > 1)
            {
                _shells = new Vector.<ClosedShell>(balances.length, true);
                slices(_mesh.tree.itemCount, VOLUMES_PER_STEP, addVolumes).call(orientShells);
            }
        }

        // The shell of the triangle in a slot.
        private function shellAt(slot:int):int
        {
            return _surface.shellOf(_mesh.tree.items[slot]);
        }

        private function isTwoSided(shell:int):Boolean
        {
            return shell >= 0 && _surface.shellStates[shell] == SurfaceTopology.TWO_SIDED;
        }

        private function addVolumes(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                var shell:int = shellAt(slot);
                if (!isTwoSided(shell))
                {
                    continue;
                }
                _shells[shell] ||= new ClosedShell(_mesh.corners[3 * slot]);
                readTriangle(slot);
                var vertices:Vector.<Number> = _mesh.vertices;
                var from:int = _shells[shell].origin;
                var volume:Number = _plane.doubleArea * (_plane.normal.x * (_corners[0] - vertices[from])
                        + _plane.normal.y * (_corners[1] - vertices[from + 1]) + _plane.normal.z * (_corners[2] - vertices[from + 2]));
                _shells[shell].volume += _surface.isReversed(_mesh.tree.items[slot]) ? -volume : volume;
            }
        }

        // Sets _corners and _plane to those of a triangle.
        private function readTriangle(slot:int):void
        {
            _mesh.readTriangle(slot, _corners);
            _plane.setTriangle(_corners, 0);
        }

        // A shell has the orientation of most of its triangles. If both are equally frequent, its triangles face outwards.
        private function orientShells():void
        {
            var isFound:Vector.<Boolean> = new Vector.<Boolean>(3, true);
            for (var shell:int = 0; shell < _shells.length; shell++)
            {
                var closed:ClosedShell = _shells[shell];
                if (closed != null)
                {
                    var sign:int = closed.volume > 0 ? 1 : (closed.volume < 0 ? -1 : 0);
                    closed.orientation = _balances[shell] > 0 ? sign : (_balances[shell] < 0 ? -sign : sign * sign);
                    isFound[closed.orientation + 1] = true;
                }
            }
            if (isFound[0] && isFound[2])
            {
                slices(_mesh.tree.itemCount, TRIANGLES_PER_STEP, testPoints).call(findCavities);
            }
        }

        // Tests four points of each triangle: its middle, and points near its corners. Triangles that count as segments have no inner side.
        private function testPoints(first:int, end:int):void
        {
            for (var slot:int = first; slot < end; slot++)
            {
                var shell:int = shellAt(slot);
                readTriangle(slot);
                if (_plane.isFlat || !isTwoSided(shell))
                {
                    continue;
                }
                for (var corner:int = MIDDLE; corner >= 0 && isUndecided(_shells[shell]); corner--)
                {
                    findEnclosingNear(shell, slot, corner);
                    keepEnclosing(shell);
                }
            }
        }

        // Whether more points decide about a shell. One point decides if too many crossings are counted, as in models with very many nested shells.
        private function isUndecided(closed:ClosedShell):Boolean
        {
            return closed.enclosing == null || closed.enclosing.length > 0 && isWorthCounting;
        }

        private function get isWorthCounting():Boolean
        {
            return _countedCrossings < WindingCounter.MAX_CROSSINGS_PER_TRIANGLE * _mesh.tree.itemCount;
        }

        // Finds the shells that enclose a point of a triangle of a shell: near a corner, or in the middle, and a little inside of the shell. readTriangle()
        // must have read the triangle.
        private function findEnclosingNear(shell:int, slot:int, corner:int):void
        {
            var facesInwards:Boolean = _surface.isReversed(_mesh.tree.items[slot]) == _shells[shell].volume > 0;
            var inwards:Number = (facesInwards ? INWARDS : -INWARDS) * cubeRoot(Math.abs(_shells[shell].volume));
            var fraction:Number = corner == MIDDLE ? 1 / 3 : SHARE_OF_EACH;
            var point:Vector.<Number> = new <Number>[inwards * _plane.normal.x, inwards * _plane.normal.y, inwards * _plane.normal.z];
            for (var axis:int = 0; axis < 3; axis++)
            {
                point[axis] += fraction * (_corners[axis] + _corners[3 + axis] + _corners[6 + axis])
                    + (corner == MIDDLE ? 0 : SHARE_OF_NEAREST * _corners[3 * corner + axis]);
            }
            _countedCrossings += _windingCounter.findEnclosing(point[0], point[1], point[2], _enclosingPoint);
        }

        // Keeps those of a shell's enclosing shells that enclose the last point too; after its first point, all shells that enclose it and are larger, or
        // that it may copy. Keeps none if all of them are larger and have the orientation of this shell.
        private function keepEnclosing(shell:int):void
        {
            var closed:ClosedShell = _shells[shell];
            var kept:Vector.<int> = new Vector.<int>();
            var isNeeded:Boolean = false;
            for each (var other:int in closed.enclosing || _enclosingPoint)
            {
                if (closed.enclosing == null ? isLarger(other, shell) || mayCopy(shell, other) : _enclosingPoint.indexOf(other) >= 0)
                {
                    kept.push(other);
                    isNeeded ||= _shells[other].orientation == -closed.orientation || mayCopy(shell, other);
                }
            }
            kept.length = isNeeded ? kept.length : 0;
            closed.enclosing = kept;
        }

        // Whether a shell may have another one inside.
        private function isLarger(outer:int, inner:int):Boolean
        {
            return isTwoSided(outer) && Math.abs(_shells[outer].volume) > (1 + LARGER) * Math.abs(_shells[inner].volume);
        }

        // Whether a shell may have the same triangles as an earlier one.
        private function mayCopy(shell:int, earlier:int):Boolean
        {
            return earlier < shell && isTwoSided(earlier) && !isLarger(earlier, shell) && !isLarger(shell, earlier);
        }

        // Finds the copies and the shells that bound cavities: the largest shells first. A shell that encloses another one is larger.
        private function findCavities():void
        {
            // negative, so that the largest shell comes first
            var sortKeys:Array = [];
            for each (var closed:ClosedShell in _shells)
            {
                sortKeys.push(closed == null ? 0 : -Math.abs(closed.volume));
            }
            for each (var shell:int in sortKeys.sort(Array.NUMERIC | Array.RETURNINDEXEDARRAY))
            {
                closed = _shells[shell];
                if (closed == null || closed.enclosing == null)
                {
                    continue;
                }
                var innermost:int = -1;
                for each (var outer:int in closed.enclosing)
                {
                    if (mayCopy(shell, outer) && isWorthCounting)
                    {
                        // it encloses all points that were tested
                        _surface.shellStates[shell] = SurfaceTopology.OPEN;
                    }
                    else if (isLarger(outer, shell) && (innermost < 0 || sortKeys[outer] > sortKeys[innermost]))
                    {
                        innermost = outer;
                    }
                }
                if (isTwoSided(shell) && innermost >= 0 && !_surface.boundsCavity(innermost) && _shells[innermost].orientation == -closed.orientation)
                {
                    _surface.cavityOf[shell] = innermost;
                }
            }
        }
    }
}
