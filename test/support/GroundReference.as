package support
{
    import flash.geom.Vector3D;
    import starlogo.terrain.Terrain;

    /**
     * The ground as a list of all its triangles: how far the pieces of agents (AgentPieces) are from it, found with every triangle against every
     * other, in other ways than the engine's.
     */
    public final class GroundReference
    {
        /** All triangles of the surface: nine numbers each, counter-clockwise from outside. */
        public var surface:Vector.<Number> = new Vector.<Number>();

        private var _boxes:Vector.<Number> = new Vector.<Number>();
        private var _box:Vector.<Number> = new Vector.<Number>(6);
        private var _all:Vector.<int> = new Vector.<int>();
        private var _over:Vector.<int> = new Vector.<int>();
        private var _close:Vector.<int> = new Vector.<int>();
        private var _near:Vector.<int> = new Vector.<int>();
        private var _nearest:Vector.<int> = new Vector.<int>();
        private var _moved:Vector.<Number> = new Vector.<Number>();
        private var _terrain:Terrain;
        private var _heights:Vector.<Number> = new Vector.<Number>();
        private var _floor:Number;

        /**
         * @param floor how deep the walls at the borders go; lower than all that is asked about
         */
        public function GroundReference(terrain:Terrain, floor:Number = -1e4)
        {
            _terrain = terrain;
            _floor = floor;
            for (var row:int = 0; row < terrain.rows; row++)
            {
                for (var column:int = 0; column < terrain.columns; column++)
                {
                    _heights.push(terrain.getHeight(column, row));
                }
            }
            if (terrain.isBlocky)
            {
                addColumns();
            }
            else
            {
                addSlopes();
            }
        }

        /**
         * How far pieces that are moved are from the surface, less than 0 if they are known to be deeper; -1 if one is under the ground.
         *
         * @param most the answer if they are farther than that
         */
        public function gapOf(pieces:Array, dx:Number = 0, dy:Number = 0, dz:Number = 0, most:Number = Infinity):Number
        {
            var least:Number = most;
            var from:int = 0;
            findClose(pieces, dx, dy, dz, most);
            for each (var piece:Object in pieces)
            {
                var to:int = from + piece.points.length;
                if (isSolid(_moved[from], _moved[from + 1], _moved[from + 2], _over))
                {
                    return -1;
                }
                findNear(from, to, least + piece.radius, _close, _near);
                for (; from < to; from += 9)
                {
                    findNear(from, from + 9, least + piece.radius, _near, _nearest);
                    for (var k:int = 0; k < _nearest.length; k++)
                    {
                        least = Math.min(least, PlainDistance.ofTriangles(_moved, from, surface, _nearest[k]) - piece.radius);
                    }
                }
                if (least <= 0 && piece.radius == 0)
                {
                    return least;
                }
            }
            return least;
        }

        /** When pieces that move first come to the surface, or are under it; NaN if it is not clear, Infinity for never. */
        public function timeOf(pieces:Array, motion:Vector3D, near:Number):Number
        {
            var time:Number = 0;
            var gap:Number = Infinity;
            for (var step:int = 0; step < 500; step++)
            {
                // after a way as long as the gap, the next is twice as long at most
                var most:Number = Math.min((1 - time) * motion.length, 2 * gap) + 2 * near;
                gap = gapOf(pieces, time * motion.x, time * motion.y, time * motion.z, most);
                if (gap <= near)
                {
                    return time;
                }
                if (time == 1)
                {
                    return Infinity;
                }
                time = Math.min(1, time + gap / motion.length);
            }
            return NaN;
        }

        /** Where a ray first meets the ground; Infinity for never. */
        public function rayTo(origin:Vector3D, direction:Vector3D):Number
        {
            if (isSolid(origin.x, origin.y, origin.z, _all))
            {
                return 0;
            }
            var least:Number = Infinity;
            for (var at:int = 0; at < surface.length; at += 9)
            {
                least = Math.min(least, PlainDistance.alongRay(origin, direction, surface, at));
            }
            return least;
        }

        private function addSlopes():void
        {
            for (var row:int = 0; row + 1 < _terrain.rows; row++)
            {
                for (var column:int = 0; column + 1 < _terrain.columns; column++)
                {
                    if (_terrain.isHole(column, row))
                    {
                        continue;
                    }
                    addTriangle(corner(column, row), corner(column + 1, row), corner(column + 1, row + 1));
                    addTriangle(corner(column, row), corner(column + 1, row + 1), corner(column, row + 1));
                    for each (var side:Array in [[0, -1, 0, 0, 1, 0], [1, 0, 1, 0, 1, 1], [0, 1, 1, 1, 0, 1], [-1, 0, 0, 1, 0, 0]])
                    {
                        var isBeside:Boolean = column + side[0] >= 0 && row + side[1] >= 0 && column + side[0] + 1 < _terrain.columns && row + side[1] + 1 < _terrain.rows;
                        if (!isBeside || _terrain.isHole(column + side[0], row + side[1]))
                        {
                            addWall(corner(column + side[2], row + side[3]), corner(column + side[4], row + side[5]), _floor, _floor);
                        }
                    }
                }
            }
        }

        private function addColumns():void
        {
            for (var row:int = 0; row < _terrain.rows; row++)
            {
                for (var column:int = 0; column < _terrain.columns; column++)
                {
                    if (_terrain.isHole(column, row))
                    {
                        continue;
                    }
                    var top:Number = heightOf(column, row);
                    var corners:Array = [];
                    for each (var off:Array in [[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]])
                    {
                        corners.push([_terrain.x + (column + off[0]) * _terrain.cellWidth, _terrain.y + (row + off[1]) * _terrain.cellWidth, top]);
                    }
                    addTriangle(corners[0], corners[1], corners[2]);
                    addTriangle(corners[0], corners[2], corners[3]);
                    var nexts:Array = [heightOf(column, row - 1), heightOf(column + 1, row), heightOf(column, row + 1), heightOf(column - 1, row)];
                    for (var side:int = 0; side < 4; side++)
                    {
                        if (nexts[side] < top)
                        {
                            addWall(corners[side], corners[(side + 1) % 4], nexts[side], nexts[side]);
                        }
                    }
                }
            }
        }

        private function heightOf(column:int, row:int):Number
        {
            var isOutside:Boolean = column < 0 || row < 0 || column >= _terrain.columns || row >= _terrain.rows;
            return isOutside || _terrain.isBlocky && _terrain.isHole(column, row) ? _floor : _heights[row * _terrain.columns + column];
        }

        private function corner(column:int, row:int):Array
        {
            return [_terrain.x + column * _terrain.cellWidth, _terrain.y + row * _terrain.cellWidth, heightOf(column, row)];
        }

        // From left to right as seen from outside.
        private function addWall(a:Array, b:Array, lowA:Number, lowB:Number):void
        {
            addTriangle([a[0], a[1], lowA], [b[0], b[1], lowB], b);
            addTriangle([a[0], a[1], lowA], b, a);
        }

        private function addTriangle(a:Array, b:Array, c:Array):void
        {
            surface.push(a[0], a[1], a[2], b[0], b[1], b[2], c[0], c[1], c[2]);
            _all.push(surface.length - 9);
            _boxes.length += 6;
            putBox(surface, surface.length - 9, surface.length, _boxes, _boxes.length - 6);
        }

        // NaN if the place is not over the triangle, or the triangle is upright.
        private function heightOn(at:int, x:Number, y:Number):Number
        {
            var sum:Number = 0;
            var weighted:Number = 0;
            for (var i:int = 0; i < 3; i++)
            {
                var p:int = at + 3 * ((i + 1) % 3);
                var q:int = at + 3 * ((i + 2) % 3);
                var weight:Number = (surface[q] - surface[p]) * (y - surface[p + 1]) - (surface[q + 1] - surface[p + 1]) * (x - surface[p]);
                if (weight < 0)
                {
                    return NaN;
                }
                sum += weight;
                weighted += weight * surface[at + 3 * i + 2];
            }
            return weighted / sum;
        }

        // Whether the ground is solid at a place, its surface included.
        private function isSolid(x:Number, y:Number, z:Number, among:Vector.<int>):Boolean
        {
            for (var i:int = 0; i < among.length; i++)
            {
                if (heightOn(among[i], x, y) >= z)
                {
                    return true;
                }
            }
            return false;
        }

        // Moves pieces. Finds the triangles whose boxes are within a distance of all of them, and those above and below them.
        private function findClose(pieces:Array, dx:Number, dy:Number, dz:Number, distance:Number):void
        {
            var radius:Number = 0;
            var to:int = 0;
            for each (var piece:Object in pieces)
            {
                var points:Vector.<Number> = piece.points;
                radius = Math.max(radius, piece.radius);
                for (var i:int = 0; i < points.length; i += 3)
                {
                    _moved[to++] = points[i] + dx;
                    _moved[to++] = points[i + 1] + dy;
                    _moved[to++] = points[i + 2] + dz;
                }
            }
            findNear(0, to, distance + radius, _all, _close);
            _box[2] = -Infinity;
            _box[5] = Infinity;
            keepNear(0, _all, _over);
        }

        // Those triangles whose boxes are within a distance of the box of some moved points, along each axis.
        private function findNear(from:int, to:int, distance:Number, among:Vector.<int>, out:Vector.<int>):void
        {
            out.length = 0;
            if (among.length > 0)
            {
                putBox(_moved, from, to, _box, 0);
                keepNear(distance, among, out);
            }
        }

        private function keepNear(distance:Number, among:Vector.<int>, out:Vector.<int>):void
        {
            out.length = 0;
            for (var i:int = 0; i < among.length; i++)
            {
                var of:int = among[i] / 9 * 6;
                if (_box[0] - _boxes[of + 3] <= distance && _boxes[of] - _box[3] <= distance && _box[1] - _boxes[of + 4] <= distance
                        && _boxes[of + 1] - _box[4] <= distance && _box[2] - _boxes[of + 5] <= distance && _boxes[of + 2] - _box[5] <= distance)
                {
                    out.push(among[i]);
                }
            }
        }

        // The least and the greatest x, y and z of some points.
        private static function putBox(points:Vector.<Number>, from:int, to:int, boxes:Vector.<Number>, at:int):void
        {
            for (var axis:int = 0; axis < 3; axis++)
            {
                var least:Number = Infinity;
                var greatest:Number = -Infinity;
                for (var i:int = from + axis; i < to; i += 3)
                {
                    least = Math.min(least, points[i]);
                    greatest = Math.max(greatest, points[i]);
                }
                boxes[at + axis] = least;
                boxes[at + axis + 3] = greatest;
            }
        }
    }
}
