package starlogo.solid.interior
{
    import flash.geom.Vector3D;
    import starlogo.convex.TrianglePlane;
    import starlogo.data.zeroedInts;
    import starlogo.geometry.cubeRoot;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;

    /**
     * Finds which shells of a surface bound cavities, in steps. A shell bounds a cavity if it lies inside of a closed shell, has the opposite
     * orientation, and no other cavity of that closed shell contains it. Only surfaces with shells of both orientations are searched. If a shell copies
     * another one, as in files that have triangles twice, it counts as open. Otherwise it would fill the other one's cavities. A copy has the same
     * corners and the same volume; its triangles may divide the same polygons otherwise.
     */
    internal final class CavityFinder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 1000;
        private static const TESTED_TRIANGLES_PER_STEP:int = 25;

        // How far inside of its shell a point is tested, as a fraction of the cube root of six times the shell's volume. Smaller: rounding decides where shells touch.
        // Larger: it may be outside of a thin shell.
        private static const INWARDS:Number = 1e-7;

        // How much larger a shell has to be to have the other one inside, as a fraction.
        private static const LARGER:Number = 1e-9;

        // A point near a corner of a triangle is the sum of these shares: of each corner, and of that one once more.
        private static const SHARE_OF_EACH:Number = 0.01;
        private static const SHARE_OF_NEAREST:Number = 0.97;

        // How many crossings are counted at most, as a multiple of the number of triangles. In a model of many nested shells each point has to be tested with
        // many of them, so the work would grow with the square of the triangles.
        private static const MAX_CROSSINGS_PER_TRIANGLE:int = 20;

        // In place of the number of a corner: the middle of the triangle.
        private static const MIDDLE:int = 3;

        private var _interior:Interior;
        private var _shellFinder:ShellFinder;

        // For each vertex, the first one at its place, and one more than the last shell that was found to have a corner there.
        private var _welded:Vector.<int>;
        private var _lastShellAt:Vector.<int>;

        // The shells that may bound cavities or have them, by their numbers. Null for the others: shells that are open or non-orientable, and copies.
        private var _shells:Vector.<ClosedShell>;

        // The shells that enclose the point that is tested.
        private var _shellsAroundPoint:Vector.<int> = new Vector.<int>();

        // The corners of a triangle, and its plane.
        private var _corners:Vector.<Number> = new Vector.<Number>(9, true);
        private var _plane:TrianglePlane = new TrianglePlane();

        // How many crossings were counted for the points so far.
        private var _countedCrossings:int = 0;

        /**
         * @param interior of the surface, which has the shells and receives which of them bound cavities
         * @param shellFinder has found the shells
         * @param welded for each vertex, the first one at its place
         */
        public function CavityFinder(interior:Interior, shellFinder:ShellFinder, welded:Vector.<int>)
        {
            _interior = interior;
            _shellFinder = shellFinder;
            _welded = welded;
            if (shellFinder.balances.length > 1)
            {
                _shells = new Vector.<ClosedShell>(shellFinder.balances.length, true);
                _lastShellAt = zeroedInts(welded.length);
                slices(shellFinder.triangleCount, TRIANGLES_PER_STEP, addTriangles).call(orientShells);
            }
        }

        // Adds triangles to their shells: their volumes, and the places of their corners, each place once. The triangles come shell by shell.
        private function addTriangles(first:int, end:int):void
        {
            var vertices:Vector.<Number> = _interior.tree.vertices;
            var triangles:Vector.<uint> = _interior.tree.triangles;
            for (var i:int = first; i < end; i++)
            {
                var triangle:int = _shellFinder.triangles[i];
                var shell:int = _interior.surface.shellOf(triangle);
                if (_interior.surface.shellStates[shell] != SurfaceTopology.ORIENTABLE)
                {
                    continue;
                }
                _shells[shell] ||= new ClosedShell(3 * triangles[3 * triangle]);
                var closed:ClosedShell = _shells[shell];
                var from:int = closed.origin;
                readTriangle(triangle);
                var volume:Number = _plane.doubleArea * (_plane.normal.x * (_corners[0] - vertices[from])
                        + _plane.normal.y * (_corners[1] - vertices[from + 1]) + _plane.normal.z * (_corners[2] - vertices[from + 2]));
                closed.sixfoldVolume += _interior.surface.isReversed(triangle) ? -volume : volume;
                for (var corner:int = 3 * triangle; corner < 3 * triangle + 3; corner++)
                {
                    var place:int = _welded[triangles[corner]];
                    if (_lastShellAt[place] != shell + 1)
                    {
                        _lastShellAt[place] = shell + 1;
                        closed.firstCorner = Math.min(closed.firstCorner, place);
                        closed.cornersHash += hashOf(place);
                    }
                }
            }
        }

        // Sets _corners and _plane to those of a triangle.
        private function readTriangle(triangle:int):void
        {
            var tree:BoxTree = _interior.tree;
            for (var i:int = 0; i < 3; i++)
            {
                var vertex:int = 3 * tree.triangles[int(3 * triangle + i)];
                _corners[int(3 * i)] = tree.vertices[vertex];
                _corners[int(3 * i + 1)] = tree.vertices[int(vertex + 1)];
                _corners[int(3 * i + 2)] = tree.vertices[int(vertex + 2)];
            }
            _plane.setTriangle(_corners, 0);
        }

        // The products are below 2 to the 53rd, so all of their lowest bits are exact.
        private static function hashOf(place:int):int
        {
            var hash:int = place * 69069;
            hash = (hash ^ hash >>> 15) * 69069;
            return hash ^ hash >>> 15;
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
                    var sign:int = closed.sixfoldVolume > 0 ? 1 : (closed.sixfoldVolume < 0 ? -1 : 0);
                    var balance:int = _shellFinder.balances[shell];
                    closed.orientation = balance > 0 ? sign : (balance < 0 ? -sign : sign * sign);
                    isFound[closed.orientation + 1] = true;
                }
            }
            if (isFound[0] && isFound[2])
            {
                markCopiesOpen();
                slices(_shellFinder.triangleCount, TESTED_TRIANGLES_PER_STEP, testPoints).call(findCavities);
            }
        }

        // A shell that copies an earlier one counts as open.
        private function markCopiesOpen():void
        {
            var shellWith:Object = {};
            for (var shell:int = 0; shell < _shells.length; shell++)
            {
                var closed:ClosedShell = _shells[shell];
                if (closed == null)
                {
                    continue;
                }
                var corners:String = closed.firstCorner + " " + closed.cornersHash;
                var earlier:ClosedShell = shellWith[corners];
                shellWith[corners] ||= closed;
                if (earlier != null && !isLarger(earlier, closed) && !isLarger(closed, earlier))
                {
                    _interior.surface.shellStates[shell] = SurfaceTopology.OPEN;
                    _shells[shell] = null;
                }
            }
        }

        // Tests four points of each triangle: its middle, and points near its corners. Triangles that count as segments have no inner side.
        private function testPoints(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var triangle:int = _shellFinder.triangles[i];
                var closed:ClosedShell = _shells[_interior.surface.shellOf(triangle)];
                readTriangle(triangle);
                for (var corner:int = MIDDLE; corner >= 0 && closed != null && !_plane.isFlat && isUndecided(closed); corner--)
                {
                    findEnclosingNear(closed, triangle, corner);
                    keepEnclosing(closed);
                }
            }
        }

        // Whether more points decide about a shell. One point decides if too many crossings are counted, as in models with very many nested shells.
        private function isUndecided(closed:ClosedShell):Boolean
        {
            return closed.enclosing == null
                || closed.enclosing.length > 0 && _countedCrossings < MAX_CROSSINGS_PER_TRIANGLE * _shellFinder.triangleCount;
        }

        // Finds the shells that enclose a point of a triangle of a shell: near a corner, or in the middle, and a little inside of the shell. readTriangle()
        // must have read the triangle.
        private function findEnclosingNear(closed:ClosedShell, triangle:int, corner:int):void
        {
            var facesInwards:Boolean = _interior.surface.isReversed(triangle) == closed.sixfoldVolume > 0;
            var inwards:Number = (facesInwards ? INWARDS : -INWARDS) * cubeRoot(Math.abs(closed.sixfoldVolume));
            var fraction:Number = corner == MIDDLE ? 1 / 3 : SHARE_OF_EACH;
            var point:Vector.<Number> = new <Number>[inwards * _plane.normal.x, inwards * _plane.normal.y, inwards * _plane.normal.z];
            for (var axis:int = 0; axis < 3; axis++)
            {
                point[axis] += fraction * (_corners[axis] + _corners[3 + axis] + _corners[6 + axis])
                    + (corner == MIDDLE ? 0 : SHARE_OF_NEAREST * _corners[3 * corner + axis]);
            }
            _countedCrossings += _interior.findEnclosing(new Vector3D(point[0], point[1], point[2]), _shellsAroundPoint);
        }

        // Keeps those of a shell's enclosing shells that enclose the last point too; after its first point, all larger shells that enclose it. Keeps none if
        // all of them have the orientation of this shell.
        private function keepEnclosing(closed:ClosedShell):void
        {
            var kept:Vector.<int> = new Vector.<int>();
            var isNeeded:Boolean = false;
            for each (var other:int in closed.enclosing || _shellsAroundPoint)
            {
                if (isLarger(_shells[other], closed) && _shellsAroundPoint.indexOf(other) >= 0)
                {
                    kept.push(other);
                    isNeeded ||= _shells[other].orientation == -closed.orientation;
                }
            }
            kept.length = isNeeded ? kept.length : 0;
            closed.enclosing = kept;
        }

        // Whether a shell may have another one inside.
        private static function isLarger(outer:ClosedShell, inner:ClosedShell):Boolean
        {
            return outer != null && Math.abs(outer.sixfoldVolume) > (1 + LARGER) * Math.abs(inner.sixfoldVolume);
        }

        // Finds the shells that bound cavities: the largest shells first. A shell that encloses another one is larger.
        private function findCavities():void
        {
            // Negative, so that the largest shell comes first. Equal volumes may come in any order: neither shell encloses the other.
            var sortKeys:Array = [];
            for each (var closed:ClosedShell in _shells)
            {
                sortKeys.push(closed == null ? 0 : -Math.abs(closed.sixfoldVolume));
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
                    if (innermost < 0 || sortKeys[outer] > sortKeys[innermost])
                    {
                        innermost = outer;
                    }
                }
                if (innermost >= 0 && !_interior.surface.boundsCavity(innermost) && _shells[innermost].orientation == -closed.orientation)
                {
                    _interior.surface.shellStates[shell] = innermost;
                }
            }
        }
    }
}
