package starlogo.models.polygons
{
    /**
     * Cuts polygons in space into triangles: concave ones, and ones with holes.
     *
     * <p>Triangles, quads and convex polygons are cut at once. Others become rings in a plane (PolygonRings), whose holes
     * are joined to the outline (HoleBridges) before ears are cut off (EarClipper). No outline is too odd: corners in a
     * straight line, and outlines that cross or cover themselves, leave no triangle without area behind.</p>
     *
     * <p>Cost: linear for convex polygons, else up to quadratic in the corners. The whole work is bounded:
     * beyond 10,000,000 looks at corners they are cut off unseen, and holes filled.</p>
     *
     * @private
     */
    public final class Triangulator
    {
        // how many corners it looks at in one call
        private static const WORK_PER_STEP:int = 10000;

        private var _vertices:Vector.<Number>;
        private var _rings:PolygonRings = new PolygonRings();
        private var _bridges:HoleBridges;
        private var _clipper:EarClipper;

        // of the polygon that is being cut: a node of its outline, and what is still to do
        private var _start:int = 0;
        private var _isBridging:Boolean = false;
        private var _isCutting:Boolean = false;

        /**
         * @param vertices as setTarget's
         * @param triangles as setTarget's
         */
        public function Triangulator(vertices:Vector.<Number> = null, triangles:Vector.<uint> = null)
        {
            setTarget(vertices, triangles);
            _bridges = new HoleBridges(_rings);
            _clipper = new EarClipper(_rings);
        }

        /**
         * Sets what polygons are cut of from now on. The limit of work is for all together.
         *
         * @param vertices x, y, z, ... that the polygons' corners index
         * @param triangles where the triangles go, three indices each, turning as their polygon turns
         */
        public function setTarget(vertices:Vector.<Number>, triangles:Vector.<uint>):void
        {
            _vertices = vertices;
            _rings.setTarget(vertices, triangles);
        }

        /**
         * Cuts a polygon, or begins to: see <code>isCutting</code>.
         *
         * @param outline the corners of its outline; it is not kept
         * @param holes those of each hole, which may turn either way; null for none
         */
        public function addPolygon(outline:Vector.<uint>, holes:Vector.<Vector.<uint>> = null):void
        {
            var hasHoles:Boolean = holes != null && holes.length > 0;
            if (outline.length < 3 || !hasHoles && addSmall(outline) || !_rings.setOutline(outline))
            {
                return;
            }
            var start:int = _rings.addLoop(outline, true);
            if (!hasHoles && addFan(outline.length))
            {
                return;
            }
            var nodes:Vector.<int> = new Vector.<int>();
            for (var i:int = 0; hasHoles && i < holes.length; i++)
            {
                if (holes[i].length > 2)
                {
                    nodes.push(_rings.addLoop(holes[i], false));
                }
            }
            _start = start;
            _isBridging = true;
            _isCutting = true;
            _bridges.setPolygon(start, nodes);
            cutSome();
        }

        /** Adds a triangle of three different corners. */
        public function addTriangle(a:uint, b:uint, c:uint):void
        {
            _rings.addTriangle(a, b, c);
        }

        /** Whether the last polygon is so large that there is more of it to cut, by <code>cutSome()</code>, before the next one. */
        public function get isCutting():Boolean
        {
            return _isCutting;
        }

        /** Goes on with it for some milliseconds. */
        public function cutSome():void
        {
            if (_isBridging)
            {
                if (_bridges.join(WORK_PER_STEP))
                {
                    return;
                }
                _isBridging = false;
                _clipper.setRing(_start);
            }
            _isCutting = _clipper.cut(WORK_PER_STEP);
        }

        /**
         * The steps of reading polygons, between which a large one that was read last is cut.
         *
         * @param read function():Boolean: adds polygons until one of them <code>isCutting</code>, returns whether there are more
         * @return the same, to be repeated
         */
        public function cuttingBetween(read:Function):Function
        {
            var hasMore:Boolean = true;
            return function():Boolean
            {
                if (_isCutting)
                {
                    cutSome();
                }
                else
                {
                    hasMore = read();
                }
                return _isCutting || hasMore;
            };
        }

        // Whether it is a triangle, or a quad, which is cut along the diagonal that lies inside.
        private function addSmall(outline:Vector.<uint>):Boolean
        {
            var a:uint = outline[0];
            var b:uint = outline[1];
            var c:uint = outline[2];
            if (outline.length == 3)
            {
                _rings.addTriangle(a, b, c);
                return true;
            }
            if (outline.length > 4)
            {
                return false;
            }
            var d:uint = outline[3];
            if (!isDiagonal(a, b, c, d) && isDiagonal(b, c, d, a))
            {
                _rings.addTriangle(a, b, d);
                _rings.addTriangle(b, c, d);
            }
            else
            {
                _rings.addTriangle(a, b, c);
                _rings.addTriangle(a, c, d);
            }
            return true;
        }

        /** Whether the two triangles that ac makes of a quad turn the same way. */
        private function isDiagonal(a:uint, b:uint, c:uint, d:uint):Boolean
        {
            var start:int = 3 * a;
            var x:Number = _vertices[start];
            var y:Number = _vertices[int(start + 1)];
            var z:Number = _vertices[int(start + 2)];
            start = 3 * b;
            var bx:Number = _vertices[start] - x;
            var by:Number = _vertices[int(start + 1)] - y;
            var bz:Number = _vertices[int(start + 2)] - z;
            start = 3 * c;
            var cx:Number = _vertices[start] - x;
            var cy:Number = _vertices[int(start + 1)] - y;
            var cz:Number = _vertices[int(start + 2)] - z;
            start = 3 * d;
            var dx:Number = _vertices[start] - x;
            var dy:Number = _vertices[int(start + 1)] - y;
            var dz:Number = _vertices[int(start + 2)] - z;
            return (by * cz - bz * cy) * (cy * dz - cz * dy) + (bz * cx - bx * cz) * (cz * dx - cx * dz) +
                (bx * cy - by * cx) * (cx * dy - cy * dx) > 0;
        }

        /** Cuts the outline from its first corner if that sees all of it, as in every convex polygon. */
        private function addFan(count:int):Boolean
        {
            for (var i:int = 2; i < count; i++)
            {
                if (!(_rings.turn(0, i - 1, i) > 0))
                {
                    return false;
                }
            }
            var vertex:Vector.<uint> = _rings.vertex;
            for (i = 2; i < count; i++)
            {
                _rings.addTriangle(vertex[0], vertex[int(i - 1)], vertex[i]);
            }
            return true;
        }
    }
}
