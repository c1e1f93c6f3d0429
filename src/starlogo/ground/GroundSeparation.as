package starlogo.ground
{
    import flash.geom.Vector3D;

    /**
     * Says whether planes separate a displaced model from all of the ground under it: each facet of the ground must be behind a plane that the model is in front
     * of. As no plane points down, the ground under the facet is behind it too. If no known plane separates a facet, its own plane may, or one between the two.
     */
    internal final class GroundSeparation
    {
        /** An answer: planes separate the two. */
        public static const SEPARATED:int = 0;

        /** An answer: the planes do not say it. */
        public static const UNKNOWN:int = 1;

        /** An answer: the model is in the ground. It has a point under it that is farthest behind the plane of a facet, and this is the next plane. */
        public static const BLOCKED:int = 2;

        private var _planes:GroundPlanes;
        private var _facet:GroundFacet = new GroundFacet();

        // The box around the displaced model.
        private var _box:GroundBox = new GroundBox();

        // How far a plane must be from the model, or from the facet.
        private var _gap:Number = 0;

        /** @param planes takes those that separate */
        public function GroundSeparation(planes:GroundPlanes)
        {
            _planes = planes;
        }

        /**
         * Looks for planes.
         *
         * @param model its box is around the whole model
         * @param gap how far the two must be apart, at least the gap across which they touch
         * @return one of the answers
         */
        public function find(model:ModelPiece, search:GroundSearch, gap:Number):int
        {
            var grid:HeightGrid = search.grid;
            var box:GroundBox = _box;
            var facet:GroundFacet = _facet;
            var width:Number = grid.cellWidth;
            var beginX:Number = grid.x - grid.border - search.origin.x;
            var beginY:Number = grid.y - grid.border - search.origin.y;
            box.copyFrom(model.box);
            box.x += _planes.displacement.x;
            box.y += _planes.displacement.y;
            box.z += _planes.displacement.z;
            var firstColumn:int = Math.max(0, Math.floor((box.x - box.halfX - beginX) / width));
            var firstRow:int = Math.max(0, Math.floor((box.y - box.halfY - beginY) / width));
            var lastColumn:int = Math.min(grid.lastCellColumn, Math.floor((box.x + box.halfX - beginX) / width));
            var lastRow:int = Math.min(grid.lastCellRow, Math.floor((box.y + box.halfY - beginY) / width));
            var answer:int = SEPARATED;
            _gap = gap;
            facet.width = width;
            for (var row:int = firstRow; row <= lastRow && answer != BLOCKED; row++)
            {
                facet.y = beginY + row * width;
                facet.minY = Math.max(0, box.y - box.halfY - facet.y);
                facet.maxY = Math.min(width, box.y + box.halfY - facet.y);
                for (var column:int = firstColumn; column <= lastColumn && answer != BLOCKED; column++)
                {
                    facet.x = beginX + column * width;
                    facet.minX = Math.max(0, box.x - box.halfX - facet.x);
                    facet.maxX = Math.min(width, box.x + box.halfX - facet.x);
                    answer = Math.max(answer, answerOfCell(row * grid.columns + column, model, search));
                }
            }
            return answer;
        }

        // The answer for the facets of a cell.
        private function answerOfCell(at:int, model:ModelPiece, search:GroundSearch):int
        {
            var grid:HeightGrid = search.grid;
            var heights:Vector.<Number> = grid.heights;
            var here:Number = heights[at];
            _facet.z = here - search.origin.z;
            if (grid.isBlocky)
            {
                // a way out of a block need not lead up
                _facet.riseX = _facet.riseY = 0;
                return isBehindPlane() ? SEPARATED : UNKNOWN;
            }
            var nextX:Number = heights[int(at + 1)];
            var nextY:Number = heights[int(at + grid.columns)];
            var opposite:Number = heights[int(at + grid.columns + 1)];
            _facet.isBesideX = true;
            _facet.riseX = (nextX - here) / grid.cellWidth;
            _facet.riseY = (opposite - nextX) / grid.cellWidth;
            var answer:int = answerOfFacet(model, search);
            if (answer == BLOCKED)
            {
                return BLOCKED;
            }
            _facet.isBesideX = false;
            _facet.riseX = (opposite - nextY) / grid.cellWidth;
            _facet.riseY = (nextY - here) / grid.cellWidth;
            return Math.max(answer, answerOfFacet(model, search));
        }

        // The answer for a facet.
        private function answerOfFacet(model:ModelPiece, search:GroundSearch):int
        {
            if (isBehindPlane())
            {
                return SEPARATED;
            }
            if (!_planes.hasRoom)
            {
                return UNKNOWN;
            }
            var plane:GroundPlane = _planes.next;
            _facet.writePlane(plane);
            if (isBoxInFront(plane) || isModelInFront(model, plane))
            {
                return SEPARATED;
            }
            if (plane.depthUnderGround(search, _planes.displacement) > 0)
            {
                return BLOCKED;
            }
            return _facet.writePlaneBelow(_box, plane) && isModelInFront(model, plane) ? SEPARATED : UNKNOWN;
        }

        // Whether the facet is behind one of the planes, which the displaced model is in front of.
        private function isBehindPlane():Boolean
        {
            for (var i:int = 0; i < _planes.count; i++)
            {
                var plane:GroundPlane = _planes.planes[i];
                if (_facet.maxAlong(plane.normal) + _gap <= plane.frontAfter(_planes.displacement))
                {
                    return true;
                }
            }
            return false;
        }

        // Whether the box around the displaced model is in front of a plane.
        private function isBoxInFront(plane:GroundPlane):Boolean
        {
            var normal:Vector3D = plane.normal;
            var box:GroundBox = _box;
            var reach:Number = Math.abs(normal.x) * box.halfX + Math.abs(normal.y) * box.halfY + normal.z * box.halfZ;
            return normal.x * box.x + normal.y * box.y + normal.z * box.z - reach >= plane.offset + _gap;
        }

        // Whether the displaced model is in front of a plane. If it is, the plane is added, because others may be behind it too.
        private function isModelInFront(model:ModelPiece, plane:GroundPlane):Boolean
        {
            plane.findPoint(model);
            if (plane.frontAfter(_planes.displacement) < plane.offset + _gap)
            {
                return false;
            }
            _planes.add();
            return true;
        }
    }
}
