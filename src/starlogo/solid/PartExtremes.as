package starlogo.solid
{
    /** Finds the outermost points of a Solid's parts, and the extent of the smallest part. */
    internal final class PartExtremes
    {
        private var _solid:Solid;

        /** For each part, the index of its points, or -1 if it has none yet. */
        public var pointsAt:Vector.<int>;

        /**
         * @param solid has the corners of the triangles; receives the points
         * @param count greater than any part's number
         */
        public function PartExtremes(solid:Solid, count:int)
        {
            _solid = solid;
            solid.partPoints.length = 0;
            pointsAt = new Vector.<int>(count, true);
            for (var i:int = 0; i < count; i++)
            {
                pointsAt[i] = -1;
            }
        }

        /** Adds a triangle to a part. */
        public function add(part:int, triangle:int):void
        {
            if (pointsAt[part] < 0)
            {
                beginPart(part, 9 * triangle);
            }
            for (var corner:int = 9 * triangle; corner < 9 * triangle + 9; corner += 3)
            {
                extendPart(pointsAt[part], corner);
            }
        }

        /** Computes the smallest extent. Must be called after all triangles were added. */
        public function finish():void
        {
            var points:Vector.<Number> = _solid.partPoints;
            for (var at:int = 0; at < points.length; at += 3 * Solid.POINTS_PER_PART)
            {
                var extent:Number = Math.max(points[at + 3] - points[at], points[at + 10] - points[at + 7], points[at + 17] - points[at + 14]);
                _solid.leastPartExtent = Math.min(_solid.leastPartExtent, extent);
            }
        }

        private function beginPart(part:int, corner:int):void
        {
            var points:Vector.<Number> = _solid.partPoints;
            pointsAt[part] = points.length;
            for (var i:int = 0; i < Solid.POINTS_PER_PART; i++)
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
                var coordinate:Number = corners[int(corner + axis)];
                var to:int = coordinate < points[int(low + axis)] ? low : low + 3;
                if (to == low || coordinate > points[int(to + axis)])
                {
                    points[to] = corners[corner];
                    points[to + 1] = corners[corner + 1];
                    points[to + 2] = corners[corner + 2];
                }
            }
        }
    }
}
