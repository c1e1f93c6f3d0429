package starlogo.solid.interior
{
    import starlogo.data.zeroedInts;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;

    /**
     * Welds vertices: finds those that are at the same place, within a tolerance, because rounding may have separated the vertices of a seam. A hash
     * table has the places by the cells of a grid. A cell is so much wider than the tolerance that most vertices are farther than that from
     * all other cells. Then no other cell is searched. Places are farther apart than the tolerance, so a cell has few of them. The table is not
     * an IntPairMap, because it need not tell cells apart: a vertex is compared with the places anyway. An IntPairMap would take longer.
     */
    internal final class VertexWelder extends StepSequence
    {
        private static const VERTICES_PER_STEP:int = 500;

        // The width of a cell, in tolerances. Smaller: more vertices are near another cell. Larger: a cell may have more places.
        private static const CELL_WIDTH:int = 8;

        // Where a cell is near the next one, as a fraction of its width: as far as the tolerance, and more than is rounded.
        private static const NEAR:Number = 1.01 / CELL_WIDTH;

        /** For each vertex, the first vertex at the same place. */
        public var welded:Vector.<int>;

        /** The largest distance of a vertex from the one to which it is welded. */
        public var widestSeam:Number = 0;

        private var _vertices:Vector.<Number>;
        private var _tolerance:Number;

        // Begins with the middle and the half-extents of the box around the triangles. The grid begins in its lowest corner.
        private var _boxes:Vector.<Number>;

        // For each bucket of the hash table, one more than the number of the last place in it, or 0. For each place, one more than the number of the
        // place before it in the same bucket, or 0.
        private var _lastInBucket:Vector.<int>;
        private var _beforeInBucket:Vector.<int>;

        /** @param tree of the triangles */
        public function VertexWelder(tree:BoxTree)
        {
            var count:int = tree.vertices.length / 3;
            var size:int = 2;
            while (size < count)
            {
                size *= 2;
            }
            _vertices = tree.vertices;
            _boxes = tree.boxes;
            _tolerance = 2 * Tolerances.WELDING * Math.max(_boxes[3], _boxes[4], _boxes[5]) + Tolerances.ROUNDING * tree.radiusAboutOrigin;
            welded = zeroedInts(count);
            _lastInBucket = zeroedInts(size);
            _beforeInBucket = zeroedInts(count);
            slices(count, VERTICES_PER_STEP, weld);
        }

        private function weld(first:int, end:int):void
        {
            for (var i:int = first; i < end; i++)
            {
                welded[i] = findOrAdd(i);
            }
        }

        // The first vertex at the place of a vertex. If that is the vertex itself, its place is added to the table.
        private function findOrAdd(vertex:int):int
        {
            var cellsPerUnit:Number = 1 / (CELL_WIDTH * _tolerance);
            var x:Number = (_vertices[3 * vertex] - _boxes[0] + _boxes[3]) * cellsPerUnit;
            var y:Number = (_vertices[int(3 * vertex + 1)] - _boxes[1] + _boxes[4]) * cellsPerUnit;
            var z:Number = (_vertices[int(3 * vertex + 2)] - _boxes[2] + _boxes[5]) * cellsPerUnit;
            var cellX:int = x;
            var cellY:int = y;
            var cellZ:int = z;
            var besideX:int = cellX + sideOf(x - cellX);
            var besideY:int = cellY + sideOf(y - cellY);
            var besideZ:int = cellZ + sideOf(z - cellZ);
            var own:int = bucketOf(cellX, cellY, cellZ);
            var nearest:int = nearestOf(own, vertex, -1);
            var beside:int = (besideX == cellX ? 0 : 1) | (besideY == cellY ? 0 : 2) | (besideZ == cellZ ? 0 : 4);
            // all cells that are beside the own one in some of these directions
            for (var i:int = beside; i > 0; i = (i - 1) & beside)
            {
                nearest = nearestOf(bucketOf((i & 1) == 0 ? cellX : besideX, (i & 2) == 0 ? cellY : besideY, (i & 4) == 0 ? cellZ : besideZ), vertex, nearest);
            }
            if (nearest >= 0)
            {
                widestSeam = Math.max(widestSeam, distanceOf(vertex, nearest));
                return nearest;
            }
            _beforeInBucket[vertex] = _lastInBucket[own];
            _lastInBucket[own] = vertex + 1;
            return vertex;
        }

        // Where the next cell is in a direction: -1, 1, or 0 if it is farther away than the tolerance, whatever is rounded.
        private static function sideOf(part:Number):int
        {
            return part < NEAR ? -1 : (part > 1 - NEAR ? 1 : 0);
        }

        // The nearest place in a bucket of the hash table, unless the nearest one so far is as near. -1 if there is none within the tolerance.
        private function nearestOf(bucket:int, vertex:int, nearest:int):int
        {
            var least:Number = nearest < 0 ? _tolerance : distanceOf(vertex, nearest);
            for (var vertexThere:int = _lastInBucket[bucket] - 1; vertexThere >= 0; vertexThere = _beforeInBucket[vertexThere] - 1)
            {
                var distance:Number = distanceOf(vertex, vertexThere);
                if (distance < least || distance == least && nearest < 0)
                {
                    least = distance;
                    nearest = vertexThere;
                }
            }
            return nearest;
        }

        private function distanceOf(vertex:int, vertexThere:int):Number
        {
            var x:Number = _vertices[3 * vertex] - _vertices[3 * vertexThere];
            var y:Number = _vertices[int(3 * vertex + 1)] - _vertices[int(3 * vertexThere + 1)];
            var z:Number = _vertices[int(3 * vertex + 2)] - _vertices[int(3 * vertexThere + 2)];
            return Math.sqrt(x * x + y * y + z * z);
        }

        // The products are below 2 to the 53rd, so all of their lowest bits are exact.
        private function bucketOf(x:int, y:int, z:int):int
        {
            var hash:int = x * 69069;
            hash = (hash ^ hash >>> 15 ^ y) * 69069;
            hash = (hash ^ hash >>> 15 ^ z) * 69069;
            return (hash ^ hash >>> 15) & _lastInBucket.length - 1;
        }
    }
}
