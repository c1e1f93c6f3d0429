package starlogo.solid
{
    import starlogo.engine;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Computes a model's SurfaceTopology, in steps: which vertices are at the same place, to within Tolerances.WELDING, which shells the triangles
     * form, which shells bound cavities, and which are one part because they are connected or overlap. If the surface is known, only the
     * WindingCounter is made.
     */
    internal final class SurfaceBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;
        private static const PARTS_PER_STEP:int = 50;

        // After so many windings of shells for each triangle, the parts that are left stay as they are. The answers are the same.
        private static const WINDINGS_PER_TRIANGLE:int = 20;

        /** The surface. Complete after the last step. */
        public var surface:SurfaceTopology;

        /** Counts the windings of the surface. Null before the last step. */
        public var windingCounter:WindingCounter = null;

        private var _mesh:TriangleMesh;
        private var _tree:BoxTree;
        private var _count:int;
        private var _welding:Welding;

        // The number of entries of the moved triangles' places.
        private var _placeCount:int = 0;

        // Null if the surface is known already.
        private var _shells:ShellFinder = null;

        // The connected vertices. For the representative of a set, one more than its part's number, or 0.
        private var _sets:DisjointSets;
        private var _numbers:Vector.<int>;

        // The outermost points of each part before parts are joined; for each shell, its part; and the parts that are one because they overlap.
        private var _extremes:PartExtremes;
        private var _partOf:Vector.<int>;
        private var _joined:DisjointSets;
        private var _windingCount:int = 0;

        /**
         * @param mesh has its corners
         * @param known the surface if it is known, or null
         */
        public function SurfaceBuilder(mesh:TriangleMesh, known:SurfaceTopology)
        {
            _mesh = mesh;
            _tree = mesh.tree;
            _count = _tree.order.length;
            surface = known || new SurfaceTopology(_count);
            if (known == null || known.widestSeam > 0)
            {
                _welding = new Welding(_tree.vertices);
                add(_welding);
            }
            if (known == null)
            {
                var edges:EdgeMatcher = new EdgeMatcher(_tree.triangles, _welding);
                _sets = new DisjointSets(_tree.vertices.length / 3);
                _numbers = new Vector.<int>(_tree.vertices.length / 3, true);
                _shells = new ShellFinder(surface, edges);
                sliced(joinSome);
                sliced(numberSome).add(edges).add(_shells);
            }
            call(beginWindings);
        }

        private function sliced(work:Function):StepSequence
        {
            return slices(_count, TRIANGLES_PER_STEP, work);
        }

        private function joinSome(first:int, end:int):void
        {
            var welded:Vector.<int> = _welding.welded;
            var triangles:Vector.<uint> = _tree.triangles;
            for (var corner:int = 3 * first; corner < 3 * end; corner += 3)
            {
                _sets.join(welded[triangles[corner]], welded[triangles[int(corner + 1)]]);
                _sets.join(welded[triangles[corner]], welded[triangles[int(corner + 2)]]);
            }
        }

        private function numberSome(first:int, end:int):void
        {
            surface.widestSeam = _welding.widestSeam;
            for (var i:int = first; i < end; i++)
            {
                var root:int = _sets.rootOf(_welding.welded[_tree.triangles[3 * i]]);
                if (_numbers[root] == 0)
                {
                    _numbers[root] = ++surface.partNumberEnd;
                }
                surface.parts[i] = _numbers[root] - 1;
            }
        }

        private function beginWindings():void
        {
            windingCounter = new WindingCounter(_mesh, surface);
            if (surface.widestSeam > 0)
            {
                windingCounter.placesAt = new Vector.<int>(_count, true);
                sliced(weld);
            }
            if (_shells != null)
            {
                _partOf = new Vector.<int>(surface.shellStates.length, true);
                _joined = new DisjointSets(surface.partNumberEnd);
                _extremes = new PartExtremes(_mesh.corners, surface.partNumberEnd);
                begin(newCavities);
                sliced(measure).slices(surface.isClosed && surface.partNumberEnd > 1 ? surface.partNumberEnd : 0, PARTS_PER_STEP, joinParts);
                sliced(numberParts);
            }
        }

        // Writes all triangles after the moved ones, and keeps those that are elsewhere than their corners.
        private function weld(first:int, end:int):void
        {
            var places:Vector.<Number> = windingCounter.places;
            for (var i:int = first; i < end; i++)
            {
                _mesh.writeCorners(i, i + 1, _welding.welded, places, _placeCount);
                var same:int = 0;
                while (same < 9 && places[_placeCount + same] == _mesh.corners[9 * i + same])
                {
                    same++;
                }
                windingCounter.placesAt[i] = same < 9 ? _placeCount : -1;
                _placeCount += same < 9 ? 9 : 0;
            }
        }

        private function newCavities():Steps
        {
            return new CavityFinder(windingCounter, _shells.balances);
        }

        private function measure(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var part:int = surface.parts[_tree.order[i]];
                var side:int = windingCounter.sideOf(i);
                if (side != 0)
                {
                    _partOf[int(Math.abs(side) - 1)] = part;
                }
                _extremes.add(part, i);
            }
        }

        // A figure often consists of shells that overlap. Another model contains all of them or none, unless that model is inside one of them. So
        // overlapping shells are joined to one part, and each pair of agents needs fewer points.
        private function joinParts(first:int, end:int):void
        {
            var points:Vector.<Number> = _extremes.points;
            for (var part:int = first; part < end && _windingCount < WINDINGS_PER_TRIANGLE * _count; part++)
            {
                var at:int = _extremes.pointsAt[part];
                for (var i:int = at; i < at + PartExtremes.STRIDE; i += 3)
                {
                    windingCounter.count(points[i], points[i + 1], points[i + 2]);
                    _windingCount += windingCounter.crossedCount;
                    for (var k:int = 0; k < windingCounter.crossedCount; k++)
                    {
                        if (windingCounter.isAround(windingCounter.crossed[k]))
                        {
                            _joined.join(_partOf[windingCounter.crossed[k]], part);
                        }
                    }
                }
            }
        }

        private function numberParts(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                surface.parts[i] = _joined.rootOf(surface.parts[i]);
            }
        }
    }
}
