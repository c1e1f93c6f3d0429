package starlogo.solid
{
    import starlogo.engine;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Prepares a model for exact tests, in steps. First come the corners of the triangles in the order of the tree.
     * Then comes their inside: the surface that they make, its cavities, and the outermost points of its parts. If the surface is known
     * already, most of the work is not needed.
     */
    internal final class SolidBuilder extends StepSequence
    {
        private static const TRIANGLES_PER_STEP:int = 400;
        private static const PARTS_PER_STEP:int = 50;

        // After so many windings of shells for each triangle, the parts that are left stay as they are. The answers are the same.
        private static const WINDINGS_PER_TRIANGLE:int = 20;

        private var _model:ModelTree;
        private var _order:Vector.<int>;
        private var _mesh:TriangleMesh;
        private var _interior:Interior = null;
        private var _surface:SurfaceTopology;
        private var _extremes:PartExtremes;

        // Null if the surface is known already.
        private var _builder:SurfaceBuilder = null;

        // For each shell, its part; and the parts that are one because they overlap.
        private var _partOf:Vector.<int>;
        private var _sets:DisjointSets;
        private var _windingCount:int = 0;

        // Null if all vertices of each seam are at one place. The number of entries of the moved triangles' places.
        private var _welding:Welding = null;
        private var _placeCount:int = 0;

        /**
         * @param model has triangles; receives the triangles, their inside and the surface
         * @param findsInside whether to find the inside
         */
        public function SolidBuilder(model:ModelTree, findsInside:Boolean)
        {
            _model = model;
            _order = model.tree.order;
            _surface = model.surface;
            _mesh = model.mesh;
            if (_mesh == null)
            {
                _mesh = new TriangleMesh(model.tree);
                sliced(placeCorners).call(keepTriangles);
            }
            if (findsInside && _surface == null)
            {
                begin(newSurface);
            }
            if (findsInside)
            {
                call(useSurface);
            }
        }

        private function sliced(work:Function):StepSequence
        {
            return slices(_order.length, TRIANGLES_PER_STEP, work);
        }

        private function placeCorners(first:int, end:int):void
        {
            _model.writeCorners(first, end, null, _mesh.corners, 9 * first);
        }

        private function keepTriangles():void
        {
            _model.mesh = _mesh;
        }

        private function newSurface():Steps
        {
            _builder = new SurfaceBuilder(_model.tree.vertices, _model.tree.triangles);
            _surface = _builder.surface;
            return _builder;
        }

        private function useSurface():void
        {
            _interior = new Interior(_mesh, _surface);
            if (_surface.widestSeam > 0)
            {
                _welding = new Welding(_model.tree.vertices);
                _interior.placesAt = new Vector.<int>(_order.length, true);
                add(_welding);
                sliced(weld);
            }
            sliced(_mesh.placePlanes);
            _partOf = new Vector.<int>(_surface.shellStates.length, true);
            _extremes = new PartExtremes(_mesh.corners, _surface.partNumberEnd);
            if (_builder != null)
            {
                _sets = new DisjointSets(_surface.partNumberEnd);
                begin(newCavities);
                sliced(measure).slices(_interior.isClosed && _surface.partNumberEnd > 1 ? _surface.partNumberEnd : 0, PARTS_PER_STEP, joinParts)
                    .call(beginAgain);
                sliced(numberParts);
            }
            sliced(measure).call(conclude);
        }

        // A figure often consists of shells that overlap. Another model contains all of them or none, unless that model is inside one of them. So
        // overlapping shells are joined to one part, and each pair of agents needs fewer points.
        private function joinParts(first:int, end:int):void
        {
            var points:Vector.<Number> = _extremes.points;
            for (var part:int = first; part < end && _windingCount < WINDINGS_PER_TRIANGLE * _order.length; part++)
            {
                var at:int = _extremes.pointsAt[part];
                for (var i:int = at; i < at + 3 * Interior.POINTS_PER_PART; i += 3)
                {
                    _interior.countWindings(points[i], points[i + 1], points[i + 2]);
                    _windingCount += _interior.crossedCount;
                    for (var k:int = 0; k < _interior.crossedCount; k++)
                    {
                        if (_interior.isAround(_interior.crossed[k]))
                        {
                            _sets.join(_partOf[_interior.crossed[k]], part);
                        }
                    }
                    _interior.clearWindings();
                }
            }
        }

        private function beginAgain():void
        {
            _extremes = new PartExtremes(_mesh.corners, _surface.partNumberEnd);
        }

        private function numberParts(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                _surface.parts[i] = _sets.rootOf(_surface.parts[i]);
            }
        }

        // Writes all triangles after the moved ones, and keeps those that are elsewhere than their corners.
        private function weld(first:int, end:int):void
        {
            var places:Vector.<Number> = _interior.places;
            for (var i:int = first; i < end; i++)
            {
                _model.writeCorners(i, i + 1, _welding.welded, places, _placeCount);
                var same:int = 0;
                while (same < 9 && places[_placeCount + same] == _mesh.corners[9 * i + same])
                {
                    same++;
                }
                _interior.placesAt[i] = same < 9 ? _placeCount : -1;
                _placeCount += same < 9 ? 9 : 0;
            }
        }

        private function newCavities():Steps
        {
            return new CavityFinder(_interior, _builder.balances);
        }

        private function measure(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                var part:int = _surface.parts[_order[i]];
                var side:int = _interior.sideOf(i);
                if (side != 0)
                {
                    _partOf[int(Math.abs(side) - 1)] = part;
                }
                _extremes.add(part, i);
            }
        }

        private function conclude():void
        {
            _interior.partPoints = _extremes.points;
            for (var at:int = 0; at < _interior.partPoints.length; at += 3 * Interior.POINTS_PER_PART)
            {
                _interior.leastPartExtent = Math.min(_interior.leastPartExtent, _extremes.extentAt(at));
            }
            _model.interior = _interior;
            _model.surface = _surface;
        }
    }
}
