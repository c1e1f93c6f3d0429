package starlogo.solid.interior
{
    import flash.geom.Vector3D;
    import starlogo.data.zeroedNumbers;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;

    /**
     * How far a model reaches towards both ends of an axis, in each cell of a grid across the axis. A point beyond that is outside, so Interior need not
     * count crossings for it. A cell is measured when a point in it is first asked about.
     */
    internal final class DepthMap
    {
        // The grid has fewer cells than the model has primitives: more memory decides few more points.
        private static const PRIMITIVES_PER_CELL:int = 64;
        private static const MAX_WIDTH:int = 128;

        // A reach may be too far by this fraction of the model's half-extent. So of many leaves that reach nearly as far, few are visited.
        private static const TOLERANCE:Number = 0.01;

        private var _tree:BoxTree;
        private var _axis:int;
        private var _slack:Number;

        // The number of cells along each side of the grid; by axis, where its first cell begins, and 1 divided by the length of a cell.
        private var _width:int;
        private var _least:Vector.<Number> = new Vector.<Number>(3, true);
        private var _cellsPerUnit:Vector.<Number> = new Vector.<Number>(3, true);

        // How far the model reaches in each cell: upwards the coordinate, and behind those, downwards its negative. NaN before it is measured.
        private var _reaches:Vector.<Number>;

        private var _search:BoxSearch = new BoxSearch();
        private var _extents:Vector.<Number> = new Vector.<Number>(6, true);
        private var _point:Vector.<Number> = new Vector.<Number>(3, true);

        /**
         * @param tree the model's
         * @param axis 0 for x
         * @param slack how far the model may reach beyond the boxes of the tree's nodes
         */
        public function DepthMap(tree:BoxTree, axis:int, slack:Number)
        {
            _tree = tree;
            _axis = axis;
            _slack = slack;
            _width = Math.min(MAX_WIDTH, Math.ceil(Math.sqrt(tree.primitiveCount / PRIMITIVES_PER_CELL)));
            for (var along:int = 0; along < 3; along++)
            {
                _least[along] = tree.boxes[along] - tree.boxes[along + 3];
                _cellsPerUnit[along] = _width / (2 * tree.boxes[along + 3]);
            }
            _reaches = zeroedNumbers(2 * _width * _width);
            for (var i:int = 0; i < _reaches.length; i++)
            {
                _reaches[i] = NaN;
            }
        }

        /** Whether a point is beyond all of the model in its cell, on its side of the middle. */
        public function isBeyond(point:Vector3D):Boolean
        {
            _point[0] = point.x;
            _point[1] = point.y;
            _point[2] = point.z;
            var sign:int = _point[_axis] < _tree.boxes[_axis] ? -1 : 1;
            var row:int = cellOf((_axis + 1) % 3);
            var column:int = cellOf((_axis + 2) % 3);
            var cell:int = row * _width + column;
            if (sign < 0)
            {
                cell += _width * _width;
            }
            if (isNaN(_reaches[cell]))
            {
                measure(cell, row, column, sign);
            }
            return sign * _point[_axis] > _reaches[cell];
        }

        // The point's row or column of the grid along an axis.
        private function cellOf(axis:int):int
        {
            var cell:int = (_point[axis] - _least[axis]) * _cellsPerUnit[axis];
            return cell < 0 ? 0 : (cell < _width ? cell : _width - 1);
        }

        // Measures how far the model reaches in a cell. The search begins at the end of the box around the model, and goes inwards.
        private function measure(cell:int, row:int, column:int, sign:int):void
        {
            var boxes:Vector.<Number> = _tree.boxes;
            var tolerance:Number = TOLERANCE * boxes[_axis + 3] + _slack;
            var end:Number = sign * boxes[_axis] + boxes[_axis + 3];
            var reach:Number = -Infinity;
            setExtents((_axis + 1) % 3, row);
            setExtents((_axis + 2) % 3, column);
            _extents[2 * _axis] = _extents[2 * _axis + 1] = sign * end;
            _search.setExtents(_extents);
            _search.beginAlongAxis(_tree, _axis, -sign);
            for (var leaf:int = _search.nextMet(); leaf >= 0; leaf = _search.nextMet())
            {
                var ofLeaf:Number = sign * boxes[6 * leaf + _axis] + boxes[6 * leaf + _axis + 3];
                if (ofLeaf > reach)
                {
                    reach = ofLeaf;
                    _search.limit = end - reach - tolerance;
                }
            }
            _reaches[cell] = reach + 2 * tolerance;
        }

        // Sets the extents of a row or a column along an axis.
        private function setExtents(axis:int, cell:int):void
        {
            _extents[2 * axis] = _least[axis] + cell / _cellsPerUnit[axis] - _slack;
            _extents[2 * axis + 1] = _least[axis] + (cell + 1) / _cellsPerUnit[axis] + _slack;
        }
    }
}
