// The package solid.interior says which points are inside of a model whose triangles come from a file: with seams, holes, shells that overlap and
// cavities. A shell is connected over edges, a component over vertices. Engines whose meshes are hollow need none of it.
// 
// An Interior answers. A DepthMap tells it of most points outside that they are. Its steps prepare it:
// VertexWelder      finds the vertices that are at the same place
// then the SurfaceTopology is found, by four classes:
// - ComponentFinder finds the components
// - EdgeMatcher     pairs the triangles that continue each other over an edge
// - ShellFinder     follows these pairs, and so finds the shells
// - CavityFinder    decides which shells bound cavities
// 
// Read Interior first, then SurfaceTopology.

package starlogo.solid.interior
{
    import flash.geom.Vector3D;
    import starlogo.geometry.Tolerances;
    import starlogo.hierarchy.BoxSearch;
    import starlogo.hierarchy.BoxTree;
    import starlogo.steps.StepSequence;
    import starlogo.steps.Steps;

    /**
     * Says which points are inside of a model's surface, by the winding numbers of its shells: it counts the triangles that a ray along an axis crosses.
     * Its steps come before: they find which vertices are at the same place, and the surface, which takes most of the time. A surface that is known
     * already is not found again.
     *
     * <p>In the arithmetic, p, q and r are the corners of a triangle. Each has three coordinates as seen from the ray's origin: a along the ray's axis,
     * b and c along the other two. So qb is the b of corner q.</p>
     *
     * @private
     */
    public final class Interior extends StepSequence
    {
        /** The tree of the triangles. */
        public var tree:BoxTree;

        /** The surface that they make, complete when no step is left. */
        public var surface:SurfaceTopology;

        /** Whether at least one shell of the surface is closed, so that it has an inside. Known when no step is left. */
        public var hasClosedShell:Boolean = false;

        /** See <code>VertexWelder.welded</code>. Null if all vertices of each seam are at one place. */
        public var welded:Vector.<int> = null;

        // How often each shell winds around the point of the last countWindings(), or 0 if a cavity of it does. Null before that.
        private var _windings:Vector.<int> = null;

        // The shells of the triangles that the ray from that point crosses, and how many they are. Shells of points before may come after them.
        private var _crossed:Vector.<int> = new Vector.<int>();
        private var _crossedCount:int = 0;

        private var _search:BoxSearch = new BoxSearch();

        // Knows of most points outside that they are. Null before the first point.
        private var _depthMap:DepthMap = null;

        // The axis of all rays, 0 for x. It is the axis along which the model is shortest.
        private var _axis:int;

        // The current ray: its origin along these axes, and whether it goes towards the smaller coordinates.
        private var _a:Number;
        private var _b:Number;
        private var _c:Number;
        private var _isBackward:Boolean;

        /**
         * @param tree of the triangles, whose corners are listed
         * @param knownSurface the surface if it is known; otherwise null
         */
        public function Interior(tree:BoxTree, knownSurface:SurfaceTopology)
        {
            var box:Vector.<Number> = tree.boxes;
            this.tree = tree;
            surface = knownSurface || new SurfaceTopology(tree.primitiveCount);
            _axis = box[3] <= box[4] && box[3] <= box[5] ? 0 : (box[4] <= box[5] ? 1 : 2);
            if (knownSurface == null || knownSurface.widestSeam > 0)
            {
                var welder:VertexWelder = new VertexWelder(tree);
                add(welder).call(function():void
                    {
                        welded = welder.widestSeam > 0 ? welder.welded : null;
                    });
            }
            if (knownSurface == null)
            {
                begin(function():Steps
                    {
                        return findingSurface(welder);
                    });
            }
            call(function():void
                {
                    hasClosedShell = surface.hasClosedShell;
                });
        }

        // The work that finds the surface, after its vertices are welded.
        private function findingSurface(welder:VertexWelder):Steps
        {
            var interior:Interior = this;
            var edges:EdgeMatcher = new EdgeMatcher(tree.triangles, welder);
            var shells:ShellFinder = new ShellFinder(surface, edges);
            surface.widestSeam = welder.widestSeam;
            return new StepSequence().add(new ComponentFinder(surface, tree.triangles, welder.welded)).add(edges).add(shells).begin(function():Steps
                {
                    return new CavityFinder(interior, shells, welder.welded);
                });
        }

        /**
         * Whether a point is inside of the surface. The point must not be on it. A point is inside if a closed shell winds around it, and no
         * shell that bounds a cavity in that one.
         */
        public function isInside(point:Vector3D):Boolean
        {
            _depthMap ||= new DepthMap(tree, _axis, slack);
            if (_depthMap.isBeyond(point))
            {
                return false;
            }
            countWindings(point);
            for (var i:int = 0; i < _crossedCount; i++)
            {
                if (encloses(_crossed[i]))
                {
                    return true;
                }
            }
            return false;
        }

        // How far a triangle may be outside of its node's box: welding moves corners, and numbers are rounded.
        private function get slack():Number
        {
            return surface.widestSeam + Tolerances.ROUNDING * tree.radiusAboutOrigin;
        }

        /**
         * Finds the shells that have a point inside of them, and not in a cavity.
         *
         * @param out receives the shells, each as often as the ray crosses it
         * @return how many triangles the ray crosses, which says how much work it was
         */
        public function findEnclosing(point:Vector3D, out:Vector.<int>):int
        {
            countWindings(point);
            out.length = 0;
            for (var i:int = 0; i < _crossedCount; i++)
            {
                if (encloses(_crossed[i]))
                {
                    out.push(_crossed[i]);
                }
            }
            return _crossedCount;
        }

        // Whether the point of the last countWindings() is inside of a shell, and not in a cavity of it.
        private function encloses(shell:int):Boolean
        {
            var state:int = surface.shellStates[shell];
            return state == SurfaceTopology.ORIENTABLE && _windings[shell] != 0
                || state == SurfaceTopology.NON_ORIENTABLE && (_windings[shell] & 1) != 0;
        }

        // Counts how often each shell winds around a point. A shell counts 0 if the point is in a cavity of it. A ray along an axis, away from the middle
        // of the model, counts the triangles that it crosses.
        // Seen along the ray, an edge is crossed by a half-line across the ray, or it is not. The two triangles at the edge have the same answer to the
        // last bit, because they have the same corners. So a ray through an edge or a corner needs no special case.
        private function countWindings(point:Vector3D):void
        {
            var x:Number = point.x;
            var y:Number = point.y;
            var z:Number = point.z;
            _windings ||= new Vector.<int>(surface.shellStates.length, true);
            for (var before:int = 0; before < _crossedCount; before++)
            {
                _windings[_crossed[before]] = 0;
            }
            _crossedCount = 0;
            _a = _axis == 0 ? x : (_axis == 1 ? y : z);
            _b = _axis == 0 ? y : (_axis == 1 ? z : x);
            _c = _axis == 0 ? z : (_axis == 1 ? x : y);
            _isBackward = _a < tree.boxes[_axis];
            _search.setCube(x, y, z, slack);
            _search.beginAlongAxis(tree, _axis, _isBackward ? -1 : 1);
            for (var leaf:int = _search.nextMet(); leaf >= 0; leaf = _search.nextMet())
            {
                var end:int = tree.endPrimitive[leaf];
                for (var index:int = tree.firstPrimitive[leaf]; index < end; index++)
                {
                    addIfCrossed(index);
                }
            }
            for (var i:int = 0; i < _crossedCount; i++)
            {
                var shell:int = _crossed[i];
                if (surface.boundsCavity(shell) && _windings[shell] != 0)
                {
                    _windings[surface.shellStates[shell]] = 0;
                }
            }
        }

        // Adds a triangle to its shell's winding number if the ray crosses it.
        private function addIfCrossed(index:int):void
        {
            var points:Vector.<Number> = tree.vertices;
            var p:int = tree.cornerOffsets[int(3 * index)];
            var q:int = tree.cornerOffsets[int(3 * index + 1)];
            var r:int = tree.cornerOffsets[int(3 * index + 2)];
            var triangle:int = tree.primitives[index];
            if (welded != null)
            {
                var vertices:Vector.<uint> = tree.triangles;
                p = 3 * welded[vertices[3 * triangle]];
                q = 3 * welded[vertices[3 * triangle + 1]];
                r = 3 * welded[vertices[3 * triangle + 2]];
            }
            var axisB:int = (_axis + 1) % 3;
            var axisC:int = (_axis + 2) % 3;
            var b:Number = _b;
            var c:Number = _c;
            var pc:Number = points[int(p + axisC)] - c;
            var qc:Number = points[int(q + axisC)] - c;
            var rc:Number = points[int(r + axisC)] - c;
            if ((pc > 0) == (qc > 0) && (qc > 0) == (rc > 0))
            {
                return;
            }
            var pb:Number = points[int(p + axisB)] - b;
            var qb:Number = points[int(q + axisB)] - b;
            var rb:Number = points[int(r + axisB)] - b;
            var crossing:int = crossingOf(pb, pc, qb, qc) + crossingOf(qb, qc, rb, rc) + crossingOf(rb, rc, pb, pc);
            // One corner is alone on its side of the half-line's plane. It comes first.
            var isPAlone:Boolean = (qc > 0) == (rc > 0);
            var isQAlone:Boolean = (pc > 0) == (rc > 0);
            var isRAlone:Boolean = (pc > 0) == (qc > 0);
            if (crossing == 0 || isPAlone && !isAhead(points, p, q, r) || isQAlone && !isAhead(points, q, r, p) || isRAlone && !isAhead(points, r, p, q))
            {
                return;
            }
            var shell:int = surface.shellOf(triangle);
            if (shell >= 0)
            {
                var turns:int = surface.isReversed(triangle) ? -crossing : crossing;
                _windings[shell] += turns;
                _crossed[_crossedCount++] = shell;
            }
        }

        // How the edge from p to q, seen along the ray, crosses the half-line from the ray: 1 upwards, -1 downwards, 0 not at all. From
        // q to p it is exactly the negative.
        private static function crossingOf(pb:Number, pc:Number, qb:Number, qc:Number):int
        {
            if ((pc > 0) == (qc > 0))
            {
                return 0;
            }
            var turn:Number = pb * qc - qb * pc;
            if (qc > 0)
            {
                return turn > 0 ? 1 : 0;
            }
            return turn < 0 ? -1 : 0;
        }

        // Whether a triangle that the ray's line crosses is ahead of its origin. It is measured between the two edges that cross the plane
        // of the half-line. Both begin at the same corner.
        private function isAhead(points:Vector.<Number>, alone:int, q:int, r:int):Boolean
        {
            var axisB:int = (_axis + 1) % 3;
            var axisC:int = (_axis + 2) % 3;
            var ac:Number = points[int(alone + axisC)] - _c;
            var toQ:Number = ac / (ac - (points[int(q + axisC)] - _c));
            var toR:Number = ac / (ac - (points[int(r + axisC)] - _c));
            var ab:Number = points[int(alone + axisB)] - _b;
            var qb:Number = ab + toQ * (points[int(q + axisB)] - _b - ab);
            var rb:Number = ab + toR * (points[int(r + axisB)] - _b - ab);
            var aa:Number = points[int(alone + _axis)] - _a;
            var qa:Number = aa + toQ * (points[int(q + _axis)] - _a - aa);
            var ra:Number = aa + toR * (points[int(r + _axis)] - _a - aa);
            var fraction:Number = qb == rb ? 0.5 : qb / (qb - rb);
            fraction = fraction < 0 ? 0 : (fraction > 1 ? 1 : fraction);
            return qa + fraction * (ra - qa) > 0 != _isBackward;
        }
    }
}
