package starlogo.hierarchy
{
    import starlogo.engine;
    import starlogo.geometry.Surface;
    import starlogo.geometry.SurfaceBuilder;
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
        private static const EXAMINING:int = 1;
        private static const JOINING:int = 2;
        private static const MEASURING:int = 3;
        private static const DONE:int = 4;

        private var _solid:Solid;
        private var _vertices:Vector.<Number>;
        private var _triangles:Vector.<uint>;
        private var _order:Vector.<int>;
        private var _surfaceBuilder:SurfaceBuilder;
        private var _surface:Surface;
        private var _phase:int = PLACING;
        private var _next:int = 0;

        private var _root:HierarchyNode;
        private var _parts:PartFinder;

        // By piece: where the points of its part are.
        private var _pointsAt:Vector.<int> = new Vector.<int>();

        /**
         * @param root the node around all triangles
         * @param vertices x, y, z each
         * @param triangles three vertex indices each
         * @param order the numbers of the triangles as the hierarchy has them
         */
        public function SolidBuilder(root:HierarchyNode, vertices:Vector.<Number>, triangles:Vector.<uint>, order:Vector.<int>)
        {
            _vertices = vertices;
            _triangles = triangles;
            _order = order;
            _solid = new Solid(root);
            _solid.corners = new Vector.<Number>(9 * order.length, true);
            _solid.extents = new Vector.<Number>(6 * order.length, true);
            _solid.planes = new Vector.<Number>(5 * order.length, true);
            _surfaceBuilder = new SurfaceBuilder(vertices, triangles);
            _root = root;
        }

        /** What was prepared, when no step is left. */
        public function get solid():Solid
        {
            return _solid;
        }

        /** @inheritDoc */
        public function step():Boolean
        {
            switch (_phase)
            {
                case PLACING:
                    placeSome();
                    break;
                case EXAMINING:
                    if (!_surfaceBuilder.step())
                    {
                        takeSurface();
                    }
                    break;
                case JOINING:
                    if (!_parts.step())
                    {
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
                for (var axis:int = 0; axis < 3; axis++)
                {
                    placeAxis(i, 3 * _order[i], axis);
                }
                placePlane(i);
            }
            _next = end;
            if (end == _order.length)
            {
                _phase = EXAMINING;
                _next = 0;
            }
        }

        private function placeAxis(triangle:int, corner:int, axis:int):void
        {
            var a:Number = _vertices[3 * _triangles[corner] + axis];
            var b:Number = _vertices[3 * _triangles[corner + 1] + axis];
            var c:Number = _vertices[3 * _triangles[corner + 2] + axis];
            _solid.corners[9 * triangle + axis] = a;
            _solid.corners[9 * triangle + 3 + axis] = b;
            _solid.corners[9 * triangle + 6 + axis] = c;
            _solid.extents[6 * triangle + axis] = Math.min(a, b, c);
            _solid.extents[6 * triangle + 3 + axis] = Math.max(a, b, c);
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

        private function takeSurface():void
        {
            _surface = _surfaceBuilder.surface;
            _solid.isClosed = _surface.isClosed;
            _solid.isOriented = _surface.isOriented;
            _solid.widestSeam = _surface.widestSeam;
            if (_surface.isOriented && _surface.isTurned != null)
            {
                turnRound();
            }
            for (var i:int = 0; i < _surface.pieceCount; i++)
            {
                _pointsAt.push(-1);
            }
            _parts = new PartFinder(_root, _solid, _surface, _order);
            _phase = JOINING;
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
                var part:int = _parts.partOf(i);
                if (_pointsAt[part] < 0)
                {
                    beginPart(part, 9 * i);
                }
                for (var corner:int = 9 * i; corner < 9 * i + 9; corner += 3)
                {
                    extendPart(_pointsAt[part], corner);
                }
            }
            _next = end;
            if (end == _order.length)
            {
                measureExtents();
                _phase = DONE;
            }
        }

        private function beginPart(part:int, corner:int):void
        {
            var points:Vector.<Number> = _solid.partPoints;
            _pointsAt[part] = points.length;
            for (var i:int = 0; i < Solid.POINTS_A_PART; i++)
            {
                points.push(_solid.corners[corner], _solid.corners[corner + 1], _solid.corners[corner + 2]);
            }
        }

        private function extendPart(at:int, corner:int):void
        {
            var points:Vector.<Number> = _solid.partPoints;
            var corners:Vector.<Number> = _solid.corners;
            for (var axis:int = 0; axis < 3; axis++)
            {
                var low:int = at + 6 * axis;
                var coordinate:Number = corners[corner + axis];
                var to:int = -1;
                if (coordinate < points[low + axis])
                {
                    to = low;
                }
                else if (coordinate > points[low + 3 + axis])
                {
                    to = low + 3;
                }
                if (to >= 0)
                {
                    points[to] = corners[corner];
                    points[to + 1] = corners[corner + 1];
                    points[to + 2] = corners[corner + 2];
                }
            }
        }

        private function measureExtents():void
        {
            var points:Vector.<Number> = _solid.partPoints;
            for (var at:int = 0; at < points.length; at += 3 * Solid.POINTS_A_PART)
            {
                var extent:Number = Math.max(points[at + 3] - points[at], points[at + 10] - points[at + 7], points[at + 17] - points[at + 14]);
                _solid.leastPartExtent = Math.min(_solid.leastPartExtent, extent);
            }
        }
    }
}
