package starlogo.geometry.hull
{
    /** The vertex farthest from a point, or from a line, or from a plane: of all vertices that were looked at, some at a time. */
    internal final class FarthestVertex
    {
        /** The vertex; the first one of several. */
        public var index:int = 0;

        private var _vertices:Vector.<Number>;
        private var _most:Number = -1;

        /**
         * @param vertices x, y, z each
         */
        public function FarthestVertex(vertices:Vector.<Number>)
        {
            _vertices = vertices;
        }

        /** Looks at the vertices from one number up to another, from a point. */
        public function lookFromPoint(x:Number, y:Number, z:Number, first:int, end:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var toX:Number = vertices[i] - x;
                var toY:Number = vertices[int(i + 1)] - y;
                var toZ:Number = vertices[int(i + 2)] - z;
                var square:Number = toX * toX + toY * toY + toZ * toZ;
                if (square > _most)
                {
                    _most = square;
                    index = i / 3;
                }
            }
        }

        /** The same from a line through a point, along a unit vector. */
        public function lookFromLine(x:Number, y:Number, z:Number, axisX:Number, axisY:Number, axisZ:Number, first:int, end:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var toX:Number = vertices[i] - x;
                var toY:Number = vertices[int(i + 1)] - y;
                var toZ:Number = vertices[int(i + 2)] - z;
                var crossX:Number = toY * axisZ - toZ * axisY;
                var crossY:Number = toZ * axisX - toX * axisZ;
                var crossZ:Number = toX * axisY - toY * axisX;
                var square:Number = crossX * crossX + crossY * crossY + crossZ * crossZ;
                if (square > _most)
                {
                    _most = square;
                    index = i / 3;
                }
            }
        }

        /** The same from a plane: its normal, and how far it is from the origin along that. */
        public function lookFromPlane(normalX:Number, normalY:Number, normalZ:Number, offset:Number, first:int, end:int):void
        {
            var vertices:Vector.<Number> = _vertices;
            var last:int = 3 * end;
            for (var i:int = 3 * first; i < last; i += 3)
            {
                var distance:Number = vertices[i] * normalX + vertices[int(i + 1)] * normalY
                    + vertices[int(i + 2)] * normalZ - offset;
                if (distance < 0)
                {
                    distance = -distance;
                }
                if (distance > _most)
                {
                    _most = distance;
                    index = i / 3;
                }
            }
        }
    }
}
