package support
{
    import flash.geom.Vector3D;
    import starlogo.agents.Agent;
    import starlogo.bounding.BoundingStructure;
    import starlogo.bounding.Box;
    import starlogo.bounding.Capsule;
    import starlogo.bounding.Sphere;
    import starlogo.engine;
    import starlogo.geometry.Placement;
    import starlogo.hierarchy.HierarchyNode;
    import starlogo.terrain.Terrain;

    use namespace engine;

    /**
     * The ground as a list of all its triangles, and agents as lists of triangles with a radius around them: how far apart they are, found with every
     * triangle against every other, in other ways than the engine's.
     */
    public final class GroundReference
    {
        /** All triangles of the surface: nine numbers each, counter-clockwise from outside. */
        public var surface:Vector.<Number> = new Vector.<Number>();

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

        /** Whether the ground is solid at a place, its surface included. */
        public function isSolid(x:Number, y:Number, z:Number):Boolean
        {
            for (var at:int = 0; at < surface.length; at += 9)
            {
                if (isUpright(at))
                {
                    continue;
                }
                var height:Number = heightOn(at, x, y);
                if (height >= z)
                {
                    return true;
                }
            }
            return false;
        }

        /** How far pieces that are moved are from the surface, less than 0 if they are known to be deeper; -1 if one is under the ground. */
        public function gapOf(pieces:Array, dx:Number = 0, dy:Number = 0, dz:Number = 0):Number
        {
            var least:Number = Infinity;
            for each (var piece:Object in pieces)
            {
                var points:Vector.<Number> = piece.points;
                var moved:Vector.<Number> = new Vector.<Number>(points.length);
                for (var i:int = 0; i < points.length; i += 3)
                {
                    moved[i] = points[i] + dx;
                    moved[i + 1] = points[i + 1] + dy;
                    moved[i + 2] = points[i + 2] + dz;
                }
                if (isSolid(moved[0], moved[1], moved[2]))
                {
                    return -1;
                }
                for (i = 0; i < moved.length; i += 9)
                {
                    for (var at:int = 0; at < surface.length; at += 9)
                    {
                        if (isFar(moved, i, surface, at, least + piece.radius))
                        {
                            continue;
                        }
                        least = Math.min(least, PlainDistance.ofTriangles(moved, i, surface, at) - piece.radius);
                        if (least <= 0)
                        {
                            return least;
                        }
                    }
                }
            }
            return least;
        }

        /** When pieces that move first come to the surface, or are under it; NaN if it is not clear, Infinity for never. */
        public function timeOf(pieces:Array, motion:Vector3D, near:Number):Number
        {
            var time:Number = 0;
            for (var step:int = 0; step < 500; step++)
            {
                var gap:Number = gapOf(pieces, time * motion.x, time * motion.y, time * motion.z);
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
            if (isSolid(origin.x, origin.y, origin.z))
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

        /** The pieces of an agent: those of its structure, or of its model's triangles (nine numbers each, in the model's space). */
        public static function piecesOf(agent:Agent, structure:BoundingStructure, triangles:Vector.<Number> = null):Array
        {
            var placement:Placement = agent.worldPlacement();
            if (triangles == null)
            {
                return [pieceOf(structure.place(placement))];
            }
            var pieces:Array = [];
            for (var i:int = 0; i < triangles.length; i += 9)
            {
                pieces.push({radius: 0, points: placed(triangles.slice(i, i + 9), placement)});
            }
            return pieces;
        }

        /** The pieces of an agent that is a tree: its nodes at a depth. */
        public static function piecesOfTree(agent:Agent, root:HierarchyNode, depth:int):Array
        {
            if (root.level >= depth || root.isLeaf)
            {
                return [pieceOf(root.bounds.place(agent.worldPlacement()))];
            }
            return piecesOfTree(agent, root.left, depth).concat(piecesOfTree(agent, root.right, depth));
        }

        /** The piece that a structure in the world is. */
        public static function pieceOf(structure:BoundingStructure):Object
        {
            if (structure is Sphere)
            {
                var center:Vector3D = Sphere(structure).center;
                return {radius: Sphere(structure).radius, points: new <Number>[center.x, center.y, center.z, center.x, center.y, center.z, center.x, center.y, center.z]};
            }
            if (structure is Capsule)
            {
                var start:Vector3D = Capsule(structure).start;
                var end:Vector3D = Capsule(structure).end;
                return {radius: Capsule(structure).radius, points: new <Number>[start.x, start.y, start.z, end.x, end.y, end.z, end.x, end.y, end.z]};
            }
            var box:Box = Box(structure);
            var points:Vector.<Number> = new Vector.<Number>();
            // by side: the axis across it, and its four corners round
            for (var side:int = 0; side < 6; side++)
            {
                for each (var corner:int in [0, 1, 2, 0, 2, 3])
                {
                    var signs:Array = [];
                    signs[side >> 1] = side % 2 == 0 ? -1 : 1;
                    signs[((side >> 1) + 1) % 3] = corner == 1 || corner == 2 ? 1 : -1;
                    signs[((side >> 1) + 2) % 3] = corner >= 2 ? 1 : -1;
                    for each (var axis:String in ["x", "y", "z"])
                    {
                        points.push(box.center[axis] + signs[0] * box.halfX * box.axisX[axis] + signs[1] * box.halfY * box.axisY[axis]
                                + signs[2] * box.halfZ * box.axisZ[axis]);
                    }
                }
            }
            return {radius: 0, points: points};
        }

        private static function placed(points:Vector.<Number>, placement:Placement):Vector.<Number>
        {
            for (var i:int = 0; i < points.length; i += 3)
            {
                var x:Number = points[i] * placement.size;
                var y:Number = points[i + 1] * placement.size;
                var z:Number = points[i + 2] * placement.size;
                points[i] = placement.r00 * x + placement.r01 * y + placement.r02 * z + placement.x;
                points[i + 1] = placement.r10 * x + placement.r11 * y + placement.r12 * z + placement.y;
                points[i + 2] = placement.r20 * x + placement.r21 * y + placement.r22 * z + placement.z;
            }
            return points;
        }

        private function addSlopes():void
        {
            for (var row:int = 0; row + 1 < _terrain.rows; row++)
            {
                for (var column:int = 0; column + 1 < _terrain.columns; column++)
                {
                    addTriangle(corner(column, row), corner(column + 1, row), corner(column + 1, row + 1));
                    addTriangle(corner(column, row), corner(column + 1, row + 1), corner(column, row + 1));
                }
            }
            for (column = 0; column + 1 < _terrain.columns; column++)
            {
                addWall(corner(column, 0), corner(column + 1, 0), _floor, _floor);
                addWall(corner(column + 1, _terrain.rows - 1), corner(column, _terrain.rows - 1), _floor, _floor);
            }
            for (row = 0; row + 1 < _terrain.rows; row++)
            {
                addWall(corner(_terrain.columns - 1, row), corner(_terrain.columns - 1, row + 1), _floor, _floor);
                addWall(corner(0, row + 1), corner(0, row), _floor, _floor);
            }
        }

        private function addColumns():void
        {
            for (var row:int = 0; row < _terrain.rows; row++)
            {
                for (var column:int = 0; column < _terrain.columns; column++)
                {
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
            return isOutside ? _floor : _heights[row * _terrain.columns + column];
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
        }

        private function isUpright(at:int):Boolean
        {
            return (surface[at + 3] - surface[at]) * (surface[at + 7] - surface[at + 1]) - (surface[at + 4] - surface[at + 1]) * (surface[at + 6] - surface[at]) == 0;
        }

        // NaN if the place is not over the triangle.
        private function heightOn(at:int, x:Number, y:Number):Number
        {
            var weights:Array = [];
            var sum:Number = 0;
            for (var i:int = 0; i < 3; i++)
            {
                var p:int = at + 3 * ((i + 1) % 3);
                var q:int = at + 3 * ((i + 2) % 3);
                weights[i] = (surface[q] - surface[p]) * (y - surface[p + 1]) - (surface[q + 1] - surface[p + 1]) * (x - surface[p]);
                if (weights[i] < 0)
                {
                    return NaN;
                }
                sum += weights[i];
            }
            return (weights[0] * surface[at + 2] + weights[1] * surface[at + 5] + weights[2] * surface[at + 8]) / sum;
        }

        // Whether the extents of two triangles are farther apart than a distance.
        private static function isFar(a:Vector.<Number>, atA:int, b:Vector.<Number>, atB:int, distance:Number):Boolean
        {
            for (var i:int = 0; i < 3; i++)
            {
                if (Math.min(a[atA + i], a[atA + i + 3], a[atA + i + 6]) - Math.max(b[atB + i], b[atB + i + 3], b[atB + i + 6]) > distance
                        || Math.min(b[atB + i], b[atB + i + 3], b[atB + i + 6]) - Math.max(a[atA + i], a[atA + i + 3], a[atA + i + 6]) > distance)
                {
                    return true;
                }
            }
            return false;
        }
    }
}
