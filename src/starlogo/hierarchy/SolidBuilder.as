package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Surface;
    import starlogo.geometry.SurfaceBuilder;
    import starlogo.geometry.SurfaceCheck;
    import starlogo.steps.Steps;

    use namespace engine;

    /**
     * Prepares what exact tests and tests for insides need of a hierarchy's triangles, in steps: their corners in the
     * hierarchy's order, the surface that they make, and the outermost points of the parts that it comes in.
     */
    internal final class SolidBuilder implements Steps
    {
        private static const TRIANGLES_A_STEP:int = 400;

        private static const PLACING:int = 0;
        private static const CHECKING:int = 1;
        private static const EXAMINING:int = 2;
        private static const JOINING:int = 3;
        private static const MEASURING:int = 4;
        private static const DONE:int = 5;

        private var _solid:Solid;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _order:Vector.<int>;
        private var _notes:SurfaceNotes;
        private var _check:SurfaceCheck;
        private var _surfaceBuilder:SurfaceBuilder;
        private var _surface:Surface;
        private var _phase:int = PLACING;
        private var _next:int = 0;

        private var _root:HierarchyNode;
        private var _parts:PartFinder;
        private var _extremes:PartExtremes;

        /**
         * @param root the node around all triangles
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         * @param order the numbers of the triangles as the hierarchy has them
         * @param notes what was noted of the surface, which spares most of the work if it is true; null for nothing
         */
        public function SolidBuilder(root:HierarchyNode, vertices:Vector.<Number>, triangles:Vector.<uint>, order:Vector.<int>,
                notes:SurfaceNotes = null)
        {
            _vertices = vertices;
            _triangles = triangles;
            _order = order;
            _solid = new Solid(root);
            _solid.corners = new Vector.<Number>(9 * order.length, true);
            _solid.extents = new Vector.<Number>(6 * order.length, true);
            _solid.planes = new Vector.<Number>(5 * order.length, true);
            _notes = notes;
            _root = root;
        }

        /** What was prepared, when no step is left. */
        public function get solid():Solid
        {
            return _solid;
        }

        /** What another one spares most of the work with, when no step is left. */
        public function get notes():SurfaceNotes
        {
            return _notes;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            switch (_phase)
            {
                case PLACING:
                    placeSome();
                    break;
                case CHECKING:
                    if (!_check.step())
                    {
                        takeChecked();
                    }
                    break;
                case EXAMINING:
                    if (!_surfaceBuilder.step())
                    {
                        takeSurface(_surfaceBuilder.surface);
                        _phase = JOINING;
                    }
                    break;
                case JOINING:
                    if (!_parts.step())
                    {
                        takeNotes();
                        _phase = MEASURING;
                    }
                    break;
                case MEASURING:
                    measureSome();
                    break;
            }
            return _phase != DONE;
        }

        private function placeSome():void
        {
            var end:int = Math.min(_next + TRIANGLES_A_STEP, _order.length);
            for (var i:int = _next; i < end; i++)
            {
                placeCorners(i, 3 * _order[i]);
                placeExtents(9 * i, 6 * i);
                placePlane(i);
            }
            _next = end;
            if (end == _order.length)
            {
                beginSurface();
            }
        }

        private function beginSurface():void
        {
            _next = 0;
            if (_notes == null)
            {
                _surfaceBuilder = new SurfaceBuilder(_vertices, _triangles);
                _phase = EXAMINING;
                return;
            }
            _check = new SurfaceCheck(_vertices, _triangles, _notes.isTurned);
            _phase = CHECKING;
        }

        // What does not hold is found out without it.
        private function takeChecked():void
        {
            if (_check.surface != null)
            {
                takeSurface(_check.surface);
                _phase = _parts.joinKnown(_notes.joins) ? MEASURING : JOINING;
                return;
            }
            _notes = null;
            beginSurface();
        }

        private function takeNotes():void
        {
            _notes = new SurfaceNotes();
            _notes.isTurned = _surface.isTurned;
            _notes.joins = _parts.joins;
        }

        private function placeCorners(triangle:int, corner:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            var corners:Vector.<Number> = _solid.corners;
            var to:int = 9 * triangle;
            for (var end:int = corner + 3; corner < end; corner++)
            {
                var at:int = 3 * _triangles[corner];
                corners[to] = vertices[at];
                corners[int(to + 1)] = vertices[int(at + 1)];
                corners[int(to + 2)] = vertices[int(at + 2)];
                to += 3;
            }
        }

        private function placeExtents(from:int, to:int):void
        {
            var corners:Vector.<Number> = _solid.corners;
            var extents:Vector.<Number> = _solid.extents;
            for (var end:int = from + 3; from < end; from++)
            {
                var least:Number = corners[from];
                var largest:Number = least;
                var coordinate:Number = corners[int(from + 3)];
                if (coordinate < least)
                {
                    least = coordinate;
                }
                else if (coordinate > largest)
                {
                    largest = coordinate;
                }
                coordinate = corners[int(from + 6)];
                if (coordinate < least)
                {
                    least = coordinate;
                }
                else if (coordinate > largest)
                {
                    largest = coordinate;
                }
                extents[to] = least;
                extents[int(to + 3)] = largest;
                to++;
            }
        }

        private function placePlane(triangle:int):void
        {
            var corners:Vector.<Number> = _solid.corners;
            var planes:Vector.<Number> = _solid.planes;
            var at:int = 9 * triangle;
            var x:Number = corners[at];
            var y:Number = corners[at + 1];
            var z:Number = corners[at + 2];
            var ux:Number = corners[at + 3] - x;
            var uy:Number = corners[at + 4] - y;
            var uz:Number = corners[at + 5] - z;
            var vx:Number = corners[at + 6] - x;
            var vy:Number = corners[at + 7] - y;
            var vz:Number = corners[at + 8] - z;
            var normalX:Number = uy * vz - uz * vy;
            var normalY:Number = uz * vx - ux * vz;
            var normalZ:Number = ux * vy - uy * vx;
            var length:Number = Math.sqrt(normalX * normalX + normalY * normalY + normalZ * normalZ);
            var to:int = 5 * triangle;
            if (!(length > 0))
            {
                planes[to] = planes[to + 1] = planes[to + 2] = planes[to + 3] = 0;
                planes[to + 4] = Infinity;
                return;
            }
            normalX /= length;
            normalY /= length;
            normalZ /= length;
            var place:Number = normalX * x + normalY * y + normalZ * z;
            planes[to] = normalX;
            planes[to + 1] = normalY;
            planes[to + 2] = normalZ;
            planes[to + 3] = place;
            planes[to + 4] = Math.max(Math.abs(normalX * corners[at + 3] + normalY * corners[at + 4] + normalZ * corners[at + 5] - place),
                    Math.abs(normalX * corners[at + 6] + normalY * corners[at + 7] + normalZ * corners[at + 8] - place));
        }

        private function takeSurface(surface:Surface):void
        {
            _surface = surface;
            _solid.isClosed = _surface.isClosed;
            _solid.isOriented = _surface.isOriented;
            _solid.widestSeam = _surface.widestSeam;
            if (_surface.isOriented && _surface.isTurned != null)
            {
                turnRound();
            }
            _extremes = new PartExtremes(_solid, _surface.pieceCount);
            _parts = new PartFinder(_root, _solid, _surface, _order);
        }

        private function turnRound():void
        {
            var corners:Vector.<Number> = _solid.corners;
            for (var i:int = 0; i < _order.length; i++)
            {
                if (_surface.isTurned[_order[i]])
                {
                    for (var at:int = 9 * i; at < 9 * i + 3; at++)
                    {
                        var coordinate:Number = corners[at];
                        corners[at] = corners[at + 3];
                        corners[at + 3] = coordinate;
                    }
                }
            }
        }

        private function measureSome():void
        {
            var end:int = Math.min(_next + TRIANGLES_A_STEP, _order.length);
            for (var i:int = _next; i < end; i++)
            {
                _extremes.add(_parts.partOf(i), i);
            }
            _next = end;
            if (end == _order.length)
            {
                _extremes.finish();
                _phase = DONE;
            }
        }
    }
}
